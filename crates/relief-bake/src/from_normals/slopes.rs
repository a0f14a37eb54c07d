//! Conversion of normals to slopes, with a count of their faults.

use rayon::prelude::*;
use relief_core::HeightMap;

use super::error::{FromNormalsError, check_steepest};
use super::holes::Holes;
use crate::fill;
use crate::kind::normal::Axes;

/// Tolerance of a normal's length: greater deviations from 1 are counted. Compression and filtering
/// leave less.
pub const UNIT_TOLERANCE: f32 = 0.1;

/// Faults of normals, in numbers of texels.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct NormalFaults {
    /// Normals that are NaN, infinite, or shorter than [`SHORTEST`](super::SHORTEST), as middle
    /// grey is.
    pub without_direction: usize,
    /// Texels with all three components at an end of their range, such as black, white and pure
    /// blue. A normal's components never are: such texels are background.
    pub background: usize,
    /// Texels that are transparent, in a map whose opacity marks holes.
    pub transparent: usize,
    /// Texels beside such a hole whose length is not 1: they are mixed with the background.
    pub mixed: usize,
    /// Column and row of the first hole.
    pub first_hole: Option<[u32; 2]>,
    /// Normals with a direction, and a length off from 1 by more than [`UNIT_TOLERANCE`], which is
    /// not used.
    pub not_unit: usize,
    /// Normals that point along the surface or into it, as no relief's normal does.
    pub below_horizon: usize,
    /// Normals above the horizon that stand for a steeper slope than accepted.
    pub too_steep: usize,
}

impl NormalFaults {
    /// Returns the number of texels that hold no normal.
    pub fn holes(&self) -> usize {
        self.without_direction + self.background + self.transparent + self.mixed
    }
}

/// Slopes of normals.
#[derive(Clone, Debug, PartialEq)]
pub struct NormalSlopes {
    /// Columns and rows.
    pub size: [u32; 2],
    /// Slopes along `u` and along `v` (down in the picture), in metres a metre, row by row from the
    /// top.
    pub along: [Vec<f32>; 2],
    /// Texels that hold a normal; none where all do. Slopes of the others were filled in.
    pub known: Option<Vec<bool>>,
    /// Faults of the normals.
    pub faults: NormalFaults,
}

impl NormalSlopes {
    /// Converts normals of any length, given row by row from the top. Normals steeper than
    /// `steepest` (metres up for a metre along) keep their direction and become as steep as
    /// `steepest`. So do normals at or below the horizon. Holes, which hold no normal, are filled
    /// smoothly with slopes from around them.
    ///
    /// # Errors
    ///
    /// When the number of normals does not match the size, when `steepest` is not above 0 and at
    /// most 1e6, or when no normal has a direction.
    pub fn of_normals(
        size: [u32; 2],
        normals: &[[f32; 3]],
        axes: Axes,
        steepest: f64,
    ) -> Result<Self, FromNormalsError> {
        Self::of_picture(size, normals, None, axes, steepest)
    }

    /// Converts a picture as [`of_normals`](Self::of_normals) does. Its opacity may mark holes:
    /// transparent texels are holes if opacity is a mask. A mask is 0 or 1 at nine of ten texels at
    /// least.
    ///
    /// # Errors
    ///
    /// Fails as [`of_normals`](Self::of_normals) does, and when there is not one opacity for each
    /// normal.
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

    /// Returns the slopes of the same normals with `y` pointing the other way.
    #[must_use]
    pub fn turned_over(mut self) -> Self {
        self.along[1].par_iter_mut().for_each(|slope| *slope = -*slope);
        self
    }

    /// Returns the root mean square of the slopes of texels that hold a normal, over both axes
    /// together.
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

/// Returns whether a normal has length 1, within [`UNIT_TOLERANCE`].
pub(super) fn is_unit(normal: [f32; 3]) -> bool {
    (length(normal) - 1.0).abs() <= UNIT_TOLERANCE
}

pub(super) fn length(normal: [f32; 3]) -> f32 {
    normal.iter().map(|x| x * x).sum::<f32>().sqrt()
}

/// Reason why a normal's slope was changed.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Fault {
    BelowHorizon,
    TooSteep,
}

/// Returns the slope along `u` and `v` of a normal.
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
    // The direction stays. A normal without a direction becomes level.
    let part = if across > 0.0 { steepest / across } else { 0.0 };
    let fault = if upright > 0.0 { Fault::TooSteep } else { Fault::BelowHorizon };
    ([-x * part, -down * part], Some(fault))
}
