//! Preparing of a picture: what is not cached is compiled and uploaded.

use std::borrow::Cow;

use relief_shaders::wgsl::Sampling;
use wgpu::{ComputePipeline, Features};

use super::GpuRenderer;
use super::passes::{DrawableSurface, Passes, Tracer, TranslucentSurface};
use crate::gpu::draw_call::check_triangles;
use crate::gpu::light_map::{Caster, Frames, LightMap};
use crate::gpu::pass_clock::PassClock;
use crate::gpu::programs::Viewer;
use crate::gpu::resident::{Common, Resident};
use crate::gpu::stencil::Counted;
use crate::gpu::targets::{self, Targets};
use crate::gpu::{GpuError, tessellate};
use crate::job::{Job, JobSurface};
use crate::samples::Sample;

/// Programs of a surface's passes.
enum SurfaceProgram {
    /// Tracing, then shading.
    Trace(Tracer, ComputePipeline),
    /// Gathering the light of a translucent surface.
    Gather(ComputePipeline),
}

impl GpuRenderer {
    /// Compiles and uploads what is not cached.
    pub(super) async fn prepare(
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
}
