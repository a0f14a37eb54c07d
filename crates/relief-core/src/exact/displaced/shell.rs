//! Pieces of the shell of a base triangle, cut along the lines between cells.
//!
//! The shell is `P(w) + h N(w)`, where position and normal are affine in the barycentric weights
//! `w` and `h` is a displacement.
//!
//! Let a piece be a convex polygon of weights with corners `w_k`, over which the displacement `D`
//! stays in `[l, u]`. A point of the piece is `w = Σ c_k w_k` with `c_k >= 0` that add up to 1. The
//! sheet there is `P(w) + D(w) N(w) = Σ c_k (P_k + D(w) N_k)`. It has the *same* `D(w)` for every
//! corner, since `P` and `N` are affine. Each `P_k + D(w) N_k` lies between `P_k + l N_k` and
//! `P_k + u N_k`. So the sheet over the piece is in the convex hull of the corners at `l` and at
//! `u`.

use glam::{DVec2, DVec3};

use super::ray_space::RaySpace;
use super::relief::Relief;
use crate::mesh::Vertex;

/// A corner of a piece.
#[derive(Clone, Copy, Debug)]
pub(super) struct Corner {
    /// Position in ray space, not displaced.
    pub position: DVec3,
    /// Normal in ray space, not normalised.
    pub normal: DVec3,
    /// Barycentric weights in the base triangle.
    pub weights: DVec3,
    /// Position on the map in cells, counted from whole numbers that are stored in the owner.
    pub place: DVec2,
}

impl Corner {
    /// Point between this corner and another, at `s` in `[0, 1]`.
    pub fn towards(&self, other: &Self, s: f64) -> Self {
        Self {
            position: self.position.lerp(other.position, s),
            normal: self.normal.lerp(other.normal, s),
            weights: self.weights.lerp(other.weights, s),
            place: self.place.lerp(other.place, s),
        }
    }

    /// Point in the middle between this corner and another, the same seen from both.
    pub fn middle(&self, other: &Self) -> Self {
        Self {
            position: 0.5 * (self.position + other.position),
            normal: 0.5 * (self.normal + other.normal),
            weights: 0.5 * (self.weights + other.weights),
            place: 0.5 * (self.place + other.place),
        }
    }

    /// Point of the shell above the corner, at a displacement.
    pub fn at(&self, metres: f64) -> DVec3 {
        self.position + metres * self.normal
    }
}

/// A convex polygon of a base triangle, with the cells under it.
#[derive(Clone, Debug)]
pub(super) struct Piece {
    /// Corners in the order of the base triangle's.
    pub corners: Vec<Corner>,
    /// Cell from whose corner positions are counted. Small numbers keep their digits far from the
    /// origin.
    base: [i64; 2],
    /// First and last column and row of the cells.
    pub first: [i64; 2],
    pub last: [i64; 2],
    /// Lower and upper bound of the displacement over these cells.
    bounds: [f64; 2],
}

impl Piece {
    /// Creates the piece of a whole base triangle.
    pub fn whole(relief: &Relief, ray: &RaySpace, vertices: [&Vertex; 3]) -> Self {
        let places = vertices.map(|vertex| relief.place(vertex.uv.as_dvec2()));
        let least = places[0].min(places[1]).min(places[2]);
        let base = [0, 1].map(|axis| relief.cells(axis, least[axis], least[axis])[0]);
        let corner = |k: usize| Corner {
            position: ray.point(vertices[k].position.as_dvec3()),
            normal: ray.direction(vertices[k].normal.as_dvec3()),
            weights: DVec3::AXES[k],
            place: places[k] - whole(base),
        };
        Self::over(relief, (0..3).map(corner).collect(), base, [i64::MIN; 2], [i64::MAX; 2])
    }

    /// Creates the piece of a polygon. Its cells are those between `first` and `last` that it
    /// touches.
    fn over(relief: &Relief, corners: Vec<Corner>, base: [i64; 2], first: [i64; 2], last: [i64; 2]) -> Self {
        let places = corners.iter().map(|corner| corner.place + whole(base));
        let empty = [DVec2::INFINITY, DVec2::NEG_INFINITY];
        let [least, greatest] =
            places.fold(empty, |[least, greatest], place| [least.min(place), greatest.max(place)]);
        let ranges = [0, 1].map(|axis| {
            let touched = relief.cells(axis, least[axis], greatest[axis]);
            touched.map(|cell| cell.clamp(first[axis], last[axis]))
        });
        let [first, last] = [0, 1].map(|end| ranges.map(|range| range[end]));
        Self { corners, base, first, last, bounds: relief.bounds(first, last) }
    }

    /// Corners of the hull that bounds the sheet over this piece.
    pub fn hull(&self) -> impl Iterator<Item = DVec3> + Clone {
        self.corners.iter().flat_map(|corner| self.bounds.map(|metres| corner.at(metres)))
    }

    /// The cell under the piece, if there is only one.
    pub fn only_cell(&self) -> Option<[i64; 2]> {
        (self.first == self.last).then_some(self.first)
    }

    /// Triangles of the piece, with positions counted from the corner of the cell.
    pub fn triangles(&self, cell: [i64; 2]) -> impl Iterator<Item = [Corner; 3]> {
        let shift = whole([0, 1].map(|axis| cell[axis] - self.base[axis]));
        let local = move |corner: Corner| Corner { place: corner.place - shift, ..corner };
        self.corners.windows(2).skip(1).map(move |pair| [self.corners[0], pair[0], pair[1]].map(local))
    }

    /// Cuts a piece over several cells along a line between two of them. The cut is where nodes of
    /// the pyramids end, so that few nodes bound each part tightly.
    pub fn split(&self, relief: &Relief) -> [Self; 2] {
        let spans = [0, 1].map(|axis| self.last[axis].abs_diff(self.first[axis]));
        let axis = usize::from(spans[1] > spans[0]);
        let line = roundest(self.first[axis], self.last[axis]);
        let at = (line - self.base[axis]) as f64;
        let [before, after] = cut(&self.corners, axis, at);
        let [mut before_last, mut after_first] = [self.last, self.first];
        before_last[axis] = line - 1;
        after_first[axis] = line;
        [
            Self::over(relief, before, self.base, self.first, before_last),
            Self::over(relief, after, self.base, after_first, self.last),
        ]
    }
}

/// Position of whole numbers of cells.
fn whole([column, row]: [i64; 2]) -> DVec2 {
    DVec2::new(column as f64, row as f64)
}

/// Number above `first`, up to `last`, with the highest power of two as a divisor.
fn roundest(first: i64, last: i64) -> i64 {
    let mut number = last;
    loop {
        let rounder = number & number.wrapping_sub(1);
        if rounder <= first || rounder == number {
            return number;
        }
        number = rounder;
    }
}

/// Parts of a convex polygon before and after a line. Both have the same corners on the line.
fn cut(corners: &[Corner], axis: usize, line: f64) -> [Vec<Corner>; 2] {
    let mut parts = [Vec::with_capacity(corners.len() + 1), Vec::with_capacity(corners.len() + 1)];
    let next = corners.iter().cycle().skip(1);
    for (corner, next) in corners.iter().zip(next) {
        let [here, there] = [corner.place[axis] - line, next.place[axis] - line];
        if here <= 0.0 {
            parts[0].push(*corner);
        }
        if here >= 0.0 {
            parts[1].push(*corner);
        }
        if here * there < 0.0 {
            let mut crossing = corner.towards(next, here / (here - there));
            crossing.place[axis] = line;
            parts[0].push(crossing);
            parts[1].push(crossing);
        }
    }
    parts
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cuts_fall_where_nodes_of_the_pyramids_end() {
        assert_eq!(roundest(3, 12), 8);
        assert_eq!(roundest(0, 255), 128);
        assert_eq!(roundest(-1, 255), 0);
        assert_eq!(roundest(-9, -3), -8);
        assert_eq!(roundest(-3, -2), -2);
        assert_eq!(roundest(6, 7), 7);
        assert_eq!(roundest(i64::from(u32::MAX), i64::from(u32::MAX) + 1), 1 << 32);
    }

    #[test]
    fn both_parts_of_a_polygon_keep_its_turn_and_fill_it() {
        let corner = |x: f64, y: f64| Corner {
            position: DVec3::ZERO,
            normal: DVec3::Z,
            weights: DVec3::X,
            place: DVec2::new(x, y),
        };
        let area = |corners: &[Corner]| -> f64 {
            let next = corners.iter().cycle().skip(1);
            corners.iter().zip(next).map(|(a, b)| 0.5 * a.place.perp_dot(b.place)).sum()
        };
        let polygon = [corner(0.0, 0.0), corner(4.0, 0.0), corner(5.0, 3.0), corner(1.0, 4.0)];
        for (axis, line) in [(0, 1.0), (0, 2.0), (1, 3.0), (1, 3.5)] {
            let parts = cut(&polygon, axis, line);
            let areas = parts.each_ref().map(|part| area(part));
            assert!(areas.iter().all(|&area| area > 0.0));
            assert!((areas[0] + areas[1] - area(&polygon)).abs() < 1e-12);
            assert!(parts[0].iter().all(|corner| corner.place[axis] <= line));
            assert!(parts[1].iter().all(|corner| corner.place[axis] >= line));
        }
    }
}
