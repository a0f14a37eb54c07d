//! A plane made solid: walls down from its border, and a flat bottom.

use glam::Vec3;
use relief_core::mesh::Vertex;

use super::Rectangle;
use crate::surface::Relief;

/// A point of a plane's border: its place and its height.
pub type BorderPoint = ([f64; 2], f64);

/// Walls and a bottom.
#[derive(Debug)]
pub struct Solid {
    /// The border in four walls, each with both of its ends: where `v` is least and `u` grows, where `u` is
    /// greatest and `v` grows, and back.
    walls: [Vec<BorderPoint>; 4],
    /// Metres of displacement at the bottom.
    bottom_m: f64,
}

/// Faces with vertices of their own, which triangles name by their places.
#[derive(Debug, Default)]
pub struct Faces {
    pub vertices: Vec<Vertex>,
    pub triangles: Vec<[u32; 3]>,
}

impl Solid {
    pub fn new(walls: [Vec<BorderPoint>; 4], bottom_m: f64) -> Self {
        Self { walls, bottom_m }
    }

    /// Points of the border.
    fn border(&self) -> u64 {
        self.walls.iter().map(|wall| wall.len() as u64 - 1).sum()
    }

    /// Vertices: every face has its own. The bottom has one in its middle.
    pub fn vertices(&self) -> u64 {
        2 * (self.border() + 4) + self.border() + 1
    }

    /// Triangles.
    pub fn triangles(&self) -> u64 {
        3 * self.border()
    }

    /// Bytes that are held.
    pub fn bytes(&self) -> u64 {
        self.walls.iter().map(|wall| size_of_val(&wall[..]) as u64).sum()
    }

    /// Makes them. They turn as the triangles of a grid do, and meet those of the plane at its border.
    pub fn faces(&self, rectangle: &Rectangle, relief: &Relief) -> Faces {
        let mut faces = Faces::default();
        let [along, down] = rectangle.tangents.map(|tangent| tangent.normalize_or_zero());
        let up = rectangle.normal.normalize_or_zero();
        let below = |place: [f64; 2]| rectangle.displaced(relief, place, self.bottom_m);
        let vertex = |place: [f64; 2], position: Vec3, normal: Vec3, tangents: [Vec3; 2]| Vertex {
            position,
            normal,
            tangent: tangents[0],
            bitangent: tangents[1],
            uv: rectangle.uv(relief, place).as_vec2(),
        };
        for (wall, (outward, ahead)) in
            self.walls.iter().zip([(-down, along), (along, down), (down, -along), (-along, -down)])
        {
            let tangents = [ahead.as_vec3(), up.as_vec3()];
            let first = faces.vertices.len() as u32;
            for &(place, height) in wall {
                let top = rectangle.position(relief, place, height);
                for position in [top, below(place)] {
                    faces.vertices.push(vertex(place, position, outward.as_vec3(), tangents));
                }
            }
            for at in (first..).step_by(2).take(wall.len() - 1) {
                let [top, bottom, next_top, next_bottom] = [at, at + 1, at + 2, at + 3];
                faces.triangles.push([top, next_top, next_bottom]);
                faces.triangles.push([top, next_bottom, bottom]);
            }
        }
        let tangents = [along.as_vec3(), down.as_vec3()];
        let first = faces.vertices.len() as u32;
        for wall in &self.walls {
            for &(place, _) in &wall[..wall.len() - 1] {
                faces.vertices.push(vertex(place, below(place), -up.as_vec3(), tangents));
            }
        }
        let middle = faces.vertices.len() as u32;
        let corner = |wall: usize| self.walls[wall][0].0;
        let centre = [0, 1].map(|axis| 0.5 * (corner(0)[axis] + corner(2)[axis]));
        faces.vertices.push(vertex(centre, below(centre), -up.as_vec3(), tangents));
        for at in first..middle {
            let next = if at + 1 == middle { first } else { at + 1 };
            faces.triangles.push([at, next, middle]);
        }
        faces
    }
}
