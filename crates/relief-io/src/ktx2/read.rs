//! Reader of KTX2 files from untrusted sources.

use std::io::{Read, Seek, SeekFrom};

use ktx2::{Header, KeyValueDataIterator, LevelIndex, MAGIC, SupercompressionScheme};
use relief_core::MAX_SIDE;
use ruzstd::decoding::StreamingDecoder;

use super::{TexelFormat, blocks, full_chain, level_size};
use crate::input::zeros;
use crate::source::SourceReader;
use crate::texture::Metadata;
use crate::{ReadError, ReadProblem, Source};

/// Name of the format in messages.
pub(super) const NAME: &str = "KTX2";

/// Greatest number of bytes of key/value data that are read.
const MOST_METADATA: u64 = 1 << 20;

/// Greatest window of a Zstandard frame that is accepted: the one that RFC 8878, section 3.1.1.1.2,
/// requires of every decoder.
const MOST_WINDOW: u64 = 8 << 20;

/// Greatest compression ratio of a Zstandard frame: a block of 128 KiB takes at least 4 bytes.
const MOST_RATIO: u64 = (128 << 10) / 4;

/// Texture from a KTX2 file, with the values that a GPU would read.
#[derive(Clone, Debug, PartialEq)]
pub struct Ktx2File {
    /// Storage format of texels.
    pub format: TexelFormat,
    /// Whether levels are compressed with Zstandard.
    pub zstd: bool,
    /// Mip levels, the finest first.
    pub levels: Vec<Ktx2Level>,
    /// Names and values of all key/value data that are text.
    pub metadata: Metadata,
}

/// Mip level of a texture.
#[derive(Clone, Debug, PartialEq)]
pub struct Ktx2Level {
    /// Numbers of columns, rows and slices.
    pub size: [u32; 3],
    /// Texels of each channel of the format, slice after slice, row by row from the top.
    pub planes: Vec<Vec<f32>>,
}

/// Reads a texture in one of the [`TexelFormat`]s from a KTX2 file or from the bytes of one. It
/// reads 2-D textures and volumes with their mip levels, uncompressed or with Zstandard, but no
/// arrays and no cube maps.
///
/// Peak memory is 4 bytes a value, a row, and with Zstandard up to 8 MiB.
///
/// # Errors
///
/// When the file cannot be read, is not a KTX2 file, is damaged, or holds an unsupported kind of
/// texture; or when its texels would take more than `max_bytes` of memory, which is checked before
/// any is allocated.
pub fn read_ktx2<'a>(source: impl Into<Source<'a>>, max_bytes: u64) -> Result<Ktx2File, ReadError> {
    let source = source.into();
    read(source, max_bytes).map_err(|problem| source.error(problem))
}

fn read(source: Source<'_>, max_bytes: u64) -> Result<Ktx2File, ReadProblem> {
    let (mut file, file_len) = source.open()?;
    let header = header(&mut file)?;
    let layout = Layout::of(&header)?;
    let metadata = metadata_of(&header, &mut file, file_len)?;
    layout.check_memory(max_bytes)?;
    let index = layout.index(&mut file, file_len)?;
    let mut levels = Vec::new();
    for (level, place) in (0..).zip(index) {
        levels.push(layout.level(level, place, &mut file)?);
    }
    Ok(Ktx2File { format: layout.format, zstd: layout.zstd, levels, metadata })
}

/// Reads only the key/value data of a file.
pub(crate) fn metadata(file: &mut SourceReader<'_>, file_len: u64) -> Result<Metadata, ReadProblem> {
    let header = header(file)?;
    metadata_of(&header, file, file_len)
}

pub(super) fn header(file: &mut SourceReader<'_>) -> Result<Header, ReadProblem> {
    let mut bytes = [0; Header::LENGTH];
    let mut read = 0;
    while read < bytes.len() {
        match file.read(&mut bytes[read..])? {
            0 => break,
            count => read += count,
        }
    }
    let known = &MAGIC[..read.min(MAGIC.len())];
    if !bytes.starts_with(known) {
        return Err(unsupported("a format other than KTX2"));
    }
    if read < bytes.len() {
        return Err(damaged("it ends too early"));
    }
    Header::from_bytes(&bytes).map_err(damaged)
}

pub(super) fn metadata_of(
    header: &Header,
    file: &mut SourceReader<'_>,
    file_len: u64,
) -> Result<Metadata, ReadProblem> {
    let (offset, length) = (u64::from(header.index.kvd_byte_offset), u64::from(header.index.kvd_byte_length));
    if offset + length > file_len {
        return Err(damaged("its metadata reach beyond its end"));
    }
    if length > MOST_METADATA {
        return Err(damaged("its metadata are too long"));
    }
    let mut data = zeros(length as usize)?;
    file.seek(SeekFrom::Start(offset)).map_err(io_problem)?;
    file.read_exact(&mut data).map_err(io_problem)?;
    let text = KeyValueDataIterator::new(&data).filter_map(|(key, value)| {
        let value = std::str::from_utf8(value.strip_suffix(b"\0").unwrap_or(value)).ok()?;
        Some((key.to_owned(), value.to_owned()))
    });
    Ok(Metadata::found(text.collect()))
}

/// Content of a checked header.
pub(super) struct Layout {
    pub format: TexelFormat,
    pub size: [u32; 3],
    pub levels: u32,
    zstd: bool,
}

impl Layout {
    pub fn of(header: &Header) -> Result<Self, ReadProblem> {
        let format = header.format.and_then(TexelFormat::of_vulkan);
        let format = format.ok_or_else(|| unsupported("a texel format that Relief does not write"))?;
        let zstd = match header.supercompression_scheme {
            None => false,
            Some(SupercompressionScheme::Zstandard) => true,
            Some(_) => return Err(unsupported("a supercompression other than Zstandard")),
        };
        if header.layer_count > 1 || header.face_count != 1 {
            return Err(unsupported("array layers or cube faces"));
        }
        let size = [header.pixel_width, header.pixel_height.max(1), header.pixel_depth.max(1)];
        if size.iter().any(|side| *side > MAX_SIDE) {
            return Err(damaged(format!("a side of {size:?} texels is too long")));
        }
        if format.is_block_compressed() && size[2] > 1 {
            return Err(unsupported("a volume of block-compressed texels"));
        }
        let levels = header.level_count.max(1);
        if levels > full_chain(size) {
            return Err(damaged(format!("{levels} mip levels are more than {size:?} texels have")));
        }
        Ok(Self { format, size, levels, zstd })
    }

    /// Number of values of a level. A side is at most 2^20, so that 64 bits hold it.
    fn values(&self, level: u32) -> u64 {
        let texels = level_size(self.size, level).map(u64::from).iter().product::<u64>();
        texels.saturating_mul(self.format.channels() as u64)
    }

    /// Memory in bytes that decompression takes beside the texels.
    pub fn window(&self) -> u64 {
        if self.zstd { MOST_WINDOW } else { 0 }
    }

    fn check_memory(&self, limit: u64) -> Result<(), ReadProblem> {
        let values = (0..self.levels).map(|level| self.values(level)).fold(0, u64::saturating_add);
        let needed = values.saturating_mul(4).saturating_add(self.window());
        let [width, height, _] = self.size;
        if needed > limit {
            return Err(ReadProblem::TooMuchMemory { width, height, needed, limit });
        }
        Ok(())
    }

    /// Reads the positions of the levels, checked against the header and the file's length.
    fn index(&self, file: &mut SourceReader<'_>, file_len: u64) -> Result<Vec<LevelIndex>, ReadProblem> {
        file.seek(SeekFrom::Start(Header::LENGTH as u64)).map_err(io_problem)?;
        let mut index = Vec::new();
        for level in 0..self.levels {
            let mut bytes = [0; LevelIndex::LENGTH];
            file.read_exact(&mut bytes).map_err(io_problem)?;
            let place = LevelIndex::from_bytes(&bytes);
            if place.byte_offset.checked_add(place.byte_length).is_none_or(|end| end > file_len) {
                return Err(damaged(format!("level {level} reaches beyond its end")));
            }
            let expected = self.format.level_bytes(level_size(self.size, level));
            let stored_fits = if self.zstd {
                place.byte_length >= place.uncompressed_byte_length / MOST_RATIO
            } else {
                Some(place.byte_length) == expected
            };
            if Some(place.uncompressed_byte_length) != expected || !stored_fits {
                return Err(damaged(format!("level {level} has a length that does not fit its size")));
            }
            index.push(place);
        }
        Ok(index)
    }

    fn level(
        &self,
        level: u32,
        place: LevelIndex,
        file: &mut SourceReader<'_>,
    ) -> Result<Ktx2Level, ReadProblem> {
        let size = level_size(self.size, level);
        file.seek(SeekFrom::Start(place.byte_offset)).map_err(io_problem)?;
        let stored = file.take(place.byte_length);
        let planes = if self.zstd {
            let content = StreamingDecoder::new_with_max_window_size(stored, MOST_WINDOW).map_err(damaged)?;
            self.planes(size, content)?
        } else {
            self.planes(size, stored)?
        };
        Ok(Ktx2Level { size, planes })
    }

    fn planes(
        &self,
        [width, height, depth]: [u32; 3],
        mut content: impl Read,
    ) -> Result<Vec<Vec<f32>>, ReadProblem> {
        let (format, channels) = (self.format, self.format.channels());
        let (columns, side) = (width as usize, format.block_side());
        let mut planes = Vec::with_capacity(channels);
        for _ in 0..channels {
            planes.push(zeros::<f32>(columns * height as usize * depth as usize)?);
        }
        let mut bytes = zeros::<u8>(format.row_bytes(width) as usize)?;
        let mut texels = zeros::<f32>(columns * side as usize * channels)?;
        let mut start = 0;
        for _ in 0..depth {
            for top in (0..height).step_by(side as usize) {
                content.read_exact(&mut bytes).map_err(|error| damaged(format!("its texels: {error}")))?;
                self.decode_row(columns, &bytes, &mut texels);
                let count = columns * side.min(height - top) as usize;
                for (plane, texels) in planes.iter_mut().zip(texels.chunks_exact(columns * side as usize)) {
                    plane[start..start + count].copy_from_slice(&texels[..count]);
                }
                start += count;
            }
        }
        if content.read(&mut [0]).map_err(|error| damaged(format!("its texels: {error}")))? != 0 {
            return Err(damaged("a level holds more than its texels"));
        }
        Ok(planes)
    }

    fn decode_row(&self, columns: usize, bytes: &[u8], texels: &mut [f32]) {
        if self.format.is_block_compressed() {
            return blocks::decompress_row(self.format, columns, bytes, texels);
        }
        let sample = self.format.sample();
        for (channel, texels) in texels.chunks_exact_mut(columns).enumerate() {
            for (texel, bytes) in texels.iter_mut().zip(bytes.chunks_exact(self.format.block_bytes())) {
                *texel = sample.decode(&bytes[channel * sample.bytes()..][..sample.bytes()]);
            }
        }
    }
}

fn damaged(what: impl ToString) -> ReadProblem {
    ReadProblem::damaged(NAME, what)
}

fn unsupported(what: &str) -> ReadProblem {
    ReadProblem::Unsupported { what: what.to_owned(), advice: "convert it to a plain KTX2 texture" }
}

fn io_problem(error: std::io::Error) -> ReadProblem {
    match error.kind() {
        std::io::ErrorKind::UnexpectedEof => damaged("it ends too early"),
        _ => ReadProblem::Io(error),
    }
}
