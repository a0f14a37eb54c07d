//! Separable filters of planes of numbers. Pixels beyond the border repeat the border's.

use rayon::prelude::*;

/// Row of `2 radius + 1` weights; the middle one belongs to the pixel itself.
#[derive(Clone, Debug)]
pub struct Kernel(Vec<f64>);

impl Kernel {
    /// Creates weights for the offsets from `-radius` to `radius`.
    pub fn new(radius: i32, weight: impl Fn(f64) -> f64) -> Self {
        Self((-radius..=radius).map(|place| weight(place.into())).collect())
    }

    /// Returns the sum of the weights.
    pub fn sum(&self) -> f64 {
        self.0.iter().sum()
    }

    /// Multiplies each weight by a factor.
    pub fn scaled(self, factor: f64) -> Self {
        Self(self.0.into_iter().map(|weight| weight * factor).collect())
    }

    /// Scales the weights so that positive ones add up to 1 and negative ones to -1.
    pub fn balanced(self) -> Self {
        let part = |is_of: fn(&f64) -> bool| self.0.iter().copied().filter(is_of).sum::<f64>().abs();
        let (positive, negative) = (part(|weight| *weight > 0.0), part(|weight| *weight < 0.0));
        let weights = self.0.iter().map(|&weight| weight / if weight < 0.0 { negative } else { positive });
        Self(weights.collect())
    }
}

/// Filters a plane of numbers along rows by one kernel and along columns by another.
pub fn filtered(plane: &[f64], [columns, rows]: [usize; 2], along_rows: &Kernel, down: &Kernel) -> Vec<f64> {
    let tap = |place: usize, offset: usize, radius: usize, count: usize| {
        (place + offset).saturating_sub(radius).min(count - 1)
    };
    let mut across = vec![0.0; plane.len()];
    across.par_chunks_mut(columns).zip(plane.par_chunks(columns)).for_each(|(out, row)| {
        let radius = along_rows.0.len() / 2;
        for (x, out) in out.iter_mut().enumerate() {
            let taps = along_rows.0.iter().enumerate();
            *out = taps.map(|(offset, weight)| weight * row[tap(x, offset, radius, columns)]).sum();
        }
    });
    let mut filtered = vec![0.0; plane.len()];
    filtered.par_chunks_mut(columns).enumerate().for_each(|(y, out)| {
        let radius = down.0.len() / 2;
        for (offset, weight) in down.0.iter().enumerate() {
            let first = tap(y, offset, radius, rows) * columns;
            for (out, value) in out.iter_mut().zip(&across[first..first + columns]) {
                *out += weight * value;
            }
        }
    });
    filtered
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_point_becomes_the_kernels_and_borders_go_on() {
        let plane: Vec<f64> = (0..35).map(|at| f64::from(u8::from(at == 17))).collect();
        let rising = Kernel::new(1, |x| x);
        let level = Kernel::new(1, |_| 1.0);
        let out = filtered(&plane, [7, 5], &rising, &level);
        // The point is at column 3, row 2; a weight of the right neighbour is felt on the left.
        assert_eq!((out[2 * 7 + 2], out[2 * 7 + 4], out[7 + 2], out[2 * 7 + 3]), (1.0, -1.0, 1.0, 0.0));
        let wide = Kernel::new(9, |_| 1.0).scaled(1.0 / 19.0);
        let same = filtered(&[0.5; 6], [2, 3], &wide, &wide);
        assert!(same.iter().all(|value| (value - 0.5).abs() < 1e-12), "{same:?}");
        let balanced = Kernel::new(2, |x| x * x - 1.5).balanced();
        assert!(balanced.sum().abs() < 1e-12 && balanced.0[0] == 0.5);
    }
}
