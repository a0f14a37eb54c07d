//! The baked maps that selections read, where tests and benchmarks need them.

use std::sync::Arc;

use relief_bake::{Progress, WantedMap, baked_map, kind};
use relief_core::{BakedMap, HeightMap, MapFormat, Metric};
use relief_shaders::{MapNeed, MapSlot, Selection, SlotMaps};

/// The maps that a selection reads over that height map, on a surface of the unit metric; one that it reads in
/// several slots is there once.
///
/// # Panics
///
/// When the registry names a kind, a texture or a setting that does not exist.
pub fn maps_for(map: &HeightMap, selection: &Selection) -> Vec<BakedMap> {
    maps_in(MapFormat::F32, map, selection)
}

/// The same, stored in a format.
///
/// # Panics
///
/// As [`maps_for`].
pub fn maps_in(format: MapFormat, map: &HeightMap, selection: &Selection) -> Vec<BakedMap> {
    let mut needs: Vec<MapNeed> = Vec::new();
    for need in selection.map_needs() {
        if !needs.iter().any(|known| known.input == need.input && known.settings == need.settings) {
            needs.push(need);
        }
    }
    let baked = needs.iter().map(|need| {
        let kind = kind(need.input.kind).unwrap_or_else(|error| panic!("{error}"));
        let mut settings = kind.defaults();
        for (name, value) in &need.settings {
            settings.set(name, f64::from(*value)).unwrap_or_else(|error| panic!("{error}"));
        }
        let (texture, levels) = (need.input.texture, need.input.levels);
        let wanted = WantedMap { kind, texture, settings, metric: need.metric(Metric::UNIT), levels, format };
        baked_map(map, &wanted, &Progress::none()).unwrap_or_else(|error| panic!("{error}"))
    });
    baked.collect()
}

/// Those maps in their slots.
///
/// # Panics
///
/// When one of them is not the selection's.
pub fn slots<'a>(map: &HeightMap, selection: &Selection, maps: &'a [BakedMap]) -> SlotMaps<'a> {
    selection.slot_maps(maps, map, Metric::UNIT).unwrap_or_else(|error| panic!("{error}"))
}

/// Those maps as a surface has them.
///
/// # Panics
///
/// When one is missing.
pub fn in_slots(selection: &Selection, maps: Vec<BakedMap>) -> Vec<(MapSlot, Arc<BakedMap>)> {
    let maps: Vec<Arc<BakedMap>> = maps.into_iter().map(Arc::new).collect();
    let needs = selection.map_needs().into_iter().map(|need| {
        let is_needed = |map: &&Arc<BakedMap>| {
            let about = map.identity();
            let has =
                |(name, value): &(&str, f32)| about.settings.iter().any(|of| of.0 == *name && of.1 == *value);
            about.kind == need.input.kind
                && about.texture == need.input.texture
                && need.settings.iter().all(has)
        };
        (need.slot, Arc::clone(maps.iter().find(is_needed).unwrap_or_else(|| panic!("no map for {need:?}"))))
    });
    needs.collect()
}
