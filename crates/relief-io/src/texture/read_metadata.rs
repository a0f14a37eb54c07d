//! Reader of the metadata in texture files.

use std::io::{BufRead, Read, Seek, SeekFrom};

use super::metadata::{EXR_ATTRIBUTE, Metadata};
use crate::input::{io_problem, zeros};
use crate::layout::Format;
use crate::source::SourceReader;
use crate::{ReadError, ReadProblem, Source, ktx2};

/// Greatest number of bytes of metadata that are read from a file.
const MOST_BYTES: u64 = 1 << 20;

/// Greatest number of attributes before the one sought in an EXR header: more than any program
/// writes.
const MOST_ATTRIBUTES: usize = 1000;

/// Reads only the metadata of a PNG, EXR or KTX2 file that this crate has written, or of the bytes
/// of one. Files without metadata return none.
///
/// # Errors
///
/// When the file cannot be read, is in none of these formats, is damaged before the end of its
/// metadata, or holds more than 1 MiB of them.
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
        [0x89, b'P', b'N', b'G', ..] => of_png(file, MOST_BYTES as usize),
        [0x76, 0x2f, 0x31, 0x01, ..] => of_exr(file, file_len),
        found if found == ::ktx2::MAGIC => ktx2::metadata(&mut file, file_len),
        _ => Err(ReadProblem::Unrecognised),
    }
}

/// Reads the texts of a PNG. Compressed texts are unpacked as long as all texts together have at
/// most `most` bytes. A longer text, or one that cannot be unpacked, belongs to another program and
/// is skipped.
fn of_png(file: SourceReader<'_>, most: usize) -> Result<Metadata, ReadProblem> {
    let problem = |error| match error {
        png::DecodingError::IoError(error) => io_problem(Format::Png, error),
        other => ReadProblem::damaged(Format::Png.name(), other),
    };
    let limits = png::Limits { bytes: MOST_BYTES as usize };
    let mut decoder = png::Decoder::new_with_limits(file, limits);
    decoder.set_ignore_iccp_chunk(true);
    let reader = decoder.read_info().map_err(problem)?;
    let (mut entries, mut left) = (Vec::new(), most);
    for mut chunk in reader.info().utf8_text.iter().cloned() {
        if chunk.decompress_text_with_limit(left).is_err() {
            continue;
        }
        let text = chunk.get_text().map_err(|error| ReadProblem::damaged(Format::Png.name(), error))?;
        left = left.saturating_sub(text.len());
        entries.push((chunk.keyword, text));
    }
    Ok(Metadata::found(entries))
}

/// Walks the attributes of the first header ("OpenEXR File Layout", openexr.com) up to `relief`.
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
            let lines = String::from_utf8(lines).map_err(|_| damaged("its metadata are not text"))?;
            return Ok(Metadata::from_lines(&lines));
        }
        file.seek_relative(length as i64).map_err(problem)?;
    }
    Err(damaged("it has too many attributes"))
}

/// Reads a name of at most 255 bytes that ends with a zero byte.
fn exr_name(file: &mut SourceReader<'_>) -> Result<Vec<u8>, ReadProblem> {
    let mut name = Vec::new();
    file.by_ref().take(256).read_until(0, &mut name).map_err(|error| io_problem(Format::Exr, error))?;
    match name.pop() {
        Some(0) => Ok(name),
        _ => Err(ReadProblem::damaged(Format::Exr.name(), "a name has no end")),
    }
}

#[cfg(test)]
mod tests {
    use png::text_metadata::ITXtChunk;

    use super::*;

    /// Picture with the given texts, compressed or not.
    fn picture(texts: &[(&str, usize, bool)]) -> Vec<u8> {
        let mut bytes = Vec::new();
        let mut writer = png::Encoder::new(&mut bytes, 1, 1).write_header().expect("a header");
        for &(name, length, compressed) in texts {
            let mut chunk = ITXtChunk::new(name, "a".repeat(length));
            chunk.compressed = compressed;
            writer.write_text_chunk(&chunk).expect("written");
        }
        writer.write_image_data(&[0]).expect("written");
        drop(writer);
        bytes
    }

    #[test]
    fn compressed_texts_of_a_picture_are_unpacked_up_to_a_limit() {
        let lengths = |texts: &[(&str, usize, bool)], most: usize| -> Vec<(String, usize)> {
            let bytes = picture(texts);
            let (file, _) = Source::bytes("a.png", &bytes).open().expect("readable");
            let found = of_png(file, most).expect("a picture");
            found.iter().map(|(name, text)| (name.to_owned(), text.len())).collect()
        };
        let one = |name: &str, length: usize| (name.to_owned(), length);
        assert_eq!(lengths(&[("x", 300, true)], 300), [one("x", 300)]);
        assert!(lengths(&[("x", 301, true)], 300).is_empty());
        // A text that is too long does not hide others, and together they stay within the limit.
        let many = [("a", 200, false), ("b", 5000, true), ("c", 90, true), ("d", 20, true), ("e", 10, true)];
        assert_eq!(lengths(&many, 300), [one("a", 200), one("c", 90), one("e", 10)]);
        // An uncompressed text is as long as its part of the file.
        assert_eq!(lengths(&[("x", 301, false)], 300), [one("x", 301)]);
        // A text that cannot be unpacked does not affect others.
        let mut bytes = picture(&[("a", 10, false), ("b", 50, true)]);
        let at = bytes.windows(7).position(|part| part == b"iTXtb\0\x01").expect("the chunk") + 9;
        let length_at = at - 13;
        let length = u32::from_be_bytes(bytes[length_at..length_at + 4].try_into().expect("four")) as usize;
        bytes[at + 3..length_at + 8 + length].fill(0xff);
        let mut crc = flate2::Crc::new();
        crc.update(&bytes[length_at + 4..length_at + 8 + length]);
        bytes[length_at + 8 + length..][..4].copy_from_slice(&crc.sum().to_be_bytes());
        let (file, _) = Source::bytes("a.png", &bytes).open().expect("readable");
        assert_eq!(of_png(file, 300).expect("a picture").get("a").map(str::len), Some(10));
    }
}
