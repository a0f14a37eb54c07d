//! L-BFGS whose first metric is diagonal in waves.

use std::collections::VecDeque;

use rayon::prelude::*;
use relief_core::{Cancelled, Watch, Wrap};

use super::objective::{Objective, Scratch};
use crate::spectrum::{Border, LineTransform, change_waves};

/// Values that a task sums.
const CHUNK: usize = 1 << 13;

/// Pairs of steps and changes of the gradient that are kept.
const PAIRS: usize = 5;

/// Part of the descent that the slope promises which a step must bring.
const ENOUGH: f64 = 1e-4;

/// Times that a step is shortened.
const SHORTER: u32 = 12;

/// Part of the value below which a step's gain ends the descent.
const ENDED: f64 = 1e-6;

/// Step and change of the gradient along it.
struct Pair {
    step: Vec<f64>,
    change: Vec<f64>,
    product: f64,
}

/// Minimises in place, by Nocedal 1980, *Updating Quasi-Newton Matrices with Limited Storage*, with
/// steps that are shortened until they bring enough.
pub(super) fn minimise(
    objective: &Objective,
    heights: &mut [f64],
    iterations: u32,
    watch: &Watch,
) -> Result<(), Cancelled> {
    let texels = heights.len();
    let metric = Metric::new(objective);
    let mut scratch = Scratch::new(texels);
    let mut gradient = vec![0.0; texels];
    let mut value = objective.evaluate(heights, &mut gradient, &mut scratch);
    let mut pairs: VecDeque<Pair> = VecDeque::with_capacity(PAIRS);
    let [mut trial, mut trial_gradient, mut direction, mut turned] = [0; 4].map(|_| vec![0.0; texels]);
    for iteration in 0..iterations {
        watch.at(iteration as f32 / iterations as f32)?;
        direction.copy_from_slice(&gradient);
        let mut parts = [0.0; PAIRS];
        for (part, pair) in parts.iter_mut().zip(&pairs) {
            *part = dot(&pair.step, &direction) / pair.product;
            add(&mut direction, -*part, &pair.change);
        }
        metric.apply(&mut direction, &mut turned, watch)?;
        let parts: Vec<f64> = parts[..pairs.len()].to_vec();
        for (part, pair) in parts.iter().zip(&pairs).rev() {
            let back = dot(&pair.change, &direction) / pair.product;
            add(&mut direction, part - back, &pair.step);
        }
        let slope = dot(&direction, &gradient);
        if slope <= 0.0 || !slope.is_finite() {
            break;
        }
        let mut length = 1.0;
        let mut found = None;
        for _ in 0..SHORTER {
            trial
                .par_iter_mut()
                .zip(&*heights)
                .zip(&direction)
                .with_min_len(CHUNK)
                .for_each(|((trial, h), d)| *trial = h - length * d);
            let next = objective.evaluate(&trial, &mut trial_gradient, &mut scratch);
            if next <= value - ENOUGH * length * slope {
                found = Some(next);
                break;
            }
            // The parabola through both values and the slope.
            let parabola = 0.5 * slope * length * length / (next - value + slope * length);
            length = parabola.clamp(0.1 * length, 0.5 * length);
        }
        let Some(next) = found else { break };
        let mut pair = if pairs.len() == PAIRS { pairs.pop_back() } else { None }.unwrap_or_else(|| Pair {
            step: vec![0.0; texels],
            change: vec![0.0; texels],
            product: 0.0,
        });
        pair.step.par_iter_mut().zip(&direction).with_min_len(CHUNK).for_each(|(s, d)| *s = -length * d);
        pair.change
            .par_iter_mut()
            .zip(&trial_gradient)
            .zip(&gradient)
            .with_min_len(CHUNK)
            .for_each(|((y, a), b)| *y = a - b);
        pair.product = dot(&pair.step, &pair.change);
        heights.copy_from_slice(&trial);
        std::mem::swap(&mut gradient, &mut trial_gradient);
        let gain = value - next;
        value = next;
        if pair.product > 0.0 {
            pairs.push_front(pair);
        }
        if gain <= ENDED * value {
            break;
        }
    }
    Ok(())
}

/// Weight that keeps waves finite which nothing sees.
const LEAST: f64 = 1e-9;

/// Inverse of the second derivatives about flat ground, nearly.
struct Metric {
    transforms: [LineTransform; 2],
    /// Weight of each wave's square along both axes.
    seen: [Vec<f64>; 2],
    bends: [Vec<f64>; 2],
    smoothness: f64,
}

impl Metric {
    fn new(objective: &Objective) -> Self {
        let border = if objective.wrap == Wrap::Repeat { Border::Tiled } else { Border::Mirrored };
        let transforms = objective.sides.map(|side| LineTransform::new(side, border));
        let [l_u, l_v, l_n] = objective.to_light;
        let level = l_u * l_u + l_v * l_v;
        let strength = |axis: usize| {
            let l = [l_u, l_v][axis];
            (l * l + 0.1 * level + 0.05 * l_n * l_n) * objective.albedo.powi(2)
                / objective.texel[axis].powi(2)
                + 2.0 * objective.flatness
        };
        let bend = |axis: usize| -> Vec<f64> {
            (0..objective.sides[axis]).map(|k| 2.0 - 2.0 * transforms[axis].turn(k).cos()).collect()
        };
        let seen = [0, 1].map(|axis| bend(axis).iter().map(|bend| bend * strength(axis)).collect());
        let bends =
            [0, 1].map(|axis| bend(axis).iter().map(|bend| bend / objective.texel[axis].powi(2)).collect());
        Self { transforms, seen, bends, smoothness: objective.smoothness }
    }

    fn apply(&self, plane: &mut [f64], turned: &mut [f64], watch: &Watch) -> Result<(), Cancelled> {
        change_waves(&self.transforms, plane, turned, &watch.quiet(), |[i, j], wave| {
            let bend = self.bends[0][i] + self.bends[1][j];
            let weight = self.seen[0][i] + self.seen[1][j] + 2.0 * self.smoothness * bend * bend;
            *wave = if i + j > 0 { *wave / (weight + LEAST) } else { 0.0 };
        })
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    let sums: Vec<f64> = a
        .par_chunks(CHUNK)
        .zip(b.par_chunks(CHUNK))
        .map(|(a, b)| a.iter().zip(b).map(|(a, b)| a * b).sum())
        .collect();
    sums.iter().sum()
}

fn add(to: &mut [f64], factor: f64, other: &[f64]) {
    to.par_chunks_mut(CHUNK).zip(other.par_chunks(CHUNK)).for_each(|(to, other)| {
        to.iter_mut().zip(other).for_each(|(to, other)| *to += factor * other);
    });
}
