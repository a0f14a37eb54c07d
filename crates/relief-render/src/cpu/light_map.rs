//! Shadow maps rendered on the CPU: a layer for each view, whose texels hold the keys of the
//! nearest hits.

use relief_core::encoding::code::Codes;
use relief_core::{BakedMap, Lanes, MapFormat, MapIdentity, MapLayout, MapTexels};
use relief_shaders::cpu::Frame;

use super::prepared_surface::{Acceleration, PreparedSurface};
use super::tiled::{Tiled, VisibleBlock};
use super::{CpuError, Progress};
use crate::job::{Job, JobSurface};
use crate::samples::Sample;

/// Shadow maps, with the surfaces and frames for which they were rendered.
#[derive(Debug)]
pub struct LightMap {
    /// The views' frames.
    frames: Vec<Frame>,
    surfaces: Vec<JobSurface>,
    pub map: BakedMap,
}

impl LightMap {
    /// Whether the shadow maps fit a job.
    pub fn is_of(&self, job: &Job) -> bool {
        let pairs = || self.surfaces.iter().zip(&job.surfaces);
        self.surfaces.len() == job.surfaces.len()
            && pairs().all(|(a, b)| a.casts_same_shadows(b))
            && self.frames == job.light_views.frames
    }

    /// Renders the shadow maps of a job. `done` counts their [`rows`].
    pub(super) fn render(
        job: &Job,
        accelerations: &[Acceleration],
        lanes: Lanes,
        done: &Progress,
    ) -> Result<Self, CpuError> {
        let views = &job.light_views;
        let side = views.size as usize;
        let count = side.checked_mul(side).and_then(|area| area.checked_mul(views.frames.len()));
        let mut keys = Vec::new();
        let reserved = count.and_then(|count| keys.try_reserve_exact(count).ok().map(|()| count));
        keys.resize(reserved.ok_or(CpuError::OutOfMemory)?, 0.0f32);
        for (layer, frame) in keys.chunks_exact_mut((side * side).max(1)).zip(&views.frames) {
            let opaque = |(surface, _): &(&JobSurface, _)| !surface.selection.is_translucent();
            let surfaces = job.surfaces.iter().zip(accelerations).filter(opaque);
            let ready: Vec<PreparedSurface> = surfaces
                .map(|(surface, acceleration)| {
                    PreparedSurface::new(surface, *frame, None, acceleration.clone())
                })
                .collect();
            let tiled = Tiled::new(&ready, &[Sample::CENTRE], [views.size; 2], lanes);
            let keys = |seen: &VisibleBlock, put: &mut dyn FnMut(usize, f32)| {
                for (point, nearest) in seen.nearest.iter().enumerate() {
                    put(point, nearest.map_or(0.0, |surface| seen.surfaces[surface].keys[point]));
                }
            };
            tiled.each(layer, 0, done, keys, |key, _, of| *key = of)?;
        }
        let map = BakedMap::new(
            MapIdentity::without_heights("light-map"),
            layout(job),
            CODES,
            MapTexels::F32(keys),
        );
        let map = map.map_err(|_| CpuError::OutOfMemory)?;
        Ok(Self { frames: views.frames.clone(), surfaces: job.surfaces.clone(), map })
    }
}

/// Returns the number of rows in all shadow maps of a job.
pub fn rows(job: &Job) -> u32 {
    job.light_views.size * job.light_views.frames.len() as u32
}

const CODES: [Codes; 4] = [Codes { low: 0.0, step: 0.0 }; 4];

fn layout(job: &Job) -> MapLayout {
    let side = job.light_views.size;
    let layers = job.light_views.frames.len() as u32;
    MapLayout { size: [side, side], levels: 1, layers, channels: 1, format: MapFormat::F32 }
}
