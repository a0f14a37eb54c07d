//! The CPU backend: the base meshes are ray cast, the translated shaders do the rest.

use std::ops::ControlFlow;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU32, Ordering};

use glam::Vec3;
use rayon::prelude::*;
use relief_core::exact::FastTracer;
use relief_core::registry::RayClass;
use relief_core::{Cost, HeightMap};
use relief_shaders::cpu::{
    Corner, Entered, FirstHit, Frame, Hit, PixelIn, PixelOut, Program, Triangle, Vec4,
};
use relief_shaders::surface::{FOLDED, Proposal};
use relief_shaders::{LightRayState, MAX_LIGHTS};

use crate::camera::Ray;
use crate::job::{Job, JobSurface, Rendering, uncovered};
use crate::kept::kept;
use crate::raycast::{RayCaster, Sides};
use crate::samples::{Sample, samples};
use crate::shellcast::ShellCaster;

/// Pixels of a band of rows: enough for all cores, and few enough to keep.
const BAND_PIXELS: u32 = 1 << 18;

/// Renders jobs on all cores, and keeps the hierarchies of their meshes and height maps from one job to the
/// next.
#[derive(Debug, Default)]
pub struct CpuRenderer {
    casters: Vec<(Arc<[Triangle]>, Arc<RayCaster>)>,
    shells: Vec<(Arc<[Triangle]>, Arc<ShellCaster>)>,
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
        let (mut casters, mut shells, mut tracers) = (Vec::new(), Vec::new(), Vec::new());
        let ready = job.surfaces.iter().map(|surface| {
            let JobSurface { triangles, height_map, selection, .. } = surface;
            let base = match selection.paths().proposal {
                Proposal::Polygons => {
                    let caster = || Arc::new(caster(triangles));
                    Base::Polygons(kept(&mut casters, &self.casters, triangles, caster))
                }
                Proposal::Shells => {
                    let shell_m = [surface.settings.shell_m.x, surface.settings.shell_m.y];
                    let caster = || Arc::new(ShellCaster::new(triangles, shell_m, surface.two_sided));
                    Base::Shells(kept(&mut shells, &self.shells, triangles, caster))
                }
            };
            // The tracer is for straight paths.
            let is_straight = !selection.paths().rays.contains(&RayClass::Bent);
            let tracer = (selection.is_exact() && is_straight).then(|| {
                kept(&mut tracers, &self.tracers, height_map, || {
                    (0..surface.settings.height_levels)
                        .map(|k| FastTracer::new(&height_map.level(k)))
                        .collect()
                })
            });
            Ready::new(surface, job.frame, base, tracer)
        });
        let ready = ready.collect();
        (self.casters, self.shells, self.tracers) = (casters, shells, tracers);
        ready
    }
}

fn caster(triangles: &[Triangle]) -> RayCaster {
    let position = |corner: &Corner| Vec3::new(corner.position.x, corner.position.y, corner.position.z);
    RayCaster::of_corners(triangles.iter().map(|Triangle { a, b, c, .. }| [a, b, c].map(position)))
}

/// The depths, relative to the nearest hit, up to which base polygons are looked at: keys and depths are
/// rounded in other ways. Smaller, and the backends may show different polygons; larger costs time only.
const DEPTH_SLACK: f64 = 1e-5;

/// What a ray meets of a surface, and all that is needed to shade it.
#[derive(Clone, Copy)]
struct Seen {
    pixel: PixelIn,
    at: Entered,
    first: FirstHit,
    /// Of equally near ones the least counts: whether the mesh was turned over, and the triangle.
    rank: (bool, u32),
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

    /// What a point of the picture shows: the nearest of the surfaces' hits, and of equally near ones that of
    /// the first surface.
    fn sample(&self, point: [f32; 2]) -> PixelOut {
        let seen = self.surfaces.iter().filter_map(|surface| Some((surface, surface.seen(point)?)));
        let nearest = seen.reduce(|best, seen| if seen.1.first.key > best.1.first.key { seen } else { best });
        nearest.map_or_else(uncovered, |(surface, seen)| surface.shade(&seen))
    }

    fn pixel(&self, x: u32, y: u32) -> PixelOut {
        let [x, y] = [x as f32 + 0.5, y as f32 + 0.5];
        let sample = |Sample { offset, .. }: &Sample| self.sample([x + offset[0], y + offset[1]]);
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

/// What proposes triangles to a ray.
enum Base {
    Polygons(Arc<RayCaster>),
    Shells(Arc<ShellCaster>),
}

/// A surface ready to be traced.
struct Ready<'a> {
    program: Program<'a>,
    triangles: &'a [Triangle],
    base: Base,
    sides: Sides,
    /// The exact tracers of all levels of detail.
    tracers: Option<Arc<[FastTracer]>>,
    /// Whether they serve shadows, too, and to how many points of a light these send rays.
    traces_shadows: bool,
    points_of_lights: u32,
    lights: u32,
    /// Whether the relief nowhere lies above its base.
    is_carved: bool,
    /// As in [`Frame`].
    near: f64,
}

impl<'a> Ready<'a> {
    fn new(surface: &'a JobSurface, frame: Frame, base: Base, tracers: Option<Arc<[FastTracer]>>) -> Self {
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
            is_carved: surface.settings.bias_m + surface.settings.scale_m <= 0.0,
            near: frame.near.into(),
        }
    }

    /// What a point of the picture shows of the surface: the nearest hit of all base polygons along the ray,
    /// and of equally near ones that of the first polygon.
    fn seen(&self, point: [f32; 2]) -> Option<Seen> {
        let direction = self.program.pixel_direction(point);
        let origin = self.program.pixel_eye(point);
        let ray = Ray {
            origin: [origin.x, origin.y, origin.z].map(f64::from).into(),
            direction: [direction.x, direction.y, direction.z].map(f64::from).into(),
        };
        let mut best: Option<Seen> = None;
        match &self.base {
            Base::Polygons(caster) => {
                for surface in caster.hits(&ray, self.sides) {
                    // What lies behind its polygon is not nearer than that.
                    if self.is_carved && surface.t > self.reach(best.as_ref()) {
                        break;
                    }
                    let side = if surface.front { 1.0 } else { -1.0 };
                    self.look(&mut best, (false, surface.triangle), side, point);
                }
            }
            Base::Shells(caster) => caster.each(&ray, |triangle| {
                self.look(&mut best, (false, triangle), 1.0, point);
                if self.sides == Sides::Both {
                    self.look(&mut best, (true, triangle), -1.0, point);
                }
                self.reach(best.as_ref())
            }),
        }
        best
    }

    /// Traces a side of a triangle, and keeps what it shows where that is the nearest so far.
    fn look(&self, best: &mut Option<Seen>, rank: (bool, u32), side: f32, point: [f32; 2]) {
        let pixel = self.program.pixel_of(&self.triangles[rank.1 as usize], side, point);
        let at = self.program.enter(pixel);
        let first = match &self.tracers {
            None => self.program.first_hit(pixel, at),
            Some(tracers) => self.first_exactly(&tracers[at.level as usize], pixel, at),
        };
        let is_nearer =
            |best: &Seen| first.key > best.first.key || (first.key == best.first.key && rank < best.rank);
        if first.hit.found == 1 && best.as_ref().is_none_or(is_nearer) {
            *best = Some(Seen { pixel, at, first, rank });
        }
    }

    /// How deep what is nearer than that may begin.
    fn reach(&self, best: Option<&Seen>) -> f64 {
        best.map_or(f64::INFINITY, |best| self.depth_of(best.first.key, DEPTH_SLACK))
    }

    /// A depth beyond that of a key, by as much slack, relatively.
    fn depth_of(&self, key: f32, slack: f64) -> f64 {
        self.near / f64::from(key) * (1.0 + slack) - self.near
    }

    /// The first hit by the exact tracer, of a shell that overlaps itself the nearest of all segments'.
    fn first_exactly(&self, tracer: &FastTracer, pixel: PixelIn, at: Entered) -> FirstHit {
        let miss = Hit::from(&relief_core::Hit::miss(Cost::default()));
        let mut first = FirstHit { hit: miss, segment: 0, key: 0.0 };
        for number in 0..at.segments {
            let path = self.program.segment(pixel, at, number);
            if path.exit > 0.0 {
                let hit = Hit::from(&tracer.trace(&(&path).into()).hit);
                if hit.found == 1 {
                    let hit = self.program.polish(pixel, at, path, hit);
                    let key = self.program.key(pixel, path, hit);
                    if first.hit.found == 0 || key > first.key {
                        first = FirstHit { hit, segment: number, key };
                    }
                    if pixel.shell.order < FOLDED {
                        break;
                    }
                }
            }
        }
        first
    }

    fn shade(&self, seen: &Seen) -> PixelOut {
        let Seen { pixel, at, first: FirstHit { hit, segment, .. }, .. } = *seen;
        let placed = self.program.place(pixel, at, segment, hit);
        let visible = match &self.tracers {
            Some(tracers) if self.traces_shadows => {
                self.visible_lights(&tracers[at.level as usize], placed, hit)
            }
            _ => self.program.visible_lights(placed, hit),
        };
        self.program.shade_hit(pixel, placed, hit, visible)
    }

    /// What of the lights arrives at a placed hit: rays that the shaders make, traced by the tracer.
    fn visible_lights(&self, tracer: &FastTracer, at: Entered, hit: Hit) -> [Vec4<f32>; MAX_LIGHTS] {
        let mut visible = [Vec4::from([0.0; 4]); MAX_LIGHTS];
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
