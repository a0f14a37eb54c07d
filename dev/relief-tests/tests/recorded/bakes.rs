//! Every texel of every kind, with its defaults but for `FEWER`, of two maps in the three wraps.

use std::collections::BTreeMap;
use std::path::Path;

use relief_bake::{Collected, KINDS, Kind, bake, kind};
use relief_core::{HeightMap, Metric, Watch, Wrap};
use relief_io::{HeightOptions, read_height};

use crate::hash::Bits;

/// Elevations that do not tile and whose sides are no powers of two, and stones that do and are.
const MAPS: [(&str, &str); 2] = [("elevation", "jacksboro.png"), ("cobbles", "cobbles.png")];

/// The metric that the maps are baked in: unequal sides, so that none is taken for another.
const METRIC: Metric = Metric { tile_m: [1.5, 1.25], scale_m: 0.1 };

/// Kinds and settings whose defaults would take a minute here.
const FEWER: [(&str, &str, f64); 7] = [
    ("generalised", "azimuths", 4.0),
    ("generalised", "elevations", 3.0),
    ("view-dependent", "azimuths", 4.0),
    ("view-dependent", "elevations", 3.0),
    ("view-dependent-free", "azimuths", 4.0),
    ("view-dependent-free", "elevations", 3.0),
    ("view-dependent-free", "bends", 3.0),
];

/// Settings with which view-dependent maps are compressed.
const COMPRESSED: [&[(&str, f64)]; 2] = [&[("rank", 6.0)], &[("rank", 6.0), ("clusters", 5.0)]];

/// The hash of every map, by its kind, the kind's revision, the height map and the wrap.
pub fn all() -> BTreeMap<String, String> {
    let mut found = BTreeMap::new();
    for (name, file) in MAPS {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data").join(file);
        let map = read_height(&path, &HeightOptions::default()).expect("a shipped map");
        for wrap in Wrap::ALL {
            let map = map.clone().with_wrap(wrap);
            for kind in KINDS {
                found.insert(format!("{} {} {name} {wrap}", kind.name, kind.revision), hash(kind, &map, &[]));
            }
            let kind = kind("view-dependent").expect("a kind");
            for settings in COMPRESSED {
                let names: Vec<&str> = settings.iter().map(|(name, _)| *name).collect();
                let key = format!("{} {} {} {name} {wrap}", kind.name, names.join(" "), kind.revision);
                found.insert(key, hash(kind, &map, settings));
            }
        }
    }
    found
}

fn hash(kind: &Kind, map: &HeightMap, changed: &[(&str, f64)]) -> String {
    let mut sink = Collected::default();
    let mut settings = kind.defaults();
    let fewer = FEWER.iter().filter(|(name, ..)| *name == kind.name);
    for (setting, value) in fewer.map(|(_, setting, value)| (*setting, *value)).chain(changed.iter().copied())
    {
        settings.set(setting, value).expect("a setting of this kind");
    }
    bake(kind, map, METRIC, &settings, &Watch::none(), &mut sink).expect("a bake");
    let mut bits = Bits::default();
    for baked in &sink.textures {
        bits.text(baked.texture.name);
        for (level, channels) in baked.levels.iter().enumerate() {
            bits.text(&format!("{:?}", baked.texture.level_size(level)));
            for (channel, texels) in baked.texture.channels.iter().zip(channels) {
                bits.text(channel.name).floats(texels.iter().copied());
            }
        }
    }
    bits.short()
}
