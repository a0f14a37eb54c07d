//! The adapter that these tests run on.

use std::sync::OnceLock;

use relief_render::gpu::{AdapterChoice, Gpu};

/// A software GPU, shared by all tests; hardware may contract and reorder arithmetic, which these tests do not allow.
/// Without one a test says that it skips, unless the environment variable `RELIEF_REQUIRE_GPU` is 1: then it fails.
pub fn software() -> Option<&'static Gpu> {
    static GPU: OnceLock<Option<Gpu>> = OnceLock::new();
    let gpu = GPU.get_or_init(|| match Gpu::new(AdapterChoice::Software) {
        Ok(gpu) => Some(gpu),
        Err(error) if std::env::var_os("RELIEF_REQUIRE_GPU").is_some_and(|value| value == "1") => {
            panic!("RELIEF_REQUIRE_GPU is 1: {error}")
        }
        Err(error) => {
            println!("skipped: {error}");
            None
        }
    });
    gpu.as_ref()
}
