//! The stages over a list of rays.

use relief_shaders::cpu::{PixelIn, Probe, Shared, read_all};
use relief_shaders::wgsl;
use wgpu::{
    BindGroupDescriptor, BindGroupEntry, BindGroupLayout, BindGroupLayoutDescriptor, BufferBindingType,
    BufferUsages, ComputePipeline, ComputePipelineDescriptor, PipelineCompilationOptions,
    PipelineLayoutDescriptor, ShaderModuleDescriptor, ShaderSource, ShaderStages,
};

use super::device::Variant;
use super::maps::{self, binding, buffer_binding};
use super::{Gpu, GpuError, Sampling};
use crate::job::Job;

/// Rays of a dispatch: a few rows of the shader's workgroups, and some ten MiB. Larger, and slow adapters may take so
/// long that the system resets them; smaller, and the waiting in between shows.
const RAYS: usize = 4 * ROW;

/// Rays of a row of the shader's workgroups.
const ROW: usize = 65_536;

/// Rays of a workgroup.
const GROUP: usize = 64;

/// The compiled probe of one variant.
#[derive(Clone)]
pub(super) struct ProbeProgram {
    maps: BindGroupLayout,
    rays: BindGroupLayout,
    pipeline: ComputePipeline,
}

impl ProbeProgram {
    fn compile(gpu: &Gpu, variant: Variant) -> Self {
        let device = &gpu.device;
        let source = match variant.sampling {
            Sampling::Exact => wgsl::PROBE_EXACT,
            Sampling::Fast => wgsl::PROBE_FAST,
        };
        let module = device.create_shader_module(ShaderModuleDescriptor {
            label: Some("probe"),
            source: ShaderSource::Wgsl(source.into()),
        });
        let maps = maps::layout(gpu, variant.sampling);
        let storage = |number, read_only| {
            binding(number, ShaderStages::COMPUTE, buffer_binding(BufferBindingType::Storage { read_only }))
        };
        let rays = device.create_bind_group_layout(&BindGroupLayoutDescriptor {
            label: Some("rays"),
            entries: &[storage(0, true), storage(1, false)],
        });
        let layout = device.create_pipeline_layout(&PipelineLayoutDescriptor {
            label: Some("probe"),
            bind_group_layouts: &[Some(&maps), Some(&rays)],
            immediate_size: 0,
        });
        let constants = variant.constants(source);
        let constants: Vec<(&str, f64)> =
            constants.iter().map(|(name, value)| (name.as_str(), *value)).collect();
        let pipeline = device.create_compute_pipeline(&ComputePipelineDescriptor {
            label: Some("probe"),
            layout: Some(&layout),
            module: &module,
            entry_point: Some("probe_main"),
            compilation_options: PipelineCompilationOptions { constants: &constants, ..Default::default() },
            cache: None,
        });
        Self { maps, rays, pipeline }
    }
}

impl Gpu {
    /// Runs a job's surface, search and refinement over rays of the caller's choice, each with its own triangle, and
    /// gives every stage's result; all zeros for a ray that never enters the relief. The job's triangles and camera are
    /// not used.
    ///
    /// # Errors
    ///
    /// When a map is larger than the adapter takes or is malformed, when the adapter cannot do the sampling, when memory
    /// runs out, or when the device is lost.
    pub fn probe(&self, job: &Job, sampling: Sampling, rays: &[PixelIn]) -> Result<Vec<Probe>, GpuError> {
        self.check_sampling(sampling)?;
        maps::check(self, job)?;
        let mut probes = Vec::new();
        probes.try_reserve_exact(rays.len()).map_err(|_| GpuError::OutOfMemory)?;
        if rays.is_empty() {
            return Ok(probes);
        }
        let variant = Variant::new(&job.settings, sampling, false);
        let program = self.probe_programs.get(self, variant, || ProbeProgram::compile(self, variant))?;
        self.guarded(|| {
            let maps = maps::upload(self, job, &program.maps, sampling)?;
            for chunk in rays.chunks(RAYS) {
                self.probe_chunk(&program, &maps, chunk, &mut probes)?;
            }
            Ok(())
        })?;
        Ok(probes)
    }

    fn probe_chunk(
        &self,
        program: &ProbeProgram,
        maps: &wgpu::BindGroup,
        rays: &[PixelIn],
        probes: &mut Vec<Probe>,
    ) -> Result<(), GpuError> {
        let bytes = (rays.len() * Probe::SIZE) as u64;
        let given = self.filled("rays", rays, BufferUsages::STORAGE)?;
        let results = self.buffer("probes", bytes, BufferUsages::STORAGE | BufferUsages::COPY_SRC);
        let readable = self.buffer("probes to read", bytes, BufferUsages::MAP_READ | BufferUsages::COPY_DST);
        let group = self.device.create_bind_group(&BindGroupDescriptor {
            label: Some("rays"),
            layout: &program.rays,
            entries: &[
                BindGroupEntry { binding: 0, resource: given.as_entire_binding() },
                BindGroupEntry { binding: 1, resource: results.as_entire_binding() },
            ],
        });
        let mut encoder = self.device.create_command_encoder(&Default::default());
        {
            let mut pass = encoder.begin_compute_pass(&Default::default());
            pass.set_pipeline(&program.pipeline);
            pass.set_bind_group(0, maps, &[]);
            pass.set_bind_group(1, &group, &[]);
            let (columns, rows) = (rays.len().min(ROW).div_ceil(GROUP), rays.len().div_ceil(ROW));
            pass.dispatch_workgroups(columns as u32, rows as u32, 1);
        }
        encoder.copy_buffer_to_buffer(&results, 0, &readable, 0, bytes);
        self.queue.submit([encoder.finish()]);
        self.read(&readable, bytes, |bytes| probes.extend(read_all::<Probe>(bytes)))
    }
}
