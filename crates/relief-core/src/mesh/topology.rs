//! Which corners of a mesh meet: welded points, shared edges, and sets of what belongs together.

use glam::Vec3;
use std::collections::HashMap;

/// For every position the number of the first one that is equal to it; -0 and 0 are equal.
pub(super) fn weld(positions: impl ExactSizeIterator<Item = Vec3>) -> Vec<u32> {
    let mut first = HashMap::with_capacity(positions.len());
    // Whoever calls has no more than 2^32 positions.
    let number = |(at, position): (usize, Vec3)| {
        let bits = (position + Vec3::ZERO).to_array().map(f32::to_bits);
        *first.entry(bits).or_insert(at as u32)
    };
    positions.enumerate().map(number).collect()
}

/// One side of an edge: that of a triangle which runs along it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct HalfEdge {
    /// The points that the edge connects, the lower number first.
    pub points: [u32; 2],
    /// The corner that the triangle runs from, counted over all triangles: `3 * triangle + place`.
    pub from: u32,
}

impl HalfEdge {
    /// The triangle.
    pub fn triangle(self) -> usize {
        self.from as usize / 3
    }

    /// The triangle's corners at [`Self::points`], in that order.
    pub fn corners(self, point_of: impl Fn(u32) -> u32) -> [u32; 2] {
        let to = next_corner(self.from);
        if point_of(self.from) == self.points[0] { [self.from, to] } else { [to, self.from] }
    }
}

/// The corner that follows in the same triangle.
fn next_corner(corner: u32) -> u32 {
    if corner % 3 == 2 { corner - 2 } else { corner + 1 }
}

/// All sides of all edges, those of an edge together. `points` has the points of every triangle's corners.
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

/// Sets of numbers, of which any two can be made one. A set goes by its least number.
pub(super) struct Sets(Vec<u32>);

impl Sets {
    /// So many sets of one number each.
    pub fn new(count: usize) -> Self {
        Self((0..count as u32).collect())
    }

    /// The least number of the set that a number is in.
    pub fn least(&mut self, number: u32) -> u32 {
        let mut at = number as usize;
        while self.0[at] as usize != at {
            // Each second link is shortened, so that the next way is half as long.
            let above = self.0[at] as usize;
            self.0[at] = self.0[above];
            at = self.0[at] as usize;
        }
        at as u32
    }

    /// Makes the sets of two numbers one.
    pub fn join(&mut self, a: u32, b: u32) {
        let (a, b) = (self.least(a), self.least(b));
        self.0[a.max(b) as usize] = a.min(b);
    }
}
