//! Parser of an EXR header, which trusts no length in it.
//!
//! Layout after "OpenEXR File Layout" (openexr.com): magic number; version and flags; attributes as
//! name, type, length and value; an empty name at the end. Multi-part files have several headers
//! and an empty one at the end. One table of chunk offsets for each part follows.

use std::io::{Read, Seek, SeekFrom};

use exr::prelude::{Compression, SampleType as ExrSample};
use relief_core::{HeightMap, MAX_SIDE};

use super::part::{ExrChannel, Part};
use crate::ReadProblem;
use crate::input::{io_problem, zeros};
use crate::layout::Format;
use crate::source::SourceReader;

/// Greatest length of a name in files with the flag for long names.
const MAX_NAME: usize = 255;

/// Greatest length of a channel list in bytes: some 2000 channels with short names. With
/// [`MAX_PARTS`] it bounds the memory that a hostile header can take.
const MAX_CHANNEL_BYTES: u64 = 1 << 16;

/// Greatest number of parts, more than any picture has.
const MAX_PARTS: usize = 256;

/// Coordinates beyond this overflow in the format's own arithmetic.
const MAX_COORDINATE: i64 = 1 << 30;

const FLAG_TILED: u32 = 1 << 9;
const FLAG_DEEP: u32 = 1 << 11;
const FLAG_MULTIPART: u32 = 1 << 12;

/// All headers of a file.
pub(super) struct FileHeader {
    pub multipart: bool,
    pub parts: Vec<Part>,
    /// Offset of the first offset table in the file.
    tables_start: u64,
    /// Least possible offset of the first chunk.
    pub chunks_start: u64,
    pub file_len: u64,
}

impl FileHeader {
    pub(super) fn read(file: &mut SourceReader<'_>, file_len: u64) -> Result<Self, ReadProblem> {
        let mut reader = AttributeReader { file, file_len, position: 0 };
        reader.bytes::<4>()?;
        let version = u32::from_le_bytes(reader.bytes()?);
        if version & 0xff != 2 {
            return Err(unsupported("a version of the format other than 2".into()));
        }
        if version & FLAG_DEEP != 0 {
            return Err(unsupported("deep data (several samples a texel)".into()));
        }
        let multipart = version & FLAG_MULTIPART != 0;
        let mut parts = Vec::new();
        if multipart {
            while let Some(part) = reader.part(true, false)? {
                parts.push(part);
                if parts.len() > MAX_PARTS {
                    return Err(damaged("it has too many parts"));
                }
            }
        } else {
            parts.extend(reader.part(false, version & FLAG_TILED != 0)?);
        }
        if parts.is_empty() {
            return Err(damaged("it has no part"));
        }
        let tables_start = reader.position;
        let entries = parts.iter().map(|part| part.table_len).sum::<u64>();
        let chunks_start = entries.checked_mul(8).and_then(|bytes| bytes.checked_add(tables_start));
        match chunks_start {
            Some(chunks_start) if chunks_start <= file_len => {
                Ok(Self { multipart, parts, tables_start, chunks_start, file_len })
            }
            _ => Err(damaged("it is shorter than its table of blocks")),
        }
    }

    /// Reads the offsets of a part's blocks of the first resolution level, from top left to bottom
    /// right.
    pub(super) fn offset_table(
        &self,
        index: usize,
        file: &mut SourceReader<'_>,
    ) -> Result<Vec<u64>, ReadProblem> {
        let before = self.parts[..index].iter().map(|part| part.table_len).sum::<u64>();
        let problem = |error| io_problem(Format::Exr, error);
        file.seek(SeekFrom::Start(self.tables_start + 8 * before)).map_err(problem)?;
        let mut offsets = zeros::<u64>(self.parts[index].chunks() as usize)?;
        for offset in &mut offsets {
            let mut bytes = [0; 8];
            file.read_exact(&mut bytes).map_err(problem)?;
            *offset = u64::from_le_bytes(bytes);
        }
        Ok(offsets)
    }
}

/// Attributes of one part, collected while its header is read.
#[derive(Default)]
struct PartAttributes {
    name: Option<String>,
    kind: Option<String>,
    channels: Option<Vec<ExrChannel>>,
    compression: Option<Compression>,
    window: Option<[i64; 4]>,
    display_window: Option<[i64; 4]>,
    tiles: Option<([u32; 2], u8)>,
    chunk_count: Option<u64>,
}

struct AttributeReader<'a, 'b> {
    file: &'a mut SourceReader<'b>,
    file_len: u64,
    position: u64,
}

impl AttributeReader<'_, '_> {
    fn bytes<const N: usize>(&mut self) -> Result<[u8; N], ReadProblem> {
        let mut bytes = [0; N];
        self.file.read_exact(&mut bytes).map_err(|error| io_problem(Format::Exr, error))?;
        self.position += N as u64;
        Ok(bytes)
    }

    /// Reads a name that ends with a zero byte.
    fn name(&mut self) -> Result<String, ReadProblem> {
        let mut name = String::new();
        loop {
            match self.bytes::<1>()? {
                [0] => return Ok(name),
                _ if name.chars().count() >= MAX_NAME => return Err(damaged("a name is too long")),
                [byte] => name.push(char::from(byte)),
            }
        }
    }

    /// Reads the whole value of an attribute.
    fn value(&mut self, length: u64, most: u64) -> Result<Vec<u8>, ReadProblem> {
        if length > most {
            return Err(damaged("an attribute is too long"));
        }
        let mut bytes = zeros(length as usize)?;
        self.file.read_exact(&mut bytes).map_err(|error| io_problem(Format::Exr, error))?;
        self.position += length;
        Ok(bytes)
    }

    fn fixed<const N: usize>(&mut self, length: u64) -> Result<[u8; N], ReadProblem> {
        if length != N as u64 {
            return Err(damaged("an attribute has a wrong length"));
        }
        self.bytes()
    }

    /// Reads one header; none at the end of a multi-part file's list.
    fn part(&mut self, multipart: bool, tiled: bool) -> Result<Option<Part>, ReadProblem> {
        let mut attributes = PartAttributes::default();
        let mut first = true;
        loop {
            let name = self.name()?;
            if name.is_empty() {
                if first && multipart {
                    return Ok(None);
                }
                return attributes.part(multipart, tiled).map(Some);
            }
            first = false;
            self.name()?;
            let length = u64::try_from(i32::from_le_bytes(self.bytes()?))
                .ok()
                .filter(|length| self.position + length <= self.file_len)
                .ok_or_else(|| damaged("an attribute is longer than the file"))?;
            self.attribute(&name, length, &mut attributes)?;
        }
    }

    fn attribute(&mut self, name: &str, length: u64, part: &mut PartAttributes) -> Result<(), ReadProblem> {
        match name {
            "channels" => part.channels = Some(channel_list(&self.value(length, MAX_CHANNEL_BYTES)?)?),
            "compression" => {
                let [code] = self.fixed(length)?;
                part.compression = Some(compression(code)?);
            }
            "dataWindow" | "displayWindow" => {
                let bytes = self.fixed::<16>(length)?;
                let (numbers, _) = bytes.as_chunks::<4>();
                let window = [0, 1, 2, 3].map(|i| i64::from(i32::from_le_bytes(numbers[i])));
                let place = if name == "dataWindow" { &mut part.window } else { &mut part.display_window };
                *place = Some(window);
            }
            "tiles" => {
                let [a, b, c, d, e, f, g, h, mode] = self.fixed(length)?;
                part.tiles =
                    Some(([u32::from_le_bytes([a, b, c, d]), u32::from_le_bytes([e, f, g, h])], mode));
            }
            "chunkCount" => {
                part.chunk_count = u64::try_from(i32::from_le_bytes(self.fixed(length)?)).ok();
            }
            "name" | "type" => {
                let bytes = self.value(length, MAX_NAME as u64)?;
                *(if name == "name" { &mut part.name } else { &mut part.kind }) =
                    Some(bytes.into_iter().map(char::from).collect());
            }
            _ => {
                let skip = i64::try_from(length).map_err(|_| damaged("an attribute is too long"))?;
                self.file.seek_relative(skip).map_err(|error| io_problem(Format::Exr, error))?;
                self.position += length;
            }
        }
        Ok(())
    }
}

impl PartAttributes {
    fn part(self, multipart: bool, tiled: bool) -> Result<Part, ReadProblem> {
        let missing = |what: &str| damaged(&format!("it lacks the attribute '{what}'"));
        let channels = self.channels.ok_or_else(|| missing("channels"))?;
        let compression = self.compression.ok_or_else(|| missing("compression"))?;
        let [left, top, right, bottom] = self.window.ok_or_else(|| missing("dataWindow"))?;
        if [left, top, right, bottom].iter().any(|coordinate| coordinate.abs() > MAX_COORDINATE) {
            return Err(damaged("its data window lies too far out"));
        }
        let side = |first: i64, last: i64| u32::try_from(last - first + 1).unwrap_or(0);
        let size = [side(left, right), side(top, bottom)];
        HeightMap::check_size(size[0], size[1])?;
        let tiled = match self.kind.as_deref() {
            Some("deepscanline" | "deeptile") => {
                return Err(unsupported("deep data (several samples a texel)".into()));
            }
            Some("tiledimage") => true,
            Some("scanlineimage") => false,
            _ => tiled,
        };
        let mut levels = 0;
        let tiles = if tiled {
            let (tile, mode) = self.tiles.ok_or_else(|| missing("tiles"))?;
            if tile.iter().any(|side| !(1..=MAX_SIDE).contains(side)) {
                return Err(damaged("its tiles have an impossible size"));
            }
            levels = mode & 0x0f;
            Some([tile[0].min(size[0]), tile[1].min(size[1])])
        } else {
            None
        };
        let mut part = Part {
            name: self.name.filter(|_| multipart),
            channels,
            compression,
            size,
            data_window: [left, top, right, bottom],
            display_window: self.display_window,
            tiles,
            table_len: 0,
        };
        let first_level = part.chunks();
        // Only the offsets of later tables and of the chunks depend on the number of all entries.
        part.table_len = match self.chunk_count {
            Some(count) if count >= first_level && (levels != 0 || count == first_level) => count,
            Some(_) => return Err(damaged("its number of blocks contradicts its size")),
            None if multipart => return Err(missing("chunkCount")),
            None => first_level,
        };
        Ok(part)
    }
}

fn channel_list(bytes: &[u8]) -> Result<Vec<ExrChannel>, ReadProblem> {
    let mut channels = Vec::new();
    let mut rest = bytes;
    while let Some(end) = rest.iter().take(MAX_NAME + 1).position(|&byte| byte == 0).filter(|&end| end > 0) {
        let (name, after) = rest.split_at(end);
        let Some((&[_, kind, _, _, _, linear, _, _, _, x0, x1, x2, x3, y0, y1, y2, y3], after)) =
            after.split_first_chunk()
        else {
            return Err(damaged("its channel list is cut off"));
        };
        let name: String = name.iter().copied().map(char::from).collect();
        let sample = match kind {
            0 => ExrSample::U32,
            1 => ExrSample::F16,
            2 => ExrSample::F32,
            other => {
                return Err(damaged(&format!("the channel '{name}' has the unknown type {other}")));
            }
        };
        let sampling = [i32::from_le_bytes([x0, x1, x2, x3]), i32::from_le_bytes([y0, y1, y2, y3])];
        if sampling != [1, 1] {
            let what = format!("the channel '{name}' at a lower resolution than the picture");
            return Err(unsupported(what));
        }
        channels.push(ExrChannel { name, sample, quantize_linearly: linear != 0 });
        rest = after;
    }
    match (channels.is_empty(), rest) {
        (false, [0]) => Ok(channels),
        _ => Err(damaged("its channel list is damaged")),
    }
}

fn compression(code: u8) -> Result<Compression, ReadProblem> {
    Ok(match code {
        0 => Compression::Uncompressed,
        1 => Compression::RLE,
        2 => Compression::ZIP1,
        3 => Compression::ZIP16,
        4 => Compression::PIZ,
        5 => Compression::PXR24,
        6 => Compression::B44,
        7 => Compression::B44A,
        8 => Compression::DWAA(None),
        9 => Compression::DWAB(None),
        10 | 11 => return Err(unsupported("HTJ2K compression".into())),
        12 => return Err(newer("LJ2K")),
        13 => return Err(newer("ZSTD")),
        other => return Err(damaged(&format!("it has the unknown compression {other}"))),
    })
}

fn damaged(what: &str) -> ReadProblem {
    ReadProblem::damaged("EXR", what)
}

/// Problem for a compression of OpenEXR 3.5, which is newer than this reader.
fn newer(name: &str) -> ReadProblem {
    unsupported(format!("{name} compression, which is newer than this program"))
}

fn unsupported(what: String) -> ReadProblem {
    ReadProblem::Unsupported {
        what,
        advice: "export a flat EXR file, version 2, ZIP compressed, channels at full size",
    }
}
