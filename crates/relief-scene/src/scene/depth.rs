//! Reliefs that are too deep for their surface.

use relief_core::{HeightMap, Metric};
use relief_io::{Remark, omissions};

/// Deepest relief without a remark, in lengths of its tile. Canyons and spikes are far from it.
/// Metres of ground on a plane of 1 m are beyond it, and so are millimetres that are read as metres.
const DEEPEST_TILES: f64 = 10.0;

/// Returns a remark on a map whose relief, from its lowest to its highest texel, is more than ten
/// times as deep as a tile is long. Nearly all that is seen of it are walls, or nothing.
///
/// `metric` has the lengths of a tile in metres. The scale is the map's own.
#[must_use]
pub fn depth_remark(map: &HeightMap, metric: Metric) -> Option<Remark> {
    let [u, v] = metric.tile_m;
    let (length_m, scale_m) = (u.max(v), map.scale_m());
    // Most maps need no look at their texels.
    if scale_m <= DEEPEST_TILES * length_m {
        return None;
    }
    let [low, high] = map.extremes().map(f64::from);
    let depth_m = scale_m * (high - low);
    (depth_m > DEEPEST_TILES * length_m).then(|| {
        let text = format!(
            "its relief is {} times as deep as its tiles are long, and hides most of itself",
            three_digits(depth_m / length_m)
        );
        Remark::new(&omissions::DEEP_RELIEF, text)
    })
}

/// Formats a number with three significant digits, without trailing zeros.
fn three_digits(number: f64) -> String {
    let rounded = format!("{number:.2e}").parse::<f64>().unwrap_or(number);
    rounded.to_string()
}

#[cfg(test)]
mod tests {
    use super::*;
    use relief_core::Wrap;

    fn remark(texels: [f32; 2], scale_m: f64, tile_m: [f64; 2]) -> Option<String> {
        let map = HeightMap::new(2, 1, texels.to_vec(), Wrap::Repeat).expect("two texels");
        let map = map.with_displacement(scale_m, 0.0).expect("a scale");
        let metric = Metric::new(tile_m, scale_m).expect("lengths");
        depth_remark(&map, metric).map(|remark| remark.text)
    }

    #[test]
    fn depth_is_measured_between_the_texels_and_in_lengths_of_the_tile() {
        let said = remark([0.0, 1.0], 840.0, [1.0, 0.5]).expect("too deep");
        assert!(said.contains("840 times as deep"), "{said}");
        assert!(remark([0.0, 1.0], 10.1, [0.5, 1.0]).is_some());
        assert_eq!(remark([0.0, 1.0], 10.0, [0.5, 1.0]), None);
        // Shallow parts of a great scale are no deep relief.
        assert_eq!(remark([0.5, 0.51], 840.0, [1.0, 1.0]), None);
        assert_eq!(remark([0.0, 1.0], 840.0, [30_000.0, 30_000.0]), None);
        // Millimetres that are read as metres.
        assert!(remark([0.0, 1.0], 20.0, [1.0, 1.0]).is_some());
    }
}
