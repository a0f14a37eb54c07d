//! Repeated measurements, with the median and the extremes, because the machine may be shared.

use std::fmt;

use relief_core::Watch;
use relief_maps::Maps;
use relief_render::Renderer;
use relief_scene::{BackendChoice, Sampling, Scene};

/// Repeated measurements of one thing.
#[derive(Clone, Debug, Default)]
pub struct Samples(Vec<f64>);

impl Samples {
    /// Milliseconds of pictures, after one that is not counted.
    pub fn of_pictures(scene: &Scene, backend: BackendChoice, rounds: u32) -> Result<Self, String> {
        let mut renderer = Renderer::new(backend, Sampling::Exact).map_err(|error| error.to_string())?;
        let mut maps = Maps::in_memory();
        let mut samples = Self::default();
        for round in 0..=rounds {
            let time = renderer.time(scene, &mut maps, &Watch::none()).map_err(|error| error.to_string())?;
            if round > 0 {
                samples.push(time.elapsed.as_secs_f64() * 1e3);
            }
        }
        Ok(samples)
    }

    /// Adds a measurement.
    pub fn push(&mut self, value: f64) {
        self.0.push(value);
    }

    /// The middle one, of an even number the upper; 0 without any.
    pub fn median(&self) -> f64 {
        let mut sorted = self.0.clone();
        sorted.sort_by(f64::total_cmp);
        sorted.get(sorted.len() / 2).copied().unwrap_or_default()
    }

    /// Round by round this over the other: what both suffered in a round cancels out.
    pub fn over(&self, other: &Self) -> Self {
        Self(self.0.iter().zip(&other.0).map(|(one, other)| one / other).collect())
    }

    /// Every measurement times a factor.
    pub fn times(&self, factor: f64) -> Self {
        Self(self.0.iter().map(|value| value * factor).collect())
    }
}

impl fmt::Display for Samples {
    /// The median, then the least and the greatest.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let least = self.0.iter().copied().fold(f64::INFINITY, f64::min);
        let greatest = self.0.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let digits = if self.median() < 10.0 { 3 } else { 1 };
        write!(f, "{:.digits$} ({least:.digits$}..{greatest:.digits$})", self.median())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn medians_and_ratios() {
        let (mut one, mut other) = (Samples::default(), Samples::default());
        for (a, b) in [(4.0, 2.0), (9.0, 3.0), (10.0, 10.0)] {
            one.push(a);
            other.push(b);
        }
        assert_eq!((one.median(), one.over(&other).median(), one.times(0.5).median()), (9.0, 2.0, 4.5));
        assert_eq!(Samples::default().median(), 0.0);
    }
}
