//! The baked maps that searches read, where tests and benchmarks need them.

use relief_bake::{Metric, Progress, kind, texels};
use relief_core::HeightMap;
use relief_shaders::{SearchMap, Selection};

/// The map that a selection's search reads over that height map; none where it reads none.
///
/// # Panics
///
/// When the registry names a kind or a texture that does not exist.
pub fn search_map(map: &HeightMap, selection: &Selection) -> Option<SearchMap> {
    let input = selection.map_input()?;
    let kind = kind(input.kind).unwrap_or_else(|error| panic!("{error}"));
    let texels = texels(kind, input.texture, map, Metric::UNIT, &kind.defaults(), &Progress::none());
    let texels = texels.unwrap_or_else(|error| panic!("{error}"));
    Some(SearchMap::new(input, [map.width(), map.height()], texels))
}
