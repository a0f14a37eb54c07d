//! What bakes are made from.

use relief_core::{HeightMap, Metric};

/// What a bake is made from.
#[derive(Clone, Copy, Debug)]
pub struct BakeInput<'a> {
    /// The height map. When values are quantised its texels are the decoded ones.
    pub map: &'a HeightMap,
    /// World lengths of the tile and the relief.
    pub metric: Metric,
}
