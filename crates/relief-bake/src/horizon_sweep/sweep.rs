//! The horizons of all texels in one azimuth.

use std::ops::Range;

use rayon::prelude::*;
use relief_core::{Cancelled, HeightMap, Metric, Watch};

use super::far;
use super::near::{self, NEAR_STEPS};
use crate::azimuths::Direction;
use crate::sheared_lines::{Band, Lines, Plane, Rows, SKEW, Slab};

/// Parts of the lines, worked on one after the other. More parts take less memory.
const SLABS: usize = 4;

/// Rows that one task finishes together. More rows share their surroundings, and take more memory.
const BAND: usize = 16;

/// Fewer lines than this are not divided further.
const LEAST_SLAB: usize = 64;

/// Sweep over a map, azimuth by azimuth.
///
/// Takes the memory of a quarter of the map (of small maps up to all of it). Each thread takes 16
/// lines of the map with their reach, and 50 of its rows.
pub(crate) struct Sweep<'a> {
    map: &'a HeightMap,
    metric: Metric,
    azimuths: u32,
    tiles: u32,
    rows: Rows<'a>,
    slab: Vec<f32>,
}

impl<'a> Sweep<'a> {
    /// Prepares a sweep of `azimuths` azimuths that reaches `tiles` tiles far.
    pub fn new(map: &'a HeightMap, metric: Metric, azimuths: u32, tiles: u32) -> Self {
        Self { map, metric, azimuths, tiles: tiles.max(1), rows: Rows::new(map), slab: Vec::new() }
    }

    /// Finds the sines of an azimuth's horizons and adds them to planes of the map's size. `add` is
    /// called once for every texel. It gets a part of a row of each plane and the sines there.
    ///
    /// # Errors
    ///
    /// When the bake is cancelled.
    pub fn azimuth<const N: usize>(
        &mut self,
        azimuth: u32,
        mut planes: [&mut [f32]; N],
        watch: &Watch,
        add: impl Fn([&mut [f32]; N], &[f32]) + Sync,
    ) -> Result<(), Cancelled> {
        let part = |azimuth: u32| azimuth as f32 / self.azimuths as f32;
        let watch = watch.piece(part(azimuth), part(azimuth + 1));
        let direction = Direction::azimuth(azimuth, self.azimuths, self.metric.texel_m(self.map));
        let lines = self.rows.lines(&direction, self.rows.reach(&direction, self.tiles));
        let aim = Aim {
            map: self.map,
            lines: &lines,
            near: near::Near::new(&direction, NEAR_STEPS),
            tilt: Tilt::new(self.metric.scale_m / direction.step_m),
        };
        let stride = lines.length + SKEW;
        let most = lines.count.div_ceil(SLABS).max(LEAST_SLAB);
        for first in (0..lines.count).step_by(most) {
            let slots = first..(first + most).min(lines.count);
            let part = |slot: usize| slot as f32 / lines.count as f32;
            let watch = watch.piece(part(slots.start), part(slots.end));
            // Every value is written before it is read.
            let values = slots.len() * stride;
            self.slab.reserve_exact(values.saturating_sub(self.slab.len()));
            self.slab.resize(values, 0.0);
            far::slopes(
                &lines,
                NEAR_STEPS,
                &mut Slab { slots: slots.clone(), stride, values: &mut self.slab },
                &watch,
            )?;
            let plane = Plane { texels: &self.slab, stride, offset: 0, slots };
            aim.finish(&plane, planes.each_mut().map(|plane| &mut **plane), &watch, &add)?;
        }
        Ok(())
    }
}

/// Direction of a sweep.
struct Aim<'a> {
    map: &'a HeightMap,
    lines: &'a Lines<'a>,
    near: near::Near,
    tilt: Tilt,
}

impl Aim<'_> {
    /// Combines the near and the far part, row by row.
    fn finish<const N: usize>(
        &self,
        far: &Plane,
        planes: [&mut [f32]; N],
        watch: &Watch,
        add: &(impl Fn([&mut [f32]; N], &[f32]) + Sync),
    ) -> Result<(), Cancelled> {
        let (width, height) = (self.map.width() as usize, self.map.height() as usize);
        let mut bands = planes.map(|plane| plane.chunks_mut(BAND * width));
        let bands: Vec<[&mut [f32]; N]> = (0..height.div_ceil(BAND))
            .map(|_| bands.each_mut().map(|bands| bands.next().unwrap_or_default()))
            .collect();
        bands.into_par_iter().enumerate().try_for_each(|(number, mut planes)| {
            let top = number * BAND;
            watch.at(0.5 + 0.5 * top as f32 / height as f32)?;
            let rows = top..(top + BAND).min(height);
            let Some(mut band) = Band::new(self.lines, rows.clone(), &far.slots) else { return Ok(()) };
            band.unshear(self.lines, far);
            let padded = near::Padded::new(self.map, rows, band.columns.clone(), NEAR_STEPS + 1);
            let mut scratch = vec![0.0; 2 * band.columns.len()];
            for run in &band.runs {
                let Range { start, end } = run.columns;
                let (heights, sines) = scratch.split_at_mut(band.columns.len());
                let sines = &mut sines[..end - start];
                self.near.slopes(&padded, run, heights, sines);
                for (sine, far) in sines.iter_mut().zip(band.row(run)) {
                    *sine = self.tilt.sine(sine.max(*far));
                }
                let row = run.row * width;
                add(planes.each_mut().map(|plane| &mut plane[row + start..row + end]), sines);
            }
            Ok(())
        })
    }
}

/// Converts slopes in heights a step into sines.
#[derive(Clone, Copy)]
struct Tilt(f32);

impl Tilt {
    /// Converts with `metres`, the slope of a rise by a height of 1 over a step. Beyond the limits
    /// every sine is 0 or 1 to rounding, and squares would not fit in `f32`.
    fn new(metres: f64) -> Self {
        const MOST: f64 = 1e18;
        Self(metres.clamp(1.0 / MOST, MOST) as f32)
    }

    #[inline]
    fn sine(self, slope: f32) -> f32 {
        let slope = (slope * self.0).max(0.0);
        slope / (1.0 + slope * slope).sqrt()
    }
}
