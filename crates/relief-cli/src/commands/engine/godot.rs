//! The kit of Godot 4: a shader, a material, a mesh and a scene, which need no import but for PNG files.

use std::fmt::Write as _;
use std::path::PathBuf;

use glam::Vec3;
use relief_export::Profile;
use relief_io::{TextureContent, WriteError, godot_mesh, write_atomically, write_dds};

use super::kit::{EngineKit, Sheet};
use super::viewed::Around;

pub const KIT: EngineKit = EngineKit {
    engine: "godot",
    title: "Godot 4",
    profiles: &[Profile::Godot4],
    placement: None,
    has_manifest: false,
    // Heights and normals come from the map of floats.
    takes: |content| !matches!(content, TextureContent::Height(_) | TextureContent::Normal),
    map_ending: "dds",
    write_map: write_dds,
    files: &[
        ("relief.gdshader", include_str!("../../../engines/godot/relief.gdshader")),
        ("relief_fragment.gdshaderinc", include_str!("../../../engines/godot/relief_fragment.gdshaderinc")),
    ],
    made: |name| {
        ["_mesh.tres", "_material.tres", ".tscn", "_demo.tscn"].map(|end| format!("{name}{end}")).into()
    },
    make,
    next: |name, folder| {
        let folder = folder.display();
        format!("  show it: {folder} within a project of Godot 4, then run {name}_demo.tscn there")
    },
};

/// Directions to the camera and to the sun.
const CAMERA: Vec3 = Vec3::new(0.6, 0.7, 1.0);
const SUN: Vec3 = Vec3::new(-0.8, 0.9, 0.7);

fn make(sheet: &Sheet, places: &[PathBuf]) -> Result<(), WriteError> {
    let [mesh, material, scene, demo] = places else { return Ok(()) };
    let named = format!("{}_material.tres", sheet.name);
    let text = godot_mesh(sheet.mesh, Some(&named)).map_err(|problem| problem.at(mesh))?;
    let texts =
        [(mesh, text), (material, of_material(sheet)), (scene, of_scene(sheet)), (demo, of_demo(sheet))];
    for (place, text) in texts {
        write_atomically(place, |out| out.write_all(text.as_bytes()))?;
    }
    Ok(())
}

/// A `ShaderMaterial`. Files are named beside it.
fn of_material(sheet: &Sheet) -> String {
    let maps = sheet.maps.iter().map(|(name, file)| (format!("relief_{name}"), file.clone()));
    let color = sheet.texture(|content| content == TextureContent::Color);
    let surface = sheet.texture(|content| matches!(content, TextureContent::Surface(_)));
    let emission = sheet.texture(|content| content == TextureContent::Emission);
    let named = [("texture_albedo", &color), ("texture_orm", &surface), ("texture_emission", &emission)];
    let named = named.into_iter().filter_map(|(name, file)| Some((name.to_owned(), file.clone()?)));
    let textures: Vec<(String, String)> = maps.chain(named).collect();
    let mut text =
        format!("[gd_resource type=\"ShaderMaterial\" load_steps={} format=3]\n\n", textures.len() + 2);
    text += "[ext_resource type=\"Shader\" path=\"relief.gdshader\" id=\"shader\"]\n";
    for (name, file) in &textures {
        let _ = writeln!(text, "[ext_resource type=\"Texture2D\" path={} id=\"{name}\"]", quoted(file));
    }
    text += "\n[resource]\nshader = ExtResource(\"shader\")\n";
    for (name, _) in &textures {
        let _ = writeln!(text, "shader_parameter/{name} = ExtResource(\"{name}\")");
    }
    let mut set = |name: &str, value: String| _ = writeln!(text, "shader_parameter/{name} = {value}");
    set("relief_scale", format!("{:?}", sheet.scale_m));
    if color.is_none() {
        // 0.4 in sRGB, as Godot's colours are.
        set("albedo", "Color(0.665, 0.665, 0.665, 1)".to_owned());
    }
    match surface {
        Some(_) => set("metallic", "1.0".to_owned()),
        None => set("roughness", "0.5".to_owned()),
    }
    if sheet.facts.emission_strength > 1.0 {
        set("emission_energy", format!("{:?}", sheet.facts.emission_strength));
    }
    text
}

/// The mesh alone, for scenes of others.
fn of_scene(sheet: &Sheet) -> String {
    let name = sheet.name;
    format!(
        "[gd_scene load_steps=2 format=3]\n\n\
         [ext_resource type=\"ArrayMesh\" path={} id=\"mesh\"]\n\n\
         [node name={} type=\"MeshInstance3D\"]\nmesh = ExtResource(\"mesh\")\n",
        quoted(&format!("{name}_mesh.tres")),
        quoted(&node_name(name)),
    )
}

/// A scene with the other one, a sun, a sky and a camera.
fn of_demo(sheet: &Sheet) -> String {
    let around = Around::of(sheet.mesh);
    let [camera, sun] =
        [(CAMERA, 3.2), (SUN, 4.0)].map(|(from, radii)| transform(around.seen_from(from, radii)));
    let name = sheet.name;
    let (scene, node) = (quoted(&format!("{name}.tscn")), quoted(&node_name(name)));
    let radius = around.radius;
    let [near, far, shadows] = [0.01 * radius, 100.0 * radius, 10.0 * radius];
    // A floor for the shadow of what stands on it.
    let [left, least, back] = around.center.to_array();
    let floor_y = least - around.height / 2.0;
    let floor = if around.height > 0.1 * radius {
        let side = 6.0 * radius;
        format!(
            "[node name=\"Floor\" type=\"MeshInstance3D\" parent=\".\"]\n\
             transform = Transform3D({side:?}, 0, 0, 0, 1, 0, 0, 0, {side:?}, {left:?}, {floor_y:?}, \
             {back:?})\n\
             mesh = SubResource(\"floor\")\n\n"
        )
    } else {
        String::new()
    };
    format!(
        "[gd_scene load_steps=6 format=3]\n\n\
         [ext_resource type=\"PackedScene\" path={scene} id=\"scene\"]\n\n\
         [sub_resource type=\"ProceduralSkyMaterial\" id=\"sky_material\"]\n\
         ground_bottom_color = Color(0.45, 0.45, 0.45, 1)\n\
         ground_horizon_color = Color(0.65, 0.66, 0.67, 1)\n\n\
         [sub_resource type=\"PlaneMesh\" id=\"floor\"]\nsize = Vector2(1, 1)\n\n\
         [sub_resource type=\"Sky\" id=\"sky\"]\nsky_material = SubResource(\"sky_material\")\n\n\
         [sub_resource type=\"Environment\" id=\"environment\"]\n\
         background_mode = 2\nsky = SubResource(\"sky\")\n\n\
         [node name=\"Demo\" type=\"Node3D\"]\n\n\
         [node name={node} parent=\".\" instance=ExtResource(\"scene\")]\n\n\
         {floor}\
         [node name=\"DirectionalLight3D\" type=\"DirectionalLight3D\" parent=\".\"]\ntransform = {sun}\n\
         light_energy = 0.5\nshadow_enabled = true\ndirectional_shadow_mode = 0\n\
         directional_shadow_max_distance = {shadows:?}\n\n\
         [node name=\"Camera3D\" type=\"Camera3D\" parent=\".\"]\ntransform = {camera}\n\
         current = true\nfov = 40.0\nnear = {near:?}\nfar = {far:?}\n\n\
         [node name=\"WorldEnvironment\" type=\"WorldEnvironment\" parent=\".\"]\n\
         environment = SubResource(\"environment\")\n"
    )
}

/// A name without the characters that Godot's nodes may not have.
fn node_name(name: &str) -> String {
    name.chars().map(|letter| if ".:@/\"%".contains(letter) { '_' } else { letter }).collect()
}

/// A frame, as Godot writes it: the rows of the basis, and the origin.
fn transform([x, y, z, origin]: [Vec3; 4]) -> String {
    let rows = [0, 1, 2].map(|row| [x[row], y[row], z[row]]).concat();
    let numbers: Vec<String> =
        rows.into_iter().chain(origin.to_array()).map(|number| format!("{number:?}")).collect();
    format!("Transform3D({})", numbers.join(", "))
}

/// A name in quotation marks.
fn quoted(name: &str) -> String {
    format!("\"{}\"", name.replace('\\', "\\\\").replace('"', "\\\""))
}
