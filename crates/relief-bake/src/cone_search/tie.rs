//! Slopes that count as equally steep. Otherwise, the rounding of heights would decide which of
//! many equally steep points is steepest, and all of them would be visited.

/// A bound prunes only when it is below the best by more than rounding.
pub(super) const MARGIN: f64 = 1.0 + 1e-9;

/// Relative amount by which slopes are raised, in the search and in the end.
const TIE: f64 = 1.0 + 1.0 / (1u64 << 16) as f64;

/// Further amount by which slopes are raised, in heights a texel. It covers the rounding to 32 bits
/// of two equal slopes. Each is a slope from one height to another, and heights are at most 1.
const STEP: f64 = 1.0 / (1u64 << 23) as f64;

/// Returns the steepest slope that counts as equal to one with that square. A level slope equals no
/// other.
#[inline(always)]
pub(super) fn raised(slope2: f64, texel_m: [f64; 2]) -> f64 {
    if slope2 > 0.0 { slope2.sqrt() * TIE + STEP / texel_m[0].min(texel_m[1]) } else { 0.0 }
}

/// Returns whether the inside of a cell exceeds the steepness of its edges by no more than a tie.
/// `heights` are its corners, and `distance2` is its least squared distance.
///
/// There is a plane from which the patch is nowhere farther than a quarter of its twist, and over a
/// plane the steepest point is on an edge. So the inside is steeper than the edges by half the
/// twist over the distance at most. The edges are visited, each from its own ends.
#[inline(always)]
pub(super) fn is_nearly_flat(heights: [f64; 4], distance2: f64, best: f64, texel_m: [f64; 2]) -> bool {
    let [h00, h10, h01, h11] = heights;
    let twist = (h00 - h10) + (h11 - h01);
    let spare = 2.0 * (raised(best, texel_m) / MARGIN - best.sqrt()).max(0.0);
    twist * twist <= spare * spare * distance2
}
