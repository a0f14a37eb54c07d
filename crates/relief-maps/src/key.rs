//! Keys of baked maps in the cache.

use blake3::{Hash, Hasher};
use relief_core::{MapFormat, MapIdentity, MapLayout, Metric, Wrap};

/// Hash of everything that determines a map's bytes. It includes the revision of the kind, not the
/// version of the program: another version reuses maps that it would bake alike.
pub fn key(identity: &MapIdentity, layout: &MapLayout) -> Hash {
    let MapIdentity { kind, revision, texture, settings, heights, wrap, metric, first_level, height_level } =
        identity;
    let Metric { tile_m, scale_m } = metric;
    let mut hasher = Hasher::new();
    let mut text = |text: &str| {
        hasher.update(&(text.len() as u64).to_le_bytes());
        hasher.update(text.as_bytes());
    };
    text(kind);
    text(texture);
    for (name, _) in settings {
        text(name);
    }
    for (_, value) in settings {
        hasher.update(&value.to_le_bytes());
    }
    hasher.update(&heights.0);
    for length in [tile_m[0], tile_m[1], *scale_m] {
        hasher.update(&length.to_le_bytes());
    }
    let format = match layout.format {
        MapFormat::F32 => 0u32,
        MapFormat::F16 => 1,
        MapFormat::Unorm8 => 2,
    };
    let wrap = match wrap {
        Wrap::Repeat => 0u32,
        Wrap::Clamp => 1,
        Wrap::Mirror => 2,
    };
    let [width, height] = layout.size;
    let layout = [width, height, layout.levels, layout.layers, layout.channels, format];
    for number in [*revision, wrap, *first_level, *height_level].into_iter().chain(layout) {
        hasher.update(&number.to_le_bytes());
    }
    hasher.finalize()
}

#[cfg(test)]
mod tests {
    use relief_core::HeightMap;

    use super::*;

    #[test]
    fn whatever_decides_the_bytes_changes_the_key() {
        let heights =
            |value| HeightMap::new(1, 1, vec![value], Wrap::Clamp).expect("a valid map").heights_hash();
        let identity = MapIdentity {
            kind: "cone".to_owned(),
            revision: 1,
            texture: String::new(),
            settings: vec![("apex".to_owned(), 0.0)],
            heights: heights(0.5),
            wrap: Wrap::Clamp,
            metric: Metric::UNIT,
            first_level: 0,
            height_level: 0,
        };
        let layout = MapLayout { size: [4, 2], levels: 1, layers: 1, channels: 1, format: MapFormat::F32 };
        let other = |change: fn(&mut MapIdentity)| {
            let mut identity = identity.clone();
            change(&mut identity);
            key(&identity, &layout)
        };
        let mut keys = vec![
            key(&identity, &layout),
            key(&MapIdentity { heights: heights(0.25), ..identity.clone() }, &layout),
            other(|identity| identity.kind = "cones".to_owned()),
            other(|identity| (identity.kind, identity.texture) = ("con".to_owned(), "e".to_owned())),
            other(|identity| identity.revision = 2),
            other(|identity| identity.texture = "top".to_owned()),
            other(|identity| identity.settings[0].1 = 1.0),
            other(|identity| identity.settings[0].0 = "bits".to_owned()),
            other(|identity| identity.settings.clear()),
            other(|identity| identity.wrap = Wrap::Mirror),
            other(|identity| identity.metric.scale_m = 2.0),
            other(|identity| identity.first_level = 1),
            other(|identity| identity.height_level = 1),
        ];
        let layouts = [
            MapLayout { size: [2, 4], ..layout },
            MapLayout { levels: 2, ..layout },
            MapLayout { layers: 2, ..layout },
            MapLayout { channels: 2, ..layout },
            MapLayout { format: MapFormat::F16, ..layout },
            MapLayout { format: MapFormat::Unorm8, ..layout },
        ];
        keys.extend(layouts.iter().map(|layout| key(&identity, layout)));
        let count = keys.len();
        keys.sort_by_key(|key| *key.as_bytes());
        keys.dedup();
        assert_eq!(keys.len(), count);
    }
}
