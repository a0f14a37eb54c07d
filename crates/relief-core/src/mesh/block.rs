//! Blocks of meshes that are too large for memory.

use super::Vertex;
use glam::Vec3;

/// One block of a mesh that is passed on block by block.
///
/// Vertices and triangles are numbered across all blocks in their order. Triangles refer only to
/// vertices of their own or earlier blocks.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MeshBlock {
    /// Vertices. Their numbers follow the previous block's.
    pub vertices: Vec<Vertex>,
    /// Corners of the triangles, as numbers of vertices, counter-clockwise seen from the front. The
    /// triangles' numbers follow the previous block's.
    pub triangles: Vec<[u32; 3]>,
    /// Positions of these triangles' corners, in metres, with the same bits as in the vertices.
    pub points: Vec<Vec3>,
    /// Corners of the same triangles, as indices into `points`.
    pub corners: Vec<[u32; 3]>,
    /// Number of the base mesh's triangle for each triangle. It is [`NO_OWNER`](Self::NO_OWNER) for
    /// walls, and the first one for triangles on a plane. Empty if unknown.
    pub owners: Vec<u32>,
}

impl MeshBlock {
    /// Owner of a triangle that lies on no triangle of the base mesh.
    pub const NO_OWNER: u32 = u32::MAX;

    /// Positions of the triangles' corners, triangle by triangle.
    pub fn positions(&self) -> impl ExactSizeIterator<Item = [Vec3; 3]> {
        self.corners.iter().map(|corners| corners.map(|corner| self.points[corner as usize]))
    }
}
