//! Groups of columns of a matrix that are alike, by k-means.
//!
//! * Lloyd 1982, "Least squares quantization in PCM".
//! * Arthur and Vassilvitskii 2007, "k-means++", for the columns that the groups begin with.

use rayon::prelude::*;
use relief_core::rng::Rng;
use relief_core::{Cancelled, Watch};

use super::matrix::Matrix;

/// Rounds after which the groups are taken as they are.
const MOST_ROUNDS: usize = 20;

/// Returns the group of each column, below `count`, which is at least 1. Groups may be empty.
///
/// # Errors
///
/// When the work is cancelled.
pub fn clusters(matrix: &Matrix, count: usize, watch: &Watch) -> Result<Vec<usize>, Cancelled> {
    let steps = (count + MOST_ROUNDS) as f32;
    let mut centres = first_centres(matrix, count, &watch.piece(0.0, count as f32 / steps))?;
    let mut groups = vec![usize::MAX; matrix.columns];
    for round in 0..MOST_ROUNDS {
        watch.at((count + round) as f32 / steps)?;
        let nearest = nearest(matrix, &centres, watch)?;
        if nearest == groups {
            break;
        }
        groups = nearest;
        move_to_means(matrix, &groups, &mut centres);
    }
    Ok(groups)
}

/// Returns columns to begin with, each drawn by its squared distance from those before. A row of
/// the result is a row of the matrix, a column a centre.
fn first_centres(matrix: &Matrix, count: usize, watch: &Watch) -> Result<Matrix, Cancelled> {
    let mut rng = Rng::new(2);
    let mut centres = Matrix::zero(matrix.rows(), count);
    let mut distances = vec![f32::INFINITY; matrix.columns];
    let mut column = rng.below(matrix.columns as u32) as usize;
    for number in 0..count {
        watch.at(number as f32 / count as f32)?;
        for row in 0..matrix.rows() {
            centres.values[row * count + number] = matrix.row(row)[column];
        }
        // Squared distances from the new centre, some columns a task.
        const COLUMNS: usize = 512;
        distances.par_chunks_mut(COLUMNS).enumerate().for_each(|(block, distances)| {
            let mut sums = vec![0.0_f32; distances.len()];
            for row in 0..matrix.rows() {
                let centre = centres.values[row * count + number];
                let values = &matrix.row(row)[block * COLUMNS..][..sums.len()];
                sums.iter_mut()
                    .zip(values)
                    .for_each(|(sum, value)| *sum += (value - centre) * (value - centre));
            }
            distances.iter_mut().zip(sums).for_each(|(distance, sum)| *distance = distance.min(sum));
        });
        let mut drawn = rng.unit() * distances.iter().map(|&distance| f64::from(distance)).sum::<f64>();
        column = distances
            .iter()
            .position(|&distance| {
                drawn -= f64::from(distance);
                drawn < 0.0
            })
            .unwrap_or(column);
    }
    Ok(centres)
}

/// Returns the nearest centre of each column.
fn nearest(matrix: &Matrix, centres: &Matrix, watch: &Watch) -> Result<Vec<usize>, Cancelled> {
    let products = matrix.transposed_times(centres, watch)?;
    let mut squares = vec![0.0_f32; centres.columns];
    for row in 0..centres.rows() {
        squares.iter_mut().zip(centres.row(row)).for_each(|(square, value)| *square += value * value);
    }
    // The square of a distance is |x|² - 2 xc + |c|², and |x|² is the same for all centres.
    let nearest = |products: &[f32]| {
        let distance = |k: &usize| 0.5 * squares[*k] - products[*k];
        (0..centres.columns).min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap_or(0)
    };
    Ok(products.values.par_chunks(centres.columns).map(nearest).collect())
}

/// Moves each centre to the mean of its columns. A centre without columns stays.
fn move_to_means(matrix: &Matrix, groups: &[usize], centres: &mut Matrix) {
    let count = centres.columns;
    let mut members = vec![0_u32; count];
    groups.iter().for_each(|&group| members[group] += 1);
    centres.values.par_chunks_mut(count).enumerate().for_each(|(row, centres)| {
        let mut sums = vec![0.0_f64; count];
        for (&value, &group) in matrix.row(row).iter().zip(groups) {
            sums[group] += f64::from(value);
        }
        for ((centre, sum), &members) in centres.iter_mut().zip(sums).zip(&members) {
            if members > 0 {
                *centre = (sum / f64::from(members)) as f32;
            }
        }
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_around_three_places_are_three_groups() {
        let mut rng = Rng::new(4);
        let true_groups: Vec<usize> = (0..300).map(|_| rng.below(3) as usize).collect();
        let rows = 20;
        let places: Vec<Vec<f32>> =
            (0..3).map(|_| (0..rows).map(|_| rng.unit() as f32 * 10.0).collect()).collect();
        let values = (0..rows)
            .flat_map(|row| true_groups.iter().map(|&group| places[group][row]).collect::<Vec<_>>())
            .map(|value| value + rng.unit() as f32)
            .collect();
        let matrix = Matrix { columns: 300, values };
        let found = clusters(&matrix, 3, &Watch::none()).expect("groups");
        for (a, true_a) in found.iter().zip(&true_groups) {
            for (b, true_b) in found.iter().zip(&true_groups) {
                assert_eq!(a == b, true_a == true_b);
            }
        }
        // More groups than columns that differ.
        let same = Matrix { columns: 5, values: vec![0.25; 15] };
        let found = clusters(&same, 4, &Watch::none()).expect("groups");
        assert!(found.iter().all(|group| *group == found[0]));
    }
}
