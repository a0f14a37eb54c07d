//! Fall of a patch away from apexes, told apart from level ground by signs that no rounding
//! changes.
//!
//! At a point `q` a patch falls, seen from `p`, by the slope `F = ∇f(q)·(q - p)`. In texels, `F` is
//! a sum of two products of a difference of heights and a difference of places. Along level ground,
//! such as a terrace, it is exactly 0, and rounding must not turn this into a fall. Nor must
//! rounding hide a fall.

use crate::cone_search::RelativeCell;

/// Rounding of a sum of two products, as a part of the sum of their sizes.
pub(super) const ROUNDING: f64 = 1e-14;

/// Rise from one height to another.
#[derive(Clone, Copy)]
struct Rise {
    by: f64,
    /// Whether `by` is the exact difference. Heights are `f32`, so it is exact unless one of them
    /// is tiny.
    is_exact: bool,
}

impl Rise {
    fn new(from: f64, to: f64) -> Self {
        let by = to - from;
        Self { by, is_exact: from + by == to && to - by == from }
    }
}

/// Returns `F` at the corners `h00 h10 h01 h11` of a cell: the least over all apexes up to `half`
/// texels from the texel's centre along each axis. Over the whole cell, it has its least value at
/// one of the corners.
///
/// Where the result is not negative, it is not negative without rounding either. Where it is 0
/// without rounding, it is 0, unless a height is tiny beside another.
pub(super) fn falls(cell: &RelativeCell, half: f64) -> [f64; 4] {
    let [h00, h10, h01, h11] = cell.heights;
    let [x, y] = cell.offset.map(|offset| offset as f64);
    let (above, below) = (Rise::new(h00, h10), Rise::new(h01, h11));
    let (left, right) = (Rise::new(h00, h01), Rise::new(h10, h11));
    [
        towards([above, left], [x, y], half),
        towards([above, right], [x + 1.0, y], half),
        towards([below, left], [x, y + 1.0], half),
        towards([below, right], [x + 1.0, y + 1.0], half),
    ]
}

/// Returns `F` at a corner with these rises of the patch along the axes, for the apex from which it
/// is least.
fn towards([along_x, along_y]: [Rise; 2], [x, y]: [f64; 2], half: f64) -> f64 {
    let (x, y) = (x - half.copysign(along_x.by), y - half.copysign(along_y.by));
    let (p, q) = (along_x.by * x, along_y.by * y);
    let (sum, rounding) = (p + q, ROUNDING * (p.abs() + q.abs()));
    if p == 0.0 || q == 0.0 || sum.abs() > rounding {
        return sum;
    }
    if !(along_x.is_exact && along_y.is_exact) {
        return -rounding;
    }
    // The products nearly cancel, so their sum is exact. Only the parts rounded off the products
    // are missing.
    sum + (along_x.by.mul_add(x, -p) + along_y.by.mul_add(y, -q))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn falls_of(offset: [i64; 2], heights: [f32; 4], half: f64) -> [f64; 4] {
        falls(&RelativeCell { offset, heights: heights.map(f64::from) }, half)
    }

    #[test]
    fn level_ground_and_contours_do_not_fall_and_a_last_bit_does() {
        assert_eq!(falls_of([5, -3], [0.7; 4], 0.5), [0.0; 4]);
        // A plane, seen along the contour through two of its corners.
        let third = 1.0f32 / 3.0;
        let [f00, f10, f01, f11] = falls_of([1, -2], [0.0, third, third, 2.0 * third], 0.0);
        assert!(f00 < 0.0 && f10 == 0.0 && f01 == 0.0 && f11 > 0.0, "{:?}", [f00, f10, f01, f11]);
        // The last bit less at a corner, and it falls beside it.
        let [_, _, f01, _] = falls_of([1, -2], [0.0, third, third, (2.0 * third).next_down()], 0.0);
        assert!(f01 < 0.0);
        // A difference that is rounded is not taken for level.
        let [f00, ..] = falls_of([1, -1], [1e-30, 1.0, 1.0, 1.0], 0.0);
        assert!(f00 < 0.0);
    }

    #[test]
    fn the_least_over_the_apexes_is_half_a_texel_ahead() {
        let [f00, f10, f01, f11] = falls_of([2, 0], [0.0, 1.0, 0.5, 1.0], 0.5);
        assert_eq!([f00, f10, f01, f11], [1.5 - 0.25, 2.5, 0.75 + 0.25, 1.25]);
    }
}
