//! The input of bakes.

use relief_core::{HeightMap, Metric};

/// Height map and metric from which a kind is baked.
#[derive(Clone, Copy, Debug)]
pub struct BakeInput<'a> {
    /// The height map. When values are quantised, its texels are the decoded ones.
    pub map: &'a HeightMap,
    /// Lengths in metres of the tile and of the relief.
    pub metric: Metric,
}
