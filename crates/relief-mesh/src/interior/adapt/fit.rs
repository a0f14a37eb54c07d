//! Fit of heights: fewer distances exceed the tolerance.
//!
//! The sum of the squared excesses is convex. A few steps of Newton's method lower it, on the
//! greatest distances of each triangle and edge, until most triangles lie within the tolerance.

use relief_core::Watch;

use super::delaunay::NONE;
use super::ground::{Gap, Ground};
use super::refine::Refined;
use crate::Judge;

/// Parts of the tolerance that the fit aims at, one after the other. Between rounds the greatest
/// distances are searched anew, as they may have moved.
const ROUNDS: [f64; 3] = [0.90, 0.93, 0.96];

/// Steps of Newton's method in a round.
const NEWTON_STEPS: usize = 2;

/// Steps of conjugate gradients, which solve each step of Newton's method roughly.
const SOLVER_STEPS: usize = 6;

/// Importance of a distance at the tolerance that does not exceed it, relative to one that does. It
/// falls with the fourth power of the distance, so that distances near the tolerance are not
/// carried over it.
const STAY: f64 = 0.2;

/// Value added to the diagonal, as a part of its greatest.
const RIDGE: f64 = 1e-6;

/// One of the greatest distances of a triangle or edge.
#[derive(Clone, Copy, Debug)]
struct Sample {
    triangle: u32,
    /// Weights of the heights of the triangle's corners in the distance.
    weights: [f32; 3],
    gap: f64,
}

/// Tile whose heights are being fitted.
struct Fit<'t, 'w, G> {
    tile: &'t mut Refined<'w, G>,
    /// The corners of the triangles.
    corners: Vec<[u32; 3]>,
    /// Points before this index do not move.
    free: usize,
    samples: Vec<Sample>,
    moves: Vec<f64>,
}

/// Moves the heights of the points within a tile so that fewer distances exceed the tolerance, and
/// by less.
///
/// Minimises the sum of the squared excesses. If nothing is gained the heights stay as they are. If
/// cancelled, it ends at once and the heights are unusable.
pub fn fit<G: Ground>(tile: &mut Refined<G>, tolerance: f64, watch: &Watch) {
    let free = tile.border();
    let count = tile.heights.len();
    if count == free {
        return;
    }
    let corners = (0..tile.mesh.count()).map(|triangle| tile.mesh.triangle(triangle)).collect();
    let mut kept = tile.heights.clone();
    let mut least = f64::INFINITY;
    let mut fit = Fit { tile, corners, free, samples: Vec::new(), moves: vec![0.0; count] };
    for round in ROUNDS {
        fit.measure();
        let excess = fit.excess(tolerance, 0.0);
        if excess < least {
            least = excess;
            kept.clone_from(&fit.tile.heights);
        }
        for _ in 0..NEWTON_STEPS {
            if watch.is_cancelled() {
                return;
            }
            if !fit.step(round * tolerance) {
                break;
            }
        }
    }
    fit.measure();
    if fit.excess(tolerance, 0.0) >= least {
        tile.heights = kept;
    }
    for height in &mut tile.heights {
        *height = f64::from(*height as f32);
    }
}

/// Returns the excess of a distance over the tolerance, with the sign of the distance.
fn beyond(gap: f64, tolerance: f64) -> f64 {
    (gap.abs() - tolerance).max(0.0).copysign(gap)
}

impl<G: Ground> Fit<'_, '_, G> {
    /// Finds the greatest distances above and below each triangle and edge.
    fn measure(&mut self) {
        let tile = &*self.tile;
        self.samples.clear();
        let free = self.free as u32;
        let mut is_done = vec![false; self.moves.len()];
        for (triangle, &points) in self.corners.iter().enumerate() {
            let triangle = triangle as u32;
            let mut take = |gap: Gap, weights: [f32; 3]| {
                // Parts between points of the border do not move.
                let moves = (0..3).any(|k| points[k] >= free && weights[k] != 0.0);
                if gap.height.is_finite() && moves {
                    self.samples.push(Sample { triangle, weights, gap: gap.height });
                }
            };
            let corners = points.map(|point| tile.corner(point));
            if tile.ground.is_left_out(corners) {
                continue;
            }
            let at = corners.map(|(at, _)| at.map(f64::from));
            let bend = tile.ground.bend(corners);
            for gap in tile.ground.within(corners).bent(bend) {
                take(gap, weights(at, gap.place));
            }
            for k in 0..3 {
                if tile.judge == Judge::Texels {
                    let point = points[k] as usize;
                    if !is_done[point] {
                        is_done[point] = true;
                        let (at, height) = corners[k];
                        let mut own = [0.0; 3];
                        own[k] = 1.0;
                        take(Gap { height: tile.ground.height(at) - height, place: at.map(f64::from) }, own);
                    }
                    continue;
                }
                let edge = 3 * triangle + k as u32;
                let [a, b] = [k, (k + 1) % 3];
                if tile.mesh.opposite(edge) == NONE || points[a] > points[b] {
                    continue;
                }
                let ends = [corners[a], corners[b]];
                let run = [0, 1].map(|axis| f64::from(ends[1].0[axis] - ends[0].0[axis]));
                let axis = usize::from(run[1].abs() > run[0].abs());
                for gap in tile.ground.along(ends).bent(bend) {
                    let part = (gap.place[axis] - f64::from(ends[0].0[axis])) / run[axis];
                    let mut weights = [0.0; 3];
                    (weights[a], weights[b]) = ((1.0 - part) as f32, part as f32);
                    take(gap, weights);
                }
            }
        }
    }

    /// Returns the sum of the squared excesses after a `part` of the moves.
    fn excess(&self, tolerance: f64, part: f64) -> f64 {
        let gap =
            |sample: &Sample| if part == 0.0 { sample.gap } else { sample.gap - part * self.rise(sample) };
        self.samples.iter().map(|sample| beyond(gap(sample), tolerance).powi(2)).sum()
    }

    /// Takes a step of Newton's method. Returns whether it lowers the excess.
    fn step(&mut self, tolerance: f64) -> bool {
        self.solve(|gap| match beyond(gap, tolerance) {
            0.0 => (STAY * (gap / tolerance).powi(4), 0.0),
            beyond => (1.0, beyond),
        });
        let before = self.excess(tolerance, 0.0);
        let parts = [1.0, 0.6, 0.3, 0.1];
        let Some(part) = parts.into_iter().find(|&part| self.excess(tolerance, part) < before) else {
            return false;
        };
        for at in 0..self.samples.len() {
            self.samples[at].gap -= part * self.rise(&self.samples[at]);
        }
        for (height, rise) in self.tile.heights.iter_mut().zip(&self.moves).skip(self.free) {
            *height += part * rise;
        }
        true
    }

    /// Returns the triangle's rise at a sample when the points move.
    fn rise(&self, sample: &Sample) -> f64 {
        let points = self.corners[sample.triangle as usize];
        (0..3).map(|k| f64::from(sample.weights[k]) * self.moves[points[k] as usize]).sum()
    }

    /// Finds the moves whose rises are nearest to the wanted ones, in the sum of squares by
    /// importance. Uses conjugate gradients with a diagonal preconditioner. `wanted` returns
    /// importance and rise for a distance.
    fn solve(&mut self, wanted: impl Fn(f64) -> (f64, f64)) {
        let count = self.moves.len();
        let mut diagonal = vec![0.0; count];
        let mut rest = vec![0.0; count];
        // Off-diagonal terms of each triangle's sides.
        let mut sides = vec![[0.0; 3]; self.corners.len()];
        for sample in &self.samples {
            let points = self.corners[sample.triangle as usize];
            let (importance, rise) = wanted(sample.gap);
            let weights = sample.weights.map(f64::from);
            for k in 0..3 {
                let weight = importance * weights[k];
                diagonal[points[k] as usize] += weight * weights[k];
                rest[points[k] as usize] += weight * rise;
                sides[sample.triangle as usize][k] += weight * weights[(k + 1) % 3];
            }
        }
        let ridge = RIDGE * diagonal.iter().copied().fold(0.0, f64::max);
        for value in &mut diagonal {
            *value += ridge;
        }
        rest[..self.free].fill(0.0);
        self.moves.fill(0.0);
        let mut direction = vec![0.0; count];
        let mut image = vec![0.0; count];
        let mut energy = 0.0;
        for turn in 0..SOLVER_STEPS {
            let next: f64 = (self.free..count).map(|k| rest[k] * rest[k] / diagonal[k]).sum();
            if next == 0.0 {
                return;
            }
            let keep = if turn == 0 { 0.0 } else { next / energy };
            energy = next;
            for k in self.free..count {
                direction[k] = rest[k] / diagonal[k] + keep * direction[k];
                image[k] = diagonal[k] * direction[k];
            }
            for (&[a, b, c], &[ab, bc, ca]) in self.corners.iter().zip(&sides) {
                let [a, b, c] = [a, b, c].map(|point| point as usize);
                image[a] += ab * direction[b] + ca * direction[c];
                image[b] += ab * direction[a] + bc * direction[c];
                image[c] += bc * direction[b] + ca * direction[a];
            }
            let along: f64 = (self.free..count).map(|k| direction[k] * image[k]).sum();
            if along <= 0.0 {
                return;
            }
            let length = energy / along;
            for k in self.free..count {
                self.moves[k] += length * direction[k];
                rest[k] -= length * image[k];
            }
        }
    }
}

/// Returns the barycentric weights of a place.
fn weights([a, b, c]: [[f64; 2]; 3], place: [f64; 2]) -> [f32; 3] {
    let cross =
        |o: [f64; 2], p: [f64; 2], q: [f64; 2]| (p[0] - o[0]) * (q[1] - o[1]) - (p[1] - o[1]) * (q[0] - o[0]);
    let area = cross(a, b, c);
    let [of_b, of_c] = [cross(a, place, c) / area, cross(a, b, place) / area];
    [1.0 - of_b - of_c, of_b, of_c].map(|weight| weight as f32)
}
