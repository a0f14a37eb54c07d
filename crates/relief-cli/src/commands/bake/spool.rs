//! Temporary storage of baked texels on the way to the files, in a nameless file beside the
//! outputs.
//!
//! Files need another order than bakes give: KTX2 begins with the smallest mip level, PNG and KTX2
//! store the channels of a texel side by side, and each file names all files of its bake. With the
//! texels on the disk, 4 bytes a value, textures of any size need memory for a few rows only.

use std::fs::File;
use std::io::{self, BufWriter, Read, Seek, SeekFrom, Write};
use std::path::Path;

use relief_bake::{Sink, SinkError, Texture};
use relief_io::Row;

/// Bytes that are read ahead for each channel.
const READ_AHEAD: u64 = 1 << 18;

/// Check that decides whether a texture can be taken, before its texels come.
type Check<'a> = dyn Fn(&Texture) -> Result<(), String> + 'a;

/// Sink that stores textures on the disk.
pub struct Spool<'a> {
    file: BufWriter<File>,
    check: &'a Check<'a>,
    textures: Vec<Spooled>,
    end: u64,
}

/// Texture on the disk.
pub struct Spooled {
    /// Description of the texture.
    pub texture: Texture,
    start: u64,
    /// Number of slices that have come, over all levels.
    slices: u64,
}

impl<'a> Spool<'a> {
    /// Creates an empty spool, whose file in `folder` has no name and leaves no trace.
    pub fn new(folder: &Path, check: &'a Check<'a>) -> io::Result<Self> {
        let file = BufWriter::with_capacity(1 << 16, tempfile::tempfile_in(folder)?);
        Ok(Self { file, check, textures: Vec::new(), end: 0 })
    }

    /// Returns the textures, and a reader of their texels.
    pub fn finish(mut self) -> Result<(Vec<Spooled>, SpoolReader), SinkError> {
        self.check_complete()?;
        let file = self.file.into_inner().map_err(|error| failed(error.error()))?;
        Ok((self.textures, SpoolReader { file, ahead: Vec::new() }))
    }

    fn check_complete(&mut self) -> Result<(), SinkError> {
        match self.textures.last() {
            Some(last) if last.place_of_next().is_some() => {
                Err(SinkError(format!("the texture '{}' came without all of its slices", last.texture.name)))
            }
            _ => Ok(()),
        }
    }
}

impl Sink for Spool<'_> {
    fn begin(&mut self, texture: &Texture) -> Result<(), SinkError> {
        self.check_complete()?;
        (self.check)(texture).map_err(SinkError)?;
        self.textures.push(Spooled { texture: texture.clone(), start: self.end, slices: 0 });
        Ok(())
    }

    fn slice(&mut self, planes: &[&[f32]]) -> Result<(), SinkError> {
        let last =
            self.textures.last_mut().ok_or_else(|| SinkError("a slice before its texture".to_owned()))?;
        let [width, height] =
            last.place_of_next().ok_or_else(|| SinkError("more slices than announced".to_owned()))?;
        let texels = width as usize * height as usize;
        if planes.len() != last.texture.channels.len() || planes.iter().any(|plane| plane.len() != texels) {
            return Err(SinkError("a slice of another size than announced".to_owned()));
        }
        let mut bytes = Vec::with_capacity(1 << 14);
        for plane in planes {
            for texels in plane.chunks(1 << 12) {
                bytes.clear();
                bytes.extend(texels.iter().flat_map(|texel| texel.to_le_bytes()));
                self.file.write_all(&bytes).map_err(|error| failed(&error))?;
            }
        }
        self.end += 4 * texels as u64 * planes.len() as u64;
        last.slices += 1;
        Ok(())
    }
}

impl Spooled {
    /// Returns columns and rows of the next slice; none after the last.
    fn place_of_next(&self) -> Option<[u32; 2]> {
        let mut before = 0;
        for level in 0..=self.texture.mips.len() {
            let [width, height, depth] = self.texture.level_size(level);
            before += u64::from(depth);
            if self.slices < before {
                return Some([width, height]);
            }
        }
        None
    }

    /// Returns the start of a row, and the end of its plane, in bytes.
    fn place(&self, row: Row) -> (u64, u64) {
        let bytes = |side: [u32; 3]| 4 * side.map(u64::from).iter().product::<u64>();
        let channels = self.texture.channels.len() as u64;
        let before: u64 =
            (0..row.level as usize).map(|level| bytes(self.texture.level_size(level)) * channels).sum();
        let [width, height, _] = self.texture.level_size(row.level as usize);
        let plane = bytes([width, height, 1]);
        let start = self.start + before + (u64::from(row.slice) * channels + row.channel as u64) * plane;
        (start + bytes([width, row.row, 1]), start + plane)
    }
}

/// Reader of rows.
pub struct SpoolReader {
    file: File,
    /// For each channel the bytes read ahead, and their start.
    ahead: Vec<(u64, Vec<u8>)>,
}

impl SpoolReader {
    /// Reads a row of a texture. Its channel and level must be the texture's own.
    pub fn row(&mut self, spooled: &Spooled, row: Row, texels: &mut [f32]) -> io::Result<()> {
        let (start, plane_end) = spooled.place(row);
        let length = 4 * texels.len() as u64;
        if self.ahead.len() <= row.channel {
            self.ahead.resize(row.channel + 1, (0, Vec::new()));
        }
        let (from, bytes) = &mut self.ahead[row.channel];
        if start < *from || start + length > *from + bytes.len() as u64 {
            *from = start;
            bytes.resize((plane_end - start).min(READ_AHEAD.max(length)) as usize, 0);
            self.file.seek(SeekFrom::Start(start))?;
            self.file.read_exact(bytes)?;
        }
        let bytes = &bytes[(start - *from) as usize..][..length as usize];
        for (texel, bytes) in texels.iter_mut().zip(bytes.as_chunks::<4>().0) {
            *texel = f32::from_le_bytes(*bytes);
        }
        Ok(())
    }
}

fn failed(error: &io::Error) -> SinkError {
    SinkError(format!("the output folder cannot be written to ({error}): check the free space on the disk"))
}
