//! How many values the CPU works on at once, as the environment says.

use relief_core::Lanes;

use crate::failure::Failure;

/// The variable: 1, 4, 8 or 16.
const VARIABLE: &str = "RELIEF_LANES";

/// What `RELIEF_LANES` says, or the most that the machine has.
pub fn from_environment() -> Result<Lanes, Failure> {
    let Some(text) = std::env::var_os(VARIABLE).filter(|text| !text.is_empty()) else {
        return Ok(Lanes::default());
    };
    let lanes = text.to_string_lossy().parse();
    lanes.map_err(|error: relief_core::LanesError| Failure::usage(format!("{VARIABLE}: {error}")))
}
