//! From normals to slopes, and what was wrong with the normals.

use rayon::prelude::*;
use relief_core::HeightMap;

use super::error::{FromNormalsError, SHORTEST, check_steepest};
use crate::fill;
use crate::kind::normal::Axes;

/// Normals whose length is off from 1 by more are counted: compression and filtering leave less.
pub const UNIT_TOLERANCE: f32 = 0.1;

/// What was wrong with normals, in numbers of texels.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct NormalFaults {
    /// They are NaN, infinite, or shorter than [`SHORTEST`].
    pub without_direction: usize,
    /// Column and row of the first of those.
    pub first_without_direction: Option<[u32; 2]>,
    /// They have a direction, and a length off from 1 by more than [`UNIT_TOLERANCE`], which is not used.
    pub not_unit: usize,
    /// They point along the surface or into it, which no relief's do.
    pub below_horizon: usize,
    /// They are above the horizon and stand for a steeper slope than accepted.
    pub too_steep: usize,
}

impl NormalFaults {
    fn and(self, other: Self) -> Self {
        Self {
            without_direction: self.without_direction + other.without_direction,
            first_without_direction: self.first_without_direction.or(other.first_without_direction),
            not_unit: self.not_unit + other.not_unit,
            below_horizon: self.below_horizon + other.below_horizon,
            too_steep: self.too_steep + other.too_steep,
        }
    }
}

/// The slopes that normals stand for.
#[derive(Clone, Debug, PartialEq)]
pub struct NormalSlopes {
    /// Columns and rows.
    pub size: [u32; 2],
    /// Slopes along `u` and along `v` (down in the picture), in metres a metre, row by row from the top.
    pub along: [Vec<f32>; 2],
    /// What was wrong with the normals.
    pub faults: NormalFaults,
}

impl NormalSlopes {
    /// The slopes of normals in those axes, given row by row from the top, of any length. Normals at or below
    /// the horizon, and those steeper than `steepest` (metres up for a metre along), keep their direction and
    /// become as steep as accepted; where there is no direction the slopes are filled in smoothly from those
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
        let [width, height] = size;
        HeightMap::check_size(width, height)?;
        if normals.len() as u64 != u64::from(width) * u64::from(height) {
            return Err(FromNormalsError::WrongLength { width, height, given: normals.len() });
        }
        check_steepest(steepest)?;
        let row_length = width as usize;
        let mut along = [0, 1].map(|_| vec![0.0f32; normals.len()]);
        let [along_u, along_v] = &mut along;
        let rows: Vec<NormalFaults> = normals
            .par_chunks(row_length)
            .zip(along_u.par_chunks_mut(row_length).zip(along_v.par_chunks_mut(row_length)))
            .enumerate()
            .map(|(row, (normals, (along_u, along_v)))| {
                let mut faults = NormalFaults::default();
                for (column, (&normal, (u, v))) in
                    normals.iter().zip(along_u.iter_mut().zip(along_v)).enumerate()
                {
                    let length = normal.iter().map(|x| x * x).sum::<f32>().sqrt();
                    if !has_direction(normal) {
                        faults.without_direction += 1;
                        faults.first_without_direction.get_or_insert([column as u32, row as u32]);
                        continue;
                    }
                    faults.not_unit += usize::from((length - 1.0).abs() > UNIT_TOLERANCE);
                    let (slope, fault) = slope(normal, axes, steepest as f32);
                    [*u, *v] = slope;
                    faults.below_horizon += usize::from(fault == Some(Fault::BelowHorizon));
                    faults.too_steep += usize::from(fault == Some(Fault::TooSteep));
                }
                faults
            })
            .collect();
        let faults = rows.into_iter().fold(NormalFaults::default(), NormalFaults::and);
        if faults.without_direction == normals.len() {
            return Err(FromNormalsError::NoDirection);
        }
        if faults.without_direction > 0 {
            let known: Vec<bool> = normals.par_iter().map(|&normal| has_direction(normal)).collect();
            for plane in &mut along {
                fill::fill([row_length, height as usize], plane, &known);
            }
        }
        Ok(Self { size, along, faults })
    }

    /// The slopes of the same normals with `y` pointing the other way.
    #[must_use]
    pub fn turned_over(mut self) -> Self {
        self.along[1].par_iter_mut().for_each(|slope| *slope = -*slope);
        self
    }

    /// Root mean square of the slopes, by both axes together.
    pub fn steepness(&self) -> f64 {
        let sum = |plane: &[f32]| plane.iter().map(|&slope| f64::from(slope).powi(2)).sum::<f64>();
        (self.along.iter().map(|plane| sum(plane)).sum::<f64>() / self.along[0].len() as f64).sqrt()
    }
}

fn has_direction(normal: [f32; 3]) -> bool {
    let length = normal.iter().map(|x| x * x).sum::<f32>().sqrt();
    length.is_finite() && length >= SHORTEST
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
