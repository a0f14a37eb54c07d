//! Steepest slopes from the apexes of texels to the cells around them, a few texels at once.
//!
//! Neighbouring texels share most of their apexes: a corner belongs to four squares, the middle of
//! a side to two. Slopes are therefore computed for points of the surface, and each texel takes the
//! steepest of its eight.

use pulp::Simd;

use super::apexes::Region;
use super::block::{Block, CELLS_READ, CENTRE, MASK, SIDE, vertex_at};
use super::field::Field;
use super::lanes::{LANES, Lanes, bits_of};
use super::point::Point;
use super::slope::{Patch, may_peak_inside, steepest_in_quarter, steepest_into};
use super::tie::is_nearly_flat;

/// Squared slopes from the points of a row of texels to the blocks around them. Slopes are in
/// heights per metre.
pub(crate) struct NearRow {
    region: Region,
    /// Squared slopes of the patches themselves at each texel. Entries beyond the last texel are
    /// not used.
    own: Vec<f64>,
    /// Squared slopes from each type of point: for the column before the first texel, then for each
    /// texel. Entries beyond are not used.
    points: [Vec<f64>; 3],
}

impl NearRow {
    /// Creates a row for a map of `width` texels a row. All slopes are 0 until
    /// [`fill`](Self::fill).
    pub fn new(width: usize) -> Self {
        let places = (width + 1).next_multiple_of(LANES) + LANES;
        Self {
            region: Region::Centre,
            own: vec![0.0; places],
            points: [vec![0.0; places], vec![0.0; places], vec![0.0; places]],
        }
    }

    /// Computes the slopes from the texels of row `row` of the map of `field`. Rows beyond the map
    /// have the texels that its wrap gives them.
    #[inline(always)]
    pub fn fill<S: Simd>(&mut self, simd: S, near: &Near, field: &Field, row: i64) {
        self.region = near.region;
        // Centres do not need the column before the first; it is filled for them, too.
        let width = field.map.width() as usize;
        for first in (0..=width).step_by(LANES) {
            let block = Block::new(field, [first as i64 - 1, row]);
            let slopes = near.slopes2(simd, &block);
            for (to, from) in self.points.iter_mut().zip(&slopes) {
                to[first..first + LANES].copy_from_slice(from);
            }
            self.own[first..first + LANES].copy_from_slice(&near.own_slopes2(&block));
        }
    }

    /// Returns the greatest squared slope of each of `count` texels from column `first` on, at most
    /// a vector's lanes. `above` is the row above, filled as well.
    #[inline(always)]
    pub fn of_texels(&self, above: &Self, first: usize, count: usize) -> Lanes {
        let mut best = [0.0; LANES];
        for (lane, best) in best.iter_mut().enumerate().take(count) {
            let (before, place) = (first + lane, first + lane + 1);
            let [right, below, corner] = &self.points;
            let around = if self.region == Region::Centre {
                [right[place]; 8]
            } else {
                [
                    right[place],
                    right[before],
                    below[place],
                    above.points[1][place],
                    corner[place],
                    corner[before],
                    above.points[2][place],
                    above.points[2][before],
                ]
            };
            *best = around.into_iter().fold(self.own[place], f64::max);
        }
        best
    }
}

/// Points whose slopes are computed for a texel, and the geometry around them in metres.
pub(crate) struct Near {
    region: Region,
    /// Sides of a texel, and one over them.
    side_m: [f64; 2],
    per_side: [f64; 2],
    points: Vec<Point>,
}

/// Squared slopes from the points of texels side by side. The points are the centres alone; or the
/// middles of the right sides, the middles of the lower sides, and the lower right corners. The
/// slopes of a side's middle include the slopes from the side's pieces to the nearest vertices.
type PerPoint = [Lanes; 3];

impl Near {
    /// Prepares the points for texels of a size in metres.
    pub fn new(side_m: [f64; 2], region: Region) -> Self {
        let halves: &[[u8; 2]] = match region {
            Region::Centre => &[[0, 0]],
            Region::Footprint => &[[1, 0], [0, 1], [1, 1]],
        };
        Self {
            region,
            side_m,
            per_side: side_m.map(|side| 1.0 / side),
            points: halves.iter().map(|halves| Point::new(*halves, side_m)).collect(),
        }
    }

    /// Returns squared slopes of the steepest rises from the points of texels to the cells near
    /// them.
    #[inline(always)]
    fn slopes2<S: Simd>(&self, simd: S, block: &Block) -> PerPoint {
        let mut slopes = [[0.0; LANES]; 3];
        for (point, slopes) in self.points.iter().zip(&mut slopes) {
            let mut sets = [0u64; LANES];
            for part in 0..LANES / S::F64_LANES {
                let (steepest, set) = self.point_slopes2(simd, point, block, part);
                S::as_mut_simd_f64s(slopes).0[part] = steepest;
                S::as_mut_simd_u64s(&mut sets).0[part] = set;
            }
            for (lane, set) in sets.into_iter().enumerate() {
                for cell in bits_of(set) {
                    let patch = self.patch(point, block, lane, cell / CELLS_READ * SIDE + cell % CELLS_READ);
                    if !is_nearly_flat(patch.rise, patch.distance2(), slopes[lane], self.side_m) {
                        slopes[lane] = patch.inside(slopes[lane]).max(slopes[lane]);
                    }
                }
            }
        }
        slopes
    }

    /// Returns the cell that begins at a vertex, relative to a point of one of the texels.
    fn patch(&self, point: &Point, block: &Block, lane: usize, first: usize) -> Patch {
        let cell = block.cell(lane, first);
        let [a, b, c, d] = point.apexes[1].map(|vertex| block.vertices[vertex][lane]);
        let apex = 0.5 * (0.5 * (a + b) + 0.5 * (c + d));
        Patch {
            corner: [0, 1].map(|axis| (cell.offset[axis] as f64 - point.at[axis]) * self.side_m[axis]),
            size: self.side_m,
            rise: cell.heights.map(|height| height - apex),
        }
    }

    /// Returns squared slopes to vertices and edges and from the rim, for as many texels as a
    /// vector has lanes. Also returns the cells whose inside may be steeper, a bit each.
    #[inline(always)]
    fn point_slopes2<S: Simd>(
        &self,
        simd: S,
        point: &Point,
        block: &Block,
        part: usize,
    ) -> (S::f64s, S::u64s) {
        let zero = simd.splat_f64s(0.0);
        let mut vertices = [zero; MASK + 1];
        for (vertex, heights) in vertices.iter_mut().zip(&block.vertices) {
            *vertex = S::as_simd_f64s(heights).0[part];
        }
        let half = simd.splat_f64s(0.5);
        let mut apexes = [zero; 4];
        for (apex, [a, b, c, d]) in apexes.iter_mut().zip(&point.apexes) {
            let above = simd.add_f64s(vertices[a & MASK], vertices[b & MASK]);
            let below = simd.add_f64s(vertices[c & MASK], vertices[d & MASK]);
            *apex =
                simd.mul_f64s(half, simd.add_f64s(simd.mul_f64s(half, above), simd.mul_f64s(half, below)));
        }
        let apex = apexes[1];
        let mut steepest = zero;
        for rule in &point.to_vertices {
            let rise = simd.max_f64s(simd.sub_f64s(vertices[rule.vertex & MASK], apex), zero);
            let slope2 = simd.mul_f64s(simd.mul_f64s(rise, rise), simd.splat_f64s(rule.closeness2));
            steepest = simd.max_f64s(slope2, steepest);
        }
        for rule in &point.to_edges {
            let [a, b] = rule.ends;
            let rise = (simd.sub_f64s(vertices[a & MASK], apex), simd.sub_f64s(vertices[b & MASK], apex));
            steepest = simd.max_f64s(rule.slope2(simd, rise), steepest);
        }
        for rule in &point.from_rim {
            let vertex = vertices[rule.vertex & MASK];
            let [a, b] = rule.ends;
            let rise = (simd.sub_f64s(vertex, apexes[a & 3]), simd.sub_f64s(vertex, apexes[b & 3]));
            steepest = simd.max_f64s(rule.slope2(simd, rise), steepest);
        }
        let mut set = simd.splat_u64s(0);
        for rule in &point.to_cells {
            let vertex = |by: usize| vertices[(rule.vertex + by) & MASK];
            let corners = [vertex(0), vertex(1), vertex(SIDE), vertex(SIDE + 1)];
            let corner = [simd.splat_f64s(rule.corner[0]), simd.splat_f64s(rule.corner[1])];
            let gap2 = simd.splat_f64s(rule.gap2);
            let may = may_peak_inside(simd, corners, apex, corner, self.per_side, gap2, steepest);
            set = simd.or_u64s(set, simd.select_u64s(may, simd.splat_u64s(rule.bit), simd.splat_u64s(0)));
        }
        (steepest, set)
    }

    /// Returns squared slopes of the patches themselves around the apexes.
    #[inline(always)]
    fn own_slopes2(&self, block: &Block) -> Lanes {
        let mut best: Lanes = [0.0; LANES];
        let centre = &block.vertices[CENTRE];
        for [x, y] in [[-1, -1], [1, -1], [-1, 1], [1, 1]] {
            let [aside, ahead, beyond] =
                [vertex_at(x, 0), vertex_at(0, y), vertex_at(x, y)].map(|vertex| &block.vertices[vertex]);
            for lane in 0..LANES {
                let corners = [centre[lane], aside[lane], ahead[lane], beyond[lane]];
                let slope2 = match self.region {
                    Region::Footprint => steepest_in_quarter(corners, self.per_side),
                    Region::Centre => steepest_into(corners, self.per_side),
                };
                best[lane] = best[lane].max(slope2);
            }
        }
        best
    }
}
