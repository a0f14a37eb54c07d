//! Products of large matrices, with the same bits on every machine and for any number of threads.

use rayon::prelude::*;
use relief_core::{Cancelled, Watch};

use crate::transpose::transpose;

/// Matrix in memory.
#[derive(Clone, Debug, PartialEq)]
pub struct Matrix {
    /// Values of a row.
    pub columns: usize,
    /// Values, row by row.
    pub values: Vec<f32>,
}

/// Rows of a product that one task computes together, so that what they read stays in the caches.
const TOGETHER: usize = 16;

impl Matrix {
    /// Creates a matrix of zeros.
    pub fn zero(rows: usize, columns: usize) -> Self {
        Self { columns, values: vec![0.0; rows * columns] }
    }

    /// Returns the number of rows.
    pub fn rows(&self) -> usize {
        self.values.len().checked_div(self.columns).unwrap_or(0)
    }

    /// Returns a row.
    pub fn row(&self, row: usize) -> &[f32] {
        &self.values[row * self.columns..(row + 1) * self.columns]
    }

    /// Returns the matrix with rows and columns exchanged.
    pub fn transposed(&self) -> Self {
        let mut values = vec![0.0; self.values.len()];
        if !values.is_empty() {
            transpose(&self.values, self.columns, &mut values);
        }
        Self { columns: self.rows(), values }
    }

    /// Returns the product with another matrix, which has as many rows as this one columns.
    ///
    /// # Errors
    ///
    /// When the work is cancelled.
    pub fn times(&self, other: &Self, watch: &Watch) -> Result<Self, Cancelled> {
        product(self.rows(), other, watch, |row, k| self.values[row * self.columns + k])
    }

    /// Returns the product of the transposed matrix with another one, which has as many rows as this
    /// one.
    ///
    /// # Errors
    ///
    /// When the work is cancelled.
    pub fn transposed_times(&self, other: &Self, watch: &Watch) -> Result<Self, Cancelled> {
        product(self.columns, other, watch, |row, k| self.values[k * self.columns + row])
    }

    /// Returns the sum of the squares of all values.
    pub fn square(&self) -> f64 {
        let sums: Vec<f64> = self.values.par_chunks(1 << 14).map(|values| dot(values, values)).collect();
        sums.iter().sum()
    }
}

/// Returns the product of a matrix of `rows` rows, by its values, with another one.
fn product(
    rows: usize,
    other: &Matrix,
    watch: &Watch,
    value: impl Fn(usize, usize) -> f32 + Sync,
) -> Result<Matrix, Cancelled> {
    let mut product = Matrix::zero(rows, other.columns);
    let block = TOGETHER * other.columns.max(1);
    product.values.par_chunks_mut(block).enumerate().try_for_each(|(number, sums)| {
        watch.check()?;
        let first = number * TOGETHER;
        // Four rows of the other matrix at once, so that a sum is read and written once for them.
        for (four, others) in other.values.chunks(4 * other.columns).enumerate() {
            for (row, sums) in sums.chunks_mut(other.columns).enumerate() {
                let factor = |k: usize| value(first + row, 4 * four + k);
                match others.len() / other.columns {
                    4 => add_four(sums, [0, 1, 2, 3].map(factor), others),
                    few => (0..few).for_each(|k| {
                        let others = &others[k * other.columns..(k + 1) * other.columns];
                        let factor = factor(k);
                        sums.iter_mut().zip(others).for_each(|(sum, other)| *sum += factor * other);
                    }),
                }
            }
        }
        Ok(())
    })?;
    Ok(product)
}

/// Adds four rows, each with its factor.
#[inline]
fn add_four(sums: &mut [f32], factors: [f32; 4], rows: &[f32]) {
    let columns = sums.len();
    let (a, rest) = rows.split_at(columns);
    let (b, rest) = rest.split_at(columns);
    let (c, d) = rest.split_at(columns);
    for ((((sum, a), b), c), d) in sums.iter_mut().zip(a).zip(b).zip(c).zip(d) {
        *sum += (factors[0] * a + factors[1] * b) + (factors[2] * c + factors[3] * d);
    }
}

/// Returns the sum of the products of two rows' values.
pub fn dot(a: &[f32], b: &[f32]) -> f64 {
    // Eight sums beside each other, for vector registers.
    const WIDTH: usize = 8;
    let mut sums = [0.0_f64; WIDTH];
    for (a, b) in a.chunks_exact(WIDTH).zip(b.chunks_exact(WIDTH)) {
        for k in 0..WIDTH {
            sums[k] += f64::from(a[k]) * f64::from(b[k]);
        }
    }
    let whole = a.len().min(b.len()) / WIDTH * WIDTH;
    let rest = a[whole..].iter().zip(&b[whole..]).map(|(&a, &b)| f64::from(a) * f64::from(b));
    sums.iter().sum::<f64>() + rest.sum::<f64>()
}

#[cfg(test)]
mod tests {
    use relief_core::rng::Rng;

    use super::*;

    fn random(rng: &mut Rng, rows: usize, columns: usize) -> Matrix {
        Matrix { columns, values: (0..rows * columns).map(|_| rng.unit() as f32 - 0.5).collect() }
    }

    #[test]
    fn products_are_the_sums_of_products() {
        let mut rng = Rng::new(1);
        for [rows, inner, columns] in [[1, 1, 1], [5, 7, 3], [40, 18, 9], [17, 64, 21]] {
            let a = random(&mut rng, rows, inner);
            let b = random(&mut rng, inner, columns);
            let product = a.times(&b, &Watch::none()).expect("a product");
            let other = a.transposed().transposed_times(&b, &Watch::none()).expect("a product");
            assert_eq!(product, other);
            let b = b.transposed();
            for row in 0..rows {
                for column in 0..columns {
                    let expected = dot(a.row(row), b.row(column));
                    let found = f64::from(product.row(row)[column]);
                    assert!((found - expected).abs() < 1e-5, "{rows} {inner} {columns}: {found} {expected}");
                }
            }
        }
    }
}
