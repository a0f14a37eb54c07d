//! The squared distance transform of a line, by the faster of two exact ways.

use super::lower_envelope::LowerEnvelope;
use super::window;

/// Steps to either side from which on the lower envelope is faster than looking around.
const ENVELOPE_FROM: f32 = 80.0;

/// A line of samples with a margin at either end, and the room to transform it.
#[derive(Debug)]
pub struct Line {
    samples: Vec<f32>,
    margin: usize,
    repeats: bool,
    step_squared: f32,
    envelope: LowerEnvelope,
}

impl Line {
    /// Room for lines of `length` samples, `step` apart, for distances of up to `reach` samples.
    pub fn new(length: usize, step: f64, reach: usize, repeats: bool) -> Self {
        // In a repeated line the nearest copy of a sample is at most half of it away.
        let margin = reach.min(if repeats { length / 2 } else { length - 1 });
        let samples = vec![f32::MAX; length + 2 * margin];
        let step_squared = (step * step) as f32;
        let envelope = LowerEnvelope::new(samples.len(), step);
        Self { samples, margin, repeats, step_squared, envelope }
    }

    /// The samples, to be filled in before they are transformed.
    pub fn samples(&mut self) -> &mut [f32] {
        let end = self.samples.len() - self.margin;
        &mut self.samples[self.margin..end]
    }

    /// `out[i] = min over v of samples[v] + (step (i - v))²`, rounded to `f32`, over all samples and, in a repeated line,
    /// their copies. Samples must be finite and not negative, and no greater than `(step reach)²`.
    pub fn transform(&mut self, out: &mut [f32]) {
        let (margin, length) = (self.margin, self.samples.len() - 2 * self.margin);
        if self.repeats {
            self.samples.copy_within(length..length + margin, 0);
            self.samples.copy_within(margin..2 * margin, margin + length);
        }
        if window::mean_steps(&self.samples, margin, self.step_squared) < ENVELOPE_FROM {
            window::transform(&self.samples, margin, self.step_squared, out);
        } else if self.repeats {
            self.envelope.transform(&self.samples, margin, out);
        } else {
            self.envelope.transform(&self.samples[margin..margin + length], 0, out);
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
            for (step, repeats) in [(0.003, true), (0.003, false), (0.02, true), (0.3, false), (2.0, true)] {
                let reach = (1.0f64 / step).ceil() as usize;
                let mut line = Line::new(length, step, reach, repeats);
                for sample in line.samples() {
                    state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                    *sample = (state >> 8) as f32 / (1 << 24) as f32;
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
