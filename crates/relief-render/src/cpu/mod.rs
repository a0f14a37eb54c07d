//! CPU backend. Rays are cast against the base meshes; the translated shaders do the rest.

use std::ops::Range;
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
use self::prepared_surface::{Acceleration, Base, PreparedSurface, SceneRays, caster};
use self::tessellated::TessellatedCache;
use self::tiled::{Tiled, VisibleBlock};
use crate::frame_cache::{cached, cached_where};
use crate::job::{Job, JobSurface, Rendering, uncovered};
use crate::prepare::Triangles;
use crate::samples::{Sample, samples};
use crate::shellcast::{Bounds, ShellCaster};
use relief_core::raycast::RayCaster;

mod block;
mod block_hits;
mod light_map;
mod prepared_surface;
mod shading;
mod shells;
pub(crate) mod tessellated;
mod tiled;
mod translucent;

/// Pixels of a band of rows: enough work for all cores, and little memory.
const BAND_PIXELS: u32 = 1 << 18;

/// Creates `count` pixels that no surface covers, or `None` without the memory. All cores write
/// them, since the first touch of memory takes time.
fn all_uncovered(count: usize) -> Option<Vec<PixelOut>> {
    let mut pixels = Vec::new();
    pixels.try_reserve_exact(count).ok()?;
    let nothing = uncovered();
    (0..count).into_par_iter().map(|_| nothing).collect_into_vec(&mut pixels);
    Some(pixels)
}

/// Reason why the CPU backend rendered no picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum CpuError {
    /// There is not enough memory for the picture or for its shadow maps.
    #[error("there is not enough memory for the picture; render a smaller one")]
    OutOfMemory,
    /// The rendering was cancelled.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

/// Renders jobs on all cores. BVHs, exact tracers and shadow maps are cached from one job to the
/// next.
#[derive(Debug, Default)]
pub struct CpuRenderer {
    casters: Vec<(Arc<Triangles>, Arc<RayCaster>)>,
    shells: Vec<(Arc<Triangles>, Arc<ShellCaster>)>,
    tracers: Vec<(Arc<HeightMap>, Arc<[FastTracer]>)>,
    light_map: Option<LightMap>,
    tessellated: TessellatedCache,
    lanes: Lanes,
}

impl CpuRenderer {
    /// Creates a renderer with an empty cache.
    pub fn new() -> Self {
        Self::default()
    }

    /// Sets the SIMD width. Default: the widest that the machine has. Pictures have the same bits.
    pub fn set_lanes(&mut self, lanes: Lanes) {
        self.lanes = lanes;
    }

    /// Renders a job.
    ///
    /// Surfaces with the exact search and refinement are traced by [`FastTracer`], if their paths
    /// are straight.
    ///
    /// # Errors
    ///
    /// When the memory cannot be had, or the rendering is cancelled.
    pub fn render(&mut self, job: &Job, watch: &Watch) -> Result<Rendering, CpuError> {
        let count = (job.width as usize).checked_mul(job.height as usize);
        let mut pixels = count.and_then(all_uncovered).ok_or(CpuError::OutOfMemory)?;
        let samples = samples(job.samples, true);
        let done = Progress::of(job, job.height, watch);
        let job = &*self.tessellated.job(job);
        let accelerations = self.accelerations(job);
        let prepared = self.prepare(job, &accelerations, &done)?;
        prepared.rows(job, &samples, 0).render(&mut pixels, &done)?;
        Ok(Rendering { width: job.width, height: job.height, pixels })
    }

    /// Renders some rows of a job, counted from the top, in bands. `sink` gets each band when it is
    /// done. With `numbers`, pixels are the same as in a [`Rendering`]. Without, only the colour is;
    /// the other values come from one of the pixel's samples, which takes less time. Rows below the
    /// picture do not count.
    ///
    /// # Errors
    ///
    /// When the memory cannot be had, or the watch or the sink cancels the rendering.
    pub fn render_rows(
        &mut self,
        job: &Job,
        rows: Range<u32>,
        numbers: bool,
        watch: &Watch,
        sink: &mut dyn FnMut(&[PixelOut]) -> Result<(), Cancelled>,
    ) -> Result<(), CpuError> {
        let Range { start, end } = rows.start..rows.end.min(job.height);
        let samples = samples(job.samples, numbers);
        let done = Progress::of(job, end.saturating_sub(start), watch);
        let job = &*self.tessellated.job(job);
        let accelerations = self.accelerations(job);
        let prepared = self.prepare(job, &accelerations, &done)?;
        let rows = (BAND_PIXELS / job.width.max(1)).clamp(1, job.height.max(1));
        let mut pixels = all_uncovered(job.width as usize * rows as usize).ok_or(CpuError::OutOfMemory)?;
        for first in (start..end).step_by(rows as usize) {
            let rows = rows.min(end - first);
            let pixels = &mut pixels[..job.width as usize * rows as usize];
            prepared.rows(job, &samples, first).render(pixels, &done)?;
            watch.check()?;
            sink(pixels)?;
        }
        Ok(())
    }

    /// Returns the addresses of cached BVHs, and of cached exact tracers.
    #[cfg(all(test, feature = "gpu"))]
    pub(crate) fn cached(&self) -> [Vec<*const ()>; 2] {
        let casters = self.casters.iter().map(|(_, caster)| Arc::as_ptr(caster).cast());
        let tracers = self.tracers.iter().map(|(_, tracer)| Arc::as_ptr(tracer).cast());
        [casters.collect(), tracers.collect()]
    }

    /// Returns BVHs and tracers of the surfaces. Cached ones that the job does not need are
    /// dropped.
    fn accelerations(&mut self, job: &Job) -> Vec<Acceleration> {
        let (mut casters, mut shells, mut tracers) = (Vec::new(), Vec::new(), Vec::new());
        let accelerations = job.surfaces.iter().map(|surface| {
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
            Acceleration { base, tracers: tracer }
        });
        let accelerations = accelerations.collect();
        (self.casters, self.shells, self.tracers) = (casters, shells, tracers);
        accelerations
    }

    /// Prepares the surfaces for the job's frame. Shadow maps are rendered unless they are cached.
    fn prepare<'a>(
        &'a mut self,
        job: &'a Job,
        accelerations: &[Acceleration],
        done: &Progress,
    ) -> Result<PreparedScene<'a>, CpuError> {
        if job.light_views.frames.is_empty() {
            self.light_map = None;
        } else if !self.light_map.as_ref().is_some_and(|known| known.is_of(job)) {
            // The cached one is dropped first, so that both need not fit into memory.
            self.light_map = None;
            self.light_map = Some(LightMap::render(job, accelerations, self.lanes, done)?);
        } else {
            done.add(light_map::rows(job))?;
        }
        let light_map = self.light_map.as_ref().map(|lights| &lights.map);
        let each = job.surfaces.iter().zip(accelerations);
        let surfaces = each.map(|(surface, acceleration)| {
            PreparedSurface::new(surface, job.frame, light_map, acceleration.clone())
        });
        let (translucent, opaque) = surfaces.partition(|surface| surface.is_translucent);
        let needs_scene = |surface: &JobSurface| surface.selection.rays_through_scene().is_some();
        let scene = job.surfaces.iter().any(needs_scene).then(|| SceneRays::new(job, accelerations));
        Ok(PreparedScene { opaque, translucent, scene, lanes: self.lanes })
    }
}

/// Progress of a job, in rows.
struct Progress<'a> {
    rows: AtomicU32,
    all: u32,
    watch: &'a Watch<'a>,
}

impl<'a> Progress<'a> {
    fn of(job: &Job, rows: u32, watch: &'a Watch<'a>) -> Self {
        Self { rows: AtomicU32::new(0), all: rows.saturating_add(light_map::rows(job)), watch }
    }

    /// Adds rows that are done, or that need no work.
    fn add(&self, rows: u32) -> Result<(), Cancelled> {
        let rows = self.rows.fetch_add(rows, Ordering::Relaxed) + rows;
        self.watch.at(rows as f32 / self.all as f32)
    }

    /// Fails if the work was cancelled.
    fn check(&self) -> Result<(), Cancelled> {
        self.watch.check()
    }
}

/// Surfaces of a picture, and the geometry that may block their lights.
struct PreparedScene<'a> {
    opaque: Vec<PreparedSurface<'a>>,
    translucent: Vec<PreparedSurface<'a>>,
    /// The whole scene, if shadow rays go through all of it.
    scene: Option<SceneRays<'a>>,
    lanes: Lanes,
}

impl<'a> PreparedScene<'a> {
    fn rows(&'a self, job: &'a Job, samples: &'a [Sample], first: u32) -> Rows<'a> {
        let tiled = Tiled::new(&self.opaque, samples, [job.width, job.height], self.lanes);
        Rows { tiled, samples, prepared: self, first }
    }
}

/// Rows of a picture that are being rendered.
struct Rows<'a> {
    tiled: Tiled<'a>,
    samples: &'a [Sample],
    prepared: &'a PreparedScene<'a>,
    first: u32,
}

impl Rows<'_> {
    /// Renders the rows into `pixels`.
    fn render(&self, pixels: &mut [PixelOut], done: &Progress) -> Result<(), Cancelled> {
        let PreparedScene { opaque, translucent, .. } = self.prepared;
        let any = opaque.first().or(translucent.first());
        let look = |seen: &VisibleBlock, put: &mut dyn FnMut(usize, PixelOut)| {
            if translucent.is_empty() { self.shade(seen, put) } else { self.shade_behind(seen, put) }
        };
        self.tiled.each(pixels, self.first, done, look, |pixel, number, shown| {
            *pixel = match (any, self.samples) {
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

    /// Shades a block's points behind the translucent surfaces.
    fn shade_behind(&self, block: &VisibleBlock, put: &mut dyn FnMut(usize, PixelOut)) {
        let translucent = &self.prepared.translucent;
        self.shade(block, &mut |place, pixel| {
            let shown = if block.points.which >> place & 1 == 1 {
                translucent::composed(translucent, block.points.points.map(|row| row[place]), pixel)
            } else {
                pixel
            };
            put(place, shown);
        });
    }

    /// Shades a block's points on opaque surfaces, surface by surface.
    fn shade(&self, block: &VisibleBlock, put: &mut dyn FnMut(usize, PixelOut)) {
        let PreparedScene { opaque, scene, lanes, .. } = self.prepared;
        for place in places(places_where(|place| block.nearest[place].is_none())) {
            put(place, uncovered());
        }
        for (number, (surface, seen)) in opaque.iter().zip(block.surfaces).enumerate() {
            let own = places_where(|place| block.nearest[place] == Some(number));
            if own != 0 {
                surface.shade(seen, own, scene.as_ref(), *lanes, put);
            }
        }
    }
}
