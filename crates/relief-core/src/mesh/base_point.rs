//! Points of a base surface and their displacement.

use super::Vertex;
use glam::{DVec2, DVec3};

/// A point of a base surface, with the data that displaces it.
///
/// It defines the displaced surface that everything else approximates or samples.
/// [`DisplacedMesh`](crate::exact::DisplacedMesh) traces that surface, and displaced meshes have
/// their vertices on it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BasePoint {
    /// Position in metres.
    pub position: DVec3,
    /// Direction of displacement. A displacement of `d` metres moves the point by `d` times its
    /// length.
    pub normal: DVec3,
    /// Texture coordinates, not wrapped.
    pub uv: DVec2,
}

impl From<&Vertex> for BasePoint {
    fn from(vertex: &Vertex) -> Self {
        Self {
            position: vertex.position.as_dvec3(),
            normal: vertex.normal.as_dvec3(),
            uv: vertex.uv.as_dvec2(),
        }
    }
}

impl BasePoint {
    /// Point of a triangle with these barycentric weights, which must add up to 1. Nothing is
    /// normalised, so that neighbours that share two corners share the side between them.
    pub fn weighted([a, b, c]: [Self; 3], [wa, wb, wc]: [f64; 3]) -> Self {
        Self {
            position: a.position * wa + b.position * wb + c.position * wc,
            normal: a.normal * wa + b.normal * wb + c.normal * wc,
            uv: a.uv * wa + b.uv * wb + c.uv * wc,
        }
    }

    /// Position after a displacement in metres (Szirmay-Kalos and Umenhoffer 2008, section 2).
    pub fn displaced(&self, metres: f64) -> DVec3 {
        self.position + metres * self.normal
    }
}
