//! Baked maps as a reader decodes them.

use relief_bake::kind::frustum::FrustumMap;
use relief_bake::{BakeError, Collected, CollectedTexture, Kind, bake, quantise};
use relief_core::encoding;
use relief_core::{HeightMap, Metric, Watch};

use relief_testing::probes::frustum::Frustum;

/// The textures of a kind, baked with those settings.
///
/// # Errors
///
/// When they cannot be baked.
///
/// # Panics
///
/// When the kind has no such setting.
pub fn textures(
    kind: &Kind,
    map: &HeightMap,
    metric: Metric,
    set: &[(&str, f64)],
) -> Result<Vec<CollectedTexture>, BakeError> {
    let mut settings = kind.defaults();
    for (name, value) in set {
        settings.set(name, *value).expect("a setting of the kind");
    }
    let mut sink = Collected::default();
    bake(kind, map, metric, &settings, &Watch::none(), &mut sink)?;
    Ok(sink.textures)
}

/// Heights for which the promise of a map baked with a number of bits holds.
///
/// # Errors
///
/// None for a valid map.
pub fn heights(map: &HeightMap, bits: u32) -> Result<HeightMap, BakeError> {
    Ok(if bits == 0 { map.clone() } else { quantise::heights(map, bits)? })
}

/// The ratios of a cone map, relaxed or not, in metres per height.
///
/// # Panics
///
/// When it is no cone map.
pub fn ratios(texture: &CollectedTexture) -> Vec<f64> {
    let note = texture.texture.notes.iter().find(|(name, _)| *name == "half_ratio_m");
    let half = note.and_then(|(_, half)| half.parse().ok()).expect("a cone map says its half ratio");
    texture.levels[0][0].iter().map(|&value| encoding::cone::decode(value, half)).collect()
}

/// Least ratio above `limit` that a cone map can store, in metres per height, by its bits and metric.
pub fn ratio_above(limit: f64, metric: &Metric, bits: u32) -> f64 {
    let half = encoding::cone::half_ratio(metric);
    let most = f64::from((1u32 << bits) - 1);
    let code = ((limit / (limit + half)).sqrt() * most).floor() + 1.0;
    if code < most { encoding::cone::decode((code / most) as f32, half) } else { f64::MAX }
}

/// The frustum map in its two textures.
///
/// # Panics
///
/// When these are none.
pub fn frustum_map(map: &HeightMap, textures: &[CollectedTexture]) -> FrustumMap {
    let plane = |texture: usize, channel: usize| textures[texture].levels[0][channel].clone();
    let slopes = [0, 1, 2, 3].map(|channel| plane(1, channel));
    FrustumMap::new([map.width(), map.height()], map.wrap(), plane(0, 0), slopes).expect("planes of the map")
}

/// The frustum of a map for a ray over a cell, not wrapped, in a quadrant.
pub fn frustum(frusta: &FrustumMap, cell: [i64; 2], forward: [bool; 2]) -> Frustum {
    let at = frusta.at(cell, forward);
    Frustum { top: f64::from(at.top), slope: f64::from(at.slope), low: at.low, high: at.high }
}

/// The values of two channels of a texel of a mip level.
pub fn pair(texture: &CollectedTexture, level: usize, column: u32, row: u32) -> [f32; 2] {
    let place = (row * texture.texture.level_size(level)[0] + column) as usize;
    [texture.levels[level][0][place], texture.levels[level][1][place]]
}

/// The value at a texel, wrapped.
pub fn at<T: Copy>(map: &HeightMap, values: &[T], [i, j]: [i64; 2]) -> T {
    let (i, j) = (map.wrap().index(i, map.width()), map.wrap().index(j, map.height()));
    values[j as usize * map.width() as usize + i as usize]
}
