//! [`relief_fuzz::READ_VOLUME`] for libFuzzer.

#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    (relief_fuzz::READ_VOLUME.run)(bytes);
});
