//! Container of GLB: the JSON and a buffer in one file.

use super::damaged;
use crate::ReadProblem;
use crate::text::without_mark;

const HEADER: usize = 12;
const CHUNK_HEADER: usize = 8;

/// Returns the JSON of a file, and the buffer inside a GLB.
pub(super) fn split(bytes: &[u8]) -> Result<(&[u8], Option<&[u8]>), ReadProblem> {
    if !bytes.starts_with(b"glTF") {
        return Ok((without_mark(bytes)?, None));
    }
    let version = word(bytes, 4)?;
    if version != 2 {
        let what = format!("version {version} of GLB");
        return Err(ReadProblem::Unsupported { what, advice: "export it as glTF 2.0" });
    }
    let len = word(bytes, 8)? as usize;
    let file = bytes
        .get(..len)
        .ok_or_else(|| damaged(format!("its header says {len} bytes, but the file has {}", bytes.len())))?;
    let (json, next) = chunk(file, HEADER, b"JSON")?.ok_or_else(|| damaged("it has no JSON"))?;
    let binary = chunk(file, next, b"BIN\0")?.map(|(binary, _)| binary);
    Ok((json, binary))
}

/// Returns the length of the JSON of a GLB from its first bytes, if the JSON follows directly.
pub(in crate::mesh) fn json_len(beginning: &[u8]) -> Option<u64> {
    let is_glb = beginning.starts_with(b"glTF") && word(beginning, 4).ok()? == 2;
    let is_json = beginning.get(HEADER + 4..HEADER + CHUNK_HEADER)? == b"JSON";
    (is_glb && is_json).then_some(u64::from(word(beginning, HEADER).ok()?))
}

/// Returns the chunk at an offset and the offset of the next one; none at the end of the file, or
/// if the chunk is of another kind.
fn chunk<'a>(file: &'a [u8], at: usize, kind: &[u8; 4]) -> Result<Option<(&'a [u8], usize)>, ReadProblem> {
    if at >= file.len() {
        return Ok(None);
    }
    let len = word(file, at)? as usize;
    word(file, at + 4)?;
    let start = at + CHUNK_HEADER;
    let content = file.get(start..).and_then(|rest| rest.get(..len));
    let content = content.ok_or_else(|| damaged(format!("a chunk of {len} bytes reaches beyond its end")))?;
    // Chunks begin at multiples of four bytes.
    let next = (start + len).next_multiple_of(4);
    Ok((file[at + 4..start] == *kind).then_some((content, next)))
}

/// Returns the 32-bit number at an offset.
fn word(bytes: &[u8], at: usize) -> Result<u32, ReadProblem> {
    let word = bytes.get(at..).and_then(|rest| rest.first_chunk());
    word.map(|word| u32::from_le_bytes(*word)).ok_or_else(|| damaged("it ends too early"))
}
