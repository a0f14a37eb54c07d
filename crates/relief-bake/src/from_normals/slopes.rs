//! From normals to slopes, and what was wrong with the normals.

use rayon::prelude::*;
use relief_core::HeightMap;

use super::error::{FromNormalsError, check_steepest};
use super::holes::Holes;
use crate::fill;
use crate::kind::normal::Axes;

/// Normals whose length is off from 1 by more are counted: compression and filtering leave less.
pub const UNIT_TOLERANCE: f32 = 0.1;

/// What was wrong with normals, in numbers of texels.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct NormalFaults {
    /// They are NaN, infinite, or shorter than [`SHORTEST`](super::SHORTEST), as middle grey is.
    pub without_direction: usize,
    /// All three components are at an end of their range, as in black, white and pure blue. A normal's
    /// never are: such texels are background.
    pub background: usize,
    /// They are transparent, in a map whose opacity marks holes.
    pub transparent: usize,
    /// They lie beside one of those and are not of length 1: mixed with the background.
    pub mixed: usize,
    /// Column and row of the first of all those.
    pub first_hole: Option<[u32; 2]>,
    /// They have a direction, and a length off from 1 by more than [`UNIT_TOLERANCE`], which is not used.
    pub not_unit: usize,
    /// They point along the surface or into it, which no relief's do.
    pub below_horizon: usize,
    /// They are above the horizon and stand for a steeper slope than accepted.
    pub too_steep: usize,
}

impl NormalFaults {
    /// Texels that hold no normal.
    pub fn holes(&self) -> usize {
        self.without_direction + self.background + self.transparent + self.mixed
    }
}

/// The slopes that normals stand for.
#[derive(Clone, Debug, PartialEq)]
pub struct NormalSlopes {
    /// Columns and rows.
    pub size: [u32; 2],
    /// Slopes along `u` and along `v` (down in the picture), in metres a metre, row by row from the top.
    pub along: [Vec<f32>; 2],
    /// Which texels hold a normal; none where all do. Slopes of the others were filled in.
    pub known: Option<Vec<bool>>,
    /// What was wrong with the normals.
    pub faults: NormalFaults,
}

impl NormalSlopes {
    /// The slopes of normals in those axes, given row by row from the top, of any length. Normals at or below
    /// the horizon, and those steeper than `steepest` (metres up for a metre along), keep their direction and
    /// become as steep as accepted. In holes, which hold no normal, slopes are filled in smoothly from those
    /// around.
    ///
    /// # Errors
    ///
    /// When the number of normals is not that of the size, when the steepest slope is no slope, or when no
    /// normal has a direction.
    pub fn of_normals(
        size: [u32; 2],
        normals: &[[f32; 3]],
        axes: Axes,
        steepest: f64,
    ) -> Result<Self, FromNormalsError> {
        Self::of_picture(size, normals, None, axes, steepest)
    }

    /// As [`of_normals`](Self::of_normals), of a picture whose opacity may mark holes: transparent texels are
    /// holes where opacity is a mask, 0 or 1 at nine of ten texels at least.
    ///
    /// # Errors
    ///
    /// As [`of_normals`](Self::of_normals); and when there is not one opacity for each normal.
    pub fn of_picture(
        size: [u32; 2],
        normals: &[[f32; 3]],
        opacity: Option<&[f32]>,
        axes: Axes,
        steepest: f64,
    ) -> Result<Self, FromNormalsError> {
        let [width, height] = size;
        HeightMap::check_size(width, height)?;
        for given in [Some(normals.len()), opacity.map(<[f32]>::len)].into_iter().flatten() {
            if given as u64 != u64::from(width) * u64::from(height) {
                return Err(FromNormalsError::WrongLength { width, height, given });
            }
        }
        check_steepest(steepest)?;
        let Holes { known, mut faults } = Holes::find(size, normals, opacity);
        if faults.holes() == normals.len() {
            return Err(FromNormalsError::NoDirection);
        }
        let row_length = width as usize;
        let mut along = [0, 1].map(|_| vec![0.0f32; normals.len()]);
        let [along_u, along_v] = &mut along;
        let rows: Vec<[usize; 3]> = normals
            .par_chunks(row_length)
            .zip(known.par_chunks(row_length))
            .zip(along_u.par_chunks_mut(row_length).zip(along_v.par_chunks_mut(row_length)))
            .map(|((normals, known), (along_u, along_v))| {
                let mut counts = [0; 3];
                let slopes = along_u.iter_mut().zip(along_v);
                let texels = normals.iter().zip(known).zip(slopes);
                for ((&normal, _), (u, v)) in texels.filter(|((_, known), _)| **known) {
                    let (slope, fault) = slope(normal, axes, steepest as f32);
                    [*u, *v] = slope;
                    counts[0] += usize::from(!is_unit(normal));
                    counts[1] += usize::from(fault == Some(Fault::BelowHorizon));
                    counts[2] += usize::from(fault == Some(Fault::TooSteep));
                }
                counts
            })
            .collect();
        for [not_unit, below_horizon, too_steep] in rows {
            faults.not_unit += not_unit;
            faults.below_horizon += below_horizon;
            faults.too_steep += too_steep;
        }
        if faults.holes() > 0 {
            for plane in &mut along {
                fill::fill([row_length, height as usize], plane, &known);
            }
        }
        let known = (faults.holes() > 0).then_some(known);
        Ok(Self { size, along, known, faults })
    }

    /// The slopes of the same normals with `y` pointing the other way.
    #[must_use]
    pub fn turned_over(mut self) -> Self {
        self.along[1].par_iter_mut().for_each(|slope| *slope = -*slope);
        self
    }

    /// Root mean square of the slopes of texels that hold a normal, by both axes together.
    pub fn steepness(&self) -> f64 {
        let is_known = |at: usize| self.known.as_ref().is_none_or(|known| known[at]);
        let sum = |plane: &[f32]| {
            let known = plane.iter().enumerate().filter(|(at, _)| is_known(*at));
            known.map(|(_, &slope)| f64::from(slope).powi(2)).sum::<f64>()
        };
        let count = self.along[0].len() - self.faults.holes();
        (self.along.iter().map(|plane| sum(plane)).sum::<f64>() / count as f64).sqrt()
    }
}

/// Whether a normal is of length 1, as far as compression and filtering leave it.
pub(super) fn is_unit(normal: [f32; 3]) -> bool {
    (length(normal) - 1.0).abs() <= UNIT_TOLERANCE
}

pub(super) fn length(normal: [f32; 3]) -> f32 {
    normal.iter().map(|x| x * x).sum::<f32>().sqrt()
}

/// Why a normal's slope is not its own.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Fault {
    BelowHorizon,
    TooSteep,
}

/// The slope along `u` and `v` of a normal.
#[inline]
pub(super) fn slope([x, y, z]: [f32; 3], axes: Axes, steepest: f32) -> ([f32; 2], Option<Fault>) {
    let (x, down, upright) = match axes {
        Axes::Tangent => (x, -y, z),
        Axes::TangentGreenDown => (x, y, z),
        Axes::World => (x, z, y),
    };
    let across = x.hypot(down);
    if across <= steepest * upright && upright > 0.0 {
        return ([-x / upright, -down / upright], None);
    }
    // The direction is kept. A normal without any is level.
    let part = if across > 0.0 { steepest / across } else { 0.0 };
    let fault = if upright > 0.0 { Fault::TooSteep } else { Fault::BelowHorizon };
    ([-x * part, -down * part], Some(fault))
}
