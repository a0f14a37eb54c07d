//! [`relief_fuzz::BAKE`] for libFuzzer.

#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    (relief_fuzz::BAKE.run)(bytes);
});
