//! The nearest sum of products of factors to a matrix: its truncated singular value decomposition.
//!
//! * Halko, Martinsson and Tropp 2011, "Finding structure with randomness", algorithms 4.4 and 5.1:
//!   an orthonormal base of nearly the strongest rows, by products with the matrix alone.

use rayon::prelude::*;
use relief_core::rng::Rng;
use relief_core::{Cancelled, Watch};

use super::matrix::{Matrix, dot};

/// Directions that are searched beyond the wanted rank.
const BEYOND_RANK: usize = 16;

/// Products with the matrix and its transpose that turn the base towards the strongest directions.
const PASSES: usize = 3;

/// Length of a vector after its projections are taken away, as a part of the length before, below
/// which only rounding is left.
const NOTHING_LEFT: f64 = 1e-6;

/// Truncated singular value decomposition.
#[derive(Clone, Debug, PartialEq)]
pub struct Svd {
    /// Left singular vectors: a row for each row of the matrix, a column for each term.
    pub of_rows: Matrix,
    /// Right singular vectors, times their singular values: a row for each column of the matrix, a
    /// column for each term.
    pub of_columns: Matrix,
    /// Singular values, from the greatest.
    pub singular: Vec<f64>,
    /// Sum of the squares of what the terms leave out.
    pub left_out: f64,
}

/// Returns the decomposition with at most `rank` terms. A matrix of a lower rank has fewer.
///
/// ```
/// use relief_bake::view_dependent::{Matrix, truncated_svd};
/// use relief_core::Watch;
///
/// // Two rows that are one row, taken twice and three times.
/// let matrix = Matrix { columns: 3, values: vec![2.0, 4.0, 6.0, 3.0, 6.0, 9.0] };
/// let svd = truncated_svd(&matrix, 2, &Watch::none())?;
/// assert_eq!(svd.singular.len(), 1);
/// assert!(svd.left_out < 1e-4);
/// # Ok::<(), relief_core::Cancelled>(())
/// ```
///
/// # Errors
///
/// When the work is cancelled.
pub fn truncated_svd(matrix: &Matrix, rank: usize, watch: &Watch) -> Result<Svd, Cancelled> {
    let rows = matrix.rows();
    let width = (rank + BEYOND_RANK).min(rows).min(matrix.columns);
    let steps = (2 * PASSES + 2) as f32;
    let step = |number: usize| watch.piece(number as f32 / steps, (number + 1) as f32 / steps);
    let mut base = if width == rows {
        let mut base = Matrix::zero(rows, width);
        (0..rows).for_each(|row| base.values[row * width + row] = 1.0);
        base
    } else {
        let mut rng = Rng::new(1);
        let random = (0..matrix.columns * width).map(|_| rng.unit() as f32 - 0.5).collect();
        let mut base = matrix.times(&Matrix { columns: width, values: random }, &step(0))?;
        make_orthonormal(&mut base, &step(0))?;
        for pass in 0..PASSES {
            let mut other = matrix.transposed_times(&base, &step(2 * pass + 1))?;
            make_orthonormal(&mut other, &step(2 * pass + 1))?;
            base = matrix.times(&other, &step(2 * pass + 2))?;
            make_orthonormal(&mut base, &step(2 * pass + 2))?;
        }
        base
    };
    let other = matrix.transposed_times(&base, &step(2 * PASSES + 1))?;
    let turned = other.transposed();
    let gram: Vec<Vec<f64>> = (0..width)
        .into_par_iter()
        .map(|row| (0..width).map(|column| dot(turned.row(row), turned.row(column))).collect())
        .collect();
    watch.check()?;
    let (values, vectors) = eigen(gram);
    let kept = values.iter().take(rank).take_while(|&&value| value > values[0] * 1e-12).count();
    let turn = Matrix {
        columns: kept,
        values: (0..width)
            .flat_map(|row| vectors[..kept].iter().map(move |vector| vector[row] as f32))
            .collect(),
    };
    base = base.times(&turn, watch)?;
    let singular: Vec<f64> = values[..kept].iter().map(|value| value.sqrt()).collect();
    let left_out = (matrix.square() - values[..kept].iter().sum::<f64>()).max(0.0);
    Ok(Svd { of_rows: base, of_columns: other.times(&turn, watch)?, singular, left_out })
}

/// Makes the columns of a matrix orthogonal and of length 1, or 0 where they depend on those before,
/// by Gram and Schmidt, twice, so that rounding of the first time is gone.
fn make_orthonormal(matrix: &mut Matrix, watch: &Watch) -> Result<(), Cancelled> {
    let rows = matrix.rows();
    let mut turned = matrix.transposed();
    for _ in 0..2 {
        let lengths: Vec<f64> = turned.values.chunks(rows).map(|row| dot(row, row).sqrt()).collect();
        for (k, &length) in lengths.iter().enumerate() {
            watch.check()?;
            let (done, rest) = turned.values.split_at_mut((k + 1) * rows);
            let vector = &mut done[k * rows..];
            let now = dot(vector, vector).sqrt();
            let factor = if now > length * NOTHING_LEFT { 1.0 / now } else { 0.0 };
            vector.iter_mut().for_each(|value| *value = (f64::from(*value) * factor) as f32);
            let vector = &*vector;
            rest.par_chunks_mut(rows).for_each(|other| {
                let along = dot(vector, other) as f32;
                other.iter_mut().zip(vector).for_each(|(other, value)| *other -= along * value);
            });
        }
    }
    *matrix = turned.transposed();
    Ok(())
}

/// Returns the eigenvalues of a symmetric matrix, from the greatest, and the eigenvectors, by
/// Jacobi's rotations.
fn eigen(mut matrix: Vec<Vec<f64>>) -> (Vec<f64>, Vec<Vec<f64>>) {
    let n = matrix.len();
    // A row of these becomes an eigenvector.
    let mut vectors: Vec<Vec<f64>> =
        (0..n).map(|row| (0..n).map(|column| f64::from(u8::from(row == column))).collect()).collect();
    let trace: f64 = (0..n).map(|k| matrix[k][k].abs()).sum();
    const SWEEPS: usize = 30;
    for _ in 0..SWEEPS {
        let mut largest = 0.0_f64;
        for p in 0..n {
            for q in p + 1..n {
                let off = matrix[p][q];
                largest = largest.max(off.abs());
                if off.abs() <= trace * 1e-18 {
                    continue;
                }
                let ratio = (matrix[q][q] - matrix[p][p]) / (2.0 * off);
                let tangent = ratio.signum() / (ratio.abs() + (1.0 + ratio * ratio).sqrt());
                let cosine = 1.0 / (1.0 + tangent * tangent).sqrt();
                let sine = tangent * cosine;
                turn_rows(&mut matrix, [p, q], [cosine, sine]);
                for row in &mut matrix {
                    let (a, b) = (row[p], row[q]);
                    row[p] = cosine * a - sine * b;
                    row[q] = sine * a + cosine * b;
                }
                turn_rows(&mut vectors, [p, q], [cosine, sine]);
            }
        }
        if largest <= trace * 1e-15 {
            break;
        }
    }
    let mut order: Vec<usize> = (0..n).collect();
    order.sort_by(|&a, &b| matrix[b][b].total_cmp(&matrix[a][a]));
    let values = order.iter().map(|&k| matrix[k][k].max(0.0)).collect();
    (values, order.iter().map(|&k| std::mem::take(&mut vectors[k])).collect())
}

/// Turns two rows in their plane.
fn turn_rows(matrix: &mut [Vec<f64>], [p, q]: [usize; 2], [cosine, sine]: [f64; 2]) {
    let (before, from) = matrix.split_at_mut(q);
    for (a, b) in before[p].iter_mut().zip(&mut from[0]) {
        (*a, *b) = (cosine * *a - sine * *b, sine * *a + cosine * *b);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A matrix of the given singular values, between random orthonormal vectors.
    fn with_values(rows: usize, columns: usize, values: &[f64]) -> Matrix {
        let mut rng = Rng::new(9);
        let mut base = |count: usize| {
            let random = (0..count * values.len()).map(|_| rng.unit() as f32 - 0.5).collect();
            let mut base = Matrix { columns: values.len(), values: random };
            make_orthonormal(&mut base, &Watch::none()).expect("a base");
            base
        };
        let (mut left, right) = (base(rows), base(columns));
        left.values.iter_mut().zip(values.iter().cycle()).for_each(|(value, &times)| *value *= times as f32);
        left.times(&right.transposed(), &Watch::none()).expect("a product")
    }

    #[test]
    fn known_singular_values_are_found_and_the_rest_is_left_out() {
        let values: Vec<f64> = (0..60).map(|k| 100.0 * 0.9_f64.powi(k)).collect();
        for [rows, columns] in [[80, 300], [300, 80], [200, 500]] {
            let matrix = with_values(rows, columns, &values);
            for rank in [1, 4, 12, 30] {
                let svd = truncated_svd(&matrix, rank, &Watch::none()).expect("a decomposition");
                assert_eq!(svd.singular.len(), rank);
                for (found, expected) in svd.singular.iter().zip(&values) {
                    assert!((found - expected).abs() < 1e-3 * expected, "{rank}: {found} for {expected}");
                }
                let dropped: f64 = values[rank..].iter().map(|value| value * value).sum();
                assert!(
                    (svd.left_out - dropped).abs() < 1e-3 * dropped,
                    "{rank}: {} {dropped}",
                    svd.left_out
                );
                let sum = svd.of_rows.times(&svd.of_columns.transposed(), &Watch::none()).expect("a product");
                let off = Matrix {
                    columns,
                    values: matrix.values.iter().zip(&sum.values).map(|(a, b)| a - b).collect(),
                };
                assert!(
                    (off.square() - dropped).abs() < 1e-3 * dropped,
                    "{rank}: {} {dropped}",
                    off.square()
                );
            }
        }
    }

    #[test]
    fn a_matrix_of_few_terms_has_no_more() {
        let matrix = Matrix { columns: 50, values: vec![0.5; 50 * 40] };
        let svd = truncated_svd(&matrix, 8, &Watch::none()).expect("a decomposition");
        assert_eq!(svd.singular.len(), 1);
        assert!((svd.singular[0] - 0.5 * 2000.0_f64.sqrt()).abs() < 1e-4, "{:?}", svd.singular);
        let nothing = truncated_svd(&Matrix::zero(40, 50), 8, &Watch::none()).expect("a decomposition");
        assert!(nothing.singular.is_empty() && nothing.left_out == 0.0);
    }
}
