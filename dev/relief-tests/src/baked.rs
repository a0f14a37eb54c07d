//! The baked maps that selections read, where tests and benchmarks need them.

use std::sync::Arc;

use relief_bake::{WantedMap, baked_map, kind};
use relief_core::{BakedMap, HeightMap, MapFormat, Metric, Watch};
use relief_shaders::{MapNeed, MapSlot, Selection, SlotMaps};

/// The maps that a selection reads over that height map, on a surface of the unit metric. One that it reads
/// in several slots is there once.
///
/// # Panics
///
/// When the registry names a kind, a texture or a setting that does not exist.
pub fn maps_for(map: &HeightMap, selection: &Selection) -> Vec<BakedMap> {
    maps_in(MapFormat::F32, map, selection)
}

/// Baked map that is stored in a format.
///
/// # Panics
///
/// As [`maps_for`].
pub fn maps_in(format: MapFormat, map: &HeightMap, selection: &Selection) -> Vec<BakedMap> {
    let needs = different_needs(selection);
    let baked = needs.iter().map(|need| {
        let kind = kind(need.input.kind).unwrap_or_else(|error| panic!("{error}"));
        let mut settings = kind.defaults();
        for (name, value) in &need.settings {
            settings.set(name, f64::from(*value)).unwrap_or_else(|error| panic!("{error}"));
        }
        let (texture, levels) = (need.input.texture, need.input.levels);
        let (metric, size) = (need.metric(Metric::UNIT), [map.width(), map.height()]);
        let height_level = need.height_level(size);
        let wanted = WantedMap { kind, texture, settings, metric, levels, height_level, format };
        baked_map(map, &wanted, &Watch::none()).unwrap_or_else(|error| panic!("{error}"))
    });
    baked.collect()
}

/// Returns the maps in their slots.
///
/// # Panics
///
/// When one of them is not the selection's.
pub fn slots<'a>(map: &HeightMap, selection: &Selection, maps: &'a [BakedMap]) -> SlotMaps<'a> {
    selection.slot_maps(maps, map, Metric::UNIT).unwrap_or_else(|error| panic!("{error}"))
}

/// What a selection reads; what several slots need is there once.
fn different_needs(selection: &Selection) -> Vec<MapNeed> {
    let mut needs: Vec<MapNeed> = Vec::new();
    for need in selection.map_needs() {
        if !needs.iter().any(|known| known.is_same_map(&need)) {
            needs.push(need);
        }
    }
    needs
}

/// Returns the maps as a surface has them.
pub fn in_slots(selection: &Selection, maps: Vec<BakedMap>) -> Vec<(MapSlot, Arc<BakedMap>)> {
    let maps: Vec<_> = different_needs(selection).into_iter().zip(maps.into_iter().map(Arc::new)).collect();
    let of = |need: &MapNeed| maps.iter().find(|(known, _)| known.is_same_map(need)).map(|(_, map)| map);
    let needs = selection.map_needs();
    needs.iter().filter_map(|need| Some((need.slot, Arc::clone(of(need)?)))).collect()
}
