//! Writer of KTX2 files.

use std::fs::File;
use std::io::{self, BufWriter, Read, Seek, SeekFrom, Write};
use std::path::Path;

use ktx2::dfd::{Basic, Block};
use ktx2::{Header, Index, LevelIndex, SupercompressionScheme};
use relief_core::MAX_SIDE;
use ruzstd::encoding::{CompressionLevel, FrameCompressor};

use super::{TexelFormat, blocks, full_chain, level_size};
use crate::texture::{Metadata, Row, RowSource};
use crate::write_whole::write_file;
use crate::{WriteError, WriteProblem};

/// Description of a KTX2 texture to write.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Ktx2Texture {
    /// Storage format of texels.
    pub format: TexelFormat,
    /// Numbers of columns, rows and slices. A texture with more than one slice is 3-D.
    pub size: [u32; 3],
    /// Number of mip levels, 1 for the finest only. Each level has half the side of the one before
    /// it, rounded down, and at least 1 along every axis.
    pub levels: u32,
    /// Number of channels that are requested by rows, at most the format's. In the format's other
    /// channels colours are 0 and opacity is 1.
    pub channels: usize,
    /// Whether to compress each level with Zstandard.
    pub zstd: bool,
    /// Names and values to store as key/value data.
    pub metadata: Metadata,
}

/// Writes a KTX2 texture. Values are rounded to the nearest that the format holds; in normalised
/// formats they are clamped to `[0, 1]`. The same input gives the same bytes.
///
/// Rows are requested from the smallest level to the finest, slice by slice, from the top, channel
/// by channel.
///
/// # Errors
///
/// When the size is 0 or above 2^20 a side; when there are more levels than the size allows, or
/// more channels than the format has; when a volume is to be stored in blocks, which not every GPU
/// reads; when the metadata have a name that the specification reserves; when `rows` fails; or when
/// the file cannot be written. Nothing is left behind then.
pub fn write_ktx2(path: &Path, texture: &Ktx2Texture, rows: &mut RowSource<'_>) -> Result<(), WriteError> {
    write_file(path, |out| {
        texture.check()?;
        write(out, texture, rows)
    })
}

impl Ktx2Texture {
    /// Checks whether a file can hold the texture, before its texels are computed.
    ///
    /// # Errors
    ///
    /// The errors of [`write_ktx2`] that concern the description.
    pub fn check(&self) -> Result<(), WriteProblem> {
        self.check_description().map_err(WriteProblem::NotStorable)
    }

    fn check_description(&self) -> Result<(), String> {
        let [width, height, depth] = self.size;
        if self.size.iter().any(|side| !(1..=MAX_SIDE).contains(side)) {
            return Err(format!("a texture has 1 to {MAX_SIDE} texels a side, not {width}x{height}x{depth}"));
        }
        if self.format.level_bytes(self.size).is_none_or(|bytes| bytes > i64::MAX as u64 / 4) {
            return Err(format!("a texture of {width}x{height}x{depth} is too large for a file"));
        }
        if !(1..=full_chain(self.size)).contains(&self.levels) {
            let most = full_chain(self.size);
            return Err(format!(
                "{width}x{height}x{depth} texels have 1 to {most} mip levels, not {}",
                self.levels
            ));
        }
        if !(1..=self.format.channels()).contains(&self.channels) {
            let most = self.format.channels();
            return Err(format!("the texel format has 1 to {most} channels, not {}", self.channels));
        }
        if depth > 1 && self.format.is_block_compressed() {
            return Err("a volume cannot be stored in block-compressed texels".to_owned());
        }
        match self.metadata.iter().find(|(key, _)| key.to_ascii_lowercase().starts_with("ktx")) {
            Some((key, _)) => {
                Err(format!("the specification reserves names such as '{key}': choose another"))
            }
            None => Ok(()),
        }
    }
}

fn write(
    out: &mut BufWriter<&File>,
    texture: &Ktx2Texture,
    rows: &mut RowSource<'_>,
) -> Result<(), WriteProblem> {
    let (descriptor, type_size) = descriptor(texture.format)?;
    let pairs = key_value_data(texture);
    let start = Header::LENGTH + LevelIndex::LENGTH * texture.levels as usize;
    let fits = |bytes: usize| {
        u32::try_from(bytes)
            .map_err(|_| WriteProblem::NotStorable("the metadata are too long: shorten them".into()))
    };
    let [width, height, depth] = texture.size;
    let header = Header {
        format: Some(texture.format.vulkan()),
        type_size,
        pixel_width: width,
        pixel_height: height,
        pixel_depth: if depth > 1 { depth } else { 0 },
        layer_count: 0,
        face_count: 1,
        level_count: texture.levels,
        supercompression_scheme: texture.zstd.then_some(SupercompressionScheme::Zstandard),
        index: Index {
            dfd_byte_offset: fits(start)?,
            dfd_byte_length: fits(descriptor.len())?,
            kvd_byte_offset: fits(start + descriptor.len())?,
            kvd_byte_length: fits(pairs.len())?,
            sgd_byte_offset: 0,
            sgd_byte_length: 0,
        },
    };
    out.write_all(&header.as_bytes())?;
    // The positions of the levels are filled in after they are written.
    out.write_all(&vec![0; LevelIndex::LENGTH * texture.levels as usize])?;
    out.write_all(&descriptor)?;
    out.write_all(&pairs)?;
    let mut end = (start + descriptor.len() + pairs.len()) as u64;
    let mut index = Vec::new();
    for level in (0..texture.levels).rev() {
        let aligned = end.next_multiple_of(alignment(texture));
        io::copy(&mut io::repeat(0).take(aligned - end), out)?;
        let uncompressed_byte_length =
            texture.format.level_bytes(level_size(texture.size, level)).unwrap_or_default();
        let mut bytes = LevelBytes::new(texture, level, rows);
        if texture.zstd {
            compress(&mut bytes, out)?;
        } else {
            io::copy(&mut bytes, out)?;
        }
        end = out.stream_position()?;
        index.push(LevelIndex { byte_offset: aligned, byte_length: end - aligned, uncompressed_byte_length });
    }
    out.seek(SeekFrom::Start(Header::LENGTH as u64))?;
    for level in index.iter().rev() {
        out.write_all(&level.as_bytes())?;
    }
    Ok(())
}

/// Alignment of a level: a multiple of 4 bytes and of its texel block, or 1 if it is compressed as
/// a whole.
fn alignment(texture: &Ktx2Texture) -> u64 {
    match (texture.zstd, texture.format.block_bytes() as u64) {
        (true, _) => 1,
        (false, bytes) => bytes.max(4),
    }
}

/// Builds the data format descriptor with its total length, and the size of the type for byte
/// swapping.
fn descriptor(format: TexelFormat) -> Result<(Vec<u8>, u32), WriteProblem> {
    let (basic, type_size) = Basic::from_format(format.vulkan())
        .map_err(|error| WriteProblem::NotStorable(format!("{error:?}")))?;
    let block = Block::Basic(basic).to_vec();
    let length = block.len() as u32 + 4;
    Ok(([&length.to_le_bytes(), block.as_slice()].concat(), type_size))
}

/// Builds the key/value data from the texture's entries and the specification's, in the order of
/// the keys' bytes, each padded to 4 bytes.
fn key_value_data(texture: &Ktx2Texture) -> Vec<u8> {
    let orientation = if texture.size[2] > 1 { "rdi" } else { "rd" };
    let writer = concat!("relief-io ", env!("CARGO_PKG_VERSION"));
    let mut pairs: Vec<(&str, &str)> = texture.metadata.iter().collect();
    pairs.extend([("KTXorientation", orientation), ("KTXwriter", writer)]);
    pairs.sort_unstable();
    let mut data = Vec::new();
    for (key, value) in pairs {
        let length = (key.len() + value.len() + 2) as u32;
        data.extend(length.to_le_bytes());
        for text in [key, value] {
            data.extend(text.as_bytes());
            data.push(0);
        }
        data.resize(data.len().next_multiple_of(4), 0);
    }
    data
}

/// Reader of a level's bytes in the order of the file, generated row by row.
struct LevelBytes<'a, 'b> {
    texture: &'a Ktx2Texture,
    rows: &'a mut RowSource<'b>,
    level: u32,
    size: [u32; 3],
    /// Slice of the next row of blocks.
    slice: u32,
    row: u32,
    texels: Vec<f32>,
    bytes: Vec<u8>,
    /// Number of bytes of the row that have been read.
    given: usize,
}

impl<'a, 'b> LevelBytes<'a, 'b> {
    fn new(texture: &'a Ktx2Texture, level: u32, rows: &'a mut RowSource<'b>) -> Self {
        let size = level_size(texture.size, level);
        Self { texture, rows, level, size, slice: 0, row: 0, texels: Vec::new(), bytes: Vec::new(), given: 0 }
    }

    fn next_row(&mut self) -> io::Result<()> {
        let format = self.texture.format;
        let [width, height, _] = self.size;
        let (columns, side) = (width as usize, format.block_side());
        let texels_a_channel = columns * side as usize;
        self.texels.resize(texels_a_channel * format.channels(), 0.0);
        // A channel that the format has and the texture lacks is 0, opacity 1.
        for (channel, texels) in self.texels.chunks_exact_mut(texels_a_channel).enumerate() {
            if channel >= self.texture.channels {
                texels.fill(if channel == 3 { 1.0 } else { 0.0 });
                continue;
            }
            for (row, texels) in (self.row..).zip(texels.chunks_exact_mut(columns)) {
                // A block that extends below the texture repeats the last row.
                let row = row.min(height - 1);
                (self.rows)(Row { level: self.level, slice: self.slice, channel, row }, texels)?;
            }
        }
        self.bytes.resize(format.row_bytes(width) as usize, 0);
        if format.is_block_compressed() {
            blocks::compress_row(format, columns, &self.texels, &mut self.bytes);
        } else {
            let sample = format.sample();
            for (channel, texels) in self.texels.chunks_exact(columns).enumerate() {
                let texel_bytes = self.bytes.chunks_exact_mut(format.block_bytes());
                for (texel, bytes) in texels.iter().zip(texel_bytes) {
                    sample.encode(*texel, &mut bytes[channel * sample.bytes()..][..sample.bytes()]);
                }
            }
        }
        self.given = 0;
        self.row += side;
        if self.row >= height {
            self.row = 0;
            self.slice += 1;
        }
        Ok(())
    }
}

impl Read for LevelBytes<'_, '_> {
    fn read(&mut self, out: &mut [u8]) -> io::Result<usize> {
        if self.given == self.bytes.len() {
            if self.slice == self.size[2] {
                return Ok(0);
            }
            self.next_row()?;
        }
        let count = out.len().min(self.bytes.len() - self.given);
        out[..count].copy_from_slice(&self.bytes[self.given..][..count]);
        self.given += count;
        Ok(count)
    }
}

/// Compresses into one Zstandard frame. The compressor panics if reading or writing fails.
/// Therefore it gets an end of data or an endless sink instead, and the failure is returned here.
fn compress(bytes: &mut LevelBytes<'_, '_>, out: &mut BufWriter<&File>) -> io::Result<()> {
    let mut compressor = FrameCompressor::new(CompressionLevel::Fastest);
    compressor.set_source(UntilFailure { inner: bytes, failure: None });
    compressor.set_drain(UntilFailure { inner: out, failure: None });
    compressor.compress();
    let source = compressor.take_source().and_then(|source| source.failure);
    let drain = compressor.take_drain().and_then(|drain| drain.failure);
    source.or(drain).map_or(Ok(()), Err)
}

struct UntilFailure<T> {
    inner: T,
    failure: Option<io::Error>,
}

impl<T: Read> Read for UntilFailure<T> {
    fn read(&mut self, out: &mut [u8]) -> io::Result<usize> {
        if self.failure.is_some() {
            return Ok(0);
        }
        self.inner.read(out).or_else(|error| {
            self.failure = Some(error);
            Ok(0)
        })
    }
}

impl<T: Write> Write for UntilFailure<T> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        if self.failure.is_none() {
            self.failure = self.inner.write_all(bytes).err();
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}
