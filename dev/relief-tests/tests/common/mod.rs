//! What several files of tests need.

use relief_render::gpu::{AdapterChoice, Gpu};

/// Whether there is an adapter; where one is required, none is a failure.
pub fn has_adapter() -> bool {
    match Gpu::new(AdapterChoice::Any) {
        Ok(_) => true,
        Err(error) if std::env::var_os("RELIEF_REQUIRE_GPU").is_some_and(|value| value == "1") => {
            panic!("{error}")
        }
        Err(error) => {
            println!("the GPU is skipped: {error}");
            false
        }
    }
}
