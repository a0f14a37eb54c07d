//! [`relief_fuzz::OBJECT`] for libFuzzer.

#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    (relief_fuzz::OBJECT.run)(bytes);
});
