//! The steepest slopes from the apexes of a texel to the cells around its centre, for a few texels at once.
//!
//! Where everything is relative to the apexes is the same for all texels, so all that depends on it is worked out once.

use pulp::Simd;

use super::apexes::{APEXES, Apexes, RIM, Region};
use super::field::{Field, Seen};
use super::slope::may_peak_inside;
use super::walk::LANES;

/// Cells of the block to each side of the centre. A cell beyond is at least 2½ texels away, from where its corners tell nearly
/// all about it; fewer, and most texels have to look into some of those; more, and the block takes longer than they do.
pub(in crate::kind) const REACH: usize = 3;

/// Vertices along a side of the block.
const SIDE: usize = 2 * REACH + 1;

/// Cells along a side of the block, and all of them.
const CELLS_ACROSS: usize = 2 * REACH;
const CELLS: usize = CELLS_ACROSS * CELLS_ACROSS;

/// Numbers of vertices have no other bits: the compiler then knows that they are within an array of so many.
const MASK: usize = (SIDE * SIDE).next_power_of_two() - 1;

/// The centre's place in the block.
const CENTRE: usize = SIDE * SIDE / 2;

/// One number for each texel.
pub(in crate::kind) type Lanes = [f64; LANES];

/// For each apex and each texel a set of cells of the block, a bit each.
pub(in crate::kind) type CellSets = [[u64; LANES]; APEXES];

/// Whether a cell at that offset from a texel is in its block.
#[inline(always)]
pub(in crate::kind) fn is_in_block(cell: [i64; 2]) -> bool {
    cell.iter().all(|x| (-(REACH as i64)..REACH as i64).contains(x))
}

/// Whether all cells around a vertex at that offset are.
#[inline(always)]
pub(in crate::kind) fn is_inside_block(vertex: [i64; 2]) -> bool {
    vertex.iter().all(|x| x.abs() < REACH as i64)
}

/// The heights around texels side by side.
pub(in crate::kind) struct Block {
    /// Of the vertices, row by row.
    vertices: [Lanes; SIDE * SIDE],
    /// Of the apexes, in the order of [`RIM`]; the centre alone without a footprint.
    apexes: [Lanes; APEXES],
}

impl Block {
    /// The heights around the texels from the one given; columns beyond the last texel are read as they come.
    #[inline(always)]
    pub fn new(field: &Field, texel: [i64; 2], region: Region) -> Self {
        let mut vertices = [[0.0; LANES]; SIDE * SIDE];
        let reach = REACH as i64;
        for (row, vertices) in vertices.chunks_exact_mut(SIDE).enumerate() {
            let heights: [f64; LANES + SIDE - 1] =
                field.row([texel[0] - reach, texel[1] + row as i64 - reach]);
            for (column, vertex) in vertices.iter_mut().enumerate() {
                vertex.copy_from_slice(&heights[column..column + LANES]);
            }
        }
        let mut apexes = [vertices[CENTRE]; APEXES];
        if region == Region::Footprint {
            for (heights, [column, row]) in apexes.iter_mut().zip(RIM) {
                // Halfway to the neighbours along one axis or both; along an axis without a step both are the centre.
                let place = |column: i8, row: i8| {
                    (CENTRE as isize + isize::from(row) * SIDE as isize + isize::from(column)) as usize
                };
                let corners = [place(0, 0), place(column, 0), place(0, row), place(column, row)];
                for (lane, height) in heights.iter_mut().enumerate() {
                    let [h00, h10, h01, h11] = corners.map(|corner| vertices[corner][lane]);
                    *height = 0.5 * (0.5 * (h00 + h10) + 0.5 * (h01 + h11));
                }
            }
        }
        Self { vertices, apexes }
    }

    /// The apexes of one of the texels.
    #[inline(always)]
    pub fn apexes(&self, lane: usize, texel: [i64; 2]) -> Apexes {
        Apexes::new(texel, self.apexes.each_ref().map(|lanes| lanes[lane]), self.vertices[CENTRE][lane])
    }

    /// The 3 by 3 vertices around the centre of one of the texels, row by row.
    pub fn around(&self, lane: usize) -> [[f64; 3]; 3] {
        [-1, 0, 1].map(|row: isize| {
            [-1, 0, 1].map(|column: isize| {
                self.vertices[(CENTRE as isize + row * SIDE as isize + column) as usize][lane]
            })
        })
    }

    /// A cell of the block, counted row by row, as seen from one of the texels.
    pub fn cell(&self, lane: usize, cell: usize) -> Seen {
        let (column, row) = (cell % CELLS_ACROSS, cell / CELLS_ACROSS);
        let first = row * SIDE + column;
        let corners = [first, first + 1, first + SIDE, first + SIDE + 1];
        Seen {
            offset: [column, row].map(|place| place as i64 - REACH as i64),
            heights: corners.map(|vertex| self.vertices[vertex][lane]),
        }
    }

    /// All cells of the block as seen from one of the texels.
    pub fn cells(&self, lane: usize) -> impl Iterator<Item = Seen> + '_ {
        (0..CELLS).map(move |cell| self.cell(lane, cell))
    }
}

/// The block's geometry, in metres.
pub(in crate::kind) struct Near {
    region: Region,
    /// One over the sides of a texel.
    per_side: [f64; 2],
    to_vertices: Vec<ToVertex>,
    to_edges: Vec<ToEdge>,
    from_rim: Vec<ToEdge>,
    to_cells: Vec<ToCell>,
}

/// From an apex to a vertex.
struct ToVertex {
    apex: usize,
    vertex: usize,
    /// One over the squared distance.
    closeness2: f64,
}

/// From an apex to an edge between two vertices; or from an edge between two apexes to a vertex, seen from the vertex.
struct ToEdge {
    /// The apex, or the vertex.
    from: usize,
    /// The two vertices, or apexes.
    ends: [usize; 2],
    /// Where they are along the edge.
    places: [f64; 2],
    /// One over the edge's length.
    per_length: f64,
    /// Squared distance from the edge's line, and one over it.
    beside2: f64,
    closeness2: f64,
}

/// From an apex to a cell that does not hold it.
struct ToCell {
    apex: usize,
    /// The bit of the cell in a set, and its corner `h00` among the vertices.
    bit: u64,
    vertex: usize,
    /// Corner `h00` from the apex.
    corner: [f64; 2],
    /// Squared distance from the apex.
    gap2: f64,
}

impl ToEdge {
    fn new(from: usize, mut ends: [usize; 2], origin: [f64; 2], places: [[f64; 2]; 2]) -> Option<Self> {
        let along = usize::from(places[0][0] == places[1][0]);
        let beside = places[0][1 - along] - origin[1 - along];
        // On the edge's own line the slope has no maximum but at an end.
        if beside == 0.0 {
            return None;
        }
        let mut along_edge = places.map(|place| place[along] - origin[along]);
        if along_edge[0] > along_edge[1] {
            along_edge.reverse();
            ends.reverse();
        }
        Some(Self {
            from,
            ends,
            places: along_edge,
            per_length: 1.0 / (along_edge[1] - along_edge[0]),
            beside2: beside * beside,
            closeness2: 1.0 / (beside * beside),
        })
    }
}

impl Near {
    /// For texels of that size, in metres, and the cells of the block not farther than `reach` vertices from the centre; from the rim to the
    /// vertices not farther than `rim_reach`.
    pub fn new(texel_m: [f64; 2], region: Region, reach: usize, rim_reach: usize) -> Self {
        let apexes: Vec<[f64; 2]> = (0..region.count()).map(|apex| region.apex_m(apex, texel_m)).collect();
        let offset = |vertex: usize| [vertex % SIDE, vertex / SIDE].map(|place| place as f64 - REACH as f64);
        let place = |vertex: usize| [0, 1].map(|axis| offset(vertex)[axis] * texel_m[axis]);
        let mut near = Self {
            region,
            per_side: texel_m.map(|side| 1.0 / side),
            to_vertices: Vec::new(),
            to_edges: Vec::new(),
            from_rim: Vec::new(),
            to_cells: Vec::new(),
        };
        let is_within = |vertex: usize, reach: usize| offset(vertex).iter().all(|x| x.abs() <= reach as f64);
        for vertex in (0..SIDE * SIDE).filter(|vertex| is_within(*vertex, reach)) {
            let is_last = offset(vertex).map(|place| place == reach as f64);
            let right = (!is_last[0]).then_some(vertex + 1);
            let below = (!is_last[1]).then_some(vertex + SIDE);
            for end in right.into_iter().chain(below) {
                for (apex, &at) in apexes.iter().enumerate() {
                    near.to_edges.extend(ToEdge::new(apex, [vertex, end], at, [vertex, end].map(place)));
                }
            }
            for (apex, &at) in apexes.iter().enumerate() {
                let [x, y] = [0, 1].map(|axis| place(vertex)[axis] - at[axis]);
                let [right, down] = [x + texel_m[0], y + texel_m[1]];
                if x != 0.0 || y != 0.0 {
                    near.to_vertices.push(ToVertex { apex, vertex, closeness2: 1.0 / (x * x + y * y) });
                }
                let holds = x <= 0.0 && right >= 0.0 && y <= 0.0 && down >= 0.0;
                if is_last == [false; 2] && !holds {
                    near.to_cells.push(ToCell {
                        apex,
                        bit: 1 << (vertex / SIDE * CELLS_ACROSS + vertex % SIDE),
                        vertex,
                        corner: [x, y],
                        gap2: x.max(-right).max(0.0).powi(2) + y.max(-down).max(0.0).powi(2),
                    });
                }
            }
            if region == Region::Footprint && is_within(vertex, rim_reach) {
                for apex in 0..APEXES {
                    let ends = [apex, (apex + 1) % APEXES];
                    near.from_rim.extend(ToEdge::new(
                        vertex,
                        ends,
                        place(vertex),
                        ends.map(|end| apexes[end]),
                    ));
                }
            }
        }
        near
    }

    /// Squared slopes of the steepest rises to vertices and edges of the block, and from the rim to the vertices inside it; and
    /// the cells whose inside may be steeper than their edges.
    #[inline(always)]
    pub fn slopes2<S: Simd>(&self, simd: S, block: &Block) -> (Lanes, CellSets) {
        let mut best = self.own_slopes2(block);
        let mut sets = [[0; LANES]; APEXES];
        let lanes = |lanes: &Lanes, part: usize| S::as_simd_f64s(lanes).0[part];
        let zero = simd.splat_f64s(0.0);
        for part in 0..LANES / S::F64_LANES {
            let mut apexes = [zero; APEXES];
            for (apex, heights) in apexes.iter_mut().zip(&block.apexes) {
                *apex = lanes(heights, part);
            }
            let mut vertices = [zero; MASK + 1];
            for (vertex, heights) in vertices.iter_mut().zip(&block.vertices) {
                *vertex = lanes(heights, part);
            }
            let mut steepest = lanes(&best, part);
            for rule in &self.to_vertices {
                let rise = simd.sub_f64s(vertices[rule.vertex & MASK], apexes[rule.apex % APEXES]);
                let rise = simd.max_f64s(rise, zero);
                let slope2 = simd.mul_f64s(simd.mul_f64s(rise, rise), simd.splat_f64s(rule.closeness2));
                steepest = simd.max_f64s(slope2, steepest);
            }
            for rule in &self.to_edges {
                let apex = apexes[rule.from % APEXES];
                let [a, b] = rule.ends;
                let rise = (simd.sub_f64s(vertices[a & MASK], apex), simd.sub_f64s(vertices[b & MASK], apex));
                steepest = simd.max_f64s(rule.slope2(simd, rise), steepest);
            }
            for rule in &self.from_rim {
                let vertex = vertices[rule.from & MASK];
                let [a, b] = rule.ends;
                let rise =
                    (simd.sub_f64s(vertex, apexes[a % APEXES]), simd.sub_f64s(vertex, apexes[b % APEXES]));
                steepest = simd.max_f64s(rule.slope2(simd, rise), steepest);
            }
            for rule in &self.to_cells {
                let vertex = |by: usize| vertices[(rule.vertex + by) & MASK];
                let corners = [vertex(0), vertex(1), vertex(SIDE), vertex(SIDE + 1)];
                let corner = [simd.splat_f64s(rule.corner[0]), simd.splat_f64s(rule.corner[1])];
                let apex = apexes[rule.apex % APEXES];
                let gap2 = simd.splat_f64s(rule.gap2);
                let may = may_peak_inside(simd, corners, apex, corner, self.per_side, gap2, steepest);
                let sets = &mut S::as_mut_simd_u64s(&mut sets[rule.apex % APEXES]).0[part];
                let bit = simd.select_u64s(may, simd.splat_u64s(rule.bit), simd.splat_u64s(0));
                *sets = simd.or_u64s(*sets, bit);
            }
            S::as_mut_simd_f64s(&mut best).0[part] = steepest;
        }
        (best, sets)
    }

    /// Squared slopes of the patches themselves around the apexes: of every direction for a footprint, of those into the
    /// patch for a centre.
    #[inline(always)]
    fn own_slopes2(&self, block: &Block) -> Lanes {
        let mut best: Lanes = [0.0; LANES];
        let centre = &block.vertices[CENTRE];
        for [x, y] in [[-1, -1], [1, -1], [-1, 1], [1, 1]] {
            let at = |column: isize, row: isize| {
                &block.vertices[(CENTRE as isize + row * SIDE as isize + column) as usize]
            };
            let (aside, ahead, beyond) = (at(x, 0), at(0, y), at(x, y));
            for lane in 0..LANES {
                let along_x = (aside[lane] - centre[lane]) * self.per_side[0];
                let along_y = (ahead[lane] - centre[lane]) * self.per_side[1];
                let slope2 = if self.region == Region::Footprint {
                    // The slopes along an axis are linear along the other: greatest at the centre or half a texel away.
                    let half_x = 0.5 * (along_x + (beyond[lane] - ahead[lane]) * self.per_side[0]);
                    let half_y = 0.5 * (along_y + (beyond[lane] - aside[lane]) * self.per_side[1]);
                    (along_x * along_x).max(half_x * half_x) + (along_y * along_y).max(half_y * half_y)
                } else if along_x > 0.0 && along_y > 0.0 {
                    along_x * along_x + along_y * along_y
                } else {
                    // A gradient that leaves the patch is left to its edges.
                    0.0
                };
                best[lane] = best[lane].max(slope2);
            }
        }
        best
    }
}

impl ToEdge {
    /// Squared slope to the steepest point strictly inside the edge, for the rises of its ends: see
    /// [`super::slope::inside_segment`], of which this is the part that depends on heights.
    #[inline(always)]
    fn slope2<S: Simd>(&self, simd: S, rise: (S::f64s, S::f64s)) -> S::f64s {
        let times = |x: S::f64s, y: f64| simd.mul_f64s(x, simd.splat_f64s(y));
        let beta = times(simd.sub_f64s(rise.1, rise.0), self.per_length);
        let alpha = simd.sub_f64s(rise.0, times(beta, self.places[0]));
        let scaled = times(beta, self.beside2);
        let inside = simd.and_m64s(
            simd.less_than_f64s(simd.splat_f64s(0.0), alpha),
            simd.and_m64s(
                simd.less_than_f64s(times(alpha, self.places[0]), scaled),
                simd.less_than_f64s(scaled, times(alpha, self.places[1])),
            ),
        );
        let squared = times(simd.mul_f64s(alpha, alpha), self.closeness2);
        simd.select_f64s(inside, simd.add_f64s(simd.mul_f64s(beta, beta), squared), simd.splat_f64s(0.0))
    }
}
