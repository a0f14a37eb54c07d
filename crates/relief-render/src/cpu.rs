//! The CPU backend: the base meshes are ray cast, the translated shaders do the rest.

use std::ops::ControlFlow;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU32, Ordering};

use glam::Vec3;
use rayon::prelude::*;
use relief_core::exact::FastTracer;
use relief_core::{Cost, HeightMap};
use relief_shaders::cpu::{Corner, Entered, Frame, Hit, PixelIn, PixelOut, Program, Triangle, Vec4};
use relief_shaders::{LightRayState, MAX_LIGHTS};

use crate::camera::Ray;
use crate::job::{Job, JobSurface, Rendering, uncovered};
use crate::kept::kept;
use crate::raycast::{RayCaster, Sides};
use crate::samples::{Sample, samples};

/// Pixels of a band of rows: enough for all cores, and few enough to keep.
const BAND_PIXELS: u32 = 1 << 18;

/// Renders jobs on all cores, and keeps the hierarchies of their meshes and height maps from one job to the
/// next.
#[derive(Debug, Default)]
pub struct CpuRenderer {
    casters: Vec<(Arc<[Triangle]>, Arc<RayCaster>)>,
    tracers: Vec<(Arc<HeightMap>, Arc<[FastTracer]>)>,
}

impl CpuRenderer {
    /// A renderer that has seen no job.
    pub fn new() -> Self {
        Self::default()
    }

    /// Renders a job; `None` where the memory for the picture cannot be had. `progress` is told the finished
    /// part, from 0 to 1, from any thread.
    ///
    /// A surface whose selection is the exact pair is traced by the core's fast exact tracer in place of
    /// search and refinement.
    pub fn render(&mut self, job: &Job, progress: &(dyn Fn(f32) + Sync)) -> Option<Rendering> {
        let count = (job.width as usize).checked_mul(job.height as usize)?;
        let mut pixels = Vec::new();
        pixels.try_reserve_exact(count).ok()?;
        pixels.resize(count, uncovered());
        let samples = samples(job.samples, true);
        let surfaces = self.ready(job);
        let whole = Rows { job, samples: &samples, surfaces: &surfaces, first: 0 };
        let done = AtomicU32::new(0);
        whole.render(&mut pixels, &AtomicBool::new(false), &|| {
            let rows = done.fetch_add(1, Ordering::Relaxed) + 1;
            progress(rows as f32 / job.height as f32);
        });
        Some(Rendering { width: job.width, height: job.height, pixels })
    }

    /// Renders a job in bands of whole rows, from the top, and hands over each when it is done, until it is
    /// told to stop or `cancel` is set. With `numbers` all numbers of a pixel are as in a [`Rendering`]; else
    /// they are those of one of its samples, which takes less time. `progress` is told the finished part,
    /// from any thread.
    pub fn render_bands(
        &mut self,
        job: &Job,
        numbers: bool,
        progress: &(dyn Fn(f32) + Sync),
        cancel: &AtomicBool,
        sink: &mut dyn FnMut(&[PixelOut]) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        let samples = samples(job.samples, numbers);
        let surfaces = self.ready(job);
        let rows = (BAND_PIXELS / job.width.max(1)).clamp(1, job.height.max(1));
        let mut pixels = vec![uncovered(); job.width as usize * rows as usize];
        let done = AtomicU32::new(0);
        for first in (0..job.height).step_by(rows as usize) {
            let rows = rows.min(job.height - first);
            let pixels = &mut pixels[..job.width as usize * rows as usize];
            Rows { job, samples: &samples, surfaces: &surfaces, first }.render(pixels, cancel, &|| {
                let rows = done.fetch_add(1, Ordering::Relaxed) + 1;
                progress(rows as f32 / job.height as f32);
            });
            if cancel.load(Ordering::Relaxed) {
                return ControlFlow::Break(());
            }
            sink(pixels)?;
        }
        ControlFlow::Continue(())
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
                kept(&mut tracers, &self.tracers, height_map, || {
                    (0..surface.settings.height_levels)
                        .map(|k| FastTracer::new(&height_map.level(k)))
                        .collect()
                })
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

/// Some rows of a picture on their way.
struct Rows<'a> {
    job: &'a Job,
    samples: &'a [Sample],
    surfaces: &'a [Ready<'a>],
    first: u32,
}

impl Rows<'_> {
    /// Renders them into as many pixels, until `cancel` is set; `done` is called after each.
    fn render(&self, pixels: &mut [PixelOut], cancel: &AtomicBool, done: &(dyn Fn() + Sync)) {
        // A picture without columns has no rows to go through either.
        pixels.par_chunks_mut(self.job.width.max(1) as usize).zip(self.first..self.job.height).for_each(
            |(row, y)| {
                if cancel.load(Ordering::Relaxed) {
                    return;
                }
                for (shaded, x) in row.iter_mut().zip(0u32..) {
                    *shaded = self.pixel(x, y);
                }
                done();
            },
        );
    }

    fn pixel(&self, x: u32, y: u32) -> PixelOut {
        let [x, y] = [x as f32 + 0.5, y as f32 + 0.5];
        let sample = |Sample { offset, .. }: &Sample| {
            let point = [x + offset[0], y + offset[1]];
            nearest(self.surfaces.iter().filter_map(|surface| surface.pixel(point)))
        };
        let Some(((last, before), surface)) = self.samples.split_last().zip(self.surfaces.first()) else {
            return uncovered();
        };
        if before.is_empty() {
            return sample(last);
        }
        let mut color = uncovered().color;
        for one in before {
            color = surface.program.add_sample(color, sample(one).color, one.weight);
        }
        let shown = sample(last);
        PixelOut { color: surface.program.add_sample(color, shown.color, last.weight), ..shown }
    }
}

/// A surface ready to be traced.
struct Ready<'a> {
    program: Program<'a>,
    triangles: &'a [Triangle],
    base: Arc<RayCaster>,
    sides: Sides,
    /// The exact tracers of all levels of detail.
    tracers: Option<Arc<[FastTracer]>>,
    /// Whether they serve shadows, too, and to how many points of a light these send rays.
    traces_shadows: bool,
    points_of_lights: u32,
    lights: u32,
}

impl<'a> Ready<'a> {
    fn new(
        surface: &'a JobSurface,
        frame: Frame,
        base: Arc<RayCaster>,
        tracers: Option<Arc<[FastTracer]>>,
    ) -> Self {
        let sides = if surface.two_sided { Sides::Both } else { Sides::Front };
        Self {
            program: surface.program(frame),
            triangles: &surface.triangles,
            base,
            sides,
            tracers,
            traces_shadows: surface.selection.has_exact_shadows(),
            points_of_lights: surface.selection.points_of_lights(),
            lights: frame.light_count,
        }
    }

    /// What a point of the picture shows of the surface: the first base polygon along the ray whose relief is
    /// hit.
    fn pixel(&self, point: [f32; 2]) -> Option<PixelOut> {
        let direction = self.program.pixel_direction(point);
        let origin = self.program.pixel_eye(point);
        let ray = Ray {
            origin: [origin.x, origin.y, origin.z].map(f64::from).into(),
            direction: [direction.x, direction.y, direction.z].map(f64::from).into(),
        };
        self.base.hits(&ray, self.sides).find_map(|surface| {
            let side = if surface.front { 1.0 } else { -1.0 };
            let Triangle { a, b, c } = self.triangles[surface.triangle as usize];
            let pixel = self.program.pixel_of([a, b, c], side, point);
            let shaded = match &self.tracers {
                None => self.program.shade_pixel(pixel),
                Some(tracers) => self.trace_exactly(tracers, pixel),
            };
            (shaded.hit == 1).then_some(shaded)
        })
    }

    fn trace_exactly(&self, tracers: &[FastTracer], pixel: PixelIn) -> PixelOut {
        let at: Entered = self.program.enter(pixel);
        let tracer = &tracers[at.path.level as usize];
        let hit = if at.valid == 1 {
            tracer.trace(&(&at.path).into()).hit
        } else {
            relief_core::Hit::miss(Cost::default())
        };
        let hit = Hit::from(&hit);
        let visible = match self.traces_shadows {
            true => self.visible_lights(tracer, at, hit),
            false => self.program.visible_lights(at, hit),
        };
        self.program.shade_hit(pixel, at, hit, visible)
    }

    /// What of the lights arrives at a hit: rays that the shaders make, traced by the tracer.
    fn visible_lights(&self, tracer: &FastTracer, at: Entered, hit: Hit) -> [Vec4<f32>; MAX_LIGHTS] {
        let mut visible = [Vec4::from([0.0; 4]); MAX_LIGHTS];
        if hit.found == 0 {
            return visible;
        }
        let count = self.points_of_lights;
        for (visible, light) in visible.iter_mut().zip(0..self.lights) {
            let is_lit = |point: &u32| {
                let ray = self.program.ray_to_light(at, hit, light, [*point, count]);
                if ray.state == LightRayState::Open as u32 {
                    !tracer.trace(&(&ray.path).into()).hit.found
                } else {
                    ray.state == LightRayState::Lit as u32
                }
            };
            let rays = count.max(1);
            visible.x = (0..rays).filter(is_lit).count() as f32 / rays as f32;
        }
        visible
    }
}
