//! Connections between corners of a mesh: welded points, shared edges and sets of connected
//! elements.

use glam::Vec3;
use std::collections::HashMap;

/// For every position, the index of the first one that is equal to it. -0 and 0 are equal.
pub(super) fn weld(positions: impl ExactSizeIterator<Item = Vec3>) -> Vec<u32> {
    let mut first = HashMap::with_capacity(positions.len());
    // All callers have at most 2^32 positions.
    let number = |(at, position): (usize, Vec3)| {
        let bits = (position + Vec3::ZERO).to_array().map(f32::to_bits);
        *first.entry(bits).or_insert(at as u32)
    };
    positions.enumerate().map(number).collect()
}

/// One side of an edge: the side of a triangle that runs along it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct HalfEdge {
    /// Points at the ends of the edge, the lower number first.
    pub points: [u32; 2],
    /// Corner at which the triangle's side begins, counted over all triangles:
    /// `3 * triangle + place`.
    pub from: u32,
}

impl HalfEdge {
    /// Number of the triangle.
    pub fn triangle(self) -> usize {
        self.from as usize / 3
    }

    /// The triangle's corners at [`Self::points`], in that order.
    pub fn corners(self, point_of: impl Fn(u32) -> u32) -> [u32; 2] {
        let to = next_corner(self.from);
        if point_of(self.from) == self.points[0] { [self.from, to] } else { [to, self.from] }
    }
}

/// Next corner in the same triangle.
fn next_corner(corner: u32) -> u32 {
    if corner % 3 == 2 { corner - 2 } else { corner + 1 }
}

/// Sides of all edges, with the sides of each edge next to each other. `points` holds the points of
/// every triangle's corners.
pub(super) fn half_edges(points: impl ExactSizeIterator<Item = [u32; 3]>) -> Vec<HalfEdge> {
    let mut halves = Vec::with_capacity(3 * points.len());
    for (triangle, points) in points.enumerate() {
        for place in 0..3 {
            let (a, b) = (points[place], points[(place + 1) % 3]);
            let from = (3 * triangle + place) as u32;
            halves.push(HalfEdge { points: [a.min(b), a.max(b)], from });
        }
    }
    halves.sort_unstable();
    halves
}

/// Disjoint sets of numbers that can be joined. A set is identified by its least number.
pub(super) struct Sets(Vec<u32>);

impl Sets {
    /// Creates `count` sets of one number each.
    pub fn new(count: usize) -> Self {
        Self((0..count as u32).collect())
    }

    /// Least number of the set that contains `number`.
    pub fn least(&mut self, number: u32) -> u32 {
        let mut at = number as usize;
        while self.0[at] as usize != at {
            // Every second link is shortened, so that the next path is half as long.
            let above = self.0[at] as usize;
            self.0[at] = self.0[above];
            at = self.0[at] as usize;
        }
        at as u32
    }

    /// Joins the sets of two numbers.
    pub fn join(&mut self, a: u32, b: u32) {
        let (a, b) = (self.least(a), self.least(b));
        self.0[a.max(b) as usize] = a.min(b);
    }
}
