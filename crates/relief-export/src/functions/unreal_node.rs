//! The code of a Custom node of Unreal's materials, which calls functions.

use std::fmt::Write as _;

use super::manifest::{FunctionsManifest, SettingPlace};

/// Returns the name that a Custom node's input has for a texture: `HeightMap` for `relief_height_map`.
pub fn unreal_input(texture: &str) -> String {
    let word = |word: &str| {
        let (first, rest) = word.split_at(word.len().min(1));
        first.to_uppercase() + rest
    };
    texture.trim_start_matches("relief_").split('_').map(word).collect()
}

/// Returns the code of a Custom node of Unreal Engine for functions with the prefix `relief`, in the form
/// [`Form::Tangent`](crate::Form::Tangent). The code gives textures and settings to the functions, and calls
/// them through `relief_surface.ush`, which `relief engine unreal` writes.
///
/// Its inputs are `UV`, `Way`, `Normal`, `PixelDepth`, `Scale`, `Sun` if the relief has a shadow on itself,
/// and the textures by the names of [`unreal_input`]. `tile` is the size of the tile that maps of the surface
/// were baked with, in centimetres.
///
/// # Examples
///
/// ```
/// use relief_core::Wrap;
/// use relief_export::{FunctionOptions, Profile, functions, unreal_node};
/// use relief_shaders::Selection;
///
/// let mut cone = Selection::method("cone")?;
/// cone.choose("shadow", "none")?;
/// let options = FunctionOptions {
///     profiles: vec![Profile::Unreal5],
///     wrap: Some(Wrap::Repeat),
///     ..FunctionOptions::default()
/// };
/// let node = unreal_node(&functions(&cone, &options)?.manifest, [100.0, 100.0]);
/// assert!(node.contains("relief.relief_search_map = SearchMap;"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn unreal_node(manifest: &FunctionsManifest, tile: [f32; 2]) -> String {
    let FunctionsManifest { bindings, settings, functions, .. } = manifest;
    let mut text = "Relief relief;\n".to_owned();
    for bound in bindings {
        let input = match bound.of.as_str() {
            "sampler" => "HeightMapSampler".to_owned(),
            _ => unreal_input(&bound.name),
        };
        let _ = writeln!(text, "relief.{} = {input};", bound.name);
    }
    text += "\nReliefSettings settings;\n";
    for setting in settings {
        if setting.name == "height_size" {
            text += "uint columns;\nuint rows;\nHeightMap.GetDimensions(columns, rows);\n";
        }
        let value = value(setting, tile);
        let _ = writeln!(text, "settings.{} = {value}; // {}", setting.name, setting.holds);
    }
    text += "\nReliefSurface seen = relief_surface(relief, settings, UV, Way, Normal);\n\
             Mask = seen.hit.hit ? 1.0 : 0.0;\n\
             HitUV = seen.hit.uv;\n\
             DepthOffset = relief_depth_offset(seen, Way, PixelDepth);\n";
    if functions.iter().any(|lent| lent.declaration.contains("relief_light(")) {
        text += "Light = relief_surface_light(relief, settings, seen, Sun);\n";
    }
    text + "return seen.bent;\n"
}

/// The value of a setting.
fn value(setting: &SettingPlace, [tile_u, tile_v]: [f32; 2]) -> String {
    match (setting.name.as_str(), setting.value) {
        ("scale", _) => "Scale".to_owned(),
        // All relief lies below the mesh: Unreal moves a pixel away from the eye alone.
        ("bias", _) => "-Scale".to_owned(),
        ("height_size", _) => "uint2(columns, rows)".to_owned(),
        ("shadow_tile" | "search_tile", _) => format!("float2({tile_u:?}, {tile_v:?})"),
        (_, Some(value)) if setting.of == "f32" => format!("{value:?}"),
        (_, Some(value)) => format!("{value}u"),
        // A sun is a point; one level and one layer are written.
        ("light_radius", _) => "0.0".to_owned(),
        ("height_levels" | "search_layers" | "shadow_layers", _) => "1u".to_owned(),
        _ => "0".to_owned(),
    }
}
