//! Small least-squares systems that may be underdetermined.

/// Ratio to the largest eigenvalue below which an unknown counts as undetermined. With 1e-4,
/// directions a hundredth of a radian apart are distinguished. Nearer ones would turn rounding into
/// noise.
const OPEN: f64 = 1e-4;

/// A least-squares system of three unknowns.
#[derive(Default)]
pub(super) struct LeastNorm {
    /// Symmetric normal matrix.
    matrix: [[f64; 3]; 3],
    right: [f64; 3],
}

impl LeastNorm {
    /// Adds the equation `row · unknowns = value`.
    pub fn add(&mut self, row: [f64; 3], value: f64) {
        for i in 0..3 {
            for j in 0..3 {
                self.matrix[i][j] += row[i] * row[j];
            }
            self.right[i] += row[i] * value;
        }
    }

    /// Returns the unknowns of least norm among all that have the least squared error. They satisfy
    /// the equations, and are 0 along every eigenvector of the normal matrix whose eigenvalue is
    /// below [`OPEN`] of the largest.
    pub fn solve(&self) -> [f64; 3] {
        let (values, vectors) = eigen(self.matrix);
        let largest = values.into_iter().fold(0.0, f64::max);
        let mut unknowns = [0.0; 3];
        for k in 0..3 {
            if values[k] <= OPEN * largest {
                continue;
            }
            let along: f64 = (0..3).map(|i| vectors[i][k] * self.right[i]).sum();
            for (i, unknown) in unknowns.iter_mut().enumerate() {
                *unknown += vectors[i][k] * along / values[k];
            }
        }
        unknowns
    }
}

/// Eigenvalues of a symmetric matrix, and its eigenvectors as the columns of a rotation, by
/// Jacobi's method.
fn eigen(mut matrix: [[f64; 3]; 3]) -> ([f64; 3], [[f64; 3]; 3]) {
    let mut vectors = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    // It converges quadratically: after four sweeps only rounding remains beside the diagonal.
    for _ in 0..8 {
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            let beside = matrix[p][q];
            if beside == 0.0 {
                continue;
            }
            let half_cot = (matrix[q][q] - matrix[p][p]) / (2.0 * beside);
            let tan = 1f64.copysign(half_cot) / (half_cot.abs() + half_cot.hypot(1.0));
            let cos = 1.0 / tan.hypot(1.0);
            let sin = tan * cos;
            for row in &mut matrix {
                (row[p], row[q]) = (cos * row[p] - sin * row[q], sin * row[p] + cos * row[q]);
            }
            let (a, b) = (matrix[p], matrix[q]);
            matrix[p] = [0, 1, 2].map(|column| cos * a[column] - sin * b[column]);
            matrix[q] = [0, 1, 2].map(|column| sin * a[column] + cos * b[column]);
            (matrix[p][q], matrix[q][p]) = (0.0, 0.0);
            for row in &mut vectors {
                (row[p], row[q]) = (cos * row[p] - sin * row[q], sin * row[p] + cos * row[q]);
            }
        }
    }
    ([matrix[0][0], matrix[1][1], matrix[2][2]], vectors)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
        (0..3).map(|i| (a[i] - b[i]).powi(2)).sum::<f64>().sqrt()
    }

    proptest! {
        #[test]
        fn what_is_determined_is_found_and_the_rest_is_0(
            rows in proptest::collection::vec(prop::array::uniform3(-1.0..1.0f64), 0..7),
            truth in prop::array::uniform3(-9.0..9.0f64),
        ) {
            let mut system = LeastNorm::default();
            for row in &rows {
                system.add(*row, (0..3).map(|i| row[i] * truth[i]).sum());
            }
            let (values, vectors) = eigen(system.matrix);
            let largest = values.into_iter().fold(0.0, f64::max);
            for k in 0..3 {
                // Each column is an eigenvector.
                let column = [0, 1, 2].map(|i| vectors[i][k]);
                let image = [0, 1, 2].map(|i| (0..3).map(|j| system.matrix[i][j] * column[j]).sum::<f64>());
                prop_assert!(distance(image, column.map(|x| x * values[k])) < 1e-12 * largest.max(1.0));
                // Along it the solution is the true value or 0.
                let along = |x: [f64; 3]| (0..3).map(|i| x[i] * column[i]).sum::<f64>();
                let expected = if values[k] > OPEN * largest { along(truth) } else { 0.0 };
                prop_assert!((along(system.solve()) - expected).abs() < 1e-8);
            }
        }
    }

    #[test]
    fn open_systems_have_the_least_solution() {
        assert_eq!(LeastNorm::default().solve(), [0.0; 3]);
        let mut system = LeastNorm::default();
        system.add([1.0, 1.0, 0.0], 2.0);
        assert!(distance(system.solve(), [1.0, 1.0, 0.0]) < 1e-12);
        // The same equation again with a small error: the mean.
        system.add([1.0, 1.0, 0.0], 4.0);
        assert!(distance(system.solve(), [1.5, 1.5, 0.0]) < 1e-12);
    }
}
