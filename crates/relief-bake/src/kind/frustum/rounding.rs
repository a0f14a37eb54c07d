//! How slopes are rounded to the safe side.

/// What raises a slope in `f64` by more than the roundings of a difference and a quotient have lowered it.
const RAISE: f64 = 1.0 + 1.0 / (1u64 << 50) as f64;

/// Lowers slopes, so that in `f32`, with three roundings of 2⁻²⁴, no node that matters is passed over.
pub const CAUTION: f32 = 1.0 - 1.0 / (1u32 << 20) as f32;

/// No slope is steeper: heights differ by 1 at most, and the nearest that counts is half a texel away.
const STEEPEST: f32 = 2.0;

/// The least `f32` that is surely not below the slope whose rounded value is given.
#[inline]
pub fn round_up(slope: f64) -> f32 {
    let raised = slope * RAISE;
    let nearest = raised as f32;
    if f64::from(nearest) < raised { nearest.next_up().min(STEEPEST) } else { nearest }
}
