//! Parts of meshes that are too large to be held.

use super::Vertex;
use glam::Vec3;

/// A part of a mesh that is handed over part by part.
///
/// Vertices and triangles are numbered in the order in which they are handed over, and triangles name no
/// vertex of a later part.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MeshBlock {
    /// The vertices that follow those of the part before.
    pub vertices: Vec<Vertex>,
    /// The corners of the triangles that follow those of the part before, by the vertices' numbers,
    /// counter-clockwise seen from the front.
    pub triangles: Vec<[u32; 3]>,
    /// Positions of these triangles' corners, in metres, the same bits as those of the vertices.
    pub points: Vec<Vec3>,
    /// The same triangles by the places of their corners' positions in `points`.
    pub corners: Vec<[u32; 3]>,
    /// The number of the base mesh's triangle that each lies on: [`NO_OWNER`](Self::NO_OWNER) of walls, and
    /// the first of a plane's. Empty where nobody knows.
    pub owners: Vec<u32>,
}

impl MeshBlock {
    /// The owner of a triangle that lies on none of the base mesh.
    pub const NO_OWNER: u32 = u32::MAX;

    /// The positions of the triangles' corners, triangle by triangle.
    pub fn positions(&self) -> impl ExactSizeIterator<Item = [Vec3; 3]> {
        self.corners.iter().map(|corners| corners.map(|corner| self.points[corner as usize]))
    }
}
