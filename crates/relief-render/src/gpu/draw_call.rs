//! Draw calls of surfaces.

use relief_shaders::cpu::{Corner, Face, Shared, ShellNode};
use relief_shaders::surface::Proposal;
use wgpu::{Buffer, RenderPass};

use super::{Gpu, GpuError, shells};
use crate::job::JobSurface;

/// Size of a draw call.
#[derive(Clone, Debug)]
pub enum DrawCall {
    /// Numbers of vertices and instances.
    Direct([u32; 2]),
    /// Buffer with the arguments of an indirect draw, which the GPU wrote.
    Indirect(Buffer),
}

impl DrawCall {
    /// Records the draw call.
    pub fn draw(&self, pass: &mut RenderPass) {
        match self {
            Self::Direct([vertices, instances]) => pass.draw(0..*vertices, 0..*instances),
            Self::Indirect(buffer) => pass.draw_indirect(buffer, 0),
        }
    }

    /// Returns the draw call of a surface's triangles. For shells it is a single triangle that
    /// covers the picture.
    pub fn of(surface: &JobSurface) -> Self {
        let count = surface.triangles.len() as u32;
        let drawn = match surface.selection.paths().proposal {
            Proposal::Polygons => count,
            Proposal::Shells => count.min(1),
        };
        Self::Direct([3 * drawn, 1])
    }
}

/// Fails if a surface has more triangles or vertices than the GPU takes. Triangle numbers are
/// signed 32-bit integers in the shaders, vertex numbers unsigned ones.
pub fn check_triangles(gpu: &Gpu, surface: &JobSurface) -> Result<(), GpuError> {
    let (count, corners) = (surface.triangles.len(), surface.triangles.corners().len());
    let of_kind = match surface.selection.paths().proposal {
        Proposal::Polygons => u64::from(u32::MAX / 3),
        Proposal::Shells => shells::MOST_TRIANGLES.min(gpu.storage_capacity(ShellNode::SIZE) / 2),
    };
    let limit = gpu.storage_capacity(Face::SIZE).min(of_kind);
    if count as u64 > limit {
        return Err(GpuError::TooManyTriangles { count, limit });
    }
    let limit = gpu.storage_capacity(Corner::SIZE);
    if corners as u64 > limit { Err(GpuError::TooManyVertices { count: corners, limit }) } else { Ok(()) }
}
