//! Extremes over squares of dual cells, from the heights each time.

use rayon::prelude::*;
use relief_core::HeightMap;

/// Least and greatest height over the dual cells of every node of a level, row by row.
pub fn level(map: &HeightMap, level: u32) -> Vec<[f32; 2]> {
    let side = 1i64 << level;
    let (width, height) = (i64::from(map.width()), i64::from(map.height()));
    let columns = (width + side - 1) / side;
    let rows = (height + side - 1) / side;
    (0..rows * columns)
        .into_par_iter()
        .map(|node| {
            let (left, top) = (node % columns * side, node / columns * side);
            let cells = (top..(top + side).min(height))
                .flat_map(|j| (left..(left + side).min(width)).map(move |i| (i, j)));
            let heights = cells.flat_map(|(i, j)| map.cell(i, j));
            heights.fold([1.0, 0.0], |[least, most], h| [h.min(least), h.max(most)])
        })
        .collect()
}
