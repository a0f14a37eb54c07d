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

/// Least and greatest height over the dual cells of every node of a level, row by row. The coarser levels
/// of the map below a node count, too.
pub fn level_over_levels(map: &HeightMap, level: u32) -> Vec<[f32; 2]> {
    let mut nodes = self::level(map, level);
    let columns = map.width().div_ceil(1 << level) as usize;
    for of in 1..level.min(map.levels()) {
        let coarser = map.level(of);
        let width = coarser.width().div_ceil(1 << (level - of)) as usize;
        for (row, extremes) in self::level(&coarser, level - of).chunks(width).enumerate() {
            for (node, [least, most]) in nodes[row * columns..].iter_mut().zip(extremes) {
                *node = [node[0].min(*least), node[1].max(*most)];
            }
        }
    }
    nodes
}
