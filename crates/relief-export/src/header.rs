//! The comment at the head of a shader's file: the manifest in words.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use crate::Profile;
use crate::manifest::{BindingPoint, Bound, Draw, FileBinding, Manifest, ShaderFile, Struct};

/// Returns the comment: `choices`, then the manifest's content for that file.
pub fn head(choices: &str, manifest: &Manifest, profile: Profile, file: &ShaderFile) -> String {
    let mut text = choices.to_owned();
    let _ = writeln!(text, "//\n// {}.", profile.title());
    let values =
        manifest.stages.iter().flat_map(|stage| stage.params.iter().map(move |param| (stage, param)));
    for (place, (stage, param)) in values.enumerate() {
        if place == 0 {
            text += "//\n// Values to begin with; all of them stay in the uniform buffer:\n";
        }
        let _ = writeln!(
            text,
            "//   {}.{} at byte {}: {}.{} = {}",
            param.uniform, param.member, param.offset, stage.stage, param.name, param.value
        );
    }
    text += "//\n";
    for entry in &file.entry_points {
        let _ = writeln!(text, "// Entry point of the {} stage: {}\n//", entry.stage, entry.name);
    }
    text.push_str(&drawn(&manifest.draw));
    if !file.bindings.is_empty() {
        text += "//\n// Bindings:\n";
    }
    for renamed in &file.bindings {
        if let Some(bound) = manifest.bindings.iter().find(|bound| bound.name == renamed.name) {
            binding(&mut text, bound, renamed, manifest);
        }
    }
    if let Some(sizes) = &file.sizes {
        let _ = writeln!(
            text,
            "//   buffer {}: 32-bit numbers, the bound bytes of {}",
            sizes.buffer,
            sizes.of.join(", ")
        );
    }
    text += "//\n// Structs of the buffers, each member after its byte:\n";
    let bound = manifest.bindings.iter().filter(|bound| file.bindings.iter().any(|it| it.name == bound.name));
    let mut held = BTreeSet::new();
    for name in bound.filter_map(|bound| bound.structure.as_deref()) {
        hold(manifest, name, &mut held);
    }
    for (name, structure) in manifest.structs.iter().filter(|(name, _)| held.contains(name.as_str())) {
        members(&mut text, name, structure);
    }
    text
}

/// Collects a struct and the structs of its members.
fn hold<'a>(manifest: &'a Manifest, name: &str, held: &mut BTreeSet<&'a str>) {
    if let Some((name, structure)) = manifest.structs.get_key_value(name)
        && held.insert(name)
    {
        structure.members.iter().for_each(|member| hold(manifest, &member.of, held));
    }
}

/// The draw call in words.
fn drawn(draw: &Draw) -> String {
    let Draw { vertices_per_triangle, instances, cull, front_face, depth, blend } = draw;
    let depth =
        if *depth { "Fragments give their own depth" } else { "Fragments leave depth to the triangles" };
    let blended = match *blend {
        "none" => "",
        _ => {
            "// Colours are premultiplied by their alpha: they are added to what is behind, times 1 - \
             alpha.\n\
             // Draw the triangles from the farthest to the nearest, behind what is opaque, and test depths\n\
             // without writing them.\n"
        }
    };
    format!(
        "// Drawn without vertex buffers: {vertices_per_triangle} vertices for each triangle; \
         instances: {instances}.\n\
         // Culled: {cull}; front faces are {front_face} in the picture. {depth}.\n\
         // Fragments hold linear colours. frame.view_projection gives the clip space. Rays are made from\n\
         // the fragment's position, by frame.corner, which belongs to (0, 0), frame.right and\n\
         // frame.down.\n{blended}"
    )
}

fn binding(text: &mut String, bound: &Bound, renamed: &FileBinding, manifest: &Manifest) {
    let called = if renamed.here == bound.name {
        bound.name.to_owned()
    } else {
        format!("{}, here {}", bound.name, renamed.here)
    };
    let _ = writeln!(text, "//   {}: {called}", at(&renamed.at));
    let mut about = format!("{}; {}", bound.of, bound.holds);
    if let Some(structure) = bound.structure.as_ref().and_then(|name| manifest.structs.get(name)) {
        let _ = write!(about, "; {} bytes", structure.size);
        about += if bound.kind == "storage" { " each" } else { "" };
    }
    let _ = writeln!(text, "//     {about}; read by the {} stage", bound.stages.join(" and the "));
    if let Some(texture) = &bound.texture {
        let _ = writeln!(text, "//     formats: {}", texture.formats.join(", "));
        let _ = writeln!(text, "//     levels: {}; layers: {}", texture.levels, texture.layers);
        if let Some(bake) = &texture.bake {
            let map = [bake.kind, bake.texture].join(" ");
            let settings = bake.settings.iter().map(|(name, value)| format!(", {name} = {value}"));
            let settings: String = settings.collect();
            let metric = bake.metric;
            let _ = writeln!(text, "//     baked map: {}{settings}, in {metric}", map.trim_end());
            if let Some(how) = &bake.how {
                let _ = writeln!(text, "//     {how}");
            }
        }
    }
    if let Some(sampler) = renamed.sampler {
        let _ = writeln!(text, "//     sampled as {sampler}: bilinear, with the wrap of the height map");
    }
}

/// A binding point in words.
fn at(at: &BindingPoint) -> String {
    match at {
        BindingPoint::Group { group, binding } => format!("group {group}, binding {binding}"),
        BindingPoint::Set { set, binding } => format!("set {set}, binding {binding}"),
        BindingPoint::Binding { binding } => format!("binding {binding}"),
        BindingPoint::Register { register, space } => format!("register {register}, space {space}"),
        BindingPoint::Buffer { buffer } => format!("buffer {buffer}"),
        BindingPoint::Texture { texture } => format!("texture {texture}"),
        BindingPoint::Sampler { sampler_state } => format!("sampler {sampler_state}"),
    }
}

fn members(text: &mut String, name: &str, structure: &Struct) {
    let _ = writeln!(text, "//   {name}, {} bytes", structure.size);
    for member in &structure.members {
        let of = match member.array {
            Some(array) => format!("{} of {}, {} bytes apart", array.count, member.of, array.stride),
            None => member.of.clone(),
        };
        let _ = writeln!(text, "//     {:>4} {}: {of}", member.offset, member.name);
    }
}
