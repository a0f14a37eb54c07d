//! The kit of Unreal Engine 5: includes and the code of a Custom node for a material, the maps, and the mesh.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use relief_export::{FunctionsManifest, Profile, unreal_input, unreal_node};
use relief_io::{
    EngineShape, Metadata, Row, RowSource, TextureContent, WriteError, write_atomically, write_engine_model,
    write_exr_rows,
};

use super::kit::{EngineKit, Sheet};

/// Metres in Unreal's centimetres.
fn in_cm(metres: f64) -> f32 {
    (metres * 100.0) as f32
}

pub const KIT: EngineKit = EngineKit {
    engine: "unreal",
    title: "Unreal Engine 5",
    profiles: &[Profile::Unreal5],
    placement: None,
    has_manifest: false,
    // Heights and normals come from the map of floats.
    takes: |content| !matches!(content, TextureContent::Height(_) | TextureContent::Normal),
    map_ending: "exr",
    write_map,
    files: &[("relief_surface.ush", include_str!("../../../engines/unreal/relief_surface.ush"))],
    made: |name| vec![NODE.to_owned(), format!("{name}.gltf"), format!("{name}.bin")],
    make,
    next: |_, folder| {
        let node = folder.join(NODE);
        format!("  make the material: the head of {} lists what its node takes and gives", node.display())
    },
};

/// The file with the code of the node.
const NODE: &str = "relief_node.hlsl";

/// EXR with floats in red, green and blue, and in opacity if there are four. A channel alone is grey: an
/// importer of colours takes that, too.
fn write_map(
    path: &Path,
    [width, height]: [u32; 2],
    channels: usize,
    rows: &mut RowSource<'_>,
) -> Result<(), WriteError> {
    let names = &["R", "G", "B", "A"][..channels.clamp(3, 4)];
    let mut filled = |row: Row, texels: &mut [f32]| {
        let channel = if row.channel < channels { row.channel } else { 0 };
        rows(Row { channel, ..row }, texels)
    };
    write_exr_rows(path, width, height, names, &Metadata::default(), &mut filled)
}

fn make(sheet: &Sheet, places: &[PathBuf]) -> Result<(), WriteError> {
    let [node, gltf, buffer] = places else { return Ok(()) };
    let mut shown = sheet.material.model(sheet.facts, EngineShape::Mesh(sheet.mesh.clone()));
    // The material is made in the editor.
    shown.textures = Default::default();
    write_engine_model(&shown, gltf, buffer, &format!("{}.bin", sheet.name))?;
    let text = head(sheet) + "\n" + &unreal_node(sheet.functions, sheet.tile_m.map(in_cm));
    write_atomically(node, |out| out.write_all(text.as_bytes()))
}

/// What the node takes and gives, as a comment.
fn head(sheet: &Sheet) -> String {
    let FunctionsManifest { functions, stages, bindings, .. } = sheet.functions;
    let named = |stage: &str| stages.iter().find(|of| of.stage == stage).map_or("", |of| of.name);
    let has_light = functions.iter().any(|lent| lent.declaration.contains("relief_light("));
    let mut inputs = vec![
        ("UV".to_owned(), "TexCoord".to_owned()),
        ("Way".to_owned(), "Absolute World Position minus Camera Position".to_owned()),
        ("Normal".to_owned(), "VertexNormalWS".to_owned()),
        ("PixelDepth".to_owned(), "PixelDepth".to_owned()),
        ("Scale".to_owned(), format!("depth of the relief in centimetres: {}", in_cm(sheet.scale_m))),
    ];
    if has_light {
        inputs.push(("Sun".to_owned(), "direction toward the sun, in the world".to_owned()));
    }
    for (name, file) in &sheet.maps {
        let bound = bindings.iter().find(|bound| bound.name.ends_with(&format!("_{name}")));
        let need = bound.and_then(|bound| bound.texture.as_ref());
        let is_single = need.and_then(|need| need.formats.first()).is_some_and(|of| of.starts_with("r32"));
        let floats = if is_single { "Single Float (R32F)" } else { "HDR High Precision (RGBA32F)" };
        inputs.push((unreal_input(name), format!("Texture Object of {file}, compressed as {floats}")));
    }
    let mut outputs = vec![
        ("Mask", "CMOT Float 1, to Opacity Mask"),
        ("HitUV", "CMOT Float 2, texture coordinates for all textures"),
        ("DepthOffset", "CMOT Float 1, to Pixel Depth Offset"),
    ];
    if has_light {
        outputs.push(("Light", "CMOT Float 1, what the relief lets through of the sun, 0 to 1"));
    }
    let mut text = format!(
        "// Relief in a Custom node of Unreal Engine 5: search `{}`, refinement `{}`, surface `{}`.\n\
         // Written by `relief engine`. All of it goes into the node's Code.\n//\n\
         // Include File Paths: /Project/relief.ush and /Project/relief_surface.ush\n\
         // Output Type: CMOT Float 3, to Normal; switch off the material's Tangent Space Normal\n//\n\
         // Inputs:\n",
        named("search"),
        named("refine"),
        named("surface"),
    );
    for (name, from) in &inputs {
        let _ = writeln!(text, "//   {name}: {from}");
    }
    text += "//\n// Additional Outputs:\n";
    for (name, to) in outputs {
        let _ = writeln!(text, "//   {name}: {to}");
    }
    text
}
