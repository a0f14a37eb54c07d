//! Cells and nodes that, towards them, are nowhere steeper than what was found.

use pulp::Simd;

use super::super::apexes::{APEXES, RIM};
use super::super::lanes::{COLUMNS, LANE_BITS, LANES};
use super::{Group, Walk};

/// What rounding may add, in parts of heights and of what a cone rises to them.
const ROUNDING: f64 = 1e-14;

/// A box over which nothing is higher than what is bilinear between its corners.
#[derive(Clone, Copy)]
pub(crate) struct Bilinear {
    /// Its sides, in columns and rows from the group's first texel.
    pub from: [f64; 2],
    pub to: [f64; 2],
    /// The heights `h00 h10 h01 h11` of its corners.
    pub heights: [f64; 4],
}

impl Walk<'_> {
    /// The lanes, a bit each, for which a point of the box may be steeper than what was found, from any of
    /// their apexes.
    ///
    /// Let `n` be a direction, and `S` the slope found. No point `q` is steeper from `p` if `f(q) - f(p) ≤ S
    /// n·(q - p)`, as that is at most `S |q - p|`. Either side, `f(q) - S n·q` and `f(p) - S n·p`, is
    /// bilinear: the one over the box, the other over each quarter of the texel's square. So corners tell.
    /// The direction is that to the box's middle; then of a box far away, or on ground inclined towards it,
    /// little is lost.
    #[inline(always)]
    pub fn may_be_steeper<S: Simd>(&self, simd: S, group: &Group, seen: &Bilinear) -> u64 {
        let splat = |x: f64| simd.splat_f64s(x);
        let [side_u, side_v] = self.texel_m;
        let centre_v = 0.5 * (seen.from[1] + seen.to[1]) * side_v;
        let half_u = 0.5 * (seen.to[0] - seen.from[0]) * side_u;
        let size_m = half_u.abs() + 0.5 * (seen.to[1] - seen.from[1]).abs() * side_v;
        let half = f64::from(self.half);
        let mut lanes = [0u64; LANES];
        for (part, lanes) in S::as_mut_simd_u64s(&mut lanes).0.iter_mut().enumerate() {
            let by = S::as_simd_f64s(&COLUMNS).0[part];
            let best = S::as_simd_f64s(&group.slope).0[part];
            let (left, right) =
                (simd.sub_f64s(splat(seen.from[0]), by), simd.sub_f64s(splat(seen.to[0]), by));
            let x = simd.add_f64s(simd.mul_f64s(left, splat(side_u)), splat(half_u));
            let y = splat(centre_v);
            let far = simd.sqrt_f64s(simd.add_f64s(simd.mul_f64s(x, x), simd.mul_f64s(y, y)));
            let slope = simd.div_f64s(best, far);
            // Heights a texel along both axes.
            let along_u = simd.mul_f64s(simd.mul_f64s(slope, x), splat(side_u));
            let along_v = simd.mul_f64s(simd.mul_f64s(slope, y), splat(side_v));
            let [to_left, to_right] = [simd.mul_f64s(along_u, left), simd.mul_f64s(along_u, right)];
            let to_top = simd.mul_f64s(along_v, splat(seen.from[1]));
            let to_bottom = simd.mul_f64s(along_v, splat(seen.to[1]));
            let [h00, h10, h01, h11] = seen.heights;
            let above = simd.max_f64s(
                simd.sub_f64s(
                    simd.max_f64s(simd.sub_f64s(splat(h00), to_left), simd.sub_f64s(splat(h10), to_right)),
                    to_top,
                ),
                simd.sub_f64s(
                    simd.max_f64s(simd.sub_f64s(splat(h01), to_left), simd.sub_f64s(splat(h11), to_right)),
                    to_bottom,
                ),
            );
            // The lowest apex, so inclined.
            let mut low = S::as_simd_f64s(&group.centres).0[part];
            if half > 0.0 {
                let (half_u, half_v) =
                    (simd.mul_f64s(along_u, splat(half)), simd.mul_f64s(along_v, splat(half)));
                for (apex, heights) in group.apexes.iter().enumerate().take(APEXES) {
                    let [column, row] = RIM[apex].map(|step| splat(f64::from(step)));
                    let to = simd.add_f64s(simd.mul_f64s(half_u, column), simd.mul_f64s(half_v, row));
                    low = simd.min_f64s(low, simd.sub_f64s(S::as_simd_f64s(heights).0[part], to));
                }
            }
            let cone = simd.mul_f64s(best, simd.add_f64s(far, splat(size_m)));
            let rounding = simd.mul_f64s(simd.add_f64s(cone, splat(1.0)), splat(ROUNDING));
            // Of a box around the lane's texel nothing is told: its direction is no number.
            let is_below = simd.less_than_or_equal_f64s(simd.add_f64s(above, rounding), low);
            *lanes = simd.select_u64s(is_below, simd.splat_u64s(0), S::as_simd_u64s(&LANE_BITS).0[part]);
        }
        lanes.into_iter().fold(0, |all, bit| all | bit)
    }
}
