//! Squared distance transform of a line, by the faster of two exact algorithms.

use super::monotone::Monotone;
use super::window;

/// Steps to either side from which on monotone minima are faster than the window.
const MONOTONE_FROM: f32 = 16.0;

/// Line of samples with a margin at either end, and the buffers of its transform.
#[derive(Debug)]
pub struct Line {
    samples: Vec<f32>,
    margin: usize,
    repeats: bool,
    step_squared: f32,
    monotone: Monotone,
}

impl Line {
    /// Allocates buffers for lines of `length` samples, `step` apart, for distances of up to
    /// `reach` samples.
    pub fn new(length: usize, step: f64, reach: usize, repeats: bool) -> Self {
        // In a repeated line the nearest copy of a sample is at most half of it away.
        let margin = reach.min(if repeats { length / 2 } else { length - 1 });
        let samples = vec![f32::MAX; length + 2 * margin];
        let step_squared = (step * step) as f32;
        let monotone = Monotone::new(length, margin, step_squared);
        Self { samples, margin, repeats, step_squared, monotone }
    }

    /// Returns the samples, to be filled in before they are transformed.
    pub fn samples(&mut self) -> &mut [f32] {
        let end = self.samples.len() - self.margin;
        &mut self.samples[self.margin..end]
    }

    /// Computes `out[i] = min over v of samples[v] + (step (i - v))²`, rounded to `f32`, over all
    /// samples and, in a repeated line, their copies. Samples must be finite and not negative, and
    /// no greater than `(step reach)²`.
    pub fn transform(&mut self, out: &mut [f32]) {
        let (margin, length) = (self.margin, self.samples.len() - 2 * self.margin);
        if self.repeats {
            self.samples.copy_within(length..length + margin, 0);
            self.samples.copy_within(margin..2 * margin, margin + length);
        }
        if window::mean_steps(&self.samples, margin, self.step_squared) < MONOTONE_FROM {
            window::transform(&self.samples, margin, self.step_squared, out);
        } else {
            self.monotone.transform(&self.samples, out);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn either_way_is_the_least_over_the_line() {
        let mut state = 1u32;
        for length in [1usize, 2, 3, 17, 64, 301] {
            for (case, (step, repeats)) in [
                (0.003, true),
                (0.003, false),
                (0.02, true),
                (0.3, false),
                (2.0, true),
                (1e-4, false),
                (0.01, true),
            ]
            .into_iter()
            .flat_map(|line| [0, 1, 2].map(|case| (case, line)))
            {
                let reach = (1.0f64 / step).ceil() as usize;
                let mut line = Line::new(length, step, reach, repeats);
                for (i, sample) in line.samples().iter_mut().enumerate() {
                    state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                    let noise = (state >> 8) as f32 / (1 << 24) as f32;
                    // Noise, all the same but for a few, and a bowl.
                    let bowl = (i as f32 / length as f32 - 0.4).powi(2);
                    *sample = [noise, if noise < 0.01 { 0.0 } else { 1.0 }, bowl][case];
                }
                let values = line.samples().to_vec();
                let mut out = vec![0.0; length];
                line.transform(&mut out);
                for (i, &got) in out.iter().enumerate() {
                    let away = |v: usize| {
                        let away = i.abs_diff(v);
                        if repeats { away.min(length - away) } else { away }
                    };
                    let least = (0..length)
                        .map(|v| f64::from(values[v]) + step * step * (away(v) as f64).powi(2))
                        .fold(f64::MAX, f64::min);
                    assert!((f64::from(got) - least).abs() <= least * 1.8e-7, "{got} for {least}");
                }
            }
        }
    }
}
