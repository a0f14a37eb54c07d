//! GLBs taken apart, by nothing of what reads them.

use serde_json::Value;

/// The JSON and the buffer of a GLB, whose lengths fit.
///
/// # Panics
///
/// When they do not.
pub fn parts(bytes: &[u8]) -> (Value, &[u8]) {
    let word = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().expect("four bytes")) as usize;
    let json = word(12);
    assert_eq!((word(8), json % 4, &bytes[24 + json..28 + json]), (bytes.len(), 0, &b"BIN\0"[..]));
    assert_eq!(word(20 + json), bytes.len() - json - 28);
    (serde_json::from_slice(&bytes[20..20 + json]).expect("JSON"), &bytes[28 + json..])
}

/// The indices of the first primitive of a mesh.
///
/// # Panics
///
/// When there are none, or they lie beyond the buffer.
pub fn indices(json: &Value, buffer: &[u8], mesh: usize) -> Vec<u32> {
    let number = |of: &Value, name: &str| of[name].as_u64().unwrap_or_default() as usize;
    let accessor = &json["accessors"][number(&json["meshes"][mesh]["primitives"][0], "indices")];
    let view = &json["bufferViews"][number(accessor, "bufferView")];
    let from = number(view, "byteOffset");
    let bytes = &buffer[from..from + number(view, "byteLength")];
    assert_eq!(bytes.len(), 4 * number(accessor, "count"));
    bytes.chunks_exact(4).map(|word| u32::from_le_bytes(word.try_into().expect("four bytes"))).collect()
}
