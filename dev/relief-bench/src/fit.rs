//! Costs as sums of two parts.

/// A least-squares fit of two factors, by relative errors.
#[derive(Default)]
pub struct Fit {
    squares: [f64; 3],
    products: [f64; 2],
}

impl Fit {
    /// Adds what both factors are multiplied by, and the value that the sum should have.
    pub fn add(&mut self, by: [f64; 2], value: f64) {
        let [a, b] = by.map(|by| by / value);
        for (sum, term) in self.squares.iter_mut().zip([a * a, a * b, b * b]) {
            *sum += term;
        }
        for (sum, term) in self.products.iter_mut().zip([a, b]) {
            *sum += term;
        }
    }

    /// Both factors.
    pub fn solved(&self) -> [f64; 2] {
        let ([aa, ab, bb], [a, b]) = (self.squares, self.products);
        let area = aa * bb - ab * ab;
        [(a * bb - b * ab) / area, (b * aa - a * ab) / area]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_fitted() {
        let mut fit = Fit::default();
        for [slices, fragments] in [[10.0, 5000.0], [20.0, 4000.0], [15.0, 90_000.0]] {
            fit.add([slices, fragments], 0.3 * slices + 1e-4 * fragments);
        }
        let [a, b] = fit.solved();
        assert!((a - 0.3).abs() < 1e-9 && (b - 1e-4).abs() < 1e-12, "{a} {b}");
    }
}
