//! Sums of products of factors that are nowhere negative.
//!
//! * Cichocki, Zdunek and Amari 2007, "Hierarchical ALS algorithms for nonnegative matrix and 3D
//!   tensor factorization": factor after factor takes the best value while all others rest.

use relief_core::rng::Rng;
use relief_core::{Cancelled, Watch};

use super::matrix::{Matrix, dot};

/// Factors of a matrix: it is nearly `of_rows` times `of_columns` transposed.
#[derive(Clone, Debug, PartialEq)]
pub struct Factors {
    /// A row for each row of the matrix, a column for each term.
    pub of_rows: Matrix,
    /// A row for each column of the matrix, a column for each term.
    pub of_columns: Matrix,
    /// Sum of the squares of what the factors leave out, after each round.
    pub left_out: Vec<f64>,
}

/// Returns non-negative factors of a matrix without negative values, after `rounds` rounds.
///
/// ```
/// use relief_bake::view_dependent::{Matrix, non_negative_factors};
/// use relief_core::Watch;
///
/// let matrix = Matrix { columns: 3, values: vec![2.0, 4.0, 6.0, 3.0, 6.0, 9.0] };
/// let factors = non_negative_factors(&matrix, 1, 10, &Watch::none())?;
/// assert!(factors.left_out[9] < 1e-4);
/// # Ok::<(), relief_core::Cancelled>(())
/// ```
///
/// # Guarantee
///
/// *No round leaves out more than the round before*: each factor is replaced by the one that leaves
/// out least while the others rest, which the old one cannot beat.
///
/// # Errors
///
/// When the work is cancelled.
pub fn non_negative_factors(
    matrix: &Matrix,
    terms: usize,
    rounds: usize,
    watch: &Watch,
) -> Result<Factors, Cancelled> {
    let rows = matrix.rows();
    if rows == 0 {
        let of_columns = Matrix::zero(matrix.columns, terms);
        return Ok(Factors { of_rows: Matrix::zero(0, terms), of_columns, left_out: vec![0.0; rounds] });
    }
    // Factors, one after the other, begin as rows of the matrix.
    let mut rng = Rng::new(3);
    let mut of_columns = Matrix::zero(terms, matrix.columns);
    for term in 0..terms.min(rows) {
        let from = rng.below(rows as u32) as usize;
        of_columns.values[term * matrix.columns..][..matrix.columns].copy_from_slice(matrix.row(from));
    }
    let mut of_rows = Matrix::zero(terms, rows);
    let square = matrix.square();
    let mut left_out = Vec::new();
    for _ in 0..rounds {
        watch.check()?;
        // Products of each row with each factor of columns: a row of these for each term.
        let mut along = Matrix::zero(terms, rows);
        for row in 0..rows {
            for term in 0..terms {
                along.values[term * rows + row] = dot(matrix.row(row), of_columns.row(term)) as f32;
            }
        }
        replace(&mut of_rows, &along, &of_columns);
        let mut along = Matrix::zero(terms, matrix.columns);
        for row in 0..rows {
            for (term, sums) in along.values.chunks_mut(matrix.columns.max(1)).enumerate() {
                let factor = of_rows.row(term)[row];
                if factor > 0.0 {
                    sums.iter_mut().zip(matrix.row(row)).for_each(|(sum, value)| *sum += factor * value);
                }
            }
        }
        replace(&mut of_columns, &along, &of_rows);
        // |M - Σ a bᵀ|² by the products that are there already.
        let mut rest = square;
        for term in 0..terms {
            rest -= 2.0 * dot(along.row(term), of_columns.row(term));
            for other in 0..terms {
                rest += dot(of_rows.row(term), of_rows.row(other))
                    * dot(of_columns.row(term), of_columns.row(other));
            }
        }
        left_out.push(rest.max(0.0));
    }
    Ok(Factors { of_rows: of_rows.transposed(), of_columns: of_columns.transposed(), left_out })
}

/// Replaces each factor by the best one. `along` holds the products of the matrix with `others`.
fn replace(factors: &mut Matrix, along: &Matrix, others: &Matrix) {
    let terms = factors.rows();
    for term in 0..terms {
        let squared = dot(others.row(term), others.row(term));
        if squared <= 0.0 {
            continue;
        }
        let mut steps: Vec<f64> = along.row(term).iter().map(|&value| f64::from(value)).collect();
        for other in 0..terms {
            let product = dot(others.row(term), others.row(other));
            let factor = factors.row(other);
            steps.iter_mut().zip(factor).for_each(|(step, &value)| *step -= product * f64::from(value));
        }
        let columns = factors.columns;
        let factor = &mut factors.values[term * columns..(term + 1) * columns];
        for (value, step) in factor.iter_mut().zip(steps) {
            *value = (f64::from(*value) + step / squared).max(0.0) as f32;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn random(rng: &mut Rng, rows: usize, columns: usize) -> Matrix {
        Matrix { columns, values: (0..rows * columns).map(|_| rng.unit() as f32).collect() }
    }

    #[test]
    fn a_sum_of_non_negative_products_is_found() {
        let mut rng = Rng::new(8);
        let left = random(&mut rng, 30, 3);
        let right = random(&mut rng, 50, 3);
        let matrix = left.times(&right.transposed(), &Watch::none()).expect("a product");
        let found = non_negative_factors(&matrix, 3, 400, &Watch::none()).expect("factors");
        let left_out = found.left_out.last().copied().expect("a round");
        assert!(left_out < 1e-3 * matrix.square(), "{left_out} of {}", matrix.square());
        assert!(found.of_rows.values.iter().chain(&found.of_columns.values).all(|value| *value >= 0.0));
    }

    #[test]
    fn no_round_leaves_out_more() {
        let mut rng = Rng::new(6);
        for [rows, columns, terms] in [[1, 40, 2], [40, 1, 2], [60, 70, 1], [60, 70, 8], [9, 20, 12]] {
            let matrix = random(&mut rng, rows, columns);
            let found = non_negative_factors(&matrix, terms, 60, &Watch::none()).expect("factors");
            let rounding = 1e-6 * matrix.square();
            for pair in found.left_out.windows(2) {
                assert!(pair[1] <= pair[0] + rounding, "{rows} {columns} {terms}: {pair:?}");
            }
            let sum = found.of_rows.times(&found.of_columns.transposed(), &Watch::none()).expect("a product");
            let off = Matrix {
                columns,
                values: matrix.values.iter().zip(&sum.values).map(|(a, b)| a - b).collect(),
            };
            let last = found.left_out.last().copied().expect("a round");
            assert!((off.square() - last).abs() < rounding, "{} {last}", off.square());
        }
    }
}
