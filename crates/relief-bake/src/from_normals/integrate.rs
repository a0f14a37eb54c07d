//! Integration of slopes to heights by least squares.

use rayon::prelude::*;
use relief_core::{HeightMap, HeightMapError, Watch, Wrap};

use super::error::{FromNormalsError, check_steepest};
use crate::kind::normal::Axes;
use crate::spectrum::{Border, LineTransform, change_waves};

/// Settings for reading and integrating normals.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Integration {
    /// The axes of the normals.
    pub axes: Axes,
    /// Size of a texel along `u` and `v` in metres.
    pub texel_m: [f64; 2],
    /// Continuation of the map beyond its edges.
    pub wrap: Wrap,
    /// Suppression of waves of about two texels, from 0, none, to 1.
    pub damping: f64,
    /// Steepest accepted slope, in metres up for a metre along.
    pub steepest: f64,
}

impl Default for Integration {
    /// Returns tangent space, texels of 1 m, tiled, undamped, slopes up to 32 (88°).
    fn default() -> Self {
        Self { axes: Axes::Tangent, texel_m: [1.0; 2], wrap: Wrap::Repeat, damping: 0.0, steepest: 32.0 }
    }
}

/// Heights integrated from normals.
#[derive(Clone, Debug, PartialEq)]
pub struct IntegratedHeights {
    /// Columns and rows.
    pub size: [u32; 2],
    /// Heights in metres, row by row from the top; their mean is 0.
    pub heights_m: Vec<f32>,
    /// Root mean square difference between the slopes of these heights and the given slopes, over
    /// both axes together. At the edges of a clamped map it counts half.
    pub misfit: f64,
    /// Normals that were at or below the horizon or steeper than accepted.
    pub too_steep: usize,
}

impl IntegratedHeights {
    /// Returns the height map: its lowest texel is 0, its highest 1, and its displacement gives
    /// back the heights in metres. A level map has scale 0.
    ///
    /// # Errors
    ///
    /// When heights are not finite; integration returns finite ones.
    pub fn to_map(&self, wrap: Wrap) -> Result<HeightMap, HeightMapError> {
        let (low, high) =
            self.heights_m.iter().fold((f32::MAX, f32::MIN), |(low, high), &h| (low.min(h), high.max(h)));
        let span = f64::from(high) - f64::from(low);
        let texel = |&h: &f32| if span > 0.0 { ((f64::from(h) - f64::from(low)) / span) as f32 } else { 0.0 };
        let texels = self.heights_m.iter().map(texel).collect();
        HeightMap::new(self.size[0], self.size[1], texels, wrap)?.with_displacement(span, f64::from(low))
    }
}

/// Integrates slopes to heights in metres by least squares. The mean of the heights is 0.
///
/// `size` is columns and rows. `slopes` are two planes, row by row from the top: along `u` (right)
/// and along `v` (down in the picture). Both are in metres up for a metre along.
///
/// `how` gives the size of a texel in metres, the wrap and the damping. Its axes do not matter, and
/// slopes steeper than its steepest one are accepted.
///
/// Takes two planes of `f64` besides its input and result.
///
/// # Errors
///
/// When sizes do not fit together, a value is not finite, a number is out of range, or it is
/// cancelled.
pub fn heights_from_slopes(
    size: [u32; 2],
    slopes: [&[f32]; 2],
    how: &Integration,
    watch: &Watch,
) -> Result<IntegratedHeights, FromNormalsError> {
    check(size, &slopes, how)?;
    let width = size[0] as usize;
    let mut plane = divergence(slopes, width, how);
    let mut turned = vec![0.0; plane.len()];
    Waves::new(size, how).solve(&mut plane, &mut turned, watch)?;
    drop(turned);
    let heights_m: Vec<f32> = plane.par_iter().map(|&h| h as f32).collect();
    drop(plane);
    let misfit = misfit(&heights_m, slopes, None, width, how);
    Ok(IntegratedHeights { size, heights_m, misfit, too_steep: 0 })
}

/// The normal equations in waves, where they are diagonal.
pub(super) struct Waves {
    transforms: [LineTransform; 2],
    eigenvalues: [Vec<Eigenvalue>; 2],
    damping: f64,
}

impl Waves {
    pub fn new(size: [u32; 2], how: &Integration) -> Self {
        let border = if how.wrap == Wrap::Repeat { Border::Tiled } else { Border::Mirrored };
        let sides = size.map(|side| side as usize);
        let transforms = sides.map(|side| LineTransform::new(side, border));
        let eigenvalues = [0, 1].map(|axis| eigenvalues(&transforms[axis], sides[axis], how.texel_m[axis]));
        Self { transforms, eigenvalues, damping: how.damping }
    }

    /// Replaces the right-hand side by the heights. The other plane is scratch of the same size.
    pub fn solve(
        &self,
        plane: &mut [f64],
        turned: &mut [f64],
        watch: &Watch,
    ) -> Result<(), FromNormalsError> {
        let Self { transforms, eigenvalues: [along_u, along_v], damping } = self;
        change_waves(transforms, plane, turned, watch, |[i, j], wave| {
            let (u, v) = (&along_u[i], &along_v[j]);
            let seen = u.seen + v.seen;
            // These waves are not seen: the least that fits is 0.
            *wave = if seen > 0.0 { *wave / (seen + damping.powi(2) * (u.damped + v.damped)) } else { 0.0 };
        })?;
        Ok(())
    }
}

/// Checks that planes and settings can be integrated.
pub(super) fn check(size: [u32; 2], planes: &[&[f32]], how: &Integration) -> Result<(), FromNormalsError> {
    let [width, height] = size;
    HeightMap::check_size(width, height)?;
    for plane in planes {
        if plane.len() as u64 != u64::from(width) * u64::from(height) {
            return Err(FromNormalsError::WrongLength { width, height, given: plane.len() });
        }
        if let Some(at) = plane.iter().position(|value| !value.is_finite()) {
            let (column, row) = ((at % width as usize) as u32, (at / width as usize) as u32);
            return Err(FromNormalsError::NotFinite { column, row });
        }
    }
    let bad = |what, value, must| Err(FromNormalsError::BadNumber { what, value, must });
    for side in how.texel_m {
        if !(1e-30..=1e30).contains(&side) {
            return bad("the size of a texel", side, "between 1e-30 and 1e30 m");
        }
    }
    if !(0.0..=1.0).contains(&how.damping) {
        return bad("the damping", how.damping, "between 0 and 1");
    }
    check_steepest(how.steepest)
}

/// Contribution of a wave along an axis to the diagonal.
struct Eigenvalue {
    /// Share in the squared slopes: `sin²θ / texel²`.
    seen: f64,
    /// Share in the damped part: `((1 - cos θ) / 2)² / texel²`.
    damped: f64,
}

fn eigenvalues(transform: &LineTransform, side: usize, texel_m: f64) -> Vec<Eigenvalue> {
    (0..side)
        .map(|k| {
            let (sin, cos) = transform.turn(k).sin_cos();
            let seen = if transform.is_invisible(k) { 0.0 } else { (sin / texel_m).powi(2) };
            Eigenvalue { seen, damped: (0.5 * (1.0 - cos) / texel_m).powi(2) }
        })
        .collect()
}

/// Returns the neighbours of a texel along a side.
pub(super) fn neighbours(wrap: Wrap, at: usize, side: usize) -> [usize; 2] {
    [-1, 1].map(|step| wrap.index(at as i64 + step, side as u32) as usize)
}

/// Factors of slopes along both sides of a map. `D` takes half of the difference at the edge of a
/// clamped map; the slope of a normal there is all of it. With half of the slope both are alike.
#[derive(Clone, Copy)]
pub(super) struct EdgeWeights {
    is_clamped: bool,
    sides: [usize; 2],
}

impl EdgeWeights {
    pub fn new(wrap: Wrap, sides: [usize; 2]) -> Self {
        Self { is_clamped: wrap == Wrap::Clamp, sides }
    }

    /// Returns the factor of slopes along an axis.
    pub fn at(self, axis: usize, place: usize) -> f32 {
        if self.is_clamped && (place == 0 || place + 1 == self.sides[axis]) { 0.5 } else { 1.0 }
    }
}

/// `Dᵀs`: the transpose of the central differences, applied to the slopes.
pub(super) fn divergence(slopes: [&[f32]; 2], width: usize, how: &Integration) -> Vec<f64> {
    let height = slopes[0].len() / width;
    let halves = how.texel_m.map(|texel| 0.5 / texel);
    let edges = EdgeWeights::new(how.wrap, [width, height]);
    // Beyond a mirrored edge, slopes continue with the opposite sign.
    let across = |before: f32, after: f32, at: usize, side: usize| {
        let mirrored = how.wrap != Wrap::Repeat;
        let before = if mirrored && at == 0 { -before } else { before };
        let after = if mirrored && at + 1 == side { -after } else { after };
        f64::from(before) - f64::from(after)
    };
    let mut out = vec![0.0; slopes[0].len()];
    out.par_chunks_mut(width).enumerate().for_each(|(j, out)| {
        let [above, below] = neighbours(how.wrap, j, height);
        let row = |plane: usize, j: usize| &slopes[plane][j * width..(j + 1) * width];
        let of_rows = [above, below].map(|j| edges.at(1, j));
        let (here, above, below) = (row(0, j), row(1, above), row(1, below));
        for (i, out) in out.iter_mut().enumerate() {
            let [before, after] = neighbours(how.wrap, i, width).map(|i| edges.at(0, i) * here[i]);
            *out = halves[0] * across(before, after, i, width)
                + halves[1] * across(of_rows[0] * above[i], of_rows[1] * below[i], j, height);
        }
    });
    out
}

/// Root mean square of `D h - s` at known texels, row by row so that threads do not change it.
/// Differences at the edges of a clamped map count half.
pub(super) fn misfit(
    heights: &[f32],
    slopes: [&[f32]; 2],
    known: Option<&[bool]>,
    width: usize,
    how: &Integration,
) -> f64 {
    let height = heights.len() / width;
    let halves = how.texel_m.map(|texel| 0.5 / texel);
    let edges = EdgeWeights::new(how.wrap, [width, height]);
    let rows: Vec<f64> = (0..height)
        .into_par_iter()
        .map(|j| {
            let [above, below] = neighbours(how.wrap, j, height).map(|j| &heights[j * width..]);
            let here = &heights[j * width..(j + 1) * width];
            (0..width)
                .filter(|i| known.is_none_or(|known| known[j * width + i]))
                .map(|i| {
                    let [before, after] = neighbours(how.wrap, i, width);
                    let slope = |before: f32, after: f32| f64::from(after) - f64::from(before);
                    let given = [0, 1].map(|axis| slopes[axis][j * width + i]);
                    let given = [edges.at(0, i) * given[0], edges.at(1, j) * given[1]].map(f64::from);
                    let u = halves[0] * slope(here[before], here[after]) - given[0];
                    let v = halves[1] * slope(above[i], below[i]) - given[1];
                    u * u + v * v
                })
                .sum()
        })
        .collect();
    let count = known.map_or(heights.len(), |known| known.iter().filter(|known| **known).count());
    (rows.iter().sum::<f64>() / count as f64).sqrt()
}
