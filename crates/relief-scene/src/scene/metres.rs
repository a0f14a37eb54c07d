//! Limit of lengths and coordinates in a scene.

use super::{ValueError, ValueProblem};

/// Largest length and coordinate in metres, a million kilometres. The shaders multiply four of them
/// in `f32`. Much larger ones would overflow there, and the picture would be empty without an
/// error.
pub(super) const MAX_METRES: f64 = 1e9;

/// Refuses lengths and coordinates that overflow in `f32` arithmetic.
pub(super) fn check_metres(key: &'static str, lengths_m: &[f64]) -> Result<(), ValueError> {
    match lengths_m.iter().find(|length| !(-MAX_METRES..=MAX_METRES).contains(*length)) {
        Some(&value) => Err(ValueProblem::Number { value, must: "from -1e9 to 1e9 metres" }.of(key)),
        None => Ok(()),
    }
}
