//! Text files: byte order marks, encodings and line ends.

use crate::ReadProblem;

/// Byte order mark of UTF-8, which Windows editors write at the beginning of a text.
pub(crate) const MARK: &[u8] = b"\xef\xbb\xbf";

/// Advice for a text in UTF-16 that is read by bytes.
const ADVICE: &str = "save it as UTF-8";

/// Byte order of a text in UTF-16, from the mark at its beginning.
fn utf16_order(bytes: &[u8]) -> Option<fn([u8; 2]) -> u16> {
    match bytes {
        [0xff, 0xfe, ..] => Some(u16::from_le_bytes),
        [0xfe, 0xff, ..] => Some(u16::from_be_bytes),
        _ => None,
    }
}

/// Returns the bytes of a text after its byte order mark.
///
/// # Errors
///
/// When the mark says that the text is UTF-16.
pub(crate) fn without_mark(bytes: &[u8]) -> Result<&[u8], ReadProblem> {
    if utf16_order(bytes).is_some() {
        return Err(ReadProblem::Unsupported { what: "text in UTF-16".into(), advice: ADVICE });
    }
    Ok(bytes.strip_prefix(MARK).unwrap_or(bytes))
}

/// Decodes a short text: UTF-8, with or without a byte order mark, or UTF-16 with one. A single
/// carriage return, the line end of old systems, becomes a line feed.
///
/// ```
/// let lines = relief_io::decode_text(b"\xef\xbb\xbfa = 1\rb = 2\r".to_vec());
/// assert_eq!(lines.as_deref(), Some("a = 1\nb = 2\n"));
/// ```
///
/// None if the bytes are not such a text.
pub fn decode_text(bytes: Vec<u8>) -> Option<String> {
    let text = match utf16_order(&bytes) {
        Some(order) => {
            let (units, []) = bytes[2..].as_chunks::<2>() else { return None };
            char::decode_utf16(units.iter().map(|&unit| order(unit))).collect::<Result<String, _>>().ok()?
        }
        None if bytes.starts_with(MARK) => std::str::from_utf8(&bytes[MARK.len()..]).ok()?.to_owned(),
        None => String::from_utf8(bytes).ok()?,
    };
    let mut ended = String::with_capacity(text.len());
    let mut characters = text.chars().peekable();
    while let Some(character) = characters.next() {
        let stands_alone = character == '\r' && characters.peek() != Some(&'\n');
        ended.push(if stands_alone { '\n' } else { character });
    }
    Some(ended)
}

/// Returns the length of the first line with its end: a line feed, a carriage return, or both. The
/// whole length if there is no line end.
pub(crate) fn line_len(bytes: &[u8]) -> usize {
    match bytes.iter().position(|byte| matches!(byte, b'\n' | b'\r')) {
        Some(at) if bytes[at..].starts_with(b"\r\n") => at + 2,
        Some(at) => at + 1,
        None => bytes.len(),
    }
}
