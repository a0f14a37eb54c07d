//! Any bytes as a normal map's file: an error or unit vectors, never a crash, never more memory than allowed.

#![no_main]

use std::io::Write;

use libfuzzer_sys::fuzz_target;
use relief_io::{GreenSign, read_normal_map};

/// Enough for every small file, and far below the fuzzer's own limit.
const MAX_BYTES: u64 = 64 << 20;

fuzz_target!(|bytes: &[u8]| {
    // The first byte chooses the sign, the rest is the file.
    let Some((&choice, bytes)) = bytes.split_first() else { return };
    let Ok(mut file) = tempfile::NamedTempFile::new() else { return };
    if file.write_all(bytes).and_then(|()| file.flush()).is_err() {
        return;
    }
    let green = if choice & 1 == 0 { GreenSign::PlusY } else { GreenSign::MinusY };
    if let Ok(map) = read_normal_map(file.path(), green, MAX_BYTES) {
        assert_eq!(map.normals.len(), map.width as usize * map.height as usize);
        for [x, y, z] in map.normals {
            assert!(((x * x + y * y + z * z).sqrt() - 1.0).abs() < 1e-5, "{x} {y} {z}");
        }
    }
});
