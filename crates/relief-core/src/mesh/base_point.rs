//! A point of a base surface, and where displacement takes it.

use super::Vertex;
use glam::{DVec2, DVec3};

/// A point of a base surface, with what displaces it.
///
/// This is the displaced surface that everything else approximates or samples:
/// [`DisplacedMesh`](crate::exact::DisplacedMesh) traces it, and displaced meshes have their vertices on it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BasePoint {
    /// Position in metres.
    pub position: DVec3,
    /// The direction of displacement: that of `d` metres goes `d` times its length far.
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
    /// The point of a triangle with those barycentric weights, which add up to 1. Nothing is normalised, so
    /// that neighbours which share two corners share the side between them.
    pub fn weighted([a, b, c]: [Self; 3], [wa, wb, wc]: [f64; 3]) -> Self {
        Self {
            position: a.position * wa + b.position * wb + c.position * wc,
            normal: a.normal * wa + b.normal * wb + c.normal * wc,
            uv: a.uv * wa + b.uv * wb + c.uv * wc,
        }
    }

    /// Where a displacement of so many metres takes the point (Szirmay-Kalos and Umenhoffer 2008, section 2).
    pub fn displaced(&self, metres: f64) -> DVec3 {
        self.position + metres * self.normal
    }
}
