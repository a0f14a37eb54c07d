//! Pictures, in two passes for each surface: rasterise and trace, then shade each pixel once.

use relief_shaders::cpu::{Frame, PixelOut, Record, Shared, Triangle, read_all};
use relief_shaders::wgsl::{SHADE_GROUP, Sampling};
use wgpu::{
    BindGroup, Color, CommandEncoder, ComputePipeline, LoadOp, Operations, RenderPassColorAttachment,
    RenderPassDepthStencilAttachment, RenderPassDescriptor, RenderPipeline, StoreOp, Texture,
};

use super::programs::Programs;
use super::resident::{Common, Resident, Uniform};
use super::targets::{self, Band, Targets};
use super::wait::block_on;
use super::{Gpu, GpuError};
use crate::job::{Job, JobSurface, Rendering};

/// Renders jobs on a GPU, and keeps there what they have in common: a second frame of the same surfaces
/// uploads a camera and compiles nothing.
#[derive(Debug)]
pub struct GpuRenderer {
    gpu: Gpu,
    programs: Programs,
    frame: Uniform,
    surfaces: Vec<Resident>,
    targets: Option<Targets>,
    /// Counts the targets that there were, whose buffers every surface binds.
    generation: u64,
    work: Work,
}

/// What a picture took besides the drawing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Work {
    /// Bytes uploaded.
    pub uploaded: u64,
    /// Programs compiled.
    pub compiled: u32,
}

/// A surface ready to be drawn.
struct Ready {
    trace: RenderPipeline,
    shade: ComputePipeline,
    maps: BindGroup,
    mesh: BindGroup,
    vertices: u32,
}

/// All that the passes of a picture need.
struct Passes {
    surfaces: Vec<Ready>,
    /// The program that empties what the surface before has traced, where there are several.
    clear: Option<RenderPipeline>,
}

impl GpuRenderer {
    /// A renderer on that GPU that has seen no job.
    pub fn new(gpu: Gpu) -> Self {
        let (programs, frame) = (Programs::new(&gpu), Uniform::new::<Frame>(&gpu, "frame"));
        let (targets, work) = (None, Work::default());
        Self { gpu, programs, frame, surfaces: Vec::new(), targets, generation: 0, work }
    }

    /// The GPU.
    pub fn gpu(&self) -> &Gpu {
        &self.gpu
    }

    /// What the last picture took besides the drawing.
    pub fn last_work(&self) -> Work {
        self.work
    }

    /// Renders a job and reads it back. `progress` is told the part done, from 0 to 1, after every band of
    /// rows. Waits for the GPU, which the web does not allow: see [`Self::render_async`].
    ///
    /// The picture is the same whenever it is rendered on the same adapter. Against the CPU, exact sampling
    /// differs where the rasteriser gives a pixel on the edge of two triangles to the other one, and by
    /// rounding.
    ///
    /// # Errors
    ///
    /// When the picture, a map or a mesh is larger than the adapter takes, when a map is malformed, when
    /// memory runs out, or when the device is lost.
    pub fn render(
        &mut self,
        job: &Job,
        sampling: Sampling,
        progress: &dyn Fn(f32),
    ) -> Result<Rendering, GpuError> {
        block_on(self.render_async(job, sampling, progress))
    }

    /// [`Self::render`] without waiting.
    ///
    /// # Errors
    ///
    /// As [`Self::render`].
    pub async fn render_async(
        &mut self,
        job: &Job,
        sampling: Sampling,
        progress: &dyn Fn(f32),
    ) -> Result<Rendering, GpuError> {
        let (width, height) = (job.width, job.height);
        let mut pixels = Vec::new();
        pixels.try_reserve_exact(width as usize * height as usize).map_err(|_| GpuError::OutOfMemory)?;
        if width == 0 || height == 0 {
            return Ok(Rendering { width, height, pixels });
        }
        let before = self.work_so_far();
        let passes = self.prepare(job, sampling).await?;
        for number in 0..self.targets()?.bands.len() {
            let band = self.targets()?.bands[number];
            self.read_band(&passes, band, &mut pixels).await?;
            progress((band.first_row + band.rows) as f32 / height as f32);
        }
        self.work = self.work_since(before);
        Ok(Rendering { width, height, pixels })
    }

    /// Draws a job into a picture that stays on the GPU, of linear colours in 16-bit floats, over the frame's
    /// background. It is drawn over by the next call. Nothing is waited for but compilers and large uploads.
    ///
    /// # Errors
    ///
    /// As [`Self::render`], and when the picture is empty.
    pub async fn draw(&mut self, job: &Job, sampling: Sampling) -> Result<&Texture, GpuError> {
        if job.width == 0 || job.height == 0 {
            return Err(GpuError::EmptyPicture);
        }
        let before = self.work_so_far();
        let passes = self.prepare(job, sampling).await?;
        let show = self.programs.show(&self.gpu, sampling).await?;
        // Every surface's group 0 binds the frame and the passes; without one there is nothing to show but
        // the background.
        let maps = passes.surfaces.first().ok_or(GpuError::EmptyPicture)?.maps.clone();
        let (gpu, layouts) = (self.gpu.clone(), self.programs.layouts.clone());
        let targets = self.targets.as_mut().ok_or(GpuError::EmptyPicture)?;
        gpu.guarded(|| {
            let (_, shown) = targets.shown(&gpu, &layouts).clone();
            for band in &targets.bands {
                let mut encoder = gpu.device().create_command_encoder(&Default::default());
                encode_band(&mut encoder, targets, &passes, *band);
                dispatch(&mut encoder, &show, &[&maps, &shown], targets.size[0], *band);
                gpu.queue().submit([encoder.finish()]);
            }
            Ok(())
        })
        .await?;
        self.work = self.work_since(before);
        let targets = self.targets.as_mut().ok_or(GpuError::EmptyPicture)?;
        Ok(&targets.shown(&self.gpu, &self.programs.layouts).0)
    }

    fn work_so_far(&self) -> Work {
        Work { uploaded: self.gpu.uploaded(), compiled: self.programs.compiled() }
    }

    fn work_since(&self, before: Work) -> Work {
        let now = self.work_so_far();
        Work { uploaded: now.uploaded - before.uploaded, compiled: now.compiled - before.compiled }
    }

    fn targets(&mut self) -> Result<&mut Targets, GpuError> {
        self.targets.as_mut().ok_or(GpuError::EmptyPicture)
    }

    /// Compiles and uploads what is not there.
    async fn prepare(&mut self, job: &Job, sampling: Sampling) -> Result<Passes, GpuError> {
        let gpu = self.gpu.clone();
        targets::check(&gpu, [job.width, job.height])?;
        for surface in &job.surfaces {
            check_triangles(&gpu, surface)?;
        }
        let clear = if job.surfaces.len() > 1 { Some(self.programs.clear(&gpu).await?) } else { None };
        let mut programs = Vec::new();
        for JobSurface { selection, two_sided, .. } in &job.surfaces {
            let trace = self.programs.trace(&gpu, selection, sampling, *two_sided).await?;
            programs.push((trace, self.programs.shade(&gpu, selection, sampling).await?));
        }
        let Self { frame, surfaces, targets, generation, .. } = self;
        let layouts = &self.programs.layouts;
        let uploaded = gpu
            .guarded(|| {
                if targets.as_ref().is_none_or(|targets| targets.size != [job.width, job.height]) {
                    // What was there goes first, so that both need not fit.
                    drop(targets.take());
                    *targets = Some(Targets::new(&gpu, [job.width, job.height], layouts));
                    *generation += 1;
                }
                let targets = targets.as_ref().ok_or(GpuError::EmptyPicture)?;
                frame.set(&gpu, job.frame);
                surfaces.truncate(job.surfaces.len());
                surfaces.resize_with(job.surfaces.len(), || Resident::new(&gpu));
                let common =
                    Common { number: *generation, frame: frame.resource(), passes: targets.passes() };
                let each = job.surfaces.iter().zip(surfaces.iter_mut()).map(|(surface, resident)| {
                    let maps = resident.maps(&gpu, surface, sampling, layouts.maps(sampling), &common)?;
                    let mesh = resident.mesh(&gpu, &surface.triangles, &layouts.mesh)?;
                    Ok((maps, mesh, 3 * surface.triangles.len() as u32))
                });
                each.collect::<Result<Vec<_>, GpuError>>()
            })
            .await;
        // After an error it is not known what arrived.
        let uploaded = uploaded.inspect_err(|_| self.forget())?;
        let ready = programs.into_iter().zip(uploaded);
        let surfaces = ready.map(|((trace, shade), (maps, mesh, vertices))| Ready {
            trace,
            shade,
            maps,
            mesh,
            vertices,
        });
        Ok(Passes { surfaces: surfaces.collect(), clear })
    }

    /// Forgets what lies on the GPU, but for programs.
    fn forget(&mut self) {
        self.surfaces.clear();
        self.targets = None;
        self.frame = Uniform::new::<Frame>(&self.gpu, "frame");
        self.generation += 1;
    }

    /// Traces, shades and reads back the rows of a band.
    async fn read_band(
        &mut self,
        passes: &Passes,
        band: Band,
        pixels: &mut Vec<PixelOut>,
    ) -> Result<(), GpuError> {
        let gpu = self.gpu.clone();
        let targets = self.targets()?;
        let bytes = targets.bytes(band);
        let readable = gpu
            .guarded(|| {
                let readable = targets.readable(&gpu).clone();
                let mut encoder = gpu.device().create_command_encoder(&Default::default());
                encode_band(&mut encoder, targets, passes, band);
                encoder.copy_buffer_to_buffer(&targets.records, 0, &readable, 0, bytes);
                gpu.queue().submit([encoder.finish()]);
                Ok(readable)
            })
            .await?;
        let read = gpu.read(&readable, bytes, |bytes| {
            pixels.extend(read_all::<Record>(bytes).into_iter().map(pixel_of));
        });
        read.await
    }
}

/// The number of a triangle travels as a signed integer, that of a vertex as an unsigned one.
fn check_triangles(gpu: &Gpu, surface: &JobSurface) -> Result<(), GpuError> {
    let (count, limit) = (surface.triangles.len(), gpu.storage_capacity(Triangle::SIZE));
    let limit = limit.min(u64::from(u32::MAX / 3));
    if count as u64 > limit { Err(GpuError::TooManyTriangles { count, limit }) } else { Ok(()) }
}

/// Traces and shades the rows of a band, surface after surface.
fn encode_band(encoder: &mut CommandEncoder, targets: &Targets, passes: &Passes, band: Band) {
    // Pixels that nothing covers are not written.
    encoder.clear_buffer(&targets.records, 0, Some(targets.bytes(band)));
    for (number, surface) in passes.surfaces.iter().enumerate() {
        trace(encoder, targets, surface, passes.clear.as_ref().filter(|_| number > 0), number, band);
        let groups = [&surface.maps, &surface.mesh, &targets.traced];
        dispatch(encoder, &surface.shade, &groups, targets.size[0], band);
    }
}

/// Rasterises and traces a surface. The first one clears all of the targets once, each further one its band.
fn trace(
    encoder: &mut CommandEncoder,
    targets: &Targets,
    surface: &Ready,
    clear: Option<&RenderPipeline>,
    number: usize,
    band: Band,
) {
    let first = number == 0 && band.first_row == 0;
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
    pass.set_scissor_rect(0, band.first_row, targets.size[0], band.rows);
    if let Some(clear) = clear {
        pass.set_pipeline(clear);
        pass.draw(0..3, 0..1);
    }
    pass.set_pipeline(&surface.trace);
    pass.set_bind_group(0, &surface.maps, &[band.offset]);
    pass.set_bind_group(1, &surface.mesh, &[]);
    pass.draw(0..surface.vertices, 0..1);
}

/// Runs a program over the pixels of a band. Group 0 has the offset of the band's pass.
fn dispatch(
    encoder: &mut CommandEncoder,
    program: &ComputePipeline,
    groups: &[&BindGroup],
    width: u32,
    band: Band,
) {
    let mut pass = encoder.begin_compute_pass(&Default::default());
    pass.set_pipeline(program);
    for (number, group) in (0u32..).zip(groups) {
        let offsets = [band.offset];
        pass.set_bind_group(number, *group, if number == 0 { &offsets } else { &[] });
    }
    pass.dispatch_workgroups(width.div_ceil(SHADE_GROUP), band.rows.div_ceil(SHADE_GROUP), 1);
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
