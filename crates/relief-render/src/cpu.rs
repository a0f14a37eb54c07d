//! The CPU backend: the base meshes are ray cast, the translated shaders do the rest.

use std::sync::Arc;
use std::sync::atomic::{AtomicU32, Ordering};

use glam::Vec3;
use rayon::prelude::*;
use relief_core::HeightMap;
use relief_core::exact::FastTracer;
use relief_shaders::cpu::{Corner, Entered, Frame, Hit, PixelIn, PixelOut, Program, Triangle};

use crate::camera::Ray;
use crate::job::{Job, JobSurface, Rendering, uncovered};
use crate::kept::kept;
use crate::raycast::{RayCaster, Sides};

/// Renders jobs on all cores, and keeps the hierarchies of their meshes and height maps from one job to the
/// next.
#[derive(Debug, Default)]
pub struct CpuRenderer {
    casters: Vec<(Arc<[Triangle]>, Arc<RayCaster>)>,
    tracers: Vec<(Arc<HeightMap>, Arc<FastTracer>)>,
}

impl CpuRenderer {
    /// A renderer that has seen no job.
    pub fn new() -> Self {
        Self::default()
    }

    /// Renders a job. `progress` is told the finished part, from 0 to 1, from any thread.
    ///
    /// A surface whose selection is the exact pair is traced by the core's fast exact tracer in place of
    /// search and refinement.
    pub fn render(&mut self, job: &Job, progress: &(dyn Fn(f32) + Sync)) -> Rendering {
        let surfaces = self.ready(job);
        let done = AtomicU32::new(0);
        let mut pixels = vec![uncovered(); job.width as usize * job.height as usize];
        // A picture without columns has no rows to go through either.
        pixels.par_chunks_mut(job.width.max(1) as usize).enumerate().for_each(|(y, row)| {
            for (shaded, x) in row.iter_mut().zip(0u32..) {
                let point = [x as f32 + 0.5, y as f32 + 0.5];
                *shaded = nearest(surfaces.iter().filter_map(|surface| surface.pixel(point)));
            }
            let rows = done.fetch_add(1, Ordering::Relaxed) + 1;
            progress(rows as f32 / job.height as f32);
        });
        Rendering { width: job.width, height: job.height, pixels }
    }

    /// The addresses of what is kept: of meshes, and of height maps.
    #[cfg(test)]
    pub(crate) fn kept(&self) -> [Vec<*const ()>; 2] {
        let casters = self.casters.iter().map(|(_, caster)| Arc::as_ptr(caster).cast());
        let tracers = self.tracers.iter().map(|(_, tracer)| Arc::as_ptr(tracer).cast());
        [casters.collect(), tracers.collect()]
    }

    /// The surfaces with their hierarchies; those that the job does not need are dropped.
    fn ready<'a>(&mut self, job: &'a Job) -> Vec<Ready<'a>> {
        let (mut casters, mut tracers) = (Vec::new(), Vec::new());
        let ready = job.surfaces.iter().map(|surface| {
            let JobSurface { triangles, height_map, selection, .. } = surface;
            let base = kept(&mut casters, &self.casters, triangles, || Arc::new(caster(triangles)));
            let tracer = selection.is_exact().then(|| {
                kept(&mut tracers, &self.tracers, height_map, || Arc::new(FastTracer::new(height_map)))
            });
            Ready::new(surface, job.frame, base, tracer)
        });
        let ready = ready.collect();
        (self.casters, self.tracers) = (casters, tracers);
        ready
    }
}

fn caster(triangles: &[Triangle]) -> RayCaster {
    let position = |corner: &Corner| Vec3::new(corner.position.x, corner.position.y, corner.position.z);
    RayCaster::of_corners(triangles.iter().map(|Triangle { a, b, c }| [a, b, c].map(position)))
}

/// The nearest of the surfaces' pixels; of equally near ones the first.
fn nearest(pixels: impl Iterator<Item = PixelOut>) -> PixelOut {
    let nearer = |best: PixelOut, pixel: PixelOut| if pixel.depth < best.depth { pixel } else { best };
    pixels.reduce(nearer).unwrap_or_else(uncovered)
}

/// A surface ready to be traced.
struct Ready<'a> {
    program: Program<'a>,
    triangles: &'a [Triangle],
    base: Arc<RayCaster>,
    sides: Sides,
    tracer: Option<Arc<FastTracer>>,
}

impl<'a> Ready<'a> {
    fn new(
        surface: &'a JobSurface,
        frame: Frame,
        base: Arc<RayCaster>,
        tracer: Option<Arc<FastTracer>>,
    ) -> Self {
        let sides = if surface.two_sided { Sides::Both } else { Sides::Front };
        Self { program: surface.program(frame), triangles: &surface.triangles, base, sides, tracer }
    }

    /// What a point of the picture shows of the surface: the first base polygon along the ray whose relief is
    /// hit.
    fn pixel(&self, point: [f32; 2]) -> Option<PixelOut> {
        let direction = self.program.pixel_direction(point);
        let ray = Ray {
            origin: self.program.eye().map(f64::from).into(),
            direction: [direction.x, direction.y, direction.z].map(f64::from).into(),
        };
        self.base.hits(&ray, self.sides).find_map(|surface| {
            let side = if surface.front { 1.0 } else { -1.0 };
            let Triangle { a, b, c } = self.triangles[surface.triangle as usize];
            let pixel = self.program.pixel_of([a, b, c], side, point);
            let shaded = match &self.tracer {
                None => self.program.shade_pixel(pixel),
                Some(tracer) => self.trace_exactly(tracer, pixel),
            };
            (shaded.hit == 1).then_some(shaded)
        })
    }

    fn trace_exactly(&self, tracer: &FastTracer, pixel: PixelIn) -> PixelOut {
        let at: Entered = self.program.surface(pixel);
        let hit =
            if at.valid == 1 { tracer.trace(&(&at.path).into()).hit } else { relief_core::Hit::miss(0) };
        self.program.shade_hit(pixel, at, Hit::from(&hit))
    }
}
