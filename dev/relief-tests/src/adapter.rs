//! The adapters that tests run on.

use std::sync::OnceLock;

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

/// How much less alike the pictures of the two backends may be than on an adapter that computes as IEEE 754
/// says. Hardware contracts multiplications with additions: its roundings are others, and of the rays that
/// graze something some find what is behind it.
#[derive(Clone, Copy, Debug)]
pub struct Leeway {
    /// Factor for the difference of equal numbers.
    pub rounding: f32,
    /// Factor for the number of pixels that show something else.
    pub outliers: f64,
}

impl Leeway {
    const OF_SOFTWARE: Self = Self { rounding: 1.0, outliers: 1.0 };
    const OF_HARDWARE: Self = Self { rounding: 10.0, outliers: 6.0 };

    /// Leeway of the adapter that [`AdapterChoice::Any`] chooses.
    pub fn of_any() -> Self {
        static LEEWAY: OnceLock<Leeway> = OnceLock::new();
        *LEEWAY.get_or_init(|| match Gpu::new(AdapterChoice::Real) {
            Ok(_) => Self::OF_HARDWARE,
            Err(_) => Self::OF_SOFTWARE,
        })
    }

    /// Share of pixels that must agree, from the share on a software adapter.
    pub fn share(self, of_software: f64) -> f64 {
        1.0 - self.outliers * (1.0 - of_software)
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
