//! Renderer of jobs on a GPU. Each surface takes two passes: one rasterises and traces, the other
//! shades each pixel in which the surface is the nearest so far. With several samples, this is done
//! for each sample, and the results are added up.

mod time;

use std::borrow::Cow;

use rayon::prelude::*;
use relief_core::{Cancelled, Watch};
use relief_shaders::MapNeed;
use relief_shaders::cpu::{PixelOut, Record, Shared};
use relief_shaders::wgsl::{SHADE_GROUP, Sampling};
use wgpu::{
    BindGroup, Color, CommandEncoder, ComputePipeline, Features, LoadOp, Operations,
    RenderPassColorAttachment, RenderPassDepthStencilAttachment, RenderPassDescriptor,
    RenderPassTimestampWrites, RenderPipeline, StoreOp, Texture,
};

use super::draw_call::{DrawCall, check_triangles};
use super::light_map::{Caster, Frames, LightMap};
use super::pass_clock::{PassClock, PassKind, Timed, timed_compute};
use super::programs::{Composer, Programs, Viewer};
use super::resident::{Common, Resident};
use super::stencil::Counted;
use super::targets::{self, Band, Pass, Targets};
use super::textures::Precision;
use super::wait::block_on;
use super::{Gpu, GpuError, pyramid, tessellate};
use crate::cpu::tessellated::TessellatedCache;
use crate::job::{Job, JobSurface, Rendering};
use crate::samples::{Sample, samples};

/// Offset of the camera's frame in the buffer of all frames.
const CAMERA: u32 = 0;

/// Renders jobs on a GPU and caches there what they share. A second frame of the same surfaces
/// uploads a camera and compiles nothing.
#[derive(Debug)]
pub struct GpuRenderer {
    gpu: Gpu,
    programs: Programs,
    frames: Frames,
    light_map: Option<LightMap>,
    surfaces: Vec<Resident>,
    targets: Option<Targets>,
    /// Number of the current targets and buffers, which every surface binds.
    generation: u64,
    /// Cache of bases tessellated on the CPU, if this GPU cannot do it.
    tessellated: TessellatedCache,
    work: Work,
}

/// Work for a picture besides drawing it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Work {
    /// Bytes uploaded.
    pub uploaded: u64,
    /// Programs compiled.
    pub compiled: u32,
    /// Baked maps built on the GPU.
    pub built: u64,
}

/// Programs of a surface's passes.
enum SurfaceProgram {
    /// Tracing, then shading.
    Trace(Tracer, ComputePipeline),
    /// Gathering the light of a translucent surface.
    Gather(ComputePipeline),
}

/// Programs that trace a surface.
enum Tracer {
    /// One program.
    Whole(RenderPipeline),
    /// Programs that go slice by slice and image by image.
    Counted(Counted),
}

/// Surface ready to be drawn.
struct DrawableSurface {
    trace: Tracer,
    shade: ComputePipeline,
    maps: BindGroup,
    mesh: BindGroup,
    shells: Option<BindGroup>,
    drawn: DrawCall,
}

/// Translucent surface whose light is ready to be gathered.
struct TranslucentSurface {
    gather: ComputePipeline,
    maps: BindGroup,
    mesh: BindGroup,
    /// What the pass writes, and the shells that it reads.
    gathered: BindGroup,
}

/// Surfaces and programs of a picture's passes.
struct Passes {
    surfaces: Vec<DrawableSurface>,
    translucent: Vec<TranslucentSurface>,
    /// Programs before and behind the translucent surfaces, if there are any.
    compose: Option<Composer>,
    /// Program that adds up samples, if there are several.
    resolve: Option<ComputePipeline>,
}

impl Passes {
    /// Returns groups 0 and 1 of any surface, for passes that read no surface's settings of their own.
    fn first_groups(&self) -> Option<[&BindGroup; 2]> {
        let opaque = self.surfaces.first().map(|surface| [&surface.maps, &surface.mesh]);
        opaque.or_else(|| self.translucent.first().map(|surface| [&surface.maps, &surface.mesh]))
    }
}

impl GpuRenderer {
    /// Creates a renderer on `gpu` with an empty cache.
    pub fn new(gpu: Gpu) -> Self {
        let (programs, frames) = (Programs::new(&gpu), Frames::new(&gpu));
        let (light_map, surfaces, targets, work) = (None, Vec::new(), None, Work::default());
        let tessellated = TessellatedCache::default();
        Self { gpu, programs, frames, light_map, surfaces, targets, generation: 0, tessellated, work }
    }

    /// Returns the GPU.
    pub fn gpu(&self) -> &Gpu {
        &self.gpu
    }

    /// Whether the renderer itself builds a map that a surface needs and does not have. It builds
    /// pyramids of heights that are 32-bit floats on the GPU, to the bit as the CPU bakes them.
    pub fn builds(&self, need: &MapNeed, sampling: Sampling) -> bool {
        Precision::of(&self.gpu, sampling) == Precision::F32 && pyramid::over(need).is_some()
    }

    /// Returns the buffers of a surface's last tessellation: totals, corners and faces.
    #[cfg(test)]
    pub(super) fn tessellation_buffers(&self, surface: usize) -> Option<[&wgpu::Buffer; 3]> {
        self.surfaces.get(surface)?.tessellation_buffers()
    }

    /// Returns the work for the last picture besides drawing it.
    pub fn last_work(&self) -> Work {
        self.work
    }

    /// Renders a job and reads it back. `watch` gets the progress after every band of rows. It
    /// waits for the GPU, which the web does not allow: use [`Self::render_async`] there.
    ///
    /// The same adapter always gives the same picture. With exact sampling it differs from the
    /// CPU's by rounding, and at pixels on edges that the rasteriser gives to the other triangle.
    ///
    /// # Errors
    ///
    /// When the picture, a map or a mesh is larger than the adapter takes, or a map is malformed.
    /// Also when memory runs out, the device is lost, or the rendering is cancelled.
    pub fn render(
        &mut self,
        job: &Job,
        sampling: Sampling,
        watch: &Watch<'_>,
    ) -> Result<Rendering, GpuError> {
        block_on(self.render_async(job, sampling, watch))
    }

    /// Renders a job like [`Self::render`], without blocking the thread.
    ///
    /// # Errors
    ///
    /// See [`Self::render`].
    pub async fn render_async(
        &mut self,
        job: &Job,
        sampling: Sampling,
        watch: &Watch<'_>,
    ) -> Result<Rendering, GpuError> {
        let (width, height) = (job.width, job.height);
        let mut pixels = Vec::new();
        pixels.try_reserve_exact(width as usize * height as usize).map_err(|_| GpuError::OutOfMemory)?;
        let mut sink = |band: &[PixelOut]| {
            // On all cores, since the first touch of memory takes time.
            pixels.par_extend(band);
            Ok(())
        };
        self.render_bands_async(job, sampling, true, watch, &mut sink).await?;
        Ok(Rendering { width, height, pixels })
    }

    /// Renders a job in bands of whole rows, from the top. `sink` gets each band when it is read
    /// back. With `numbers`, pixels are the same as in a [`Rendering`]. Without, only the colour
    /// is; the other values come from one of the pixel's samples, which takes less time. It waits
    /// for the GPU, which the web does not allow: use [`Self::render_bands_async`] there.
    ///
    /// # Errors
    ///
    /// See [`Self::render`]. Also when `sink` cancels the rendering.
    pub fn render_bands(
        &mut self,
        job: &Job,
        sampling: Sampling,
        numbers: bool,
        watch: &Watch<'_>,
        sink: &mut dyn FnMut(&[PixelOut]) -> Result<(), Cancelled>,
    ) -> Result<(), GpuError> {
        block_on(self.render_bands_async(job, sampling, numbers, watch, sink))
    }

    /// Renders a job like [`Self::render_bands`], without blocking the thread.
    ///
    /// # Errors
    ///
    /// See [`Self::render`].
    pub async fn render_bands_async(
        &mut self,
        job: &Job,
        sampling: Sampling,
        numbers: bool,
        watch: &Watch<'_>,
        sink: &mut dyn FnMut(&[PixelOut]) -> Result<(), Cancelled>,
    ) -> Result<(), GpuError> {
        if job.width == 0 || job.height == 0 {
            return Ok(());
        }
        let before = self.work_so_far();
        let ready = self.prepare(job, sampling, samples(job.samples, numbers), None).await?;
        let mut pixels = Vec::new();
        for number in 0..self.targets()?.bands.len() {
            pixels.clear();
            let band = self.read_band(&ready, number, &mut pixels).await?;
            watch.at((band.first_row + band.rows) as f32 / job.height as f32)?;
            sink(&pixels)?;
        }
        self.work = self.work_since(before);
        Ok(())
    }

    /// Draws a job into a texture that stays on the GPU, over the frame's background. It holds
    /// linear colours in 16-bit floats. The next call draws over it. Only compiling and large
    /// uploads are waited for.
    ///
    /// # Errors
    ///
    /// See [`Self::render`]. Also when the picture is empty.
    pub async fn draw(&mut self, job: &Job, sampling: Sampling) -> Result<&Texture, GpuError> {
        if job.width == 0 || job.height == 0 {
            return Err(GpuError::EmptyPicture);
        }
        targets::check_whole(&self.gpu, [job.width, job.height])?;
        let before = self.work_so_far();
        let ready = self.prepare(job, sampling, samples(job.samples, false), None).await?;
        let show = self.programs.show(&self.gpu, sampling).await?;
        // Every surface's group 0 binds the frame and the passes. Without a surface there is only
        // the background to show.
        let maps = ready.first_groups().ok_or(GpuError::EmptyPicture)?[0].clone();
        let (gpu, layouts) = (self.gpu.clone(), self.programs.layouts.clone());
        let targets = self.targets.as_mut().ok_or(GpuError::EmptyPicture)?;
        gpu.guarded(|| {
            let (_, shown) = targets.shown(&gpu, &layouts).clone();
            for passes in &targets.bands {
                submit_band(&gpu, targets, &ready, passes, None, |encoder, last| {
                    dispatch(encoder, &show, &[&maps, &shown], targets.size[0], last, None);
                });
            }
            Ok(())
        })
        .await?;
        self.work = self.work_since(before);
        let targets = self.targets.as_mut().ok_or(GpuError::EmptyPicture)?;
        Ok(&targets.shown(&self.gpu, &self.programs.layouts).0)
    }

    fn work_so_far(&self) -> Work {
        let (uploaded, built) = (self.gpu.uploaded(), self.gpu.built());
        Work { uploaded, compiled: self.programs.compiled(), built }
    }

    fn work_since(&self, before: Work) -> Work {
        let now = self.work_so_far();
        Work {
            uploaded: now.uploaded - before.uploaded,
            compiled: now.compiled - before.compiled,
            built: now.built - before.built,
        }
    }

    fn targets(&mut self) -> Result<&mut Targets, GpuError> {
        self.targets.as_mut().ok_or(GpuError::EmptyPicture)
    }

    /// Compiles and uploads what is not cached.
    async fn prepare(
        &mut self,
        job: &Job,
        sampling: Sampling,
        samples: Vec<Sample>,
        clock: Option<&PassClock>,
    ) -> Result<Passes, GpuError> {
        let gpu = self.gpu.clone();
        targets::check(&gpu, [job.width, job.height])?;
        let job = &*if tessellate::is_possible(gpu.device()) {
            Cow::Borrowed(job)
        } else {
            self.tessellated.job(job)
        };
        for (number, surface) in job.surfaces.iter().enumerate() {
            check_triangles(&gpu, surface)?;
            if surface.selection.rays_through_scene().is_some() {
                return Err(GpuError::RaysThroughScene { surface: number });
            }
        }
        let counts = job.surfaces.iter().position(|surface| surface.selection.counts_in_stencil());
        if let Some(surface) = counts
            && !gpu.device().features().contains(Features::DEPTH32FLOAT_STENCIL8)
        {
            return Err(GpuError::NoStencil { surface });
        }
        let counts = counts.is_some();
        let viewer = if counts { Viewer::CameraBesideCounts } else { Viewer::Camera };
        let several = samples.len() > 1;
        let resolve = if several { Some(self.programs.resolve(&gpu, sampling).await?) } else { None };
        let mut programs = Vec::new();
        let count = job.surfaces.iter().filter(|surface| surface.selection.is_translucent()).count();
        let compose = if count > 0 { Some(self.programs.compose(&gpu, sampling).await?) } else { None };
        for surface in &job.surfaces {
            let JobSurface { selection, two_sided, .. } = surface;
            if selection.is_translucent() {
                programs.push(SurfaceProgram::Gather(self.programs.gather(&gpu, selection, sampling).await?));
                continue;
            }
            let trace = if selection.counts_in_stencil() {
                let programs = self.programs.stencil(&gpu, selection, sampling).await?;
                Tracer::Counted(Counted::of(surface, programs))
            } else {
                Tracer::Whole(self.programs.trace(&gpu, viewer, selection, sampling, *two_sided).await?)
            };
            programs
                .push(SurfaceProgram::Trace(trace, self.programs.shade(&gpu, selection, sampling).await?));
        }
        let mut light_programs = Vec::new();
        let has_lights = !job.light_views.frames.is_empty();
        for JobSurface { selection, two_sided, .. } in job.surfaces.iter().filter(|_| has_lights) {
            // Translucent surfaces do not hide lights.
            light_programs.push(if selection.is_translucent() {
                None
            } else {
                Some(self.programs.trace(&gpu, Viewer::Light, selection, sampling, *two_sided).await?)
            });
        }
        let builder = self.programs.pyramids(&gpu, &job.surfaces, sampling).await?;
        let tessellator = self.programs.tessellator(&gpu, &job.surfaces, sampling).await?;
        let Self { frames, light_map, surfaces, targets, generation, .. } = self;
        let layouts = &self.programs.layouts;
        let uploaded = gpu
            .guarded(|| {
                let size = [job.width, job.height];
                let fit = |targets: &Targets| {
                    (targets.size, targets.counts, targets.translucent) == (size, counts, count as u32)
                        && targets.samples == samples
                };
                if !targets.as_ref().is_some_and(fit) {
                    // The old targets are dropped first, so that both need not fit into memory.
                    drop(targets.take());
                    *targets = Some(Targets::new(&gpu, size, samples, counts, count as u32, layouts)?);
                    *generation += 1;
                }
                let targets = targets.as_ref().ok_or(GpuError::EmptyPicture)?;
                let [other_views, is_other_buffer] = frames.set(&gpu, job.frame, &job.light_views.frames);
                let fits = light_map.as_ref().map(|map| map.fits(&job.light_views));
                let is_other_map = has_lights && fits != Some(true);
                if is_other_map || !has_lights {
                    drop(light_map.take());
                }
                if is_other_map {
                    *light_map = Some(LightMap::new(&gpu, &job.light_views)?);
                }
                if is_other_buffer || is_other_map || fits.is_some() != has_lights {
                    *generation += 1;
                }
                let mut shadows_changed = other_views || is_other_map || surfaces.len() != job.surfaces.len();
                surfaces.truncate(job.surfaces.len());
                surfaces.resize_with(job.surfaces.len(), || Resident::new(&gpu));
                let common = Common {
                    number: *generation,
                    frame: frames.resource(),
                    passes: targets.passes(),
                    builder: builder.as_ref(),
                    light_map: light_map.as_ref().map(|map| &map.view),
                };
                let each = job.surfaces.iter().zip(surfaces.iter_mut()).map(|(surface, resident)| {
                    let maps = resident.maps(&gpu, surface, sampling, layouts.maps(sampling), &common)?;
                    let mesh = resident.mesh(&gpu, surface, layouts, tessellator.as_ref(), &maps, clock)?;
                    shadows_changed |= maps.changed || mesh.is_other;
                    Ok((maps, mesh))
                });
                let uploaded = each.collect::<Result<Vec<_>, GpuError>>()?;
                if let Some(map) = light_map.as_ref().filter(|_| shadows_changed) {
                    let parts = light_programs.into_iter().zip(&uploaded);
                    let casters = parts.filter_map(|(program, (maps, mesh))| {
                        Some(Caster {
                            program: program?,
                            maps: maps.for_lights.clone(),
                            mesh: mesh.group.clone(),
                            shells: mesh.shells.clone(),
                            drawn: mesh.drawn.clone(),
                        })
                    });
                    map.draw(&gpu, frames, targets.whole, &casters.collect::<Vec<_>>());
                }
                Ok(uploaded)
            })
            .await;
        // After an error it is not known what arrived.
        let uploaded = uploaded.inspect_err(|_| self.forget())?;
        let mut ready = Passes { surfaces: Vec::new(), translucent: Vec::new(), compose, resolve };
        let targets = self.targets.as_ref().ok_or(GpuError::EmptyPicture)?;
        for (program, (maps, mesh)) in programs.into_iter().zip(uploaded) {
            let (maps, shells) = (maps.for_camera, mesh.shells);
            match program {
                SurfaceProgram::Trace(trace, shade) => {
                    let (mesh, drawn) = (mesh.group, mesh.drawn);
                    ready.surfaces.push(DrawableSurface { trace, shade, maps, mesh, shells, drawn });
                }
                SurfaceProgram::Gather(gather) => {
                    let nodes = mesh.shell_nodes.as_ref();
                    let gathered =
                        nodes.and_then(|nodes| targets.gathered(&gpu, &self.programs.layouts, nodes));
                    if let Some(gathered) = gathered {
                        ready.translucent.push(TranslucentSurface {
                            gather,
                            maps,
                            mesh: mesh.group,
                            gathered,
                        });
                    }
                }
            }
        }
        Ok(ready)
    }

    /// Drops all data on the GPU except programs.
    fn forget(&mut self) {
        self.surfaces.clear();
        self.targets = None;
        self.frames = Frames::new(&self.gpu);
        self.light_map = None;
        self.generation += 1;
    }

    /// Traces and shades the rows of a band, and reads them back.
    async fn read_band(
        &mut self,
        ready: &Passes,
        number: usize,
        pixels: &mut Vec<PixelOut>,
    ) -> Result<Band, GpuError> {
        let gpu = self.gpu.clone();
        let targets = self.targets()?;
        let first = targets.bands.get(number).and_then(|passes| passes.first());
        let band = first.ok_or(GpuError::EmptyPicture)?.band;
        let [bytes, _] = targets.bytes(band);
        let readable = gpu
            .guarded(|| {
                let readable = targets.readable(&gpu).clone();
                submit_band(&gpu, targets, ready, &targets.bands[number], None, |encoder, _| {
                    encoder.copy_buffer_to_buffer(&targets.records, 0, &readable, 0, bytes);
                });
                Ok(readable)
            })
            .await?;
        let read = gpu.read(&readable, bytes, |bytes| {
            let records = bytes.par_chunks_exact(Record::SIZE).map(Record::read);
            pixels.par_extend(records.map(pixel_of));
        });
        read.await?;
        Ok(band)
    }
}

/// Traces and shades the rows of a band, sample after sample, so that no submission takes long.
/// `finish` records the end of the last one.
fn submit_band(
    gpu: &Gpu,
    targets: &Targets,
    ready: &Passes,
    passes: &[Pass],
    clock: Option<&PassClock>,
    finish: impl Fn(&mut CommandEncoder, &Pass),
) {
    for (number, pass) in passes.iter().enumerate() {
        let mut encoder = gpu.device().create_command_encoder(&Default::default());
        let [records, sums] = targets.bytes(pass.band);
        if number == 0 && ready.resolve.is_some() {
            encoder.clear_buffer(&targets.sums, 0, Some(sums));
        }
        // The first surface's pass writes all of them.
        if ready.surfaces.is_empty() {
            encoder.clear_buffer(&targets.records, 0, Some(records));
        }
        for (number, surface) in ready.surfaces.iter().enumerate() {
            let timed = |kind| clock.and_then(|clock| clock.next(kind));
            trace(&mut encoder, targets, surface, pass, number == 0, timed(PassKind::Trace));
            let groups = [&surface.maps, &surface.mesh, &targets.traced];
            dispatch(&mut encoder, &surface.shade, &groups, targets.size[0], pass, timed(PassKind::Shade));
        }
        if let (Some(composer), Some(composed), Some(first)) =
            (&ready.compose, targets.composed(), ready.translucent.first())
        {
            let around = [&first.maps, &first.mesh, composed];
            dispatch(&mut encoder, &composer.begin, &around, targets.size[0], pass, None);
            for surface in &ready.translucent {
                let timed = clock.and_then(|clock| clock.next(PassKind::Shade));
                let groups = [&surface.maps, &surface.mesh, &surface.gathered];
                dispatch(&mut encoder, &surface.gather, &groups, targets.size[0], pass, timed);
            }
            dispatch(&mut encoder, &composer.compose, &around, targets.size[0], pass, None);
        }
        if let Some((resolve, [maps, mesh])) = ready.resolve.as_ref().zip(ready.first_groups()) {
            let groups = [maps, mesh, &targets.traced];
            dispatch(&mut encoder, resolve, &groups, targets.size[0], pass, None);
        }
        if pass.is_last {
            finish(&mut encoder, pass);
        }
        gpu.queue().submit([encoder.finish()]);
    }
}

/// Rasterises and traces a surface, behind the surfaces before it unless it is the first.
fn trace(
    encoder: &mut CommandEncoder,
    targets: &Targets,
    surface: &DrawableSurface,
    pass: &Pass,
    is_first: bool,
    timed: Option<Timed>,
) {
    let ops = Operations { load: LoadOp::Clear(Color::TRANSPARENT), store: StoreOp::Store };
    let keys = if is_first { LoadOp::Clear(0.0) } else { LoadOp::Load };
    let color = |view| Some(RenderPassColorAttachment { view, depth_slice: None, resolve_target: None, ops });
    let mut drawn = encoder.begin_render_pass(&RenderPassDescriptor {
        label: Some("trace"),
        color_attachments: &[color(&targets.hit), color(&targets.what)],
        depth_stencil_attachment: Some(RenderPassDepthStencilAttachment {
            view: &targets.depth,
            depth_ops: Some(Operations { load: keys, store: StoreOp::Store }),
            stencil_ops: targets
                .counts
                .then_some(Operations { load: LoadOp::Clear(0), store: StoreOp::Discard }),
        }),
        timestamp_writes: timed.map(|Timed { queries, begin, end }| RenderPassTimestampWrites {
            query_set: queries,
            beginning_of_pass_write_index: Some(begin),
            end_of_pass_write_index: Some(end),
        }),
        occlusion_query_set: None,
        multiview_mask: None,
    });
    drawn.set_scissor_rect(0, 0, targets.size[0], pass.band.rows);
    drawn.set_bind_group(0, &surface.maps, &[CAMERA, pass.offset]);
    drawn.set_bind_group(1, &surface.mesh, &[]);
    if let Some(shells) = &surface.shells {
        drawn.set_bind_group(2, shells, &[]);
    }
    match &surface.trace {
        Tracer::Whole(program) => {
            drawn.set_pipeline(program);
            surface.drawn.draw(&mut drawn);
        }
        Tracer::Counted(counted) => counted.draw(&mut drawn),
    }
}

/// Runs a program over the pixels of a band. Group 0 has the offsets of the frame and of the pass.
fn dispatch(
    encoder: &mut CommandEncoder,
    program: &ComputePipeline,
    groups: &[&BindGroup],
    width: u32,
    pass: &Pass,
    timed: Option<Timed>,
) {
    let mut run = encoder.begin_compute_pass(&timed_compute(timed));
    run.set_pipeline(program);
    for (number, group) in (0u32..).zip(groups) {
        let offsets = [CAMERA, pass.offset];
        run.set_bind_group(number, *group, if number == 0 { &offsets } else { &[] });
    }
    run.dispatch_workgroups(width.div_ceil(SHADE_GROUP), pass.band.rows.div_ceil(SHADE_GROUP), 1);
}

fn pixel_of(record: Record) -> PixelOut {
    PixelOut {
        color: record.color,
        hit: record.hit & 1,
        exhausted: (record.hit >> 1) & 1,
        uv: record.uv,
        height: record.height,
        position: record.position,
        normal: record.normal,
        depth: record.depth,
        t: record.t,
        cell: record.cell,
        reads: record.reads,
        steps: record.steps,
        bytes: record.bytes,
        lit: record.lit,
        level: (record.hit >> 2) & 63,
        z: record.z,
        surface: record.hit >> 8,
        transmittance: record.transmittance,
    }
}
