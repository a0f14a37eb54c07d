//! Filling of patches with as few triangles as a tolerance allows: method and budget.

use std::sync::atomic::{AtomicU64, Ordering};

use relief_core::Watch;

use crate::edge::Along;
use crate::interior::{Fill, FillRequest, Filled, STEPS};
use crate::surface::Relief;
use crate::{Fit, Judge, MeshSettings, MesherError};

/// Least tolerance, as a height of the map. Below it `f32` is too coarse.
const LEAST: f64 = 1e-6;

/// Part of a cell's twist that remains where the cell is cut as finely as the lattice allows. Two
/// triangles are off by a quarter of twist times length times width.
const FINEST: f64 = 0.25 / (STEPS * STEPS) as f64;

/// Bytes per triangle while its patch is filled.
const BYTES_IN_WORK: u64 = 200;

/// Bytes per triangle afterwards, with its share of the points.
const BYTES_FILLED: u64 = 20;

/// Method by which patches are filled.
#[derive(Clone, Copy, Debug)]
pub struct Filling {
    /// Function that fills a patch.
    pub fill: Fill,
    /// Function that chooses the points of a side among its knots.
    pub side: Along,
    /// Greatest number of triangles in all.
    pub most: u64,
}

/// Returns the least tolerance that triangles over a relief can keep to, as a height of the map.
pub fn least_tolerance(relief: &Relief, judge: Judge) -> f64 {
    let twist = if judge == Judge::Surface { relief.greatest_twist() } else { 0.0 };
    LEAST.max(FINEST * twist)
}

/// Budget of triangles and memory for all patches. It counts triangles, so that the order of
/// patches does not matter.
#[derive(Debug)]
pub struct FillBudget<'a> {
    judge: Judge,
    fit: Fit,
    /// Greatest number of triangles in all.
    most: u64,
    /// Greatest number of triangles that are held (half of the memory), and of a patch in work (a
    /// quarter of it).
    held: u64,
    in_work: u64,
    limit: u64,
    triangles: AtomicU64,
    watch: Watch<'a>,
}

impl<'a> FillBudget<'a> {
    pub fn new(settings: &MeshSettings, most: u64, watch: Watch<'a>) -> Self {
        let limit = settings.max_bytes;
        let (held, in_work) = (limit / 2 / BYTES_FILLED, limit / 4 / BYTES_IN_WORK);
        let MeshSettings { judge, fit, .. } = *settings;
        Self { judge, fit, most, held, in_work, limit, triangles: AtomicU64::new(0), watch }
    }

    /// Returns the greatest number of triangles of a patch.
    fn most_in_patch(&self) -> u64 {
        self.in_work.min(self.most).min(u64::from(u32::MAX / 4))
    }

    /// Returns the request to fill a patch to `tolerance`.
    pub fn request(&self, tolerance: f64) -> FillRequest<'a> {
        FillRequest {
            tolerance,
            judge: self.judge,
            fit: self.fit,
            most: self.most_in_patch() as u32,
            watch: self.watch,
        }
    }

    fn check(&self, triangles: u64, fits: u64) -> Result<(), MesherError> {
        match triangles {
            too_many if too_many > self.most => Err(MesherError::MoreThan { most: self.most }),
            too_many if too_many > fits => Err(MesherError::NoMemory { limit: self.limit }),
            _ => Ok(()),
        }
    }

    /// Adds a filled patch to the count. Returns an error if it exceeds the budget.
    pub fn admit(&self, filled: Option<Filled>) -> Result<Filled, MesherError> {
        let Some(filled) = filled else {
            self.watch.check()?;
            self.check(self.most_in_patch() + 1, self.in_work)?;
            return Err(MesherError::NoMemory { limit: self.limit });
        };
        let own = filled.triangles.len() as u64;
        self.check(self.triangles.fetch_add(own, Ordering::Relaxed) + own, self.held)?;
        Ok(filled)
    }

    /// Returns the number of triangles of all patches so far.
    pub fn triangles(&self) -> u64 {
        self.triangles.load(Ordering::Relaxed)
    }
}
