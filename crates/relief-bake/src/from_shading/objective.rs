//! The sum that is minimised on one level, and its gradient.

use rayon::prelude::*;
use relief_core::Wrap;

/// Photograph and model of one level. Heights are in texels along `u`.
pub(super) struct Objective<'a> {
    /// Columns and rows.
    pub sides: [usize; 2],
    pub wrap: Wrap,
    /// Length of a texel along each axis, in texels along `u`.
    pub texel: [f64; 2],
    /// Unit vector to the light along `u` (right), `v` (down) and towards the camera.
    pub to_light: [f64; 3],
    /// Brightness of a texel that faces the light.
    pub albedo: f64,
    /// Brightness of each pixel.
    pub brightness: &'a [f32],
    /// Brightness from which a pixel may be brighter than it says.
    pub overexposed: f64,
    /// Weight of the squared Laplacian of the heights.
    pub smoothness: f64,
    /// Weight of the squared slopes.
    pub flatness: f64,
}

/// Difference between brightness and model from which it counts less than its square.
const ROBUST: f64 = 0.1;

/// Planes that an evaluation needs besides heights and gradient.
pub(super) struct Scratch {
    /// Derivatives of a pixel's term by the slope to its right, left, lower and upper neighbour.
    slopes: [Vec<f32>; 4],
    /// Laplacian of the heights.
    laplacian: Vec<f64>,
}

impl Scratch {
    pub fn new(texels: usize) -> Self {
        Self { slopes: [0; 4].map(|_| vec![0.0; texels]), laplacian: vec![0.0; texels] }
    }
}

/// Neighbours of a place on an axis, after and before it. None lies beyond an edge that does not
/// tile.
#[inline]
fn beside(at: usize, side: usize, wrap: Wrap) -> [Option<usize>; 2] {
    if side == 1 {
        return [None; 2];
    }
    let tiles = wrap == Wrap::Repeat;
    let after = if at + 1 < side { Some(at + 1) } else { tiles.then_some(0) };
    let before = if at > 0 { Some(at - 1) } else { tiles.then_some(side - 1) };
    [after, before]
}

/// Brightness of a slope, and its derivatives.
#[inline]
fn lambert([l_u, l_v, l_n]: [f64; 3], p: f64, q: f64) -> (f64, f64, f64) {
    let facing = l_n - l_u * p - l_v * q;
    let square = 1.0 / (1.0 + p * p + q * q);
    let length = square.sqrt();
    let value = facing * length;
    (value, -l_u * length - value * p * square, -l_v * length - value * q * square)
}

impl Objective<'_> {
    /// Returns the sum at `heights` and writes its gradient.
    pub fn evaluate(&self, heights: &[f64], gradient: &mut [f64], scratch: &mut Scratch) -> f64 {
        let [width, height] = self.sides;
        let Scratch { slopes: [after_u, before_u, after_v, before_v], laplacian } = scratch;
        let sums: Vec<f64> = after_u
            .par_chunks_mut(width)
            .zip(before_u.par_chunks_mut(width))
            .zip(after_v.par_chunks_mut(width))
            .zip(before_v.par_chunks_mut(width))
            .zip(laplacian.par_chunks_mut(width))
            .enumerate()
            .map(|(j, ((((after_u, before_u), after_v), before_v), laplacian))| {
                let row = &heights[j * width..][..width];
                let rows =
                    beside(j, height, self.wrap).map(|row| row.map(|row| &heights[row * width..][..width]));
                let bright = &self.brightness[j * width..][..width];
                let mut sum = 0.0;
                for i in 0..width {
                    let [right, left] = beside(i, width, self.wrap);
                    let here = row[i];
                    let along_u = [right.map(|at| row[at] - here), left.map(|at| here - row[at])];
                    let along_v = [rows[0].map(|row| row[i] - here), rows[1].map(|row| here - row[i])];
                    let (term, du, dv) = self.pixel(f64::from(bright[i]), along_u, along_v);
                    let bend = bend(along_u) + bend(along_v) / self.texel[1].powi(2);
                    laplacian[i] = bend;
                    sum += term + self.smoothness * bend * bend;
                    [after_u[i], before_u[i]] = du;
                    [after_v[i], before_v[i]] = dv;
                }
                sum
            })
            .collect();
        let (slopes, laplacian) = (&scratch.slopes, &scratch.laplacian);
        gradient.par_chunks_mut(width).enumerate().for_each(|(j, out)| {
            let [below, above] = beside(j, height, self.wrap);
            let ratio = 1.0 / self.texel[1].powi(2);
            for (i, out) in out.iter_mut().enumerate() {
                let [right, left] = beside(i, width, self.wrap);
                let at = j * width + i;
                let here = laplacian[at];
                let mut sum = 0.0;
                let mut bends = 0.0;
                // The slope to the right is seen by this pixel and by its right neighbour.
                if let Some(right) = right {
                    sum -= f64::from(slopes[0][at] + slopes[1][j * width + right]);
                    bends += laplacian[j * width + right] - here;
                }
                if let Some(left) = left {
                    sum += f64::from(slopes[1][at] + slopes[0][j * width + left]);
                    bends += laplacian[j * width + left] - here;
                }
                if let Some(below) = below {
                    sum -= f64::from(slopes[2][at] + slopes[3][below * width + i]);
                    bends += (laplacian[below * width + i] - here) * ratio;
                }
                if let Some(above) = above {
                    sum += f64::from(slopes[3][at] + slopes[2][above * width + i]);
                    bends += (laplacian[above * width + i] - here) * ratio;
                }
                *out = sum + 2.0 * self.smoothness * bends;
            }
        });
        sums.iter().sum()
    }

    /// Returns a pixel's term, and its derivatives by the differences of heights after and before
    /// it along both axes.
    #[inline]
    fn pixel(
        &self,
        brightness: f64,
        along_u: [Option<f64>; 2],
        along_v: [Option<f64>; 2],
    ) -> (f64, [f32; 2], [f32; 2]) {
        let inverse = 1.0 / self.texel[1];
        let us = both(along_u);
        let vs = both(along_v).map(|(slope, weight)| (slope * inverse, weight));
        let mut light = 0.0;
        let mut du = [0.0; 2];
        let mut dv = [0.0; 2];
        let mut steepness = 0.0;
        let [mut steep_u, mut steep_v] = [[0.0; 2]; 2];
        for (a, &(p, weight_u)) in us.iter().enumerate() {
            for (b, &(q, weight_v)) in vs.iter().enumerate() {
                let weight = weight_u * weight_v;
                let (value, by_p, by_q) = lambert(self.to_light, p, q);
                steepness += weight * (p * p + q * q);
                steep_u[a] += weight * p;
                steep_v[b] += weight * q;
                if value > 0.0 {
                    light += weight * value;
                    du[a] += weight * by_p;
                    dv[b] += weight * by_q;
                }
            }
        }
        let mut off = self.albedo * light - brightness;
        if brightness >= self.overexposed {
            off = off.min(0.0);
        }
        // Pseudo-Huber: half the square near 0, linear far from it.
        let root = (1.0 + (off / ROBUST).powi(2)).sqrt();
        let term = ROBUST * ROBUST * (root - 1.0) + self.flatness * steepness;
        let by = self.albedo * off / root;
        let by_slope = |d: f64, steep: f64| by * d + 2.0 * self.flatness * steep;
        (
            term,
            [0, 1].map(|at| by_slope(du[at], steep_u[at]) as f32),
            [0, 1].map(|at| (by_slope(dv[at], steep_v[at]) * inverse) as f32),
        )
    }

    /// Returns the root mean square of the differences between brightness and model.
    pub fn misfit(&self, heights: &[f64]) -> f64 {
        let bare = Objective { smoothness: 0.0, flatness: 0.0, ..*self };
        let mut scratch = Scratch::new(heights.len());
        let mut gradient = vec![0.0; heights.len()];
        let sum = bare.evaluate(heights, &mut gradient, &mut scratch);
        (2.0 * sum / heights.len() as f64).sqrt()
    }
}

/// Returns slopes after and before a place, with the weight of each.
#[inline]
fn both(along: [Option<f64>; 2]) -> [(f64, f64); 2] {
    match along {
        [Some(after), Some(before)] => [(after, 0.5), (before, 0.5)],
        [Some(after), None] => [(after, 1.0), (0.0, 0.0)],
        [None, Some(before)] => [(0.0, 0.0), (before, 1.0)],
        [None, None] => [(0.0, 1.0), (0.0, 0.0)],
    }
}

#[inline]
fn bend([after, before]: [Option<f64>; 2]) -> f64 {
    after.unwrap_or(0.0) - before.unwrap_or(0.0)
}
