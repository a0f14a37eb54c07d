//! Points of the surface that are apexes of texels, and their surroundings.
//!
//! Offsets from a point are the same for all texels, so they are computed once for a map.

use pulp::Simd;

use super::block::{CELLS_READ, CENTRE, REACH, SIDE, vertex_at};

/// Point of the surface, and its surroundings.
pub(super) struct Point {
    /// Place from the texel's centre, in texels.
    pub at: [f64; 2],
    /// Ends of the rim's pieces that meet there, the point itself between them. Each is the mean of
    /// the four vertices listed.
    pub apexes: [[usize; 4]; 3],
    pub to_vertices: Vec<ToVertex>,
    pub to_edges: Vec<ToEdge>,
    pub from_rim: Vec<ToEdge>,
    pub to_cells: Vec<ToCell>,
}

/// Slope to a vertex.
pub(super) struct ToVertex {
    pub vertex: usize,
    /// One over the squared distance.
    pub closeness2: f64,
}

/// Slope to an edge between two vertices; or slope from a piece of the rim to a vertex, seen from
/// the vertex.
pub(super) struct ToEdge {
    /// Vertices, or the piece's ends among the point's apexes.
    pub ends: [usize; 2],
    /// Vertex from which a piece of the rim is seen.
    pub vertex: usize,
    /// Places of the ends along the edge.
    places: [f64; 2],
    /// One over the edge's length.
    per_length: f64,
    /// Squared distance from the edge's line, and one over it.
    beside2: f64,
    pub closeness2: f64,
}

/// Slope to a cell that does not hold the point.
pub(super) struct ToCell {
    /// Bit of the cell in a set, and its corner `h00` among the vertices.
    pub bit: u64,
    pub vertex: usize,
    /// Corner `h00`, in metres from the point.
    pub corner: [f64; 2],
    /// Squared distance from the point.
    pub gap2: f64,
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

    /// Returns the squared slope to the steepest point strictly inside the edge, for the rises of
    /// its ends. This is the part of [`super::slope::inside_segment`] that depends on heights.
    #[inline(always)]
    pub fn slope2<S: Simd>(&self, simd: S, rise: (S::f64s, S::f64s)) -> S::f64s {
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

impl Point {
    /// Creates the point at a place in halves of a texel from the centre: 0 or 1 along each axis.
    /// Its surroundings are the blocks of all texels that have it.
    pub fn new(halves: [u8; 2], side_m: [f64; 2]) -> Self {
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

    /// Adds the pieces of the rim that meet in the middle of a side, for the vertices inside of the
    /// block. Hardly any texel needs vertices on the block's border; these are left to the walk.
    fn add_rim(
        &mut self,
        halves: [u8; 2],
        place: &impl Fn(usize) -> [f64; 2],
        is_near: &impl Fn(usize) -> bool,
        metres: &impl Fn([f64; 2]) -> [f64; 2],
    ) {
        let steps = halves.map(isize::from);
        // The four vertices whose mean is a place: from the first one, 0 or 1 steps along each
        // axis.
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
