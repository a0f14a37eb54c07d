//! Solid of a plane with holes: walls along its outline, and its triangles once more at the bottom.

use std::collections::{HashMap, HashSet};

use glam::{DVec3, Vec2, Vec3};
use rayon::prelude::*;
use relief_core::mesh::Vertex;

use crate::point;
use crate::triangles::Numbered;

/// Greatest distance by which touching vertices are moved apart: as a part of a texel, and of the
/// distance of a triangle's corner from its opposite side.
const APART: [f64; 2] = [1.0 / 16.0, 1.0 / 8.0];

/// Greatest change of heights by that, as a part of the tolerance.
const CHANGE: f64 = 0.01;

/// Least distance by which vertices are moved apart, as a part of the largest coordinate: more than
/// floats round.
const LEAST: f64 = 8.0 * f32::EPSILON as f64;

/// Plane of a solid's bottom.
#[derive(Clone, Copy, Debug)]
pub struct Bottom {
    /// Point of the base plane.
    pub corner: DVec3,
    /// Unit normal of the base plane.
    pub up: DVec3,
    /// Height of the bottom above the base plane in metres, below 0.
    pub height_m: f64,
}

impl Bottom {
    /// Returns the point of the bottom below a position.
    fn below(&self, position: Vec3) -> Vec3 {
        let position = position.as_dvec3();
        point::stored(position + self.up * (self.height_m - (position - self.corner).dot(self.up)))
    }

    /// Returns the component of a vector along the plane.
    fn flat(&self, vector: DVec3) -> DVec3 {
        vector - self.up * vector.dot(self.up)
    }
}

/// Limits on moving vertices apart.
#[derive(Clone, Copy, Debug)]
pub struct ShiftLimits {
    /// Side of a texel in metres.
    pub texel_m: f64,
    /// Tolerance of the triangles' heights in metres.
    pub tolerance_m: f64,
}

/// Sides of the remaining triangles that have no other triangle, and vertices at which pieces
/// touch.
///
/// A wall cannot pass a position through which the outline goes twice: four walls would meet in one
/// line. So each piece but the largest gets a vertex of its own there, moved a little into the
/// piece.
#[derive(Debug)]
pub struct Sides {
    /// Corners of each side as its triangle turns, and the triangle's third corner.
    border: Vec<[u32; 3]>,
    /// Triangles around touching vertices, without the largest piece: for each piece the two other
    /// corners of its triangles, from side to side.
    fans: Vec<(u32, Vec<[u32; 2]>)>,
}

impl Sides {
    /// Bytes per triangle while sides are searched.
    pub const BYTES_PER_TRIANGLE: u64 = 48;

    /// Finds the sides of fewer than 2^32 / 3 triangles.
    pub fn of(triangles: &[[u32; 3]]) -> Self {
        let mut sides: Vec<[u32; 3]> = Vec::with_capacity(3 * triangles.len());
        for (number, corners) in triangles.iter().enumerate() {
            for place in 0..3 {
                let [a, b] = [corners[place], corners[(place + 1) % 3]];
                sides.push([a.min(b), a.max(b), (3 * number + place) as u32]);
            }
        }
        sides.par_sort_unstable();
        let alone = sides.chunk_by(|a, b| a[..2] == b[..2]).filter(|seam| seam.len() == 1);
        let mut border: Vec<[u32; 3]> = alone
            .map(|seam| {
                let (corners, place) = (triangles[seam[0][2] as usize / 3], seam[0][2] as usize % 3);
                [0, 1, 2].map(|k| corners[(place + k) % 3])
            })
            .collect();
        drop(sides);
        border.sort_unstable();
        let begun = border.chunk_by(|a, b| a[0] == b[0]).filter(|sides| sides.len() > 1);
        let mut around: HashMap<u32, HashMap<u32, u32>> =
            begun.map(|sides| (sides[0][0], HashMap::new())).collect();
        if around.is_empty() {
            return Self { border, fans: Vec::new() };
        }
        for corners in triangles {
            for place in 0..3 {
                if let Some(next) = around.get_mut(&corners[place]) {
                    next.insert(corners[(place + 1) % 3], corners[(place + 2) % 3]);
                }
            }
        }
        let mut fans = Vec::new();
        for sides in border.chunk_by(|a, b| a[0] == b[0]).filter(|sides| sides.len() > 1) {
            let vertex = sides[0][0];
            let next = &around[&vertex];
            let fan = |start: u32| {
                let step = |[_, last]: &[u32; 2]| next.get(last).map(|&after| [*last, after]);
                let first = next.get(&start).map(|&after| [start, after]);
                // A fan has no more triangles than the vertex.
                std::iter::successors(first, step).take(next.len()).collect::<Vec<[u32; 2]>>()
            };
            let mut here: Vec<Vec<[u32; 2]>> = sides.iter().map(|&[_, start, _]| fan(start)).collect();
            here.sort_by_key(|fan| (usize::MAX - fan.len(), fan.first().copied()));
            fans.extend(here.into_iter().skip(1).map(|fan| (vertex, fan)));
        }
        Self { border, fans }
    }

    /// Returns the vertices whose positions are needed.
    pub fn wanted(&self) -> HashSet<u32> {
        let ends = self.border.iter().map(|[start, ..]| *start);
        let around =
            self.fans.iter().flat_map(|(vertex, fan)| fan.iter().flatten().copied().chain([*vertex]));
        ends.chain(around).collect()
    }
}

/// Walls along an outline.
#[derive(Debug)]
pub struct Outline {
    bottom: Bottom,
    /// Number of vertices before pieces are parted. Copies have the next numbers.
    originals: u32,
    /// Copies of vertices at which pieces touch: the number of the original, and the copy.
    copies: Vec<(u32, Vertex)>,
    /// Index of the copy that a triangle uses, by the vertex and the next corner.
    places: HashMap<[u32; 2], u32>,
    /// The sides of the border, as their triangles turn.
    border: Vec<[u32; 2]>,
    /// Positions of the border's vertices.
    positions: HashMap<u32, Vec3>,
    /// Number of the bottom's first vertex: the number of vertices above.
    pub first_below: u32,
}

impl Outline {
    /// Creates the walls along `sides`, whose vertices are in `found`.
    pub fn new(
        sides: Sides,
        found: &HashMap<u32, Vertex>,
        originals: u32,
        bottom: Bottom,
        limits: ShiftLimits,
    ) -> Self {
        let (mut copies, mut places) = (Vec::new(), HashMap::new());
        for (vertex, fan) in &sides.fans {
            let Some(copy) = shifted(*vertex, fan, found, &bottom, &limits) else { continue };
            for [next, _] in fan {
                places.insert([*vertex, *next], copies.len() as u32);
            }
            copies.push((*vertex, copy));
        }
        let positions = sides
            .border
            .iter()
            .filter_map(|[start, ..]| found.get(start).map(|vertex| (*start, vertex.position)));
        let positions = positions.collect();
        let mut outline =
            Self { bottom, originals, copies, places, border: Vec::new(), positions, first_below: 0 };
        outline.border =
            sides.border.iter().map(|&[a, b, c]| [outline.own(a, b), outline.own(b, c)]).collect();
        outline
    }

    /// Returns the number of copies, which part pieces.
    pub fn copy_count(&self) -> u32 {
        self.copies.len() as u32
    }

    /// Returns the number of walls, one for each side of the border. Each has two triangles.
    pub fn wall_count(&self) -> u32 {
        self.border.len() as u32
    }

    /// Returns the number of bytes in use.
    pub fn bytes(&self) -> u64 {
        let of_maps = 2 * (self.places.len() * 12 + self.positions.len() * 16);
        (of_maps + size_of_val(&self.copies[..]) + size_of_val(&self.border[..])) as u64
    }

    /// Returns a copy, which parts pieces.
    pub fn copy(&self, at: u32) -> (Vertex, Numbered) {
        let (of, vertex) = self.copies[at as usize];
        (vertex, Numbered { number: self.originals + at, smooth: of })
    }

    /// Returns number and position of the copy that a triangle uses in place of a vertex, if it
    /// does. The next corner identifies the triangle.
    #[inline]
    pub fn replacement(&self, vertex: u32, next: u32) -> Option<(u32, Vec3)> {
        let at = *self.places.get(&[vertex, next])?;
        Some((self.originals + at, self.copies[at as usize].1.position))
    }

    fn own(&self, vertex: u32, next: u32) -> u32 {
        self.replacement(vertex, next).map_or(vertex, |(number, _)| number)
    }

    fn position(&self, number: u32) -> Vec3 {
        match number.checked_sub(self.originals) {
            Some(copy) => self.copies[copy as usize].1.position,
            None => self.positions.get(&number).copied().unwrap_or(Vec3::NAN),
        }
    }

    /// Returns the vertex of the bottom below a vertex of the plane.
    pub fn vertex_below(&self, vertex: &Vertex) -> Vertex {
        let position = self.bottom.below(vertex.position);
        Vertex { position, normal: -self.bottom.up.as_vec3(), ..*vertex }
    }

    /// Returns the point of the bottom below a position.
    pub fn below(&self, position: Vec3) -> Vec3 {
        self.bottom.below(position)
    }

    /// Returns the upper ends of a wall, as its triangle turns: numbers and positions.
    pub fn wall(&self, at: u32) -> [(u32, Vec3); 2] {
        self.border[at as usize].map(|number| (number, self.position(number)))
    }
}

/// Returns a copy of a vertex, moved into the triangles around it. It moves along the triangle in
/// their middle, so that it stays in its plane.
fn shifted(
    vertex: u32,
    fan: &[[u32; 2]],
    found: &HashMap<u32, Vertex>,
    bottom: &Bottom,
    limits: &ShiftLimits,
) -> Option<Vertex> {
    let own = found.get(&vertex)?;
    let at = |number: u32| found.get(&number).map(|vertex| vertex.position.as_dvec3());
    let from = own.position.as_dvec3();
    let middle = fan.get(fan.len() / 2)?.map(|number| found.get(&number));
    let [Some(a), Some(b)] = middle else { return None };
    let toward = (a.position.as_dvec3() + b.position.as_dvec3() - 2.0 * from) / 3.0;
    let toward_uv = (a.uv + b.uv - 2.0 * own.uv) / 3.0;
    // Distance from the opposite sides, and change of heights if the vertex moves all the way.
    let (mut nearest, mut change) = (f64::INFINITY, 0.0_f64);
    for &[next, last] in fan {
        let [b, c] = [at(next)?, at(last)?];
        let normal = (b - from).cross(c - from);
        let opposite = bottom.flat(c - b).length();
        nearest = nearest.min(normal.dot(bottom.up).abs() / opposite);
        change = change.max((toward.dot(normal) / normal.dot(bottom.up)).abs());
    }
    let far = bottom.flat(toward).length();
    let most = (APART[0] * limits.texel_m).min(APART[1] * nearest) / far;
    let largest = from.abs().max_element();
    let least = (LEAST * largest).min(APART[1] * nearest) / far;
    let part = most.min(CHANGE * limits.tolerance_m / change).max(least);
    let part = if part.is_finite() { part } else { 0.0 };
    let uv: Vec2 = own.uv + toward_uv * part as f32;
    Some(Vertex { position: point::stored(from + toward * part), uv, ..*own })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pieces_that_touch_at_a_point_are_parted_there() {
        // Two triangles at a vertex, and a third beside the first.
        let triangles = [[0, 1, 2], [0, 3, 4], [0, 2, 5]];
        let sides = Sides::of(&triangles);
        assert_eq!(sides.border.len(), 7);
        assert_eq!(sides.fans, vec![(0, vec![[3, 4]])]);
        // A square has none.
        let square = Sides::of(&[[0, 1, 2], [0, 2, 3]]);
        assert!(square.fans.is_empty() && square.border.len() == 4);
        assert_eq!(square.wanted(), HashSet::from([0, 1, 2, 3]));
    }
}
