//! Rounding of slopes to the safe side.

/// Factor that raises a slope in `f64` by more than the rounding of a difference and a quotient has
/// lowered it.
const RAISE: f64 = 1.0 + 1.0 / (1u64 << 50) as f64;

/// Factor that lowers slopes. With three roundings of 2⁻²⁴ in `f32`, no node that matters is
/// skipped.
pub const CAUTION: f32 = 1.0 - 1.0 / (1u32 << 20) as f32;

/// Steepest possible slope: heights differ by 1 at most, and the nearest point that counts is half
/// a texel away.
const STEEPEST: f32 = 2.0;

/// Returns the least `f32` that is surely not below the slope whose rounded value is given.
#[inline]
pub fn round_up(slope: f64) -> f32 {
    let raised = slope * RAISE;
    let nearest = raised as f32;
    if f64::from(nearest) < raised { nearest.next_up().min(STEEPEST) } else { nearest }
}
