//! Tessellation on the GPU, for each view. Base triangles that are not visible are culled; the rest
//! is counted, numbered, made and drawn. Nothing is read back.

use std::sync::Arc;

use relief_shaders::cpu::{
    BaseEdge, BasePatch, BaseVertex, Corner, Face, Shared, Tally, Tessellation as Grid, TessellationTotals,
    Vec2, Voxel,
};
use relief_shaders::wgsl::{TESSELLATE_BLOCK, TESSELLATE_COARSEST, TESSELLATE_GROUP, TESSELLATE_ROW};
use wgpu::{BindGroup, BindGroupLayout, Buffer, BufferUsages, ComputePass, ComputePipeline, Device};

use super::layouts::group;
use super::pass_clock::{PassClock, PassKind, timed_compute};
use super::resident::Uniform;
use super::{Gpu, GpuError};
use crate::prepare::{Capacity, TessellatedBase, Tessellation};

/// Storage buffers that a pass binds.
pub const STORAGE_BUFFERS: u32 = 8;

/// Offsets of the numbers of workgroups in the totals, in bytes.
const POINT_GROUPS: u64 = 16;
const TRIANGLE_GROUPS: u64 = 32;

/// Bindings of the passes that count.
pub const COUNTING: &[&str] = &[
    "tessellation",
    "base_vertices",
    "base_edges",
    "base_patches",
    "voxels",
    "tallies",
    "tally_blocks",
    "made_totals",
];

/// Bindings of the passes that make points and triangles.
pub const MAKING: &[&str] = &[
    "tessellation",
    "base_vertices",
    "base_edges",
    "base_patches",
    "voxels",
    "tallies",
    "made_totals",
    "made_corners",
    "made_faces",
];

/// Programs of the passes.
#[derive(Clone, Debug)]
pub struct Tessellator {
    pub begin: ComputePipeline,
    pub voxels: ComputePipeline,
    pub seen: ComputePipeline,
    pub edges: ComputePipeline,
    pub patches: ComputePipeline,
    pub blocks: ComputePipeline,
    pub totals: ComputePipeline,
    pub starts: ComputePipeline,
    pub points: ComputePipeline,
    pub triangles: ComputePipeline,
    pub swept: ComputePipeline,
}

/// Layouts of group 1: of the passes that count, and of the passes that make points and triangles.
#[derive(Clone, Debug)]
pub struct Groups {
    pub counting: BindGroupLayout,
    pub making: BindGroupLayout,
}

/// Whether a device can bind enough storage buffers for the passes.
pub fn is_possible(device: &Device) -> bool {
    device.limits().max_storage_buffers_per_shader_stage >= STORAGE_BUFFERS
}

/// Base on the GPU, with the buffers of its points and triangles.
#[derive(Debug)]
pub struct Tessellated {
    base: Arc<TessellatedBase>,
    capacity: Capacity,
    grid: Uniform,
    counting: BindGroup,
    making: BindGroup,
    mesh: BindGroup,
    totals: Buffer,
    drawn: Buffer,
    #[cfg(test)]
    made: [Buffer; 2],
}

impl Tessellated {
    /// Creates a base with memory for its tessellation by a view, or as much as the GPU's buffers
    /// hold.
    ///
    /// # Errors
    ///
    /// When the base itself does not fit.
    pub fn new(
        gpu: &Gpu,
        of: &Tessellation,
        groups: &Groups,
        mesh: &BindGroupLayout,
    ) -> Result<Self, GpuError> {
        let Tessellation { base, .. } = of;
        let TessellatedBase { vertices, edges, patches, .. } = &**base;
        let capacity = capacity(gpu, of)?;
        let storage = |label, count: usize, bytes: usize| {
            let bytes = (count.max(1) * bytes) as u64;
            gpu.buffer(label, bytes, BufferUsages::STORAGE | BufferUsages::COPY_SRC)
        };
        let tallies = edges.len() + patches.len();
        let grid = Uniform::new::<Grid>(gpu, "tessellation");
        let filled = [
            gpu.filled("base_vertices", vertices, BufferUsages::STORAGE)?,
            gpu.filled("base_edges", edges, BufferUsages::STORAGE)?,
            gpu.filled("base_patches", patches, BufferUsages::STORAGE)?,
        ];
        let voxels = storage("voxels", vertices.len(), Voxel::SIZE);
        let blocks = tallies.div_ceil(TESSELLATE_BLOCK as usize);
        let blocks = storage("tally_blocks", blocks, <Vec2<u32> as Shared>::SIZE);
        let tallies = storage("tallies", tallies, Tally::SIZE);
        let size = TessellationTotals::SIZE as u64;
        let totals = gpu.buffer("made_totals", size, BufferUsages::STORAGE | BufferUsages::COPY_SRC);
        let drawn = gpu.buffer("drawn", size, BufferUsages::INDIRECT | BufferUsages::COPY_DST);
        let corners = storage("made_corners", vertices.len() + capacity.points as usize, Corner::SIZE);
        let faces = storage("made_faces", capacity.triangles as usize, Face::SIZE);
        let bound = [
            ("tessellation", grid.resource()),
            ("base_vertices", filled[0].as_entire_binding()),
            ("base_edges", filled[1].as_entire_binding()),
            ("base_patches", filled[2].as_entire_binding()),
            ("voxels", voxels.as_entire_binding()),
            ("tallies", tallies.as_entire_binding()),
            ("tally_blocks", blocks.as_entire_binding()),
            ("made_totals", totals.as_entire_binding()),
            ("made_corners", corners.as_entire_binding()),
            ("made_faces", faces.as_entire_binding()),
        ];
        let named = |label, layout, names: &[&str]| {
            let of_group: Vec<_> = bound.iter().filter(|(name, _)| names.contains(name)).cloned().collect();
            group(gpu.device(), label, layout, &of_group)
        };
        let counting = named("tessellate", &groups.counting, COUNTING);
        let making = named("tessellate", &groups.making, MAKING);
        let bound =
            [("mesh_faces", faces.as_entire_binding()), ("mesh_corners", corners.as_entire_binding())];
        let mesh = group(gpu.device(), "mesh", mesh, &bound);
        Ok(Self {
            base: Arc::clone(base),
            capacity,
            grid,
            counting,
            making,
            mesh,
            totals,
            drawn,
            #[cfg(test)]
            made: [corners, faces],
        })
    }

    /// Whether base and capacity fit the given tessellation.
    pub fn fits(&self, gpu: &Gpu, of: &Tessellation) -> bool {
        Arc::ptr_eq(&self.base, &of.base) && capacity(gpu, of).is_ok_and(|capacity| capacity == self.capacity)
    }

    /// Returns the buffers of the totals, the corners and the faces.
    #[cfg(test)]
    pub fn tessellation_buffers(&self) -> [&Buffer; 3] {
        [&self.totals, &self.made[0], &self.made[1]]
    }

    /// Returns the bind group of the triangles, the same as of other meshes.
    pub fn mesh(&self) -> &BindGroup {
        &self.mesh
    }

    /// Returns the buffer with the arguments of the indirect draw.
    pub fn drawn(&self) -> &Buffer {
        &self.drawn
    }

    /// Waits for the GPU and returns the number of triangles made last.
    pub async fn triangles(&self, gpu: &Gpu) -> Result<u64, GpuError> {
        let size = TessellationTotals::SIZE as u64;
        let readable = gpu
            .guarded(|| {
                let readable = gpu.buffer("made", size, BufferUsages::MAP_READ | BufferUsages::COPY_DST);
                let mut encoder = gpu.device().create_command_encoder(&Default::default());
                encoder.copy_buffer_to_buffer(&self.totals, 0, &readable, 0, size);
                gpu.queue().submit([encoder.finish()]);
                Ok(readable)
            })
            .await?;
        let mut made = 0;
        gpu.read(&readable, size, |bytes| made = TessellationTotals::read(bytes).triangles).await?;
        Ok(made.into())
    }

    /// Makes the triangles of a view, unless they are cached. Returns whether they were made; they
    /// are also made if the surface's maps or settings changed. It does not wait for the GPU.
    pub fn make(
        &mut self,
        gpu: &Gpu,
        of: &Tessellation,
        tessellator: &Tessellator,
        maps: &BindGroup,
        is_other_surface: bool,
        clock: Option<&PassClock>,
    ) -> bool {
        let Capacity { triangles, points } = self.capacity;
        let grid = Grid { most_points: points, most_triangles: triangles, ..of.grid };
        if !self.grid.set(gpu, grid) && !is_other_surface {
            return false;
        }
        let mut encoder = gpu.device().create_command_encoder(&Default::default());
        let timed = || timed_compute(clock.and_then(|clock| clock.next(PassKind::Make)));
        {
            let mut pass = encoder.begin_compute_pass(&timed());
            pass.set_bind_group(1, &self.counting, &[]);
            self.count(&mut pass, tessellator, &grid);
        }
        encoder.copy_buffer_to_buffer(&self.totals, 0, &self.drawn, 0, TessellationTotals::SIZE as u64);
        {
            let mut pass = encoder.begin_compute_pass(&timed());
            // Nothing of a frame or a pass is read.
            pass.set_bind_group(0, maps, &[0, 0]);
            pass.set_bind_group(1, &self.making, &[]);
            if grid.is_swept == 1 {
                // This pass places the inner points, before they are displaced.
                let [columns, rows] = in_rows(grid.patches);
                pass.set_pipeline(&tessellator.swept);
                pass.dispatch_workgroups(columns, rows, 1);
            }
            for (program, groups) in
                [(&tessellator.points, POINT_GROUPS), (&tessellator.triangles, TRIANGLE_GROUPS)]
            {
                pass.set_pipeline(program);
                pass.dispatch_workgroups_indirect(&self.drawn, groups);
            }
        }
        gpu.queue().submit([encoder.finish()]);
        true
    }

    fn count(&self, pass: &mut ComputePass, tessellator: &Tessellator, grid: &Grid) {
        let tallies = grid.edges + grid.patches;
        let blocks = tallies.div_ceil(TESSELLATE_BLOCK);
        let mut run = |program: &ComputePipeline, count: u32| {
            let [columns, rows] = groups_for(count);
            pass.set_pipeline(program);
            pass.dispatch_workgroups(columns, rows, 1);
        };
        run(&tessellator.begin, 1);
        run(&tessellator.voxels, grid.vertices);
        run(&tessellator.seen, grid.patches);
        for _ in 0..=TESSELLATE_COARSEST {
            run(&tessellator.edges, grid.edges);
            run(&tessellator.patches, grid.patches);
            run(&tessellator.blocks, blocks);
            run(&tessellator.totals, 1);
        }
        run(&tessellator.starts, blocks);
    }
}

/// Returns columns and rows of workgroups for a number of invocations.
fn groups_for(count: u32) -> [u32; 2] {
    in_rows(count.div_ceil(TESSELLATE_GROUP))
}

/// Returns columns and rows of a number of workgroups.
fn in_rows(groups: u32) -> [u32; 2] {
    let in_row = TESSELLATE_ROW / TESSELLATE_GROUP;
    [groups.min(in_row), groups.div_ceil(in_row)]
}

/// Returns the capacity that a view asks for, reduced to the GPU's buffers.
fn capacity(gpu: &Gpu, of: &Tessellation) -> Result<Capacity, GpuError> {
    let Tessellation { base, grid } = of;
    let (vertices, patches) = (base.vertices.len() as u64, base.patches.len() as u64);
    let [corners, of_base, faces, of_patches, tallies] =
        [Corner::SIZE, BaseVertex::SIZE, Face::SIZE, BasePatch::SIZE.max(BaseEdge::SIZE), Tally::SIZE]
            .map(|bytes| gpu.storage_capacity(bytes));
    if vertices > corners.min(of_base) {
        let limit = corners.min(of_base);
        return Err(GpuError::TooManyVertices { count: base.vertices.len(), limit });
    }
    // Triangle numbers are signed 32-bit integers, vertex numbers unsigned ones. A triangle has at
    // most three edges for itself.
    let triangles = faces.min(u64::from(u32::MAX / 6)).min(grid.most_triangles.into());
    let limit = triangles.min(of_patches / 3).min(tallies / 4);
    if patches > limit {
        return Err(GpuError::TooManyTriangles { count: base.patches.len(), limit });
    }
    let points = (corners - vertices).min(grid.most_points.into());
    Ok(Capacity { triangles: triangles as u32, points: points as u32 })
}
