//! [`relief_fuzz::MESH`] for libFuzzer.

#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    (relief_fuzz::MESH.run)(bytes);
});
