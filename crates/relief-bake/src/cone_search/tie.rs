//! Slopes that count as equally steep: else the rounding of heights would decide what is steepest of much
//! that is equally steep, and all of it had to be looked at.

/// A bound prunes only when it is below the best by more than rounding.
pub(super) const MARGIN: f64 = 1.0 + 1e-9;

/// What slopes are raised by, in the search and in the end, relatively.
const TIE: f64 = 1.0 + 1.0 / (1u64 << 16) as f64;

/// What they are raised by beside that, in heights a texel: what rounding to 32 bits may make of two slopes
/// that are equal, when each is that from one height to another, which is below 1.
const STEP: f64 = 1.0 / (1u64 << 23) as f64;

/// The steepest slope that one with that square stands for. What is level stands for nothing else.
#[inline(always)]
pub(super) fn raised(slope2: f64, texel_m: [f64; 2]) -> f64 {
    if slope2 > 0.0 { slope2.sqrt() * TIE + STEP / texel_m[0].min(texel_m[1]) } else { 0.0 }
}

/// Whether the inside of a cell with those corners, at least so far away, can be steeper than its edges by no
/// more than what the steepest one stands for.
///
/// There is a plane from which the patch is nowhere farther than a quarter of its twist, and over a plane the
/// steepest point is on an edge. So the inside is steeper than the edges by half the twist over the distance
/// at most; and the edges are looked at, each from its own ends.
#[inline(always)]
pub(super) fn is_nearly_flat(heights: [f64; 4], distance2: f64, best: f64, texel_m: [f64; 2]) -> bool {
    let [h00, h10, h01, h11] = heights;
    let twist = (h00 - h10) + (h11 - h01);
    let spare = 2.0 * (raised(best, texel_m) / MARGIN - best.sqrt()).max(0.0);
    twist * twist <= spare * spare * distance2
}
