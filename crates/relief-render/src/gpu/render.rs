//! The picture, in two passes.

use relief_shaders::cpu::{PixelOut, Record, Shared, Triangle, read_all, write_all};
use relief_shaders::{cpu::Band, wgsl};
use wgpu::{
    BindGroup, BindGroupDescriptor, BindGroupEntry, BindGroupLayout, BindGroupLayoutDescriptor,
    BindingResource, Buffer, BufferBindingType, BufferUsages, Color, ColorTargetState, CommandEncoder,
    CompareFunction, ComputePipeline, ComputePipelineDescriptor, DepthStencilState, Extent3d, Face,
    FragmentState, LoadOp, Operations, PipelineCompilationOptions, PipelineLayoutDescriptor, PrimitiveState,
    RenderPassColorAttachment, RenderPassDepthStencilAttachment, RenderPassDescriptor, RenderPipeline,
    RenderPipelineDescriptor, ShaderModuleDescriptor, ShaderSource, ShaderStages, StoreOp, TextureDescriptor,
    TextureDimension, TextureFormat, TextureSampleType, TextureUsages, TextureView, TextureViewDescriptor,
    VertexState,
};

use super::device::Variant;
use super::maps::{self, binding, buffer_binding, texture_binding};
use super::{Gpu, GpuError, Sampling};
use crate::job::{Job, Rendering};

/// Pixels of a band of rows, which is traced, shaded and read back at once: 20 MiB of records. Larger, and slow adapters
/// may take so long that the system resets them; smaller, and the mesh is drawn more often than need be.
const BAND_PIXELS: u32 = 1 << 18;

/// Rows and columns of a workgroup of the shading pass.
const GROUP: u32 = 8;

const HIT: TextureFormat = TextureFormat::Rgba32Float;
const WHAT: TextureFormat = TextureFormat::Rg32Sint;
const DEPTH: TextureFormat = TextureFormat::Depth32Float;

/// The compiled passes of one variant.
#[derive(Clone)]
pub(super) struct RenderProgram {
    maps: BindGroupLayout,
    mesh: BindGroupLayout,
    traced: BindGroupLayout,
    trace: RenderPipeline,
    shade: ComputePipeline,
}

impl RenderProgram {
    fn compile(gpu: &Gpu, variant: Variant) -> Self {
        let device = &gpu.device;
        let source = match variant.sampling {
            Sampling::Exact => wgsl::RENDER_EXACT,
            Sampling::Fast => wgsl::RENDER_FAST,
        };
        let module = device.create_shader_module(ShaderModuleDescriptor {
            label: Some("render"),
            source: ShaderSource::Wgsl(source.into()),
        });
        let every = ShaderStages::VERTEX_FRAGMENT | ShaderStages::COMPUTE;
        let uniform = buffer_binding(BufferBindingType::Uniform);
        let storage = |read_only| buffer_binding(BufferBindingType::Storage { read_only });
        let layout = |label, entries: &[_]| {
            device.create_bind_group_layout(&BindGroupLayoutDescriptor { label: Some(label), entries })
        };
        let maps = maps::layout(gpu, variant.sampling);
        let mesh =
            layout("mesh", &[binding(0, ShaderStages::VERTEX, uniform), binding(1, every, storage(true))]);
        let float = texture_binding(TextureSampleType::Float { filterable: false });
        let traced = layout(
            "traced",
            &[
                binding(0, ShaderStages::COMPUTE, float),
                binding(1, ShaderStages::COMPUTE, texture_binding(TextureSampleType::Sint)),
                binding(2, ShaderStages::COMPUTE, storage(false)),
                binding(3, ShaderStages::COMPUTE, uniform),
            ],
        );
        let pipeline_layout = |label, groups: &[_]| {
            device.create_pipeline_layout(&PipelineLayoutDescriptor {
                label: Some(label),
                bind_group_layouts: groups,
                immediate_size: 0,
            })
        };
        let constants = variant.constants(source);
        let constants: Vec<(&str, f64)> =
            constants.iter().map(|(name, value)| (name.as_str(), *value)).collect();
        let options = PipelineCompilationOptions { constants: &constants, ..Default::default() };
        let target = |format: TextureFormat| Some(ColorTargetState::from(format));
        let trace = device.create_render_pipeline(&RenderPipelineDescriptor {
            label: Some("trace"),
            layout: Some(&pipeline_layout("trace", &[Some(&maps), Some(&mesh)])),
            vertex: VertexState {
                module: &module,
                entry_point: Some("vertex_main"),
                compilation_options: options.clone(),
                buffers: &[],
            },
            primitive: PrimitiveState {
                cull_mode: (!variant.two_sided).then_some(Face::Back),
                ..Default::default()
            },
            // Strictly nearer: of two triangles at the same depth the first counts, as on the CPU.
            depth_stencil: Some(DepthStencilState {
                format: DEPTH,
                depth_write_enabled: Some(true),
                depth_compare: Some(CompareFunction::Less),
                stencil: Default::default(),
                bias: Default::default(),
            }),
            multisample: Default::default(),
            fragment: Some(FragmentState {
                module: &module,
                entry_point: Some("fragment_main"),
                compilation_options: options.clone(),
                targets: &[target(HIT), target(WHAT)],
            }),
            multiview_mask: None,
            cache: None,
        });
        let shade = device.create_compute_pipeline(&ComputePipelineDescriptor {
            label: Some("shade"),
            layout: Some(&pipeline_layout("shade", &[Some(&maps), Some(&mesh), Some(&traced)])),
            module: &module,
            entry_point: Some("shade_main"),
            compilation_options: options,
            cache: None,
        });
        Self { maps, mesh, traced, trace, shade }
    }
}

/// What the passes write: textures of the whole picture, buffers of a band.
struct Targets {
    hit: TextureView,
    what: TextureView,
    depth: TextureView,
    band: Buffer,
    records: Buffer,
    readable: Buffer,
}

impl Targets {
    fn new(gpu: &Gpu, width: u32, height: u32, rows: u32) -> Self {
        let texture = |label, format, usage| {
            let texture = gpu.device.create_texture(&TextureDescriptor {
                label: Some(label),
                size: Extent3d { width, height, depth_or_array_layers: 1 },
                mip_level_count: 1,
                sample_count: 1,
                dimension: TextureDimension::D2,
                format,
                usage: TextureUsages::RENDER_ATTACHMENT | usage,
                view_formats: &[],
            });
            texture.create_view(&TextureViewDescriptor::default())
        };
        let bytes = u64::from(width) * u64::from(rows) * Record::SIZE as u64;
        Self {
            hit: texture("traced hit", HIT, TextureUsages::TEXTURE_BINDING),
            what: texture("traced what", WHAT, TextureUsages::TEXTURE_BINDING),
            depth: texture("depth", DEPTH, TextureUsages::empty()),
            band: gpu.buffer("band", Band::SIZE as u64, BufferUsages::UNIFORM | BufferUsages::COPY_DST),
            records: gpu.buffer(
                "records",
                bytes,
                BufferUsages::STORAGE | BufferUsages::COPY_SRC | BufferUsages::COPY_DST,
            ),
            readable: gpu.buffer("records to read", bytes, BufferUsages::MAP_READ | BufferUsages::COPY_DST),
        }
    }
}

/// The bind groups, and how many vertices there are to draw.
struct Bound {
    maps: BindGroup,
    mesh: BindGroup,
    traced: BindGroup,
    vertices: u32,
}

impl Gpu {
    /// Renders a job. `progress` is told the part done, from 0 to 1, after every band of rows.
    ///
    /// The picture is the same whenever it is rendered on the same adapter. Against the CPU, exact sampling differs where
    /// the rasteriser gives a pixel on the edge of two triangles to the other one, and by rounding.
    ///
    /// # Errors
    ///
    /// When the picture, a map or the mesh is larger than the adapter takes, when a map is malformed, when the adapter
    /// cannot do the sampling, when memory runs out, or when the device is lost.
    pub fn render(
        &self,
        job: &Job,
        sampling: Sampling,
        progress: &dyn Fn(f32),
    ) -> Result<Rendering, GpuError> {
        let (width, height) = (job.width, job.height);
        self.check_sampling(sampling)?;
        self.check_texture("picture", width, height)?;
        maps::check(self, job)?;
        // The number of a triangle travels as a signed integer, that of a vertex as an unsigned one.
        let limit = self.storage_capacity(Triangle::SIZE).min(u64::from(u32::MAX / 3));
        if job.triangles.len() as u64 > limit {
            return Err(GpuError::TooManyTriangles { count: job.triangles.len(), limit });
        }
        let mut pixels = Vec::new();
        pixels.try_reserve_exact(width as usize * height as usize).map_err(|_| GpuError::OutOfMemory)?;
        if width == 0 || height == 0 {
            return Ok(Rendering { width, height, pixels });
        }
        let variant = Variant::new(&job.settings, sampling, job.two_sided);
        let program = self.render_programs.get(self, variant, || RenderProgram::compile(self, variant))?;
        let band_rows = (BAND_PIXELS / width).clamp(1, height);
        let (targets, bound) = self.guarded(|| {
            let targets = Targets::new(self, width, height, band_rows);
            let bound = self.bind(job, &program, &targets, sampling)?;
            Ok((targets, bound))
        })?;
        for first_row in (0..height).step_by(band_rows as usize) {
            let band = Band { first_row, rows: band_rows.min(height - first_row) };
            self.guarded(|| self.render_band(&program, &targets, &bound, width, band, &mut pixels))?;
            progress((first_row + band.rows) as f32 / height as f32);
        }
        Ok(Rendering { width, height, pixels })
    }

    fn bind(
        &self,
        job: &Job,
        program: &RenderProgram,
        targets: &Targets,
        sampling: Sampling,
    ) -> Result<Bound, GpuError> {
        let maps = maps::upload(self, job, &program.maps, sampling)?;
        let columns = job.view_projection.as_flattened();
        let matrix = self.filled("view projection", columns, BufferUsages::UNIFORM)?;
        let triangles = self.filled("triangles", job.triangles, BufferUsages::STORAGE)?;
        let entry = |binding, resource| BindGroupEntry { binding, resource };
        let group = |label, layout, entries: &[_]| {
            self.device.create_bind_group(&BindGroupDescriptor { label: Some(label), layout, entries })
        };
        let mesh = group(
            "mesh",
            &program.mesh,
            &[entry(0, matrix.as_entire_binding()), entry(1, triangles.as_entire_binding())],
        );
        let traced = group(
            "traced",
            &program.traced,
            &[
                entry(0, BindingResource::TextureView(&targets.hit)),
                entry(1, BindingResource::TextureView(&targets.what)),
                entry(2, targets.records.as_entire_binding()),
                entry(3, targets.band.as_entire_binding()),
            ],
        );
        Ok(Bound { maps, mesh, traced, vertices: 3 * job.triangles.len() as u32 })
    }

    /// Traces, shades and reads back the rows of a band.
    fn render_band(
        &self,
        program: &RenderProgram,
        targets: &Targets,
        bound: &Bound,
        width: u32,
        band: Band,
        pixels: &mut Vec<PixelOut>,
    ) -> Result<(), GpuError> {
        self.queue.write_buffer(&targets.band, 0, &write_all(&[band]));
        let bytes = u64::from(width) * u64::from(band.rows) * Record::SIZE as u64;
        let mut encoder = self.device.create_command_encoder(&Default::default());
        trace(&mut encoder, program, targets, bound, width, band);
        // Pixels that nothing covers are not written.
        encoder.clear_buffer(&targets.records, 0, Some(bytes));
        {
            let mut pass = encoder.begin_compute_pass(&Default::default());
            pass.set_pipeline(&program.shade);
            pass.set_bind_group(0, &bound.maps, &[]);
            pass.set_bind_group(1, &bound.mesh, &[]);
            pass.set_bind_group(2, &bound.traced, &[]);
            pass.dispatch_workgroups(width.div_ceil(GROUP), band.rows.div_ceil(GROUP), 1);
        }
        encoder.copy_buffer_to_buffer(&targets.records, 0, &targets.readable, 0, bytes);
        self.queue.submit([encoder.finish()]);
        self.read(&targets.readable, bytes, |bytes| {
            pixels.extend(read_all::<Record>(bytes).into_iter().map(pixel_of));
        })
    }
}

fn trace(
    encoder: &mut CommandEncoder,
    program: &RenderProgram,
    targets: &Targets,
    bound: &Bound,
    width: u32,
    band: Band,
) {
    let first = band.first_row == 0;
    let load = if first { LoadOp::Clear(Color::TRANSPARENT) } else { LoadOp::Load };
    let ops = Operations { load, store: StoreOp::Store };
    let depth =
        Operations { load: if first { LoadOp::Clear(1.0) } else { LoadOp::Load }, store: StoreOp::Store };
    let color = |view| Some(RenderPassColorAttachment { view, depth_slice: None, resolve_target: None, ops });
    let mut pass = encoder.begin_render_pass(&RenderPassDescriptor {
        label: Some("trace"),
        color_attachments: &[color(&targets.hit), color(&targets.what)],
        depth_stencil_attachment: Some(RenderPassDepthStencilAttachment {
            view: &targets.depth,
            depth_ops: Some(depth),
            stencil_ops: None,
        }),
        timestamp_writes: None,
        occlusion_query_set: None,
        multiview_mask: None,
    });
    pass.set_pipeline(&program.trace);
    pass.set_bind_group(0, &bound.maps, &[]);
    pass.set_bind_group(1, &bound.mesh, &[]);
    pass.set_scissor_rect(0, band.first_row, width, band.rows);
    pass.draw(0..bound.vertices, 0..1);
}

fn pixel_of(record: Record) -> PixelOut {
    PixelOut {
        color: record.color,
        hit: record.hit,
        exhausted: record.exhausted,
        uv: record.uv,
        height: record.height,
        position: record.position,
        normal: record.normal,
        depth: record.depth,
        t: record.t,
        cell: record.cell,
        reads: record.reads,
    }
}
