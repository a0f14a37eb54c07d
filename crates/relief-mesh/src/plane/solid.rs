//! Solid of a plane: walls down from its border, and a flat bottom.

use glam::Vec3;
use relief_core::mesh::Vertex;

use super::Rectangle;
use crate::surface::Relief;
use crate::triangles::Numbered;

/// Point of a plane's border: its place, its height, and the number of its vertex.
pub type BorderPoint = ([f64; 2], f64, u32);

/// Walls and a bottom.
#[derive(Debug)]
pub struct Solid {
    /// Border in four walls, each with both of its ends: where `v` is least and `u` grows, where
    /// `u` is greatest and `v` grows, and back.
    walls: [Vec<BorderPoint>; 4],
    /// Displacement of the bottom in metres.
    bottom_m: f64,
}

/// Faces between vertices. Triangles name them by their indices in `points`.
#[derive(Debug, Default)]
pub struct Faces {
    /// Vertices of these faces alone.
    pub own: Vec<(Vertex, Numbered)>,
    /// All corners.
    pub points: Vec<(Numbered, Vec3)>,
    pub triangles: Vec<[u32; 3]>,
}

impl Solid {
    pub fn new(walls: [Vec<BorderPoint>; 4], bottom_m: f64) -> Self {
        Self { walls, bottom_m }
    }

    /// Returns the number of points of the border.
    fn border(&self) -> u64 {
        self.walls.iter().map(|wall| wall.len() as u64 - 1).sum()
    }

    /// Returns the number of vertices: one below each point of the border, and one in the middle of
    /// the bottom.
    pub fn vertices(&self) -> u64 {
        self.border() + 1
    }

    /// Returns the number of triangles.
    pub fn triangles(&self) -> u64 {
        3 * self.border()
    }

    /// Returns the number of bytes in use.
    pub fn bytes(&self) -> u64 {
        self.walls.iter().map(|wall| size_of_val(&wall[..]) as u64).sum()
    }

    /// Makes the faces, with vertices numbered from `first` on. They turn like the triangles of a
    /// grid, and share the vertices of the plane's border.
    pub fn faces(&self, rectangle: &Rectangle, relief: &Relief, first: u32) -> Faces {
        let mut faces = Faces::default();
        let [tangent, bitangent] = rectangle.tangents.map(|tangent| tangent.normalize_or_zero().as_vec3());
        let normal = -rectangle.normal.normalize_or_zero().as_vec3();
        let mut add = |place: [f64; 2]| {
            let position = rectangle.displaced(relief, place, self.bottom_m);
            let numbered = Numbered::both(first + faces.own.len() as u32);
            let uv = rectangle.uv(relief, place).as_vec2();
            faces.own.push((Vertex { position, normal, tangent, bitangent, uv }, numbered));
            faces.points.push((numbered, position));
        };
        let border: Vec<BorderPoint> =
            self.walls.iter().flat_map(|wall| &wall[..wall.len() - 1]).copied().collect();
        border.iter().for_each(|&(place, ..)| add(place));
        let corner = |wall: usize| self.walls[wall][0].0;
        add([0, 1].map(|axis| 0.5 * (corner(0)[axis] + corner(2)[axis])));
        for &(place, height, number) in &border {
            faces.points.push((Numbered::both(number), rectangle.position(relief, place, height)));
        }
        let count = border.len() as u32;
        let top = |at: u32| count + 1 + at;
        for at in 0..count {
            let next = (at + 1) % count;
            faces.triangles.push([top(at), top(next), next]);
            faces.triangles.push([top(at), next, at]);
            faces.triangles.push([at, next, count]);
        }
        faces
    }
}
