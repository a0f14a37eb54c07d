//! What is drawn of a surface.

use relief_shaders::cpu::{Corner, Face, Shared};
use relief_shaders::surface::Proposal;
use relief_shaders::wgsl::BOX_VERTICES;
use wgpu::{Buffer, RenderPass};

use super::{Gpu, GpuError};
use crate::job::JobSurface;

/// How much is drawn.
#[derive(Clone, Debug)]
pub enum Drawn {
    /// So many vertices and instances.
    Direct([u32; 2]),
    /// As many as a buffer says, which the GPU wrote.
    Indirect(Buffer),
}

impl Drawn {
    /// Draws it.
    pub fn draw(&self, pass: &mut RenderPass) {
        match self {
            Self::Direct([vertices, instances]) => pass.draw(0..*vertices, 0..*instances),
            Self::Indirect(buffer) => pass.draw_indirect(buffer, 0),
        }
    }

    /// The triangles of a surface that has them. Shells have an instance for each side, as polygons have
    /// faces.
    pub fn of(surface: &JobSurface) -> Self {
        let both = surface.two_sided && surface.selection.paths().proposal == Proposal::Shells;
        Self::Direct([vertices_of(surface) * surface.triangles.len() as u32, 1 + u32::from(both)])
    }
}

/// The vertices that are drawn for a triangle.
fn vertices_of(surface: &JobSurface) -> u32 {
    match surface.selection.paths().proposal {
        Proposal::Polygons => 3,
        Proposal::Shells => BOX_VERTICES,
    }
}

/// Refuses more triangles than the GPU takes. The number of a triangle travels as a signed integer, that of a
/// vertex as an unsigned one.
pub fn check_triangles(gpu: &Gpu, surface: &JobSurface) -> Result<(), GpuError> {
    let (count, corners) = (surface.triangles.len(), surface.triangles.corners().len());
    let limit = gpu.storage_capacity(Face::SIZE).min(u64::from(u32::MAX / vertices_of(surface)));
    if count as u64 > limit {
        return Err(GpuError::TooManyTriangles { count, limit });
    }
    let limit = gpu.storage_capacity(Corner::SIZE);
    if corners as u64 > limit { Err(GpuError::TooManyVertices { count: corners, limit }) } else { Ok(()) }
}
