//! Integration of slopes that only some texels have.

use rayon::prelude::*;
use relief_core::{Watch, Wrap};

use super::error::FromNormalsError;
use super::integrate::{
    EdgeWeights, IntegratedHeights, Integration, Waves, check, divergence, heights_from_slopes, misfit,
    neighbours,
};
use super::slopes::NormalSlopes;

/// Root mean square error of the slopes at the end, as a part of the error at the start.
const REDUCED: f64 = 1e-5;

/// Part to which the error is reduced where only the quality of the fit matters.
const ROUGHLY: f64 = 1e-2;

/// Most steps.
const MOST_STEPS: usize = 100;

/// Integrates the slopes of texels that hold a normal. Other texels do not count: their heights
/// continue smoothly.
///
/// Where all texels hold a normal this is [`heights_from_slopes`]. Otherwise, the least squares
/// have weights of 0 in holes and are no longer diagonal in waves. They are solved by conjugate
/// gradients, from the heights of filled slopes on. The preconditioner is the waves of the whole
/// map. Each step costs as much as heights without holes; there are 100 at most. Takes six planes
/// of `f64` besides its input and result.
///
/// # Errors
///
/// Fails as [`heights_from_slopes`] does.
pub fn heights_from_known_slopes(
    slopes: &NormalSlopes,
    how: &Integration,
    watch: &Watch,
) -> Result<IntegratedHeights, FromNormalsError> {
    solved(slopes, how, REDUCED, watch)
}

/// Integrates only as exactly as is needed to compare the fits of two slopes.
pub(super) fn roughly(
    slopes: &NormalSlopes,
    how: &Integration,
    watch: &Watch,
) -> Result<IntegratedHeights, FromNormalsError> {
    solved(slopes, how, ROUGHLY, watch)
}

fn solved(
    slopes: &NormalSlopes,
    how: &Integration,
    reduced: f64,
    watch: &Watch,
) -> Result<IntegratedHeights, FromNormalsError> {
    let NormalSlopes { size, along: [along_u, along_v], known, .. } = slopes;
    let along = [&along_u[..], along_v];
    let Some(known) = known else { return heights_from_slopes(*size, along, how, watch) };
    check(*size, &along, how)?;
    let width = size[0] as usize;
    let waves = Waves::new(*size, how);
    let equations = Equations { known, width, how };
    let mut heights = divergence(along, width, how);
    let mut scratch = vec![0.0; heights.len()];
    let piece = |step: usize| {
        let part = |step: usize| step as f32 / (MOST_STEPS + 2) as f32;
        watch.piece(part(step), part(step + 1))
    };
    waves.solve(&mut heights, &mut scratch, &piece(0))?;
    // Residual of the right-hand side.
    let mut rest = equations.right(along);
    let mut image = vec![0.0; heights.len()];
    equations.left(&heights, &mut image);
    rest.par_iter_mut().zip(&image).for_each(|(rest, image)| *rest -= image);
    let mut solved = rest.clone();
    waves.solve(&mut solved, &mut scratch, &piece(1))?;
    let mut step = solved.clone();
    let mut energy = dot(&rest, &solved, width);
    let enough = reduced * reduced * energy;
    for count in 0..MOST_STEPS {
        if energy <= enough {
            break;
        }
        equations.left(&step, &mut image);
        let curvature = dot(&step, &image, width);
        if curvature <= 0.0 {
            break;
        }
        let far = energy / curvature;
        heights.par_iter_mut().zip(&step).for_each(|(height, step)| *height += far * step);
        rest.par_iter_mut().zip(&image).for_each(|(rest, image)| *rest -= far * image);
        solved.copy_from_slice(&rest);
        waves.solve(&mut solved, &mut scratch, &piece(count + 2))?;
        let next = dot(&rest, &solved, width);
        let part = next / energy;
        step.par_iter_mut().zip(&solved).for_each(|(step, solved)| *step = solved + part * *step);
        energy = next;
    }
    drop((rest, image, step, solved, scratch));
    let heights_m: Vec<f32> = heights.par_iter().map(|&h| h as f32).collect();
    drop(heights);
    let misfit = misfit(&heights_m, along, Some(known), width, how);
    Ok(IntegratedHeights { size: *size, heights_m, misfit, too_steep: 0 })
}

/// Dot product, summed row by row, so that threads do not change it.
fn dot(a: &[f64], b: &[f64], width: usize) -> f64 {
    let rows: Vec<f64> = a
        .par_chunks(width)
        .zip(b.par_chunks(width))
        .map(|(a, b)| a.iter().zip(b).map(|(a, b)| a * b).sum())
        .collect();
    rows.iter().sum()
}

/// `(DᵀWD + damping² PᵀP) h = DᵀW s`, where `W` is 1 at known texels and 0 elsewhere.
struct Equations<'a> {
    known: &'a [bool],
    width: usize,
    how: &'a Integration,
}

impl Equations<'_> {
    /// Returns the right-hand side.
    fn right(&self, slopes: [&[f32]; 2]) -> Vec<f64> {
        let mut out = vec![0.0; self.known.len()];
        let sides = [self.width, self.known.len() / self.width];
        let edges = EdgeWeights::new(self.how.wrap, sides);
        let slope = |axis: usize, at: usize| {
            let place = [at % self.width, at / self.width][axis];
            f64::from(edges.at(axis, place) * slopes[axis][at])
        };
        self.transposed(slope, |_| 0.0, &mut out);
        out
    }

    /// Computes the left-hand side of heights.
    fn left(&self, heights: &[f64], out: &mut [f64]) {
        let damping = self.how.damping;
        let slope = |axis: usize, at: usize| {
            let [before, after] = self.beside(axis, at);
            (heights[after] - heights[before]) * 0.5 / self.how.texel_m[axis]
        };
        // P is a quarter of the second difference over a texel's side, and symmetric.
        let bend = |axis: usize, at: usize| {
            let [before, after] = self.beside(axis, at);
            0.25 * (2.0 * heights[at] - heights[before] - heights[after]) / self.how.texel_m[axis]
        };
        let twice = |axis: usize, at: usize| {
            let [before, after] = self.beside(axis, at);
            0.25 * (2.0 * bend(axis, at) - bend(axis, before) - bend(axis, after)) / self.how.texel_m[axis]
        };
        let damped =
            |at: usize| if damping > 0.0 { damping.powi(2) * (twice(0, at) + twice(1, at)) } else { 0.0 };
        self.transposed(slope, damped, out);
    }

    /// Returns the texels before and after a texel along an axis.
    fn beside(&self, axis: usize, at: usize) -> [usize; 2] {
        let (width, height) = (self.width, self.known.len() / self.width);
        let (column, row) = (at % width, at / width);
        if axis == 0 {
            neighbours(self.how.wrap, column, width).map(|column| row * width + column)
        } else {
            neighbours(self.how.wrap, row, height).map(|row| row * width + column)
        }
    }

    /// Computes `DᵀW` of slopes, plus `more`.
    fn transposed(
        &self,
        slope: impl Fn(usize, usize) -> f64 + Sync,
        more: impl Fn(usize) -> f64 + Sync,
        out: &mut [f64],
    ) {
        let (width, height) = (self.width, self.known.len() / self.width);
        let weighed = |axis: usize, at: usize| if self.known[at] { slope(axis, at) } else { 0.0 };
        let mirrored = self.how.wrap != Wrap::Repeat;
        out.par_chunks_mut(width).enumerate().for_each(|(row, out)| {
            for (column, out) in out.iter_mut().enumerate() {
                let at = row * width + column;
                *out = more(at);
                for (axis, place, side) in [(0, column, width), (1, row, height)] {
                    let [before, after] = self.beside(axis, at).map(|at| weighed(axis, at));
                    // Beyond a mirrored edge, slopes continue with the opposite sign.
                    let before = if mirrored && place == 0 { -before } else { before };
                    let after = if mirrored && place + 1 == side { -after } else { after };
                    *out += (before - after) * 0.5 / self.how.texel_m[axis];
                }
            }
        });
    }
}
