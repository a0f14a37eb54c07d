//! The stages over a list of rays.

use relief_shaders::cpu::{Frame, PassSettings, PixelIn, Probe, Shared, read_all};
use relief_shaders::wgsl::{PROBE_GROUP, PROBE_ROW, Sampling};
use wgpu::{BindGroup, BufferUsages, ComputePipeline};

use super::layouts::group;
use super::programs::Programs;
use super::resident::{Common, Resident, Uniform};
use super::wait::block_on;
use super::{Gpu, GpuError};
use crate::job::JobSurface;

/// Rays of a dispatch: a few rows of the shader's workgroups, and some ten MiB. Larger, and slow adapters may
/// take so long that the system resets them; smaller, and the waiting in between shows.
const RAYS: usize = 4 * PROBE_ROW as usize;

/// Runs stages over rays, and keeps the programs.
#[derive(Debug)]
pub struct Prober {
    gpu: Gpu,
    programs: Programs,
}

impl Prober {
    /// A prober on that GPU.
    pub fn new(gpu: Gpu) -> Self {
        Self { programs: Programs::new(&gpu), gpu }
    }

    /// Runs a surface's stages over rays of the caller's choice, each with its own triangle, and gives every
    /// stage's result; all zeros for a ray that never enters the relief. The surface's own triangles are not
    /// used.
    ///
    /// # Errors
    ///
    /// When a map is larger than the adapter takes or is malformed, when memory runs out, or when the device
    /// is lost.
    pub fn probe(
        &mut self,
        surface: &JobSurface,
        sampling: Sampling,
        rays: &[PixelIn],
    ) -> Result<Vec<Probe>, GpuError> {
        block_on(self.probe_async(surface, sampling, rays))
    }

    async fn probe_async(
        &mut self,
        surface: &JobSurface,
        sampling: Sampling,
        rays: &[PixelIn],
    ) -> Result<Vec<Probe>, GpuError> {
        let mut probes = Vec::new();
        probes.try_reserve_exact(rays.len()).map_err(|_| GpuError::OutOfMemory)?;
        if rays.is_empty() {
            return Ok(probes);
        }
        let program = self.programs.probe(&self.gpu, &surface.selection, sampling).await?;
        let builder = self.programs.pyramids(&self.gpu, std::slice::from_ref(surface), sampling).await?;
        let layouts = &self.programs.layouts;
        let maps = self
            .gpu
            .guarded(|| {
                let mut frame = Uniform::new::<Frame>(&self.gpu, "frame");
                frame.set(&self.gpu, Frame::none());
                let passes = Uniform::new::<PassSettings>(&self.gpu, "passes");
                let common = Common {
                    number: 0,
                    frame: frame.resource(),
                    passes: passes.resource(),
                    builder: builder.as_ref(),
                    light_map: None,
                };
                let mut resident = Resident::new(&self.gpu);
                resident
                    .maps(&self.gpu, surface, sampling, layouts.maps(sampling), &common)
                    .map(|maps| maps.seen)
            })
            .await?;
        for chunk in rays.chunks(RAYS) {
            self.probe_chunk(&program, &maps, chunk, &mut probes).await?;
        }
        Ok(probes)
    }

    async fn probe_chunk(
        &self,
        program: &ComputePipeline,
        maps: &BindGroup,
        rays: &[PixelIn],
        probes: &mut Vec<Probe>,
    ) -> Result<(), GpuError> {
        let gpu = &self.gpu;
        let bytes = (rays.len() * Probe::SIZE) as u64;
        let row = PROBE_ROW as usize;
        let readable = gpu
            .guarded(|| {
                let given = gpu.filled("rays", rays, BufferUsages::STORAGE)?;
                let results = gpu.buffer("probes", bytes, BufferUsages::STORAGE | BufferUsages::COPY_SRC);
                let readable =
                    gpu.buffer("probes to read", bytes, BufferUsages::MAP_READ | BufferUsages::COPY_DST);
                let bound = [("pixels", given.as_entire_binding()), ("probes", results.as_entire_binding())];
                let rays_group = group(gpu.device(), "rays", &self.programs.layouts.rays, &bound);
                let mut encoder = gpu.device().create_command_encoder(&Default::default());
                {
                    let mut pass = encoder.begin_compute_pass(&Default::default());
                    pass.set_pipeline(program);
                    pass.set_bind_group(0, maps, &[0, 0]);
                    pass.set_bind_group(1, &rays_group, &[]);
                    let columns = rays.len().min(row).div_ceil(PROBE_GROUP as usize);
                    pass.dispatch_workgroups(columns as u32, rays.len().div_ceil(row) as u32, 1);
                }
                encoder.copy_buffer_to_buffer(&results, 0, &readable, 0, bytes);
                gpu.queue().submit([encoder.finish()]);
                Ok(readable)
            })
            .await?;
        gpu.read(&readable, bytes, |bytes| probes.extend(read_all::<Probe>(bytes))).await
    }
}
