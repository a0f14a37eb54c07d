//! The CPU backend: the base meshes are ray cast, the translated shaders do the rest.

use std::sync::Arc;
use std::sync::atomic::{AtomicU32, Ordering};

use rayon::prelude::*;
use relief_core::exact::FastTracer;
use relief_core::registry::RayClass;
use relief_core::{Cancelled, HeightMap, Lanes, Watch};
use relief_shaders::cpu::PixelOut;
use relief_shaders::surface::Proposal;

use self::block::{places, places_where};
use self::light_map::LightMap;
use self::ready::{Base, Made, Ready, SceneRays, caster};
use self::tessellated::KeptTessellated;
use self::tiled::{SeenBlock, Tiled};
use crate::frame_cache::{cached, cached_where};
use crate::job::{Job, JobSurface, Rendering, uncovered};
use crate::prepare::Triangles;
use crate::samples::{Sample, samples};
use crate::shellcast::{Bounds, ShellCaster};
use relief_core::raycast::RayCaster;

mod block;
mod light_map;
mod ready;
mod seen;
mod shading;
mod shells;
pub(crate) mod tessellated;
mod tiled;

/// Pixels of a band of rows: enough for all cores, and few enough to keep.
const BAND_PIXELS: u32 = 1 << 18;

/// Creates `count` pixels that nothing covers, or `None` without the memory. All cores write them, since the
/// first touch of memory takes time.
fn all_uncovered(count: usize) -> Option<Vec<PixelOut>> {
    let mut pixels = Vec::new();
    pixels.try_reserve_exact(count).ok()?;
    let nothing = uncovered();
    (0..count).into_par_iter().map(|_| nothing).collect_into_vec(&mut pixels);
    Some(pixels)
}

/// Why the CPU has no picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum CpuError {
    /// The memory for the picture, or for what lights see, cannot be had.
    #[error("there is no memory for the picture")]
    OutOfMemory,
    /// The rendering was cancelled.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

/// Renders jobs on all cores, and keeps the hierarchies of their meshes and height maps, and what their
/// lights see, from one job to the next.
#[derive(Debug, Default)]
pub struct CpuRenderer {
    casters: Vec<(Arc<Triangles>, Arc<RayCaster>)>,
    shells: Vec<(Arc<Triangles>, Arc<ShellCaster>)>,
    tracers: Vec<(Arc<HeightMap>, Arc<[FastTracer]>)>,
    light_map: Option<LightMap>,
    tessellated: KeptTessellated,
    lanes: Lanes,
}

impl CpuRenderer {
    /// A renderer that has seen no job.
    pub fn new() -> Self {
        Self::default()
    }

    /// Sets the SIMD width. Default: the widest that the machine has. Pictures have the same bits.
    pub fn set_lanes(&mut self, lanes: Lanes) {
        self.lanes = lanes;
    }

    /// Renders a job.
    ///
    /// A surface whose selection is the exact pair is traced by the core's fast exact tracer in place of
    /// search and refinement.
    ///
    /// # Errors
    ///
    /// When the memory cannot be had, or the rendering is cancelled.
    pub fn render(&mut self, job: &Job, watch: &Watch) -> Result<Rendering, CpuError> {
        let count = (job.width as usize).checked_mul(job.height as usize);
        let mut pixels = count.and_then(all_uncovered).ok_or(CpuError::OutOfMemory)?;
        let samples = samples(job.samples, true);
        let done = Done::of(job, watch);
        let job = &*self.tessellated.job(job);
        let made = self.made(job);
        let lit = self.lit(job, &made, &done)?;
        lit.rows(job, &samples, 0).render(&mut pixels, &done)?;
        Ok(Rendering { width: job.width, height: job.height, pixels })
    }

    /// Renders a job in bands of whole rows, from the top, and hands over each when it is done. With
    /// `numbers` all numbers of a pixel are as in a [`Rendering`]; else they belong to one of its samples,
    /// which takes less time.
    ///
    /// # Errors
    ///
    /// When the memory cannot be had, or the watch or the sink cancels the rendering.
    pub fn render_bands(
        &mut self,
        job: &Job,
        numbers: bool,
        watch: &Watch,
        sink: &mut dyn FnMut(&[PixelOut]) -> Result<(), Cancelled>,
    ) -> Result<(), CpuError> {
        let samples = samples(job.samples, numbers);
        let done = Done::of(job, watch);
        let job = &*self.tessellated.job(job);
        let made = self.made(job);
        let lit = self.lit(job, &made, &done)?;
        let rows = (BAND_PIXELS / job.width.max(1)).clamp(1, job.height.max(1));
        let mut pixels = all_uncovered(job.width as usize * rows as usize).ok_or(CpuError::OutOfMemory)?;
        for first in (0..job.height).step_by(rows as usize) {
            let rows = rows.min(job.height - first);
            let pixels = &mut pixels[..job.width as usize * rows as usize];
            lit.rows(job, &samples, first).render(pixels, &done)?;
            watch.check()?;
            sink(pixels)?;
        }
        Ok(())
    }

    /// The addresses of what is kept: of meshes, and of height maps.
    #[cfg(test)]
    pub(crate) fn cached(&self) -> [Vec<*const ()>; 2] {
        let casters = self.casters.iter().map(|(_, caster)| Arc::as_ptr(caster).cast());
        let tracers = self.tracers.iter().map(|(_, tracer)| Arc::as_ptr(tracer).cast());
        [casters.collect(), tracers.collect()]
    }

    /// The hierarchies of the surfaces; those that the job does not need are dropped.
    fn made(&mut self, job: &Job) -> Vec<Made> {
        let (mut casters, mut shells, mut tracers) = (Vec::new(), Vec::new(), Vec::new());
        let made = job.surfaces.iter().map(|surface| {
            let JobSurface { triangles, height_map, selection, .. } = surface;
            let base = match selection.paths().proposal {
                Proposal::Polygons => {
                    let caster = || Arc::new(caster(triangles));
                    Base::Polygons(cached(&mut casters, &self.casters, triangles, caster))
                }
                Proposal::Shells => {
                    let bounds = Bounds::of(surface);
                    let fits = |caster: &ShellCaster| caster.bounds() == bounds;
                    let caster = || Arc::new(ShellCaster::new(triangles, bounds));
                    Base::Shells(cached_where(&mut shells, &self.shells, triangles, fits, caster))
                }
            };
            // The tracer is for straight paths.
            let is_straight = !selection.paths().rays.contains(&RayClass::Bent);
            let tracer = (selection.is_exact() && is_straight).then(|| {
                cached(&mut tracers, &self.tracers, height_map, || {
                    (0..surface.settings.height_levels)
                        .map(|k| FastTracer::new(&height_map.level(k)))
                        .collect()
                })
            });
            Made { base, tracers: tracer }
        });
        let made = made.collect();
        (self.casters, self.shells, self.tracers) = (casters, shells, tracers);
        made
    }

    /// The surfaces ready for the job's frame, with what its lights see: that is rendered unless it is known.
    fn lit<'a>(&'a mut self, job: &'a Job, made: &[Made], done: &Done) -> Result<Lit<'a>, CpuError> {
        if job.light_views.frames.is_empty() {
            self.light_map = None;
        } else if !self.light_map.as_ref().is_some_and(|known| known.is_of(job)) {
            // What was kept goes first, so that both need not fit.
            self.light_map = None;
            self.light_map = Some(LightMap::render(job, made, self.lanes, done)?);
        } else {
            done.add(light_map::rows(job))?;
        }
        let light_map = self.light_map.as_ref().map(|lights| &lights.map);
        let each = job.surfaces.iter().zip(made);
        let surfaces = each.map(|(surface, made)| Ready::new(surface, job.frame, light_map, made.clone()));
        let needs_scene = |surface: &JobSurface| surface.selection.rays_through_scene().is_some();
        let scene = job.surfaces.iter().any(needs_scene).then(|| SceneRays::new(job, made));
        Ok(Lit { surfaces: surfaces.collect(), scene, lanes: self.lanes })
    }
}

/// How much of a job is done.
struct Done<'a> {
    rows: AtomicU32,
    all: u32,
    watch: &'a Watch<'a>,
}

impl<'a> Done<'a> {
    fn of(job: &Job, watch: &'a Watch<'a>) -> Self {
        Self { rows: AtomicU32::new(0), all: job.height.saturating_add(light_map::rows(job)), watch }
    }

    /// Adds rows that are done, or that need no work.
    fn add(&self, rows: u32) -> Result<(), Cancelled> {
        let rows = self.rows.fetch_add(rows, Ordering::Relaxed) + rows;
        self.watch.at(rows as f32 / self.all as f32)
    }

    /// Asks whether to go on.
    fn check(&self) -> Result<(), Cancelled> {
        self.watch.check()
    }
}

/// The surfaces of a picture, and what may be in the way of their lights.
struct Lit<'a> {
    surfaces: Vec<Ready<'a>>,
    /// Where rays of lights go through all of the scene.
    scene: Option<SceneRays<'a>>,
    lanes: Lanes,
}

impl<'a> Lit<'a> {
    fn rows(&'a self, job: &'a Job, samples: &'a [Sample], first: u32) -> Rows<'a> {
        let tiled = Tiled::new(&self.surfaces, samples, [job.width, job.height], self.lanes);
        let (scene, lanes) = (self.scene.as_ref(), self.lanes);
        Rows { tiled, samples, surfaces: &self.surfaces, scene, first, lanes }
    }
}

/// Some rows of a picture on their way.
struct Rows<'a> {
    tiled: Tiled<'a>,
    samples: &'a [Sample],
    surfaces: &'a [Ready<'a>],
    scene: Option<&'a SceneRays<'a>>,
    first: u32,
    lanes: Lanes,
}

impl Rows<'_> {
    /// Renders them into as many pixels.
    fn render(&self, pixels: &mut [PixelOut], done: &Done) -> Result<(), Cancelled> {
        let look = |seen: &SeenBlock, put: &mut dyn FnMut(usize, PixelOut)| self.shade(seen, put);
        self.tiled.each(pixels, self.first, done, look, |pixel, number, shown| {
            *pixel = match (self.surfaces.first(), self.samples) {
                (Some(surface), samples) if samples.len() > 1 => {
                    // The colour of the samples before.
                    let before = if number == 0 { uncovered().color } else { pixel.color };
                    let color = surface.add_sample(before, shown.color, samples[number].weight);
                    PixelOut { color, ..shown }
                }
                _ => shown,
            };
        })
    }

    /// What a block's points look like, surface by surface.
    fn shade(&self, block: &SeenBlock, put: &mut dyn FnMut(usize, PixelOut)) {
        for place in places(places_where(|place| block.nearest[place].is_none())) {
            put(place, uncovered());
        }
        for (number, (surface, seen)) in self.surfaces.iter().zip(block.surfaces).enumerate() {
            let own = places_where(|place| block.nearest[place] == Some(number));
            if own != 0 {
                surface.shade(seen, own, self.scene, self.lanes, put);
            }
        }
    }
}
