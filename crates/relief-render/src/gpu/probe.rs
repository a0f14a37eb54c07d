//! Runs of the stages over a list of rays, and of search and refinement over a list of paths.

use std::marker::PhantomData;
use std::time::Duration;

use relief_shaders::cpu::{Frame, Hit, PassSettings, Path, PixelIn, Probe, Shared, read_all};
use relief_shaders::wgsl::{PROBE_GROUP, PROBE_ROW, Sampling};
use web_time::Instant;
use wgpu::{BindGroup, BindGroupLayout, Buffer, BufferUsages, CommandEncoder, ComputePipeline};

use super::layouts::group;
use super::programs::{List, Programs};
use super::resident::{Common, Resident, Uniform};
use super::{Gpu, GpuError};
use crate::block_on;
use crate::job::JobSurface;

/// Rays of a dispatch: a few rows of the shader's workgroups, and some ten MiB. With larger
/// dispatches, slow adapters may take so long that the system resets them. With smaller ones,
/// waiting takes a notable share of the time.
const RAYS: usize = 4 * PROBE_ROW as usize;

/// Runs stages over lists of rays or paths, and caches the compiled programs.
#[derive(Debug)]
pub struct Prober {
    gpu: Gpu,
    programs: Programs,
}

impl Prober {
    /// Creates a prober on `gpu`.
    pub fn new(gpu: Gpu) -> Self {
        Self { programs: Programs::new(&gpu), gpu }
    }

    /// Runs a surface's stages over rays, each with its own triangle. Returns the results of all
    /// stages for each ray, in order; all zeros for a ray that never enters the relief. The
    /// surface's own triangles are not used.
    ///
    /// # Errors
    ///
    /// When a map is larger than the adapter takes or is malformed, when memory runs out, or when
    /// the device is lost.
    pub fn probe(
        &mut self,
        surface: &JobSurface,
        sampling: Sampling,
        rays: &[PixelIn],
    ) -> Result<Vec<Probe>, GpuError> {
        block_on(async {
            let pass: Pass<PixelIn, Probe> = self.pass_over(List::Rays, surface, sampling).await?;
            self.results(&pass, rays).await
        })
    }

    /// Traces paths through a surface's relief by its search and refinement. Returns the hit of
    /// each path, in order, like [`MethodTracer`](relief_shaders::cpu::MethodTracer). The surface's
    /// own triangles are not used.
    ///
    /// # Errors
    ///
    /// See [`probe`](Self::probe).
    pub fn trace(
        &mut self,
        surface: &JobSurface,
        sampling: Sampling,
        paths: &[Path],
    ) -> Result<Vec<Hit>, GpuError> {
        block_on(async {
            let pass: Pass<Path, Hit> = self.pass_over(List::Paths, surface, sampling).await?;
            self.results(&pass, paths).await
        })
    }

    /// Measures the time of [`trace`](Self::trace) on the GPU, without uploads before and reading
    /// back after. Each dispatch traces a part of the paths. It runs `rounds` times, and its
    /// shortest time counts.
    ///
    /// # Errors
    ///
    /// See [`probe`](Self::probe).
    pub fn trace_time(
        &mut self,
        surface: &JobSurface,
        sampling: Sampling,
        paths: &[Path],
        rounds: u16,
    ) -> Result<Duration, GpuError> {
        block_on(async {
            let pass: Pass<Path, Hit> = self.pass_over(List::Paths, surface, sampling).await?;
            let mut all = Duration::ZERO;
            for part in paths.chunks(RAYS) {
                all += self.least_time(&pass, part, rounds).await?;
            }
            Ok(all)
        })
    }

    /// Creates a pass of a surface's stages over a kind of list.
    async fn pass_over<Input: Shared, Output: Shared>(
        &mut self,
        list: List,
        surface: &JobSurface,
        sampling: Sampling,
    ) -> Result<Pass<Input, Output>, GpuError> {
        let program = self.programs.over(&self.gpu, list, &surface.selection, sampling).await?;
        let maps = self.maps(surface, sampling).await?;
        let layout = self.programs.layouts.list(list).clone();
        Ok(Pass { program, maps, layout, names: list.names(), kinds: PhantomData })
    }

    /// Uploads the maps and settings that the stages of a surface read, and returns their bind
    /// group.
    async fn maps(&mut self, surface: &JobSurface, sampling: Sampling) -> Result<BindGroup, GpuError> {
        let builder = self.programs.pyramids(&self.gpu, std::slice::from_ref(surface), sampling).await?;
        let layouts = &self.programs.layouts;
        self.gpu
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
                    .map(|maps| maps.for_camera)
            })
            .await
    }

    /// Runs a pass over a list and returns its results.
    async fn results<Input: Shared, Output: Shared>(
        &self,
        pass: &Pass<Input, Output>,
        list: &[Input],
    ) -> Result<Vec<Output>, GpuError> {
        let mut made = Vec::new();
        made.try_reserve_exact(list.len()).map_err(|_| GpuError::OutOfMemory)?;
        for part in list.chunks(RAYS) {
            let gpu = &self.gpu;
            let bytes = (part.len() * Output::SIZE) as u64;
            let readable = gpu
                .guarded(|| {
                    let part = pass.part(gpu, part)?;
                    let usage = BufferUsages::MAP_READ | BufferUsages::COPY_DST;
                    let readable = gpu.buffer("results to read", bytes, usage);
                    let mut encoder = gpu.device().create_command_encoder(&Default::default());
                    pass.dispatch(&part, &mut encoder);
                    encoder.copy_buffer_to_buffer(&part.results, 0, &readable, 0, bytes);
                    gpu.queue().submit([encoder.finish()]);
                    Ok(readable)
                })
                .await?;
            gpu.read(&readable, bytes, |bytes| made.extend(read_all::<Output>(bytes))).await?;
        }
        Ok(made)
    }

    /// Returns the shortest time of several runs of a pass over a part of a list.
    async fn least_time<Input: Shared, Output: Shared>(
        &self,
        pass: &Pass<Input, Output>,
        part: &[Input],
        rounds: u16,
    ) -> Result<Duration, GpuError> {
        let gpu = &self.gpu;
        let part = gpu.guarded(|| pass.part(gpu, part)).await?;
        let mut least = None;
        for _ in 0..rounds {
            let start = Instant::now();
            gpu.guarded(|| {
                let mut encoder = gpu.device().create_command_encoder(&Default::default());
                pass.dispatch(&part, &mut encoder);
                gpu.queue().submit([encoder.finish()]);
                Ok(())
            })
            .await?;
            gpu.wait()?;
            let taken = start.elapsed();
            least = Some(least.map_or(taken, |least: Duration| least.min(taken)));
        }
        Ok(least.unwrap_or_default())
    }
}

/// Program over a list, with the bind group of a surface.
struct Pass<Input, Output> {
    program: ComputePipeline,
    maps: BindGroup,
    layout: BindGroupLayout,
    /// Names of the bindings of the list and of the results.
    names: [&'static str; 2],
    kinds: PhantomData<(Input, Output)>,
}

/// Part of a list for one dispatch.
struct Part {
    len: usize,
    results: Buffer,
    group: BindGroup,
}

impl<Input: Shared, Output: Shared> Pass<Input, Output> {
    /// Uploads a part of a list, and allocates its results.
    fn part(&self, gpu: &Gpu, list: &[Input]) -> Result<Part, GpuError> {
        let [given, made] = self.names;
        let list_buffer = gpu.filled(given, list, BufferUsages::STORAGE)?;
        let bytes = (list.len() * Output::SIZE) as u64;
        let results = gpu.buffer(made, bytes, BufferUsages::STORAGE | BufferUsages::COPY_SRC);
        let bound = [(given, list_buffer.as_entire_binding()), (made, results.as_entire_binding())];
        let group = group(gpu.device(), given, &self.layout, &bound);
        Ok(Part { len: list.len(), results, group })
    }

    fn dispatch(&self, part: &Part, encoder: &mut CommandEncoder) {
        let mut pass = encoder.begin_compute_pass(&Default::default());
        pass.set_pipeline(&self.program);
        pass.set_bind_group(0, &self.maps, &[0, 0]);
        pass.set_bind_group(1, &part.group, &[]);
        let row = PROBE_ROW as usize;
        let columns = part.len.min(row).div_ceil(PROBE_GROUP as usize);
        pass.dispatch_workgroups(columns as u32, part.len.div_ceil(row) as u32, 1);
    }
}
