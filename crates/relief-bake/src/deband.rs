//! Slopes instead of steps: heights that were rounded to few levels, smoothed within the rounding.
//!
//! A height that was rounded to a step lies within half a step of its level. Among all maps within
//! these bounds the smoothest is taken: the one with the least sum of squared Laplacians. The
//! Laplacian is the sum of second differences along both axes, with the map's wrap. It is diagonal
//! in the waves of [`from_normals`](crate::from_normals): tiled, or mirrored for maps that are
//! clamped or mirrored.
//!
//! # Method
//!
//! Alternating directions (Boyd et al. 2011, *Distributed Optimization and Statistical Learning via
//! the Alternating Direction Method of Multipliers*, section 5): each round solves for the
//! smoothest map near the last one in waves and clamps it to the bounds. The last step is a clamp,
//! so the bounds hold whatever the number of rounds.
//!
//! # Rough places
//!
//! Where relief is rougher than its steps, rounding does not show, and smoothing would take relief
//! away. The Laplacian of rounding errors alone is 1.3 steps, root mean square. The bounds are half
//! a step where the Laplacian of the map is at most [`SMOOTH`] steps, root mean square over 9x9
//! texels. They shrink to nothing at [`ROUGH`] steps.
//!
//! # Accuracy
//!
//! Root mean square error as a part of the rounded map's, 512² texels of 32, 64 and 128 levels:
//! at most 0.08 for waves no shorter than a sixth of the side, and 0.23 for fractal ground whose
//! amplitude falls with the frequency to the power of 2.5. Cobbles of 8 bits, which are rougher
//! than their steps, keep their error: 0.99.
//!
//! Results are the same bits for any number of threads.

use rayon::prelude::*;
use relief_core::{Cancelled, EqualSteps, HeightMap, Watch, Wrap};

use crate::spectrum::{Border, LineTransform, change_waves};

/// Default number of rounds.
pub const ROUNDS: u32 = 150;

/// Most rounds.
pub const MOST_ROUNDS: u32 = 10_000;

/// Roughness in steps up to which heights move by half a step.
pub const SMOOTH: f64 = 1.5;

/// Roughness in steps from which heights stay.
pub const ROUGH: f64 = 3.0;

/// Memory in bytes that a texel takes besides its map.
pub const BYTES_PER_TEXEL: u64 = 40;

/// Weight of the distance from the last map in a round.
const NEARNESS: f64 = 0.1;

/// Texels on either side of the middle of the window of roughness.
const REACH: i64 = 4;

/// Settings.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Debanding {
    /// Difference between neighbouring levels, in heights from 0 to 1: above 0 and at most 1.
    pub step: f64,
    /// Number of rounds, from 0, which changes nothing, to [`MOST_ROUNDS`]. Default: [`ROUNDS`].
    pub rounds: u32,
}

impl Debanding {
    /// Creates the settings for steps of a size, with the default number of rounds.
    pub const fn of_step(step: f64) -> Self {
        Self { step, rounds: ROUNDS }
    }
}

/// Reason why a map is not smoothed.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum DebandError {
    /// The step is no part of the heights.
    #[error("the step is {0} of the heights from 0 to 1: it must be at least 1e-7 and at most 1")]
    BadStep(f64),
    /// There are too many rounds.
    #[error("{0} rounds are too many: there can be {MOST_ROUNDS}")]
    TooManyRounds(u32),
    /// The work was cancelled.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

/// Finds the step of a map's levels. Holes do not count. Returns `None` if the map is level, or if
/// its heights do not lie on equal steps.
pub fn steps_of(map: &HeightMap) -> Option<EqualSteps> {
    let width = i64::from(map.width());
    let is_hole = |at: usize| map.is_hole(at as i64 % width, at as i64 / width);
    let texels = map.texels().iter().enumerate();
    EqualSteps::of(texels.filter(|(at, _)| map.holes().is_none() || !is_hole(*at)).map(|(_, &h)| h))
}

/// Returns the texels of the map with slopes instead of steps, row by row from the top.
///
/// No texel moves by more than half a step, and all stay from 0 to 1. Takes [`BYTES_PER_TEXEL`].
///
/// ```
/// use relief_bake::deband::{Debanding, deband};
/// use relief_core::{HeightMap, Watch, Wrap};
///
/// let hill = |i: u32, _: u32| 0.5 - 0.5 * (i as f64 * std::f64::consts::TAU / 128.0).cos();
/// let coded = |i, j| ((hill(i, j) * 20.0).round() / 20.0) as f32;
/// let map = HeightMap::from_fn(128, 128, Wrap::Repeat, coded)?;
/// let smooth = deband(&map, &Debanding::of_step(0.05), &Watch::none())?;
/// let off = |texels: &[f32]| -> f64 {
///     (0..128).map(|i| (f64::from(texels[i as usize]) - hill(i, 0)).abs()).sum()
/// };
/// assert!(off(&smooth) < 0.3 * off(map.texels()));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
///
/// When a setting is out of range, or the work is cancelled.
pub fn deband(map: &HeightMap, how: &Debanding, watch: &Watch) -> Result<Vec<f32>, DebandError> {
    if !(1e-7..=1.0).contains(&how.step) {
        return Err(DebandError::BadStep(how.step));
    }
    if how.rounds > MOST_ROUNDS {
        return Err(DebandError::TooManyRounds(how.rounds));
    }
    watch.at(0.0)?;
    let bounds = Bounds { texels: map.texels(), step: how.step, reach: reach(map, how.step) };
    let sides = [map.width(), map.height()].map(|side| side as usize);
    let smoothing = Smoothing::new(sides, map.wrap());
    // Heights in steps: the solution of the last round with the errors that clamping has left so
    // far.
    let mut sums: Vec<f64> = map.texels().par_iter().map(|&h| f64::from(h) / how.step).collect();
    let (mut plane, mut turned) = (vec![0.0; sums.len()], vec![0.0; sums.len()]);
    for round in 0..how.rounds {
        let parts = [round, round + 1].map(|round| round as f32 / how.rounds as f32);
        let (plane, watch) = (plane.as_mut_slice(), watch.piece(parts[0], parts[1]));
        plane.par_iter_mut().zip(&sums).enumerate().with_min_len(CHUNK).for_each(|(at, (value, &sum))| {
            *value = 2.0 * bounds.clamp(at, sum) - sum;
        });
        smoothing.solve(plane, &mut turned, &watch)?;
        sums.par_iter_mut().zip(&*plane).enumerate().with_min_len(CHUNK).for_each(|(at, (sum, &value))| {
            *sum += value - bounds.clamp(at, *sum);
        });
    }
    let height = |(at, &sum): (usize, &f64)| (bounds.clamp(at, sum) * how.step).clamp(0.0, 1.0) as f32;
    Ok(sums.par_iter().enumerate().map(height).collect())
}

/// Texels of a task.
const CHUNK: usize = 1 << 14;

/// Bounds of the heights in steps.
struct Bounds<'a> {
    texels: &'a [f32],
    step: f64,
    /// Distance from the map to both bounds, from 0 to half a step.
    reach: Vec<f32>,
}

impl Bounds<'_> {
    #[inline]
    fn clamp(&self, at: usize, value: f64) -> f64 {
        let (level, reach) = (f64::from(self.texels[at]) / self.step, f64::from(self.reach[at]));
        value.max(level - reach).min(level + reach)
    }
}

/// Returns the distance in steps by which each texel may move: half a step, less in rough places.
fn reach(map: &HeightMap, step: f64) -> Vec<f32> {
    let [width, height] = [map.width() as usize, map.height() as usize];
    let (wrap, texels) = (map.wrap(), map.texels());
    let beside = |at: usize, by: i64, side: usize| wrap.index(at as i64 + by, side as u32) as usize;
    let squares: Vec<f32> = (0..texels.len())
        .into_par_iter()
        .with_min_len(CHUNK)
        .map(|at| {
            let (i, j) = (at % width, at / width);
            let along_u = [-1, 1].map(|by| j * width + beside(i, by, width));
            let along_v = [-1, 1].map(|by| beside(j, by, height) * width + i);
            let around: f64 = along_u.into_iter().chain(along_v).map(|at| f64::from(texels[at])).sum();
            ((4.0 * f64::from(texels[at]) - around) / step).powi(2) as f32
        })
        .collect();
    let mut rows = vec![0.0f32; squares.len()];
    rows.par_chunks_mut(width).zip(squares.par_chunks(width)).for_each(|(sums, squares)| {
        for (i, sum) in sums.iter_mut().enumerate() {
            *sum = (-REACH..=REACH).map(|by| squares[beside(i, by, width)]).sum();
        }
    });
    let mut reach = squares;
    reach.par_chunks_mut(width).enumerate().for_each(|(j, out)| {
        let around = (-REACH..=REACH).map(|by| &rows[beside(j, by, height) * width..][..width]);
        out.fill(0.0);
        for row in around {
            out.iter_mut().zip(row).for_each(|(sum, part)| *sum += part);
        }
        for value in out {
            let roughness = (f64::from(*value) / (2 * REACH + 1).pow(2) as f64).sqrt();
            *value = (0.5 * ((ROUGH - roughness) / (ROUGH - SMOOTH)).clamp(0.0, 1.0)) as f32;
        }
    });
    reach
}

/// The smoothest plane near another one, in waves.
struct Smoothing {
    transforms: [LineTransform; 2],
    /// Second differences of waves along both axes.
    bends: [Vec<f64>; 2],
}

impl Smoothing {
    fn new(sides: [usize; 2], wrap: Wrap) -> Self {
        let border = if wrap == Wrap::Repeat { Border::Tiled } else { Border::Mirrored };
        let transforms = sides.map(|side| LineTransform::new(side, border));
        let bend = |axis: usize| {
            let bend = |k| 2.0 - 2.0 * transforms[axis].turn(k).cos();
            (0..sides[axis]).map(bend).collect()
        };
        let bends = [bend(0), bend(1)];
        Self { transforms, bends }
    }

    fn solve(&self, plane: &mut [f64], turned: &mut [f64], watch: &Watch) -> Result<(), Cancelled> {
        let Self { transforms, bends: [along_u, along_v] } = self;
        change_waves(transforms, plane, turned, watch, |[i, j], wave| {
            *wave *= NEARNESS / ((along_u[i] + along_v[j]).powi(2) + NEARNESS);
        })
    }
}
