//! Extremes over windows, each from all of its heights.

use rayon::prelude::*;
use relief_core::HeightMap;

/// Least and greatest height around every dual cell grown by `radius` texels, row by row.
pub fn window_bounds(map: &HeightMap, radius: u32) -> Vec<[f32; 2]> {
    let all = extremes(map);
    (0..i64::from(map.height()))
        .into_par_iter()
        .flat_map_iter(|j| (0..i64::from(map.width())).map(move |i| [i, j]))
        .map(|cell| bounds(map, radius, cell, all))
        .collect()
}

/// Least and greatest height of a map.
pub fn extremes(map: &HeightMap) -> [f32; 2] {
    map.texels().iter().fold([1.0f32, 0.0], |[low, high], &h| [h.min(low), h.max(high)])
}

/// Least and greatest height around one dual cell grown by `radius` texels. Stops at the map's least and
/// greatest heights, `all`.
pub fn bounds(map: &HeightMap, radius: u32, [i, j]: [i64; 2], all: [f32; 2]) -> [f32; 2] {
    let radius = i64::from(radius);
    let mut extremes = [1.0f32, 0.0];
    for row in j - radius..=j + radius + 1 {
        for column in i - radius..=i + radius + 1 {
            let height = map.texel(column, row);
            extremes = [height.min(extremes[0]), height.max(extremes[1])];
        }
        if extremes == all {
            break;
        }
    }
    extremes
}
