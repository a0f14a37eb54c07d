//! Any bytes as a height map's file: an error or a valid map, never a crash, never more memory than allowed.

#![no_main]

use std::io::Write;

use libfuzzer_sys::fuzz_target;
use relief_io::{Fill, HeightOptions, read_height};

/// Enough for every small file, and far below the fuzzer's own limit.
const MAX_BYTES: u64 = 64 << 20;

fuzz_target!(|bytes: &[u8]| {
    // The first byte chooses the options, the rest is the file.
    let Some((&choice, bytes)) = bytes.split_first() else { return };
    let Ok(mut file) = tempfile::NamedTempFile::new() else { return };
    if file.write_all(bytes).and_then(|()| file.flush()).is_err() {
        return;
    }
    let channel = match choice & 3 {
        0 => None,
        1 => Some("r".to_owned()),
        2 => Some("a".to_owned()),
        _ => Some("y".to_owned()),
    };
    let fill = if choice & 4 != 0 { Fill::Always } else { Fill::Never };
    let options = HeightOptions { channel, fill, max_bytes: MAX_BYTES, ..HeightOptions::default() };
    if let Ok(map) = read_height(file.path(), &options) {
        assert!(map.texels().iter().all(|texel| (0.0..=1.0).contains(texel)));
    }
});
