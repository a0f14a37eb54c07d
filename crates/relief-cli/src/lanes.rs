//! SIMD width of the CPU backend, from the environment.

use relief_core::Lanes;

use crate::failure::Failure;

/// Environment variable with the SIMD width: 1, 4, 8 or 16.
const VARIABLE: &str = "RELIEF_LANES";

/// Returns the SIMD width that `RELIEF_LANES` sets, else the widest that the machine has.
pub fn from_environment() -> Result<Lanes, Failure> {
    let Some(text) = std::env::var_os(VARIABLE).filter(|text| !text.is_empty()) else {
        return Ok(Lanes::default());
    };
    let lanes = text.to_string_lossy().parse();
    lanes.map_err(|error: relief_core::LanesError| Failure::usage(format!("{VARIABLE}: {error}")))
}
