//! Apexes of a texel, and the steepest slope from any of them to the surface around a vertex.

use pulp::Simd;

use super::field::RelativeCell;
use super::slope::{Patch, inside_segment, may_peak_inside};

/// The most apexes of a texel.
pub(crate) const APEXES: usize = 8;

/// One number for each apex.
pub(crate) type PerApex = [f64; APEXES];

/// Greatest of squared slopes.
#[inline(always)]
pub(super) fn most(slopes: &PerApex) -> f64 {
    slopes.iter().fold(0.0, |most, &slope2| if slope2 > most { slope2 } else { most })
}

/// Places of a texel's apexes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Region {
    /// At the texel's centre.
    Centre,
    /// Anywhere in the texel's square.
    Footprint,
}

impl Region {
    /// Returns half the side of the box of apexes, in texels.
    pub const fn half(self) -> f64 {
        match self {
            Region::Centre => 0.0,
            Region::Footprint => 0.5,
        }
    }

    /// Returns the number of apexes that suffice.
    pub const fn count(self) -> usize {
        match self {
            Region::Centre => 1,
            Region::Footprint => APEXES,
        }
    }

    /// Returns the place of an apex in metres from the texel's centre.
    pub fn apex_m(self, apex: usize, texel_m: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|axis| f64::from(RIM[apex][axis]) * self.half() * texel_m[axis])
    }
}

/// Apexes of a footprint, in order along the rim of the texel's square: columns and rows from the
/// centre, in halves of its side.
pub(super) const RIM: [[i8; 2]; APEXES] =
    [[-1, -1], [0, -1], [1, -1], [1, 0], [1, 1], [0, 1], [-1, 1], [-1, 0]];

/// A bit for each apex.
const APEX_BITS: [u64; APEXES] = [1, 2, 4, 8, 16, 32, 64, 128];

/// Places of the apexes of every texel. These apexes suffice by the proof of
/// [`cone_ratios`](crate::kind::cone::cone_ratios).
pub(crate) struct ApexGeometry {
    pub region: Region,
    pub texel_m: [f64; 2],
    per_side: [f64; 2],
    /// Places in metres from the texel's centre along `u` and `v`, in the order of [`RIM`]; 0
    /// without a footprint.
    at_m: [PerApex; 2],
}

/// Apexes of one texel.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Apexes {
    /// The texel.
    pub texel: [i64; 2],
    /// Heights of the apexes; without a footprint, all are the centre's height.
    pub heights: PerApex,
    /// Height of the centre.
    pub centre: f64,
    /// Lowest height.
    pub low: f64,
}

impl Apexes {
    #[inline(always)]
    pub fn new(texel: [i64; 2], heights: PerApex, centre: f64) -> Self {
        Self { texel, heights, centre, low: heights.into_iter().fold(centre, f64::min) }
    }
}

impl ApexGeometry {
    pub fn new(region: Region, texel_m: [f64; 2]) -> Self {
        let at_m = [0, 1].map(|axis| std::array::from_fn(|apex| region.apex_m(apex, texel_m)[axis]));
        Self { region, texel_m, per_side: texel_m.map(|side| 1.0 / side), at_m }
    }

    /// Metres along an axis from the apexes to a vertex `by` texels away.
    #[inline(always)]
    fn place<S: Simd>(&self, simd: S, by: [i64; 2], axis: usize, part: usize) -> S::f64s {
        let to = simd.splat_f64s(by[axis] as f64 * self.texel_m[axis]);
        simd.sub_f64s(to, S::as_simd_f64s(&self.at_m[axis]).0[part])
    }

    /// Squared metres along an axis to cells that begin at those places.
    #[inline(always)]
    fn gap2<S: Simd>(&self, simd: S, from: S::f64s, axis: usize) -> S::f64s {
        let zero = simd.splat_f64s(0.0);
        let to = simd.add_f64s(from, simd.splat_f64s(self.texel_m[axis]));
        let gap = simd.max_f64s(simd.max_f64s(from, simd.sub_f64s(zero, to)), zero);
        simd.mul_f64s(gap, gap)
    }

    /// Returns squared slopes from the apexes to a vertex `by` texels away.
    #[inline(always)]
    pub fn to_vertex<S: Simd>(&self, simd: S, apexes: &Apexes, by: [i64; 2], height: f64) -> PerApex {
        let mut slopes = [0.0; APEXES];
        for (part, slopes) in S::as_mut_simd_f64s(&mut slopes).0.iter_mut().enumerate() {
            let (x, y) = (self.place(simd, by, 0, part), self.place(simd, by, 1, part));
            let rise = simd.sub_f64s(simd.splat_f64s(height), S::as_simd_f64s(&apexes.heights).0[part]);
            let rise = simd.max_f64s(rise, simd.splat_f64s(0.0));
            let squared = simd.add_f64s(simd.mul_f64s(x, x), simd.mul_f64s(y, y));
            *slopes = simd.div_f64s(simd.mul_f64s(rise, rise), squared);
        }
        slopes
    }

    /// Returns squared slopes from the apexes to the steepest point strictly inside an edge:
    /// [`inside_segment`] for all apexes at once. The edge leads from a vertex `by` texels away to
    /// the next one along an axis.
    #[inline(always)]
    pub fn to_edge<S: Simd>(
        &self,
        simd: S,
        apexes: &Apexes,
        by: [i64; 2],
        axis: usize,
        heights: [f64; 2],
    ) -> PerApex {
        let (zero, side) = (simd.splat_f64s(0.0), self.texel_m[axis]);
        let beta = simd.splat_f64s((heights[1] - heights[0]) / side);
        let mut slopes = [0.0; APEXES];
        for (part, slopes) in S::as_mut_simd_f64s(&mut slopes).0.iter_mut().enumerate() {
            let (from, beside) = (self.place(simd, by, axis, part), self.place(simd, by, 1 - axis, part));
            let to = simd.add_f64s(from, simd.splat_f64s(side));
            let squared = simd.mul_f64s(beside, beside);
            let rise = simd.sub_f64s(simd.splat_f64s(heights[0]), S::as_simd_f64s(&apexes.heights).0[part]);
            let alpha = simd.sub_f64s(rise, simd.mul_f64s(beta, from));
            let scaled = simd.mul_f64s(beta, squared);
            let inside = simd.and_m64s(
                simd.and_m64s(simd.less_than_f64s(zero, squared), simd.less_than_f64s(zero, alpha)),
                simd.and_m64s(
                    simd.less_than_f64s(simd.mul_f64s(from, alpha), scaled),
                    simd.less_than_f64s(scaled, simd.mul_f64s(to, alpha)),
                ),
            );
            let far = simd.div_f64s(simd.mul_f64s(alpha, alpha), squared);
            *slopes = simd.select_f64s(inside, simd.add_f64s(simd.mul_f64s(beta, beta), far), zero);
        }
        slopes
    }

    /// Returns a lower bound of the squared slope to one end of a segment, as a part of the squared
    /// slope to any of its points: see [`super::walk`]. The segment is `length_m` long. Along
    /// either axis it is nowhere farther than `reach` texels from the vertex `by` texels away.
    /// Without a bound, the result is not positive.
    #[inline(always)]
    pub fn turn(&self, by: [i64; 2], reach: f64, length_m: f64) -> f64 {
        let gap =
            |axis: usize| (by[axis].abs() as f64 - reach - self.region.half()).max(0.0) * self.texel_m[axis];
        1.0 - 0.25 * length_m * length_m / (gap(0) * gap(0) + gap(1) * gap(1))
    }

    /// Returns the apexes, a bit each, from which the inside of a cell may be steeper than its
    /// edges and than `best`.
    #[inline(always)]
    pub fn may_peak_inside<S: Simd>(&self, simd: S, apexes: &Apexes, cell: &RelativeCell, best: f64) -> u64 {
        let mut bits = [0u64; APEXES];
        // Written out: a closure within `map` would not be compiled for the vectors.
        let [h00, h10, h01, h11] = cell.heights;
        let corners =
            [simd.splat_f64s(h00), simd.splat_f64s(h10), simd.splat_f64s(h01), simd.splat_f64s(h11)];
        let best = simd.splat_f64s(best);
        for (part, bits) in S::as_mut_simd_u64s(&mut bits).0.iter_mut().enumerate() {
            let x = self.place(simd, cell.offset, 0, part);
            let y = self.place(simd, cell.offset, 1, part);
            let gap2 = simd.add_f64s(self.gap2(simd, x, 0), self.gap2(simd, y, 1));
            let apex = S::as_simd_f64s(&apexes.heights).0[part];
            let may = may_peak_inside(simd, corners, apex, [x, y], self.per_side, gap2, best);
            *bits = simd.select_u64s(may, S::as_simd_u64s(&APEX_BITS).0[part], simd.splat_u64s(0));
        }
        bits.into_iter().fold(0, |all, bit| all | bit)
    }

    /// Returns squared metres from a box of offsets in texels to the box of apexes.
    #[inline(always)]
    pub fn distance2(&self, from: [f64; 2], to: [f64; 2]) -> f64 {
        let half = self.region.half();
        let gap = |axis: usize| (from[axis] - half).max(-half - to[axis]).max(0.0) * self.texel_m[axis];
        gap(0) * gap(0) + gap(1) * gap(1)
    }

    /// Returns the heights of the 3 by 3 points at -1, 0 and 1 times half the side of the box of
    /// apexes, row by row.
    pub fn grid(&self, apexes: &Apexes) -> [[f64; 3]; 3] {
        let mut grid = [[apexes.centre; 3]; 3];
        for ([column, row], height) in RIM.into_iter().zip(apexes.heights) {
            grid[(row + 1) as usize][(column + 1) as usize] = height;
        }
        grid
    }

    /// Returns a cell relative to an apex.
    #[inline(always)]
    pub fn patch(&self, apexes: &Apexes, apex: usize, cell: &RelativeCell) -> Patch {
        Patch {
            corner: [0, 1].map(|axis| cell.offset[axis] as f64 * self.texel_m[axis] - self.at_m[axis][apex]),
            size: self.texel_m,
            rise: cell.heights.map(|height| height - apexes.heights[apex]),
        }
    }

    /// Returns the squared slope to a vertex from the steepest point inside the piece of the rim
    /// that follows an apex.
    pub fn rim_slope2(&self, apexes: &Apexes, apex: usize, vertex: [i64; 2], height: f64) -> f64 {
        let mut ends = [apex, (apex + 1) % APEXES];
        // Half of the rim runs backward; a segment runs forward.
        if RIM[ends[0]] > RIM[ends[1]] {
            ends.reverse();
        }
        let along = usize::from(RIM[ends[0]][0] == RIM[ends[1]][0]);
        let place = |end: usize, axis: usize| self.at_m[axis][end] - vertex[axis] as f64 * self.texel_m[axis];
        let rise = ends.map(|end| height - apexes.heights[end]);
        inside_segment(rise, place(ends[0], along), place(ends[1], along), place(ends[0], 1 - along))
    }
}
