//! Cells and nodes that, in their direction, are nowhere steeper than the best slope.

use pulp::Simd;

use super::super::apexes::{APEXES, RIM};
use super::super::lanes::{COLUMNS, LANE_BITS, LANES};
use super::{Group, Walk};

/// Rounding, as a part of heights and of a cone's rise to them.
const ROUNDING: f64 = 1e-14;

/// Box with an upper bound of the surface in it.
pub(crate) trait UpperBound {
    /// Returns the sides of the box, in columns and rows from the group's first texel.
    fn sides(&self) -> [[f64; 2]; 2];

    /// Returns the greatest height of the bound above a plane through a lane's texel at height 0.
    /// The plane is inclined by `along` heights a texel; the texels are `by` columns from the
    /// group's first.
    fn highest<S: Simd>(&self, simd: S, along: [S::f64s; 2], by: S::f64s) -> S::f64s;
}

/// Box over which the surface is nowhere above the bilinear patch between four corners.
#[derive(Clone, Copy)]
pub(crate) struct Bilinear {
    /// Sides, in columns and rows from the group's first texel.
    pub from: [f64; 2],
    pub to: [f64; 2],
    /// Heights `h00 h10 h01 h11` of its corners.
    pub heights: [f64; 4],
}

impl UpperBound for Bilinear {
    fn sides(&self) -> [[f64; 2]; 2] {
        [[self.from[0], self.to[0]], [self.from[1], self.to[1]]]
    }

    #[inline(always)]
    fn highest<S: Simd>(&self, simd: S, [along_u, along_v]: [S::f64s; 2], by: S::f64s) -> S::f64s {
        let splat = |x: f64| simd.splat_f64s(x);
        let to_left = simd.mul_f64s(along_u, simd.sub_f64s(splat(self.from[0]), by));
        let to_right = simd.mul_f64s(along_u, simd.sub_f64s(splat(self.to[0]), by));
        let to_top = simd.mul_f64s(along_v, splat(self.from[1]));
        let to_bottom = simd.mul_f64s(along_v, splat(self.to[1]));
        let [h00, h10, h01, h11] = self.heights.map(splat);
        let upper = simd.max_f64s(simd.sub_f64s(h00, to_left), simd.sub_f64s(h10, to_right));
        let lower = simd.max_f64s(simd.sub_f64s(h01, to_left), simd.sub_f64s(h11, to_right));
        simd.max_f64s(simd.sub_f64s(upper, to_top), simd.sub_f64s(lower, to_bottom))
    }
}

/// Vertex of the upper hull of a profile, which holds the highest texel of each of a node's
/// columns, or rows.
#[derive(Clone, Copy)]
pub(crate) struct ProfileVertex {
    /// Columns, or rows, behind the node's first one.
    pub place: i32,
    pub height: f32,
}

/// Box over which the surface is nowhere above the upper hull of a profile along an axis.
pub(super) struct Profile<'a> {
    pub sides: [[f64; 2]; 2],
    pub axis: usize,
    pub hull: &'a [ProfileVertex],
    /// Place of the node's first column, or row, and the direction of the next one.
    pub first: f64,
    pub step: f64,
}

impl UpperBound for Profile<'_> {
    fn sides(&self) -> [[f64; 2]; 2] {
        self.sides
    }

    #[inline(always)]
    fn highest<S: Simd>(&self, simd: S, along: [S::f64s; 2], by: S::f64s) -> S::f64s {
        let zero = simd.splat_f64s(0.0);
        // Along the profile's axis, and along the other one.
        let (along, by) =
            if self.axis == 0 { (along, [by, zero]) } else { ([along[1], along[0]], [zero, by]) };
        let to = |axis: usize, place: f64| {
            simd.mul_f64s(along[axis], simd.sub_f64s(simd.splat_f64s(place), by[axis]))
        };
        let mut highest = simd.splat_f64s(f64::NEG_INFINITY);
        for vertex in self.hull {
            let place = self.first + self.step * f64::from(vertex.place);
            let height = simd.splat_f64s(f64::from(vertex.height));
            highest = simd.max_f64s(highest, simd.sub_f64s(height, to(0, place)));
        }
        let [from, end] = self.sides[1 - self.axis];
        simd.sub_f64s(highest, simd.min_f64s(to(1, from), to(1, end)))
    }
}

impl Walk<'_> {
    /// Returns the lanes, a bit each, for which a point of the box may be steeper than the best
    /// slope, from any of their apexes.
    ///
    /// Let `n` be a direction, and `S` the slope found. No point `q` is steeper from `p` if
    /// `f(q) - f(p) ≤ S n·(q - p)`, as the right side is at most `S |q - p|`. Either side,
    /// `f(q) - S n·q` and `f(p) - S n·p`, is bilinear: the one over the box, the other over each
    /// quarter of the texel's square. So corners suffice. The direction is towards the box's
    /// middle. Little is then lost for a box far away, or on ground inclined towards it.
    #[inline(always)]
    pub fn may_be_steeper<S: Simd, A: UpperBound>(&self, simd: S, group: &Group, bounds: &A) -> u64 {
        let splat = |x: f64| simd.splat_f64s(x);
        let [side_u, side_v] = self.texel_m;
        let [columns, rows] = bounds.sides();
        let centre_v = 0.5 * (rows[0] + rows[1]) * side_v;
        let centre_u = 0.5 * (columns[0] + columns[1]);
        let size_m = 0.5 * ((columns[1] - columns[0]) * side_u + (rows[1] - rows[0]) * side_v);
        let half = f64::from(self.half);
        let mut lanes = [0u64; LANES];
        for (part, lanes) in S::as_mut_simd_u64s(&mut lanes).0.iter_mut().enumerate() {
            let by = S::as_simd_f64s(&COLUMNS).0[part];
            let best = S::as_simd_f64s(&group.slope).0[part];
            let x = simd.mul_f64s(simd.sub_f64s(splat(centre_u), by), splat(side_u));
            let y = splat(centre_v);
            let far = simd.sqrt_f64s(simd.add_f64s(simd.mul_f64s(x, x), simd.mul_f64s(y, y)));
            let slope = simd.div_f64s(best, far);
            // Heights a texel along both axes.
            let along_u = simd.mul_f64s(simd.mul_f64s(slope, x), splat(side_u));
            let along_v = simd.mul_f64s(simd.mul_f64s(slope, y), splat(side_v));
            let above = bounds.highest(simd, [along_u, along_v], by);
            // The lowest apex, inclined in the same way.
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
            // A box around the lane's texel is never skipped: its direction is no number.
            let is_below = simd.less_than_or_equal_f64s(simd.add_f64s(above, rounding), low);
            *lanes = simd.select_u64s(is_below, simd.splat_u64s(0), S::as_simd_u64s(&LANE_BITS).0[part]);
        }
        lanes.into_iter().fold(0, |all, bit| all | bit)
    }
}

#[cfg(test)]
mod tests {
    use pulp::Scalar;
    use relief_core::rng::Rng;
    use relief_core::{HeightMap, Wrap};

    use super::super::super::apexes::{Apexes, Region};
    use super::super::super::tie::raised;
    use super::*;

    #[test]
    fn nothing_that_is_passed_over_is_steeper_and_most_that_is_flatter_is_passed_over() {
        let map = HeightMap::from_fn(4, 4, Wrap::Clamp, |_, _| 0.0).expect("a valid map");
        let texel_m = [1.0, 0.7];
        let mut rng = Rng::new(3);
        let (mut over, mut flatter) = (0, 0);
        for case in 0..4000 {
            let region = if case % 2 == 0 { Region::Centre } else { Region::Footprint };
            let walk = Walk::new(&map, texel_m, region);
            let mut group = Group::new();
            group.begin([0, 0]);
            // The surface in the square is a plane.
            let lean = [0.0; 2].map(|_| rng.between(-0.05, 0.05));
            let half = region.half();
            let heights = RIM.map(|[u, v]| half * (lean[0] * f64::from(u) + lean[1] * f64::from(v)));
            walk.lower(&mut group, 0, &Apexes::new([0, 0], heights, 0.0));
            let from = [0.0; 2].map(|_| (rng.between(4.0, 30.0) * rng.pick(&[-1.0, 1.0])).round());
            let side = rng.pick(&[1.0, 8.0]);
            let corners = [0.0; 4].map(|_| rng.between(0.0, 1.0));
            let hull: Vec<_> = (0..=side as i32)
                .map(|place| ProfileVertex { place, height: rng.between(0.0, 1.0) as f32 })
                .collect();
            let bilinear = Bilinear { from, to: from.map(|x| x + side), heights: corners };
            let (axis, step) = (rng.below(2) as usize, rng.pick(&[-1.0, 1.0]));
            let first = from[axis] + if step < 0.0 { side } else { 0.0 };
            let sides = from.map(|x| [x, x + side]);
            let profile = Profile { sides, axis, hull: &hull, first, step };
            let is_profile = rng.below(2) == 0;
            let mut steepest = 0.0f64;
            for _ in 0..400 {
                let part = [0.0; 2].map(|_| rng.pick(&[0.0, 1.0, rng.clone().unit()]));
                let height = if is_profile {
                    let place = if step < 0.0 { 1.0 - part[axis] } else { part[axis] } * side;
                    let (k, rest) = (place.floor().min(side - 1.0), place - place.floor().min(side - 1.0));
                    let [a, b] = [hull[k as usize].height, hull[k as usize + 1].height].map(f64::from);
                    a + (b - a) * rest
                } else {
                    let [h00, h10, h01, h11] = corners;
                    (h00 + (h10 - h00) * part[0]) * (1.0 - part[1]) + (h01 + (h11 - h01) * part[0]) * part[1]
                };
                let apex = [0.0; 2].map(|_| half * rng.pick(&[-1.0, 1.0, rng.clone().between(-1.0, 1.0)]));
                let low = lean[0] * apex[0] + lean[1] * apex[1];
                let to = [0, 1].map(|axis| (from[axis] + side * part[axis] - apex[axis]) * texel_m[axis]);
                steepest = steepest.max((height - low) / to[0].hypot(to[1]));
            }
            let slope = steepest * rng.between(0.8, 1.3);
            walk.raise_bar(&mut group, 0, slope * slope);
            let may = if is_profile {
                walk.may_be_steeper(Scalar::new(), &group, &profile)
            } else {
                walk.may_be_steeper(Scalar::new(), &group, &bilinear)
            };
            let is_over = may & LANE_BITS[0] == 0;
            let stands_for = raised(slope * slope, texel_m);
            assert!(!is_over || stands_for >= steepest, "case {case}: {slope} and {steepest}");
            over += usize::from(is_over);
            flatter += usize::from(slope > steepest);
        }
        assert!(over > flatter / 3, "{over} of {flatter} were passed over");
    }
}
