//! Exchange of a plane's rows and columns.

use rayon::prelude::*;

/// Columns that one task reads together, so that a cache line is read once.
const COLUMNS: usize = 16;

/// Writes the transpose of a plane with rows of `width` values into `to`.
pub(crate) fn transpose<T: Copy + Send + Sync>(from: &[T], width: usize, to: &mut [T]) {
    let height = from.len() / width;
    to.par_chunks_mut(height * COLUMNS).enumerate().for_each(|(block, columns)| {
        let first = block * COLUMNS;
        for (j, row) in from.chunks(width).enumerate() {
            for (column, &value) in columns.chunks_mut(height).zip(&row[first..]) {
                column[j] = value;
            }
        }
    });
}
