//! The adapters that tests run on.

use relief_render::gpu::{AdapterChoice, Gpu};

/// A device of an adapter of that kind. Where there is none the test says that it skips, unless the
/// environment variable `RELIEF_REQUIRE_GPU` is 1.
///
/// # Panics
///
/// When an adapter is required and there is none.
pub fn open(choice: AdapterChoice) -> Option<Gpu> {
    match Gpu::new(choice) {
        Ok(gpu) => Some(gpu),
        Err(error) if std::env::var_os("RELIEF_REQUIRE_GPU").is_some_and(|value| value == "1") => {
            panic!("RELIEF_REQUIRE_GPU is 1: {error}")
        }
        Err(error) => {
            println!("the GPU is skipped: {error}");
            None
        }
    }
}

/// Whether there is any adapter.
///
/// # Panics
///
/// As [`open`].
pub fn has_adapter() -> bool {
    open(AdapterChoice::Any).is_some()
}
