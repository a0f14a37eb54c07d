//! Reads the names and values inside texture files, and nothing else of them.

use std::io::{BufRead, Read, Seek, SeekFrom};

use super::metadata::{EXR_ATTRIBUTE, Metadata};
use crate::input::{io_problem, zeros};
use crate::layout::Format;
use crate::source::SourceReader;
use crate::{ReadError, ReadProblem, Source, ktx2};

/// The most bytes of metadata that are read from a file.
const MOST_BYTES: u64 = 1 << 20;

/// The most attributes before the one sought in an EXR header: more than any program writes.
const MOST_ATTRIBUTES: usize = 1000;

/// Reads the metadata of a PNG, EXR or KTX2 file that this crate has written, or of the bytes of one, and
/// nothing else of it. Files without any give none.
///
/// # Errors
///
/// When the file cannot be read, is none of those formats, is damaged before the end of its metadata, or
/// holds more than 1 MiB of them.
pub fn read_metadata<'a>(source: impl Into<Source<'a>>) -> Result<Metadata, ReadError> {
    let source = source.into();
    read(source).map_err(|problem| source.error(problem))
}

fn read(source: Source<'_>) -> Result<Metadata, ReadProblem> {
    let (mut file, file_len) = source.open()?;
    let mut signature = Vec::new();
    file.by_ref().take(12).read_to_end(&mut signature)?;
    file.seek(SeekFrom::Start(0))?;
    match signature.as_slice() {
        [0x89, b'P', b'N', b'G', ..] => of_png(file),
        [0x76, 0x2f, 0x31, 0x01, ..] => of_exr(file, file_len),
        found if found == ::ktx2::MAGIC => ktx2::metadata(&mut file, file_len),
        _ => Err(ReadProblem::Unrecognised),
    }
}

fn of_png(file: SourceReader<'_>) -> Result<Metadata, ReadProblem> {
    let problem = |error| match error {
        png::DecodingError::IoError(error) => io_problem(Format::Png, error),
        other => ReadProblem::damaged(Format::Png.name(), other),
    };
    let limits = png::Limits { bytes: MOST_BYTES as usize };
    let reader = png::Decoder::new_with_limits(file, limits).read_info().map_err(problem)?;
    let mut entries = Vec::new();
    for chunk in &reader.info().utf8_text {
        let text = chunk.get_text().map_err(|error| ReadProblem::damaged(Format::Png.name(), error))?;
        entries.push((chunk.keyword.clone(), text));
    }
    Ok(Metadata::found(entries))
}

/// Walks the attributes of the first header ("OpenEXR File Layout", openexr.com) up to ours.
fn of_exr(mut file: SourceReader<'_>, file_len: u64) -> Result<Metadata, ReadProblem> {
    let problem = |error| io_problem(Format::Exr, error);
    let damaged = |what: &str| ReadProblem::damaged(Format::Exr.name(), what);
    file.seek(SeekFrom::Start(8)).map_err(problem)?;
    for _ in 0..MOST_ATTRIBUTES {
        let name = exr_name(&mut file)?;
        if name.is_empty() {
            return Ok(Metadata::default());
        }
        let kind = exr_name(&mut file)?;
        let mut length = [0; 4];
        file.read_exact(&mut length).map_err(problem)?;
        let length = u64::from(u32::from_le_bytes(length));
        if length > file_len {
            return Err(damaged("an attribute is longer than the file"));
        }
        if name == EXR_ATTRIBUTE.as_bytes() && kind == b"string" {
            if length > MOST_BYTES {
                return Err(damaged("its metadata are too long"));
            }
            let mut lines = zeros(length as usize)?;
            file.read_exact(&mut lines).map_err(problem)?;
            let lines = String::from_utf8(lines).map_err(|_| damaged("its metadata are no text"))?;
            return Ok(Metadata::from_lines(&lines));
        }
        file.seek_relative(length as i64).map_err(problem)?;
    }
    Err(damaged("it has too many attributes"))
}

/// A name of at most 255 bytes that ends with a zero byte.
fn exr_name(file: &mut SourceReader<'_>) -> Result<Vec<u8>, ReadProblem> {
    let mut name = Vec::new();
    file.by_ref().take(256).read_until(0, &mut name).map_err(|error| io_problem(Format::Exr, error))?;
    match name.pop() {
        Some(0) => Ok(name),
        _ => Err(ReadProblem::damaged(Format::Exr.name(), "a name has no end")),
    }
}
