//! Requirements on textures, and the bakes that fill them.

use relief_core::registry::{MapLevels, MapMetric};
use relief_shaders::bindings::{Binding, BindingKind};
use relief_shaders::wgsl::Sampling;
use relief_shaders::{MapNeed, MapSlot};

use crate::Options;
use crate::manifest::{Bake, TextureNeed};

/// Formats of heights.
const HEIGHTS: &[&str] = &["r32float", "r16float", "r16unorm"];

/// Formats of colours and normals. Filtered ones may have 16 bits, which every GPU filters.
const PICTURES: &[&str] = &["rgba32float", "rgba16float"];

/// Formats of masks.
const MASKS: &[&str] = &["r8unorm"];

/// Formats of baked maps, by their number of channels: floats, or codes of 8 bits that the settings
/// decode.
const BAKED: &[&str] = &[
    "r32float",
    "rg32float",
    "rgba32float",
    "r16float",
    "rg16float",
    "rgba16float",
    "r8unorm",
    "rg8unorm",
    "rgba8unorm",
];

/// Formats of the views of an object's images: places in the world.
const PLACES: &[&str] = &["rgba32float"];

/// Formats of shadow maps.
const KEYS: &[&str] = &["r32float"];

/// Returns the requirements on the texture of a binding; none for other kinds of bindings.
pub fn need(binding: &Binding, needs: &[MapNeed], options: &Options) -> Option<TextureNeed> {
    let BindingKind::Texture { layers: has_layers, filtered } = binding.kind else { return None };
    let dimension = if has_layers { "2d-array" } else { "2d" };
    let filtered = filtered && options.sampling == Sampling::Fast;
    let slot = MapSlot::ALL.into_iter().find(|slot| slot.name() == binding.name);
    let map = needs.iter().find(|need| Some(need.slot) == slot);
    let text = |levels: &str, layers: &str| [levels.to_owned(), layers.to_owned()];
    let (formats, [levels, layers]) = match (binding.name, slot) {
        ("height_map", _) => (HEIGHTS, text("surface_settings.height_levels", "1")),
        ("color_map", _) => (PICTURES, text("surface_settings.color_levels", "1")),
        ("normal_map", _) => {
            (PICTURES, text("surface_settings.normal_levels", "1; 2 if there is more than one level"))
        }
        ("material_map", _) => {
            (PICTURES, text("surface_settings.material_levels", "1; 2 if there is a map of emission"))
        }
        (_, Some(MapSlot::Environment)) => (PICTURES, text("surface_settings.environment_levels", "6")),
        (_, Some(MapSlot::Lights)) => (KEYS, text("1", "one for each shadow map")),
        (_, Some(MapSlot::Object)) => (PLACES, text("1", "1")),
        (_, Some(slot)) => {
            let layers = format!("surface_settings.maps[{}].layers", slot as u32);
            (BAKED, [map.map_or("1".to_owned(), levels_of), layers])
        }
        _ => (MASKS, text("1", "1")),
    };
    let bake = map.map(|need| bake(need, options));
    Some(TextureNeed { dimension, formats, filtered, levels, layers, bake })
}

fn levels_of(need: &MapNeed) -> String {
    let levels = match need.input.levels {
        MapLevels::One => "1".to_owned(),
        MapLevels::ChainFrom(first) => {
            format!("the bake's levels from {first} on, each padded to half the size of the one before")
        }
        MapLevels::MeansFrom(_) => "all of the bake".to_owned(),
        MapLevels::EachDetail => {
            "one for each level of the height map, baked from that level's heights".to_owned()
        }
    };
    match need.side {
        Some(side) => format!(
            "{levels}; they begin at the height map's finest level of at most {side} texels a side, whose \
             number is surface_settings.maps[{}].first_level",
            need.slot as u32
        ),
        None => levels,
    }
}

fn bake(need: &MapNeed, options: &Options) -> Bake {
    let metric = match need.input.metric {
        MapMetric::Texture => "texture",
        MapMetric::Scene => "metres",
    };
    Bake {
        kind: need.input.kind,
        texture: need.input.texture,
        settings: need.settings.iter().copied().collect(),
        side: need.side,
        metric,
        how: options.bake.map(|how| how(need)),
    }
}

#[cfg(test)]
mod tests {
    use relief_shaders::Selection;
    use relief_shaders::bindings::BINDINGS;

    use super::*;

    #[test]
    fn every_texture_of_group_0_has_formats() {
        for binding in BINDINGS.iter().filter(|binding| binding.group == 0) {
            let need = need(binding, &[], &Options::default());
            assert_eq!(
                need.is_some(),
                matches!(binding.kind, BindingKind::Texture { .. }),
                "{}",
                binding.name
            );
            // Only masks have 8 bits.
            let is_mask = need.is_some_and(|need| need.formats == MASKS);
            assert_eq!(is_mask, binding.name == "hole_map", "{}", binding.name);
        }
    }

    #[test]
    fn a_map_of_a_coarser_level_says_of_which() {
        let binding = BINDINGS.iter().find(|binding| binding.name == MapSlot::Ambient.name());
        let binding = binding.expect("a binding");
        for (ambient, side) in [("bent-normal", None), ("occlusion", None), ("sky", Some(256))] {
            let mut selection = Selection::exact();
            selection.choose("ambient", ambient).expect("an ambient light");
            if let Some(side) = side {
                selection.set("ambient.side", f64::from(side)).expect("a setting");
            }
            let texture = need(binding, &selection.map_needs(), &Options::default()).expect("a texture");
            assert_eq!(texture.bake.expect("a baked map").side, side, "{ambient}");
            assert_eq!(texture.levels.contains("first_level"), side.is_some(), "{ambient}");
        }
    }
}
