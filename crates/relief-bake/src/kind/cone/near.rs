//! The steepest slopes from the apexes of texels to the cells around them, for a few texels at once.
//!
//! Neighbouring texels share most of their apexes: a corner of their squares is that of four, the middle of a side that of two. So it is
//! points of the surface that are worked out here, and each texel takes the steepest of its eight. Where everything is relative to
//! such a point is the same for all texels, so all that depends on it is worked out once for a map.

use pulp::Simd;

use super::apexes::{APEXES, Apexes, RIM, Region};
use super::field::{Field, Seen};
use super::slope::{Patch, may_peak_inside, steepest_in_quarter, steepest_into};
use super::walk::LANES;

/// Cells of the block to each side of a texel's centre. A cell beyond is at least 2½ texels away, from where its corners tell nearly
/// all about it; fewer, and most texels have to look into some of those; more, and the block takes longer than they do.
const REACH: usize = 3;

/// Vertices along a side of what is read: the block, and one more for the texel to the right or below.
const SIDE: usize = 2 * REACH + 2;

/// Numbers of vertices have no other bits: the compiler then knows that they are within an array of so many.
const MASK: usize = (SIDE * SIDE).next_power_of_two() - 1;

/// Cells along a side of the block.
const CELLS_ACROSS: usize = 2 * REACH;

/// Cells along a side of what is read.
const CELLS_READ: usize = SIDE - 1;

/// The centre's place among the vertices.
const CENTRE: usize = REACH * SIDE + REACH;

/// One number for each texel.
pub(in crate::kind) type Lanes = [f64; LANES];

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

/// The vertex so many columns and rows from the centre.
const fn vertex_at(column: isize, row: isize) -> usize {
    (CENTRE as isize + row * SIDE as isize + column) as usize
}

/// The heights of the vertices around texels side by side, row by row.
pub(in crate::kind) struct Block {
    vertices: [Lanes; SIDE * SIDE],
}

impl Block {
    /// The heights around the texels from the one given; columns beyond the last texel are read as they come.
    #[inline(always)]
    pub fn new(field: &Field, texel: [i64; 2]) -> Self {
        let mut vertices = [[0.0; LANES]; SIDE * SIDE];
        let reach = REACH as i64;
        for (row, vertices) in vertices.chunks_exact_mut(SIDE).enumerate() {
            let heights: [f64; LANES + SIDE - 1] =
                field.row([texel[0] - reach, texel[1] + row as i64 - reach]);
            for (column, vertex) in vertices.iter_mut().enumerate() {
                vertex.copy_from_slice(&heights[column..column + LANES]);
            }
        }
        Self { vertices }
    }

    /// The apexes of the texels from the one given.
    #[inline(always)]
    pub fn apexes(&self, texel: [i64; 2], region: Region) -> [Apexes; LANES] {
        let centre = &self.vertices[CENTRE];
        let mut heights = [*centre; APEXES];
        if region == Region::Footprint {
            for (heights, [column, row]) in heights.iter_mut().zip(RIM) {
                // Halfway to the neighbours along one axis or both; along an axis without a step both are the centre.
                let place = |column: i8, row: i8| vertex_at(isize::from(column), isize::from(row));
                let [aside, ahead] = [place(column, 0), place(0, row)].map(|vertex| &self.vertices[vertex]);
                let beyond = &self.vertices[place(column, row)];
                for (lane, height) in heights.iter_mut().enumerate() {
                    *height = 0.5 * (0.5 * (centre[lane] + aside[lane]) + 0.5 * (ahead[lane] + beyond[lane]));
                }
            }
        }
        std::array::from_fn(|lane| {
            let heights = heights.each_ref().map(|lanes| lanes[lane]);
            Apexes::new([texel[0] + lane as i64, texel[1]], heights, centre[lane])
        })
    }

    /// The 3 by 3 vertices around the centre of one of the texels, row by row.
    pub fn around(&self, lane: usize) -> [[f64; 3]; 3] {
        [-1, 0, 1].map(|row| [-1, 0, 1].map(|column| self.vertices[vertex_at(column, row)][lane]))
    }

    /// A cell that begins at a vertex, as seen from one of the texels.
    #[inline(always)]
    pub fn cell(&self, lane: usize, first: usize) -> Seen {
        let corners = [first, first + 1, first + SIDE, first + SIDE + 1];
        Seen { offset: offset_of(first), heights: corners.map(|vertex| self.vertices[vertex][lane]) }
    }

    /// The heights of the corners `h00 h10 h01 h11` of a cell that begins at a vertex.
    #[inline(always)]
    pub fn corners(&self, first: usize) -> [&Lanes; 4] {
        let at = |by: usize| &self.vertices[(first + by) & MASK];
        [at(0), at(1), at(SIDE), at(SIDE + 1)]
    }
}

/// The vertices at which the cells of a texel's block begin.
pub(in crate::kind) fn cells_of_block() -> impl Iterator<Item = usize> {
    (0..CELLS_ACROSS).flat_map(|row| (0..CELLS_ACROSS).map(move |column| row * SIDE + column))
}

/// How far a vertex is from the centre, in texels.
#[inline(always)]
pub(in crate::kind) fn offset_of(vertex: usize) -> [i64; 2] {
    [vertex % SIDE, vertex / SIDE].map(|place| place as i64 - REACH as i64)
}

/// Squared slopes from the points of a row of texels to the blocks around them.
pub(in crate::kind) struct NearRow {
    region: Region,
    /// From the patches themselves at each texel, and beyond the last as they come.
    own: Vec<f64>,
    /// From each sort of point, one for the column before the first texel, one for each texel, and then as they come.
    points: [Vec<f64>; 3],
}

impl NearRow {
    /// For so many texels.
    pub fn new(width: usize) -> Self {
        let places = (width + 1).next_multiple_of(LANES) + LANES;
        Self {
            region: Region::Centre,
            own: vec![0.0; places],
            points: [vec![0.0; places], vec![0.0; places], vec![0.0; places]],
        }
    }

    /// Fills it for a row.
    #[inline(always)]
    pub fn fill<S: Simd>(&mut self, simd: S, near: &Near, field: &Field, row: i64) {
        self.region = near.region;
        // A centre has no use for the column before the first; the same is done for it all the same.
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

    /// Squared slopes of `count` texels from a column on, given those of the row above.
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

/// The points whose slopes are worked out for a texel, and the geometry around them in metres.
pub(in crate::kind) struct Near {
    region: Region,
    /// The sides of a texel and one over them.
    side_m: [f64; 2],
    per_side: [f64; 2],
    points: Vec<Point>,
}

/// Squared slopes from the points of texels side by side: of the centres; or of the middles of the right sides, of the lower
/// sides, and of the lower right corners, with the slopes from the sides' pieces to the nearest vertices among those of their middles.
type PerPoint = [Lanes; 3];

/// A point of the surface, and all that it is near to.
struct Point {
    /// Its place from the texel's centre, in texels.
    at: [f64; 2],
    /// The ends of the rim's pieces that meet there, the point itself between them: the four vertices around each, of which each
    /// is the mean.
    apexes: [[usize; 4]; 3],
    to_vertices: Vec<ToVertex>,
    to_edges: Vec<ToEdge>,
    from_rim: Vec<ToEdge>,
    to_cells: Vec<ToCell>,
}

/// To a vertex.
struct ToVertex {
    vertex: usize,
    /// One over the squared distance.
    closeness2: f64,
}

/// To an edge between two vertices; or from a piece of the rim to a vertex, seen from the vertex.
struct ToEdge {
    /// The vertices; or the piece's ends among the point's apexes.
    ends: [usize; 2],
    /// The vertex that a piece of the rim is seen from.
    vertex: usize,
    /// Where the ends are along the edge.
    places: [f64; 2],
    /// One over the edge's length.
    per_length: f64,
    /// Squared distance from the edge's line, and one over it.
    beside2: f64,
    closeness2: f64,
}

/// To a cell that does not hold the point.
struct ToCell {
    /// The bit of the cell in a set, and its corner `h00` among the vertices.
    bit: u64,
    vertex: usize,
    /// Corner `h00` from the point.
    corner: [f64; 2],
    /// Squared distance from the point.
    gap2: f64,
}

impl ToEdge {
    fn new(vertex: usize, mut ends: [usize; 2], origin: [f64; 2], places: [[f64; 2]; 2]) -> Option<Self> {
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
            ends,
            vertex,
            places: along_edge,
            per_length: 1.0 / (along_edge[1] - along_edge[0]),
            beside2: beside * beside,
            closeness2: 1.0 / (beside * beside),
        })
    }
}

impl Point {
    /// The point at that place in halves of a texel from the centre: 0 or 1 along each axis. It is near to the blocks of all
    /// texels that have it.
    fn new(halves: [u8; 2], side_m: [f64; 2]) -> Self {
        let at = halves.map(|half| 0.5 * f64::from(half));
        let metres = |place: [f64; 2]| [place[0] * side_m[0], place[1] * side_m[1]];
        let offset = |vertex: usize| [vertex % SIDE, vertex / SIDE].map(|place| place as f64 - REACH as f64);
        let place = |vertex: usize| metres(offset(vertex));
        // Vertices not farther than `reach` from one of the texels that have the point.
        let is_near = |vertex: usize, reach: usize| {
            let place = offset(vertex);
            (0..2).all(|axis| {
                let last = reach as f64 + f64::from(halves[axis]);
                (-(reach as f64)..=last).contains(&place[axis])
            })
        };
        let mut point = Self {
            at,
            apexes: [[CENTRE; 4]; 3],
            to_vertices: Vec::new(),
            to_edges: Vec::new(),
            from_rim: Vec::new(),
            to_cells: Vec::new(),
        };
        let origin = metres(at);
        for vertex in (0..SIDE * SIDE).filter(|vertex| is_near(*vertex, REACH)) {
            let [x, y] = [0, 1].map(|axis| place(vertex)[axis] - origin[axis]);
            let [right, below] = [x + side_m[0], y + side_m[1]];
            if x != 0.0 || y != 0.0 {
                point.to_vertices.push(ToVertex { vertex, closeness2: 1.0 / (x * x + y * y) });
            }
            let has_right = vertex % SIDE + 1 < SIDE && is_near(vertex + 1, REACH);
            let has_below = vertex / SIDE + 1 < SIDE && is_near(vertex + SIDE, REACH);
            for (end, is_there) in [(vertex + 1, has_right), (vertex + SIDE, has_below)] {
                if is_there {
                    point.to_edges.extend(ToEdge::new(
                        vertex,
                        [vertex, end],
                        origin,
                        [vertex, end].map(place),
                    ));
                }
            }
            let holds = x <= 0.0 && right >= 0.0 && y <= 0.0 && below >= 0.0;
            if has_right && has_below && !holds {
                point.to_cells.push(ToCell {
                    bit: 1 << (vertex / SIDE * CELLS_READ + vertex % SIDE),
                    vertex,
                    corner: [x, y],
                    gap2: x.max(-right).max(0.0).powi(2) + y.max(-below).max(0.0).powi(2),
                });
            }
        }
        point.add_rim(halves, &place, &|vertex| is_near(vertex, REACH - 1), &metres);
        point
    }

    /// Adds the pieces of the rim that meet in the middle of a side, to the vertices that are not on the rim of a block: from
    /// those hardly any texel needs it, and they are left to the walk.
    fn add_rim(
        &mut self,
        halves: [u8; 2],
        place: &impl Fn(usize) -> [f64; 2],
        is_near: &impl Fn(usize) -> bool,
        metres: &impl Fn([f64; 2]) -> [f64; 2],
    ) {
        let steps = halves.map(isize::from);
        // The mean of the four vertices around a place in halves of a texel, each half being 0 or 1 from a vertex.
        let around = |first: [isize; 2], steps: [isize; 2]| {
            [[0, 0], [steps[0], 0], [0, steps[1]], steps].map(|[x, y]| vertex_at(first[0] + x, first[1] + y))
        };
        self.apexes = [around([0, 0], steps); 3];
        if steps[0] + steps[1] != 1 {
            return;
        }
        // Along the side: to the corner before it and to the one behind.
        let along = [steps[1], steps[0]];
        self.apexes[0] = around([-along[0], -along[1]], [1, 1]);
        self.apexes[2] = around([0, 0], [1, 1]);
        let ends = [-0.5, 0.0, 0.5]
            .map(|by| metres([self.at[0] + by * along[0] as f64, self.at[1] + by * along[1] as f64]));
        for vertex in (0..SIDE * SIDE).filter(|vertex| is_near(*vertex)) {
            for [a, b] in [[0, 1], [1, 2]] {
                self.from_rim.extend(ToEdge::new(vertex, [a, b], place(vertex), [ends[a], ends[b]]));
            }
        }
    }
}

impl Near {
    /// For texels of that size, in metres.
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

    /// Squared slopes of the steepest rises from the points of texels to the cells near them.
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
            for (lane, mut set) in sets.into_iter().enumerate() {
                while set != 0 {
                    let cell = set.trailing_zeros() as usize;
                    set &= set - 1;
                    let patch = self.patch(point, block, lane, cell / CELLS_READ * SIDE + cell % CELLS_READ);
                    slopes[lane] = patch.inside(slopes[lane]).max(slopes[lane]);
                }
            }
        }
        slopes
    }

    /// The cell that begins at a vertex as seen from a point of one of the texels.
    fn patch(&self, point: &Point, block: &Block, lane: usize, first: usize) -> Patch {
        let seen = block.cell(lane, first);
        let [a, b, c, d] = point.apexes[1].map(|vertex| block.vertices[vertex][lane]);
        let apex = 0.5 * (0.5 * (a + b) + 0.5 * (c + d));
        Patch {
            corner: [0, 1].map(|axis| (seen.offset[axis] as f64 - point.at[axis]) * self.side_m[axis]),
            size: self.side_m,
            rise: seen.heights.map(|height| height - apex),
        }
    }

    /// Squared slopes to vertices and edges and from the rim, for as many texels as a vector has lanes; and the cells whose inside
    /// may be steeper, a bit each.
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

    /// Squared slopes of the patches themselves around the apexes.
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
