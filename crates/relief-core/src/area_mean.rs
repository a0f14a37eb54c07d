//! Coarser mip levels of maps. Each texel is the mean over its area in the next finer level.

use rayon::prelude::*;

/// Columns and rows of the next coarser level: half of each, rounded down, but at least 1. GPU mip
/// chains round in the same way.
pub fn coarser_size(size: [u32; 2]) -> [u32; 2] {
    size.map(|side| (side / 2).max(1))
}

/// Number of mip levels of a map, from the finest to the single texel, both included.
pub fn level_count(size: [u32; 2]) -> u32 {
    size[0].max(size[1]).max(1).ilog2() + 1
}

/// Returns the next coarser level of a map of `N` channels, row by row from the top.
///
/// Each texel is the mean over its area. Where a side is odd, some texels lie across two areas and
/// count for each in part. So the mean of the whole map does not change, except for rounding.
pub fn coarser<const N: usize>(texels: &[[f32; N]], size: [u32; 2]) -> Vec<[f32; N]> {
    coarser_of(|at| texels[at], size)
}

/// Returns the next coarser level of a map whose texels are computed: `value` takes a texel's
/// number. See [`coarser`].
pub fn coarser_of<const N: usize>(value: impl Fn(usize) -> [f32; N] + Sync, size: [u32; 2]) -> Vec<[f32; N]> {
    let to = coarser_size(size);
    let [columns, rows] = [0, 1].map(|axis| areas(size[axis], to[axis]));
    let width = size[0] as usize;
    let texel = |row: &Area, column: &Area| {
        let mut sums = [0.0; N];
        for (j, down) in row {
            for (i, across) in column {
                for (sum, value) in sums.iter_mut().zip(value(j * width + i)) {
                    *sum += down * across * f64::from(value);
                }
            }
        }
        sums.map(|sum| sum as f32)
    };
    rows.par_iter().flat_map_iter(|row| columns.iter().map(move |column| texel(row, column))).collect()
}

/// Texels of a row that overlap an area: the index and the part of the area that it covers.
type Area = Vec<(usize, f64)>;

/// Areas of a row of `from` texels that is reduced to `to` texels.
fn areas(from: u32, to: u32) -> Vec<Area> {
    let [from, to] = [u64::from(from), u64::from(to)];
    // A length unit in which a source texel is `to` long and a target texel is `from` long.
    let area = |at: u64| {
        let (start, end) = (at * from, (at + 1) * from);
        let part = |j: u64| (end.min((j + 1) * to) - start.max(j * to)) as f64 / from as f64;
        (start / to..end.div_ceil(to)).map(|j| (j as usize, part(j))).collect()
    };
    (0..to).map(area).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texels_count_for_the_areas_that_they_lie_in() {
        assert_eq!(coarser(&[[1.0], [3.0], [5.0], [8.0]], [2, 2]), [[4.25]]);
        assert_eq!(coarser(&[[1.0], [3.0], [5.0], [8.0]], [4, 1]), [[2.0], [6.5]]);
        let thirds = coarser(&[[3.0], [6.0], [9.0]], [3, 1]);
        assert_eq!(thirds, [[6.0]]);
        // Five texels become two. The middle one counts half in each.
        assert_eq!(coarser(&[[5.0], [10.0], [20.0], [0.0], [5.0]], [5, 1]), [[10.0], [6.0]]);
        assert_eq!(coarser(&[[1.0, 2.0]], [1, 1]), [[1.0, 2.0]]);
    }

    #[test]
    fn the_mean_of_a_map_stays() {
        for size in [[64, 64], [37, 21], [1, 13], [5, 1], [97, 2]] {
            let count = size[0] * size[1];
            let texels: Vec<[f32; 1]> = (0..count).map(|at| [(at * 37 % 101) as f32 / 100.0]).collect();
            let mean = |texels: &[[f32; 1]]| {
                texels.iter().map(|[t]| f64::from(*t)).sum::<f64>() / texels.len() as f64
            };
            let (mut level, mut at, mut levels) = (texels.clone(), size, 1);
            while at != [1, 1] {
                (level, at, levels) = (coarser(&level, at), coarser_size(at), levels + 1);
                assert_eq!(level.len(), (at[0] * at[1]) as usize);
                assert!((mean(&level) - mean(&texels)).abs() < 1e-6, "{size:?}");
            }
            assert_eq!(levels, level_count(size));
        }
    }
}
