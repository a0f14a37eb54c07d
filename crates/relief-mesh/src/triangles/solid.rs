//! Solid of an open base: an underside, and walls between it and the displaced surface.

use glam::{DVec3, Vec3};
use relief_core::mesh::Vertex;

use super::shape::WholeEdge;
use super::{Numbered, PatchBorder, Triangles, counted};
use crate::plane::Faces;
use crate::surface::Relief;
use crate::{BaseSurface, Directions, MesherError, point};

/// Least length of an interpolated direction, in lengths of a normal. Where corners of a triangle
/// face ways farther apart, the underside would have to be too deep.
const SHORTEST: f64 = 0.5;

/// Stands for a vertex that the underside lacks.
const NONE: u32 = u32::MAX;

/// Underside and walls of the pieces that have a border.
///
/// The underside has one triangle for each base triangle. All are displaced by the same amount,
/// along interpolated directions, so that each is flat. A wall stands on each side of the border.
#[derive(Debug)]
pub struct Solid {
    /// Vertices of the base that the underside has.
    corners: Vec<u32>,
    /// Index of each vertex in `corners`, by the first vertex at its position.
    places: Vec<u32>,
    /// Triangles of the base that the underside has.
    patches: Vec<u32>,
    /// Triangle and side of each wall.
    walls: Vec<[u32; 2]>,
    /// Number of the first vertex of the underside.
    first: u32,
    /// Displacement of the underside in metres.
    metres: f64,
}

impl Solid {
    /// Creates the solid under a base. `lowest_m` is the base's lowest displacement, `solid_m` the
    /// thickness. Vertices are numbered from `first` on.
    pub fn new(
        base: &Triangles,
        relief: &Relief,
        [lowest_m, solid_m]: [f64; 2],
        first: u64,
    ) -> Result<Self, MesherError> {
        let (patches, walls) = base
            .border
            .as_ref()
            .map(|border| (border.patches.clone(), border.sides.clone()))
            .unwrap_or_default();
        let mut places = vec![NONE; base.corners.count()];
        let mut corners = Vec::new();
        for vertex in patches.iter().flat_map(|&patch| base.triangles[patch as usize]) {
            let vertex = base.corners.leader(vertex);
            let place = &mut places[vertex as usize];
            if *place == NONE {
                *place = corners.len() as u32;
                corners.push(vertex);
            }
        }
        counted(first + corners.len() as u64)?;
        let metres = displacement(base, relief, &patches, [lowest_m, solid_m]);
        Ok(Self { corners, places, patches, walls, first: counted(first)?, metres })
    }

    /// Returns the number of vertices of the underside.
    pub fn corner_count(&self) -> u32 {
        self.corners.len() as u32
    }

    /// Returns the number of triangles of the underside.
    pub fn patch_count(&self) -> u32 {
        self.patches.len() as u32
    }

    /// Returns the number of walls.
    pub fn wall_count(&self) -> u32 {
        self.walls.len() as u32
    }

    /// Returns the number of triangles of a wall. Their corners lie on the border and on the
    /// underside.
    pub fn wall_triangles(&self, base: &Triangles, wall: u32) -> u64 {
        u64::from(base.parts_of(self.walls[wall as usize])) + 1
    }

    /// Returns the number after the last vertex.
    pub fn end(&self) -> u64 {
        u64::from(self.first) + self.corners.len() as u64
    }

    /// Returns the number of bytes in use.
    pub fn bytes(&self) -> u64 {
        let Self { corners, places, patches, walls, .. } = self;
        let of_numbers = [corners, places, patches].map(|list| size_of_val(&list[..]));
        (of_numbers.iter().sum::<usize>() + size_of_val(&walls[..])) as u64
    }

    /// Returns a vertex of the underside, by its index in it, and its numbers.
    pub fn corner(&self, base: &Triangles, place: u32) -> (Vertex, Numbered) {
        let vertex = self.corners[place as usize];
        let Vertex { normal, tangent, bitangent, uv, .. } = *base.corners.vertex(vertex);
        let normal = -normal.try_normalize().unwrap_or_default();
        let position = self.below(base, vertex);
        (Vertex { position, normal, tangent, bitangent, uv }, self.numbered(base, vertex))
    }

    /// Returns a triangle of the underside, by its index in it: the number of the base triangle,
    /// and the corners. They turn like the base triangle.
    pub fn triangle(&self, base: &Triangles, place: u32) -> (u32, [(Numbered, Vec3); 3]) {
        let patch = self.patches[place as usize];
        let corners = base.triangles[patch as usize];
        (patch, corners.map(|vertex| (self.numbered(base, vertex), self.below(base, vertex))))
    }

    /// Returns a wall: first the points of the border, then the two points below its ends. The
    /// polygon between them is cut into triangles by cutting off each corner that stands out, in
    /// order.
    pub fn wall(&self, base: &Triangles, relief: &Relief, wall: u32) -> Faces {
        let [patch, side] = self.walls[wall as usize];
        let corners = base.triangles[patch as usize];
        let ends = [0, 1].map(|end| corners[(side as usize + end) % 3]);
        let parts = base.parts_of([patch, side]);
        let of_ends = ends.map(|end| base.at_corner(end).base);
        let along = of_ends[1].position - of_ends[0].position;
        let up = (of_ends[0].normal + of_ends[1].normal).normalize_or_zero();
        let normal = along.cross(up).normalize_or_zero();
        let border = PatchBorder::new(base, relief, patch);
        let on_border =
            |at: u32| if at == parts { border.point((side + 1) % 3, 0) } else { border.point(side, at) };
        let below = ends.map(|end| (self.numbered(base, end), self.below(base, end)));
        let points: Vec<(Numbered, Vec3)> = (0..=parts).map(on_border).chain(below).collect();
        let [from, to] = [parts + 1, parts + 2];
        let at = |corner: u32| points[corner as usize].1.as_dvec3();
        let stands_out = |[a, b, c]: [u32; 3]| (at(c) - at(b)).cross(at(a) - at(b)).dot(normal) > 0.0;
        let mut triangles = Vec::with_capacity(parts as usize + 1);
        let mut open = vec![from];
        for next in (0..=parts).chain([to]) {
            while let [.., before, last] = open[..] {
                if next != to && !stands_out([next, last, before]) {
                    break;
                }
                triangles.push([next, last, before]);
                open.pop();
            }
            open.push(next);
        }
        Faces { own: Vec::new(), points, triangles }
    }

    /// Returns the position below a vertex of the base.
    fn below(&self, base: &Triangles, vertex: u32) -> Vec3 {
        point::stored(base.at_corner(vertex).base.displaced(self.metres))
    }

    fn numbered(&self, base: &Triangles, vertex: u32) -> Numbered {
        Numbered::both(self.first + self.places[base.corners.leader(vertex) as usize])
    }
}

/// Returns the displacement of the underside in metres.
///
/// A point of it lies `metres |N|` along its direction, `|N|` the length of the interpolated
/// direction there. The displaced surface lies `h |N|` along it, or `h` with directions of one
/// length.
fn displacement(base: &Triangles, relief: &Relief, patches: &[u32], [lowest_m, solid_m]: [f64; 2]) -> f64 {
    let lengths = patches.iter().map(|&patch| lengths(base.directions(patch)));
    let [shortest, longest] =
        lengths.fold([f64::INFINITY, 0.0_f64], |[least, most], [low, high]| [least.min(low), most.max(high)]);
    let shortest = shortest.max(SHORTEST);
    let lowest_m = lowest_m - base.hollow(patches, shortest);
    if relief.directions() == Directions::Raw {
        return lowest_m - solid_m / shortest;
    }
    let metres = lowest_m - solid_m;
    metres / if metres < 0.0 { shortest } else { longest.max(shortest) }
}

/// Returns the least and the greatest length of directions that are interpolated between these.
fn lengths([a, b, c]: [DVec3; 3]) -> [f64; 2] {
    let longest = a.length().max(b.length()).max(c.length());
    let on_side = |[a, b]: [DVec3; 2]| {
        let along = b - a;
        let part = (-a.dot(along) / along.length_squared()).clamp(0.0, 1.0);
        // For two that are the same any part will do.
        (a + along * if part.is_finite() { part } else { 0.0 }).length()
    };
    let mut shortest = on_side([a, b]).min(on_side([b, c])).min(on_side([c, a]));
    let up = (b - a).cross(c - a);
    let is_inside = [[a, b], [b, c], [c, a]].iter().all(|[from, to]| up.dot(from.cross(*to)) > 0.0);
    if is_inside {
        shortest = shortest.min(up.normalize_or_zero().dot(a).abs());
    }
    [shortest, longest]
}

impl Triangles {
    /// Returns the number of parts of a side.
    fn parts_of(&self, [patch, side]: [u32; 2]) -> u32 {
        self.edges.parts(self.edges.sides(patch)[side as usize])
    }

    /// Returns the greatest depth of the smooth base below its triangles, in metres of displacement
    /// along directions of at least this length.
    fn hollow(&self, patches: &[u32], shortest: f64) -> f64 {
        let own = patches.iter().flat_map(|&patch| self.edges.sides(patch)).map(|edge| {
            let leader = self.leader(edge);
            WholeEdge {
                ends: self.edges.ends(leader).map(|end| self.corners.base(end)),
                lift_m: self.lift(leader),
            }
        });
        let sides: Vec<WholeEdge> = match &self.parts {
            Some(parts) => parts.edges().to_vec(),
            None => own.collect(),
        };
        let deepest = |depths: &mut dyn Iterator<Item = f64>| depths.fold(0.0, f64::max);
        match self.base {
            BaseSurface::Flat => 0.0,
            // The products of each two of three weights sum to at most a third.
            BaseSurface::Lift => deepest(&mut sides.iter().map(|side| -side.lift_m)) / 3.0,
            // It lies within the hull of its control points, which are off along the normals of the
            // ends. These normals are as far from directions between as those directions are short.
            BaseSurface::Pn => {
                let depths = sides.iter().flat_map(|side| {
                    let [a, b] = side.ends;
                    let along = (b.position - a.position) / 3.0;
                    [along.dot(a.normal.normalize_or_zero()), -along.dot(b.normal.normalize_or_zero())]
                });
                deepest(&mut depths.into_iter()) / (shortest * shortest)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_of_directions_are_those_of_samples() {
        let triples = [
            [DVec3::new(1.0, 0.1, 0.0), DVec3::new(0.0, 1.0, 0.2), DVec3::new(0.1, 0.0, 1.3)],
            [DVec3::new(1.0, 0.1, 0.0), DVec3::new(-0.9, 0.3, 0.0), DVec3::new(0.1, 1.7, 0.4)],
            [DVec3::Z, DVec3::Z, DVec3::X],
            [DVec3::Z; 3],
        ];
        for [a, b, c] in triples {
            let (mut least, mut most) = (f64::INFINITY, 0.0_f64);
            for i in 0..=200 {
                for j in 0..=200 - i {
                    let [of_b, of_c] = [i, j].map(|part| f64::from(part) / 200.0);
                    let length = (a * (1.0 - of_b - of_c) + b * of_b + c * of_c).length();
                    (least, most) = (least.min(length), most.max(length));
                }
            }
            let [shortest, longest] = lengths([a, b, c]);
            assert!((shortest - least).abs() < 1e-4 && shortest <= least + 1e-12, "{a} {b} {c}");
            assert!((longest - most).abs() < 1e-12, "{a} {b} {c}");
        }
    }
}
