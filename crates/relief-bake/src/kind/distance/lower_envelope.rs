//! The squared distance transform of a line in linear time.
//!
//! Felzenszwalb and Huttenlocher 2012, *Distance Transforms of Sampled Functions*, section 2.

/// The lower envelope of the parabolas over a line of samples, and the room that finding it takes.
#[derive(Debug)]
pub struct LowerEnvelope {
    /// Squared distance between neighbouring samples.
    step_squared: f64,
    /// `1 / (2 k step²)` for the distance `k` between two sites.
    reciprocals: Vec<f64>,
    /// Samples whose parabola is lowest somewhere, in order.
    sites: Vec<u32>,
    /// Where each of them begins to be the lowest.
    starts: Vec<f64>,
}

impl LowerEnvelope {
    /// Room for lines of that many samples, `step` apart.
    pub fn new(samples: usize, step: f64) -> Self {
        let step_squared = step * step;
        let reciprocals = (0..samples).map(|k| 0.5 / (k as f64 * step_squared)).collect();
        Self { step_squared, reciprocals, sites: vec![0; samples], starts: vec![0.0; samples] }
    }

    /// `out[i] = min over v of values[v] + step² (from + i - v)²`, rounded to `f32`.
    ///
    /// The minimum is missed by less than 1e-9 of it at most, where two parabolas cross next to a sample. `values` must be
    /// finite, not negative, at least one, and no more than the room is for; `from + out.len()` at most as many.
    pub fn transform(&mut self, values: &[f32], from: usize, out: &mut [f32]) {
        let (sites, starts) = (&mut self.sites[..values.len()], &mut self.starts[..values.len()]);
        sites[0] = 0;
        starts[0] = f64::NEG_INFINITY;
        let mut last = 0;
        for (q, &value) in values.iter().enumerate().skip(1) {
            loop {
                let v = sites[last] as usize;
                // The middle and a correction, instead of a difference of squares that cancels.
                let rise = f64::from(value) - f64::from(values[v]);
                let cross = 0.5 * (q + v) as f64 + rise * self.reciprocals[q - v];
                if cross > starts[last] {
                    last += 1;
                    sites[last] = q as u32;
                    starts[last] = cross;
                    break;
                }
                // The first start is minus infinity, so that `last` is not 0 here.
                last -= 1;
            }
        }
        let mut at = 0;
        for (i, out) in (from..).zip(out) {
            while at < last && starts[at + 1] < i as f64 {
                at += 1;
            }
            let site = sites[at] as usize;
            let away = i as f64 - site as f64;
            *out = (f64::from(values[site]) + self.step_squared * (away * away)) as f32;
        }
    }
}
