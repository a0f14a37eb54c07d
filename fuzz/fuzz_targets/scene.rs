//! [`relief_fuzz::SCENE`] for libFuzzer.

#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    (relief_fuzz::SCENE.run)(bytes);
});
