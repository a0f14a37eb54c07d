//! Patches that are filled with as few triangles as a tolerance allows: what they have in common.

use std::sync::atomic::{AtomicU64, Ordering};

use relief_core::Watch;

use crate::edge::Along;
use crate::interior::{Fill, Filled, STEPS, Wanted};
use crate::surface::Relief;
use crate::{Fit, Judge, MeshSettings, MesherError};

/// The least tolerance, as a height of the map: below it numbers of `f32` are too coarse.
const LEAST: f64 = 1e-6;

/// The part of a cell's twist that remains where it is cut as finely as the lattice allows: two triangles lie
/// off by a quarter of the twist times length and width.
const FINEST: f64 = 0.25 / (STEPS * STEPS) as f64;

/// Bytes that a triangle takes while its patch is filled.
const BYTES_MADE: u64 = 200;

/// Bytes that a triangle takes afterwards, with its part of the points.
const BYTES_HELD: u64 = 20;

/// How patches are filled.
#[derive(Clone, Copy, Debug)]
pub struct Filling {
    /// What fills them.
    pub fill: Fill,
    /// Which knots of a side are its points.
    pub side: Along,
    /// The most triangles of all.
    pub most: u64,
}

/// The least tolerance that triangles over a relief can keep to, as a height of the map.
pub fn least_tolerance(relief: &Relief, judge: Judge) -> f64 {
    let twist = if judge == Judge::Surface { relief.greatest_twist() } else { 0.0 };
    LEAST.max(FINEST * twist)
}

/// How many triangles there may be: numbers, so that it does not matter which patch comes first.
#[derive(Debug)]
pub struct Room<'a> {
    judge: Judge,
    fit: Fit,
    /// The most triangles of all.
    most: u64,
    /// The most that may be held, and made of a patch in work: half of the memory, and a quarter of it.
    held: u64,
    made: u64,
    limit: u64,
    triangles: AtomicU64,
    watch: Watch<'a>,
}

impl<'a> Room<'a> {
    pub fn new(settings: &MeshSettings, most: u64, watch: Watch<'a>) -> Self {
        let limit = settings.max_bytes;
        let (held, made) = (limit / 2 / BYTES_HELD, limit / 4 / BYTES_MADE);
        let MeshSettings { judge, fit, .. } = *settings;
        Self { judge, fit, most, held, made, limit, triangles: AtomicU64::new(0), watch }
    }

    /// The most triangles of a patch.
    fn of_patch(&self) -> u64 {
        self.made.min(self.most).min(u64::from(u32::MAX / 4))
    }

    /// How a patch is to be filled.
    pub fn wanted(&self, tolerance: f64) -> Wanted<'a> {
        Wanted {
            tolerance,
            judge: self.judge,
            fit: self.fit,
            most: self.of_patch() as u32,
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

    /// A patch that was filled, if there is room for it.
    pub fn taken(&self, filled: Option<Filled>) -> Result<Filled, MesherError> {
        let Some(filled) = filled else {
            self.watch.check()?;
            self.check(self.of_patch() + 1, self.made)?;
            return Err(MesherError::NoMemory { limit: self.limit });
        };
        let own = filled.triangles.len() as u64;
        self.check(self.triangles.fetch_add(own, Ordering::Relaxed) + own, self.held)?;
        Ok(filled)
    }

    /// The triangles of all patches so far.
    pub fn triangles(&self) -> u64 {
        self.triangles.load(Ordering::Relaxed)
    }
}
