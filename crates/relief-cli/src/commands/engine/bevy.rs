//! The kit of Bevy: a program that shows the mesh, and the material for other programs.

use std::fmt::Write as _;
use std::path::PathBuf;

use relief_export::{FunctionsManifest, Placement, Profile};
use relief_io::{EngineShape, TextureContent, WriteError, write_atomically, write_engine_model};

use super::kit::{EngineKit, Sheet};
use super::three::write_map;
use super::viewed::Around;

/// The bind group of materials, and the first number after the settings, which stand behind the numbers of
/// Bevy's own material.
const PLACE: Placement = Placement { group: 3, first_binding: 101 };

pub const KIT: EngineKit = EngineKit {
    engine: "bevy",
    title: "Bevy",
    profiles: &[Profile::Wesl],
    placement: Some(PLACE),
    has_manifest: false,
    // Heights and normals come from the map of floats.
    takes: |content| !matches!(content, TextureContent::Height(_) | TextureContent::Normal),
    map_ending: "ktx2",
    write_map,
    files: &[
        ("Cargo.toml", include_str!("../../../engines/bevy/project.toml")),
        ("Cargo.lock", include_str!("../../../engines/bevy/project.lock")),
        ("main.rs", include_str!("../../../engines/bevy/main.rs")),
        ("relief.rs", include_str!("../../../engines/bevy/relief.rs")),
        ("relief_material.wesl", include_str!("../../../engines/bevy/relief_material.wesl")),
    ],
    made: |name| {
        ["relief_functions.rs".to_owned(), "relief_model.rs".to_owned()]
            .into_iter()
            .chain([format!("{name}.gltf"), format!("{name}.bin")])
            .collect()
    },
    make,
    next: |_, folder| format!("  show it: cd '{}', then cargo run --release", folder.display()),
};

fn make(sheet: &Sheet, places: &[PathBuf]) -> Result<(), WriteError> {
    let [functions, model, gltf, buffer] = places else { return Ok(()) };
    let mut shown = sheet.material.model(sheet.facts, EngineShape::Mesh(sheet.mesh.clone()));
    // The program names the textures itself.
    let textures = std::mem::take(&mut shown.textures);
    write_engine_model(&shown, gltf, buffer, &format!("{}.bin", sheet.name))?;
    let texts = [(functions, of_functions(sheet)), (model, of_model(sheet, textures.has_occlusion))];
    for (place, text) in texts {
        write_atomically(place, |out| out.write_all(text.as_bytes()))?;
    }
    Ok(())
}

/// A type of WGSL in Rust.
fn in_rust(of: &str) -> &str {
    match of {
        "vec2f" => "Vec2",
        "vec2u" => "UVec2",
        "vec4u" => "UVec4",
        other => other,
    }
}

/// The value that a setting begins with.
fn value(sheet: &Sheet, name: &str, of: &str, known: Option<f32>) -> String {
    let [tile_u, tile_v] = sheet.tile_m;
    match (name, known) {
        ("scale", _) => "scale".to_owned(),
        ("bias", _) => "bias: -scale".to_owned(),
        ("height_size", _) => format!("height_size: UVec2::new({}, {})", sheet.size[0], sheet.size[1]),
        ("shadow_tile" | "search_tile", _) => format!("{name}: Vec2::new({tile_u:?}, {tile_v:?})"),
        (_, Some(value)) if of == "f32" => format!("{name}: {value:?}"),
        (_, Some(value)) => format!("{name}: {value}"),
        // A sun is a point; one level and one layer are written.
        ("light_radius", _) => format!("{name}: 0.0"),
        ("height_levels" | "search_layers" | "shadow_layers", _) => format!("{name}: 1"),
        _ => format!("{name}: Default::default()"),
    }
}

/// The settings and maps of the functions, as Bevy binds them.
fn of_functions(sheet: &Sheet) -> String {
    let FunctionsManifest { functions, point, settings, bindings, prefix, stages, .. } = sheet.functions;
    let named = |stage: &str| stages.iter().find(|of| of.stage == stage).map_or("", |of| of.name);
    let has_light = functions.iter().any(|lent| lent.declaration.starts_with("fn relief_light("));
    let has_size = settings.iter().any(|setting| setting.name == "height_size")
        && bindings.iter().any(|bound| bound.name == "relief_height_map");
    let has_curvature = point.iter().any(|member| member.name == "curvature");
    let mut text = format!(
        "//! The settings and maps of `relief.wesl`: search `{}`, refinement `{}`, surface `{}`.\n\
         //! Written by `relief engine`.\n\n\
         use bevy::prelude::*;\nuse bevy::render::render_resource::{{AsBindGroup, ShaderType}};\n\n\
         /// Whether points have a curvature: on bent meshes, for silhouettes.\n\
         pub const HAS_CURVATURE: bool = {has_curvature};\n\n\
         /// Whether the relief shadows itself by a function.\n\
         pub const HAS_LIGHT: bool = {has_light};\n\n\
         /// Whether the shader reads the size of the height map from the texture.\n\
         pub const HAS_SIZE: bool = {has_size};\n\n\
         /// What is the same for all points of a surface.\n\
         #[derive(Clone, Copy, Debug, Reflect, ShaderType)]\npub struct ReliefSettings {{\n",
        named("search"),
        named("refine"),
        named("surface"),
    );
    for setting in settings {
        let _ =
            writeln!(text, "    /// {}\n    pub {}: {},", setting.holds, setting.name, in_rust(&setting.of));
    }
    text += "}\n\nimpl ReliefSettings {\n    \
             /// Settings of a relief below the mesh: `scale` is the length from the height 0 to the height 1.\n    \
             pub fn new(scale: f32) -> Self {\n        Self {\n";
    for setting in settings {
        let value = value(sheet, &setting.name, &setting.of, setting.value);
        let _ = writeln!(text, "            {value},");
    }
    text += "        }\n    }\n}\n\n/// The relief of a material.\n\
             #[derive(Asset, AsBindGroup, Clone, Debug, Reflect)]\n\
             pub struct Relief {\n    #[uniform(100)]\n    pub settings: ReliefSettings,\n";
    for bound in bindings {
        let name = bound.name.trim_start_matches(&format!("{prefix}_"));
        let (number, holds) = (bound.binding, bound.holds);
        let _ = writeln!(
            text,
            "    /// {holds}.\n    #[texture({number}, filterable = false)]\n    pub {name}: Handle<Image>,"
        );
    }
    text + "}\n"
}

/// The files of the mesh and of its material, for the program.
fn of_model(sheet: &Sheet, has_occlusion: bool) -> String {
    let around = Around::of(sheet.mesh);
    let [x, y, z] = around.center.to_array();
    let mesh = format!("{}.gltf#Mesh0/Primitive0", sheet.name);
    let color = sheet.texture(|content| content == TextureContent::Color);
    let surface = sheet.texture(|content| matches!(content, TextureContent::Surface(_)));
    let emission = sheet.texture(|content| content == TextureContent::Emission);
    let mut base = String::new();
    let mut set = |line: String| _ = writeln!(base, "            {line},");
    match &color {
        Some(file) => set(format!("base_color_texture: Some(files.load({file:?}))")),
        None => set("base_color: Color::linear_rgb(0.4, 0.4, 0.4)".to_owned()),
    }
    match &surface {
        Some(file) => {
            set(format!("metallic_roughness_texture: Some(linear(files, {file:?}))"));
            set("perceptual_roughness: 1.0".to_owned());
            set("metallic: 1.0".to_owned());
            if has_occlusion {
                set(format!("occlusion_texture: Some(linear(files, {file:?}))"));
            }
        }
        None => set("perceptual_roughness: 0.5".to_owned()),
    }
    if let Some(file) = &emission {
        set(format!("emissive_texture: Some(files.load({file:?}))"));
        set(format!("emissive: LinearRgba::rgb({0:?}, {0:?}, {0:?})", sheet.facts.emission_strength));
    }
    let mut maps = String::new();
    for (name, file) in &sheet.maps {
        let _ = writeln!(maps, "            {name}: files.load({file:?}),");
    }
    let pictures = [&color, &surface, &emission].into_iter().flatten();
    let files = [&mesh].into_iter().chain(sheet.maps.iter().map(|(_, file)| file)).chain(pictures);
    let files: Vec<String> = files.map(|file| format!("{file:?}")).collect();
    let linear = if surface.is_some() {
        "/// A texture whose numbers are no colours.\n\
         fn linear(files: &AssetServer, file: &'static str) -> Handle<Image> {\n    \
         let is_linear = |settings: &mut ImageLoaderSettings| settings.is_srgb = false;\n    \
         files.load_builder().with_settings(is_linear).load(file)\n}\n\n"
    } else {
        ""
    };
    let loader = if surface.is_some() { "use bevy::image::ImageLoaderSettings;\n" } else { "" };
    format!(
        "//! The mesh and its material. Written by `relief engine`.\n\n\
         {loader}use bevy::prelude::*;\n\n\
         use crate::relief::{{Relief, ReliefMaterial, ReliefSettings}};\n\n\
         /// The sphere around the mesh, and its height.\n\
         pub const CENTER: Vec3 = Vec3::new({x:?}, {y:?}, {z:?});\n\
         pub const RADIUS: f32 = {:?};\npub const HEIGHT: f32 = {:?};\n\n\
         /// The depth of the relief.\nconst SCALE: f32 = {:?};\n\n\
         /// The files that are read.\nconst FILES: [&str; {}] = [{}];\n\n\
         /// Whether all files are read; none if one cannot be.\n\
         pub fn are_read(files: &AssetServer) -> Option<bool> {{\n    \
         let states = FILES.map(|file| files.get_handle_untyped(file).map(|of| files.load_state(of.id())));\n    \
         let is_failed = states.iter().flatten().any(|state| state.is_failed());\n    \
         let is_read = states.iter().all(|state| state.as_ref().is_some_and(|state| state.is_loaded()));\n    \
         (!is_failed).then_some(is_read)\n}}\n\n\
         pub fn mesh(files: &AssetServer) -> Handle<Mesh> {{\n    \
         files.load({mesh:?})\n}}\n\n\
         {linear}pub fn material(files: &AssetServer) -> ReliefMaterial {{\n    \
         ReliefMaterial {{\n        base: StandardMaterial {{\n{base}            ..default()\n        }},\n        \
         extension: Relief {{\n            settings: ReliefSettings::new(SCALE),\n{maps}        }},\n    }}\n}}\n",
        around.radius,
        around.height,
        sheet.scale_m as f32,
        files.len(),
        files.join(", "),
    )
}
