//! Extremes over windows, each from all of its heights.

use rayon::prelude::*;
use relief::HeightMap;

/// Least and greatest height around every dual cell grown by `radius` texels, row by row. Stops looking where no height
/// can be lower or higher.
pub fn window_bounds(map: &HeightMap, radius: u32) -> Vec<[f32; 2]> {
    let radius = i64::from(radius);
    let heights = map.texels().iter();
    let [lowest, highest] = heights.fold([1.0f32, 0.0], |[low, high], &h| [h.min(low), h.max(high)]);
    (0..i64::from(map.height()))
        .into_par_iter()
        .flat_map_iter(|j| (0..i64::from(map.width())).map(move |i| (i, j)))
        .map(|(i, j)| {
            let mut extremes = [1.0f32, 0.0];
            for row in j - radius..=j + radius + 1 {
                for column in i - radius..=i + radius + 1 {
                    let height = map.texel(column, row);
                    extremes = [height.min(extremes[0]), height.max(extremes[1])];
                }
                if extremes == [lowest, highest] {
                    break;
                }
            }
            extremes
        })
        .collect()
}
