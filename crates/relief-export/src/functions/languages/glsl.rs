//! GLSL: of OpenGL, of OpenGL ES and WebGL, and of Vulkan.

use naga::ShaderStage;
use naga::back::glsl;

use super::Source;
use crate::writers::UNCHECKED;
use crate::{ExportError, Profile, Target};

/// The beginning of the entry point.
const MAIN: &str = "void main() {";

pub fn write(source: &Source, profile: Profile) -> Result<String, ExportError> {
    let options = glsl::Options {
        version: match profile {
            Profile::Core330 => glsl::Version::Desktop(330),
            Profile::Es300 | Profile::Godot4 => glsl::Version::new_gles(300),
            Profile::Es310 => glsl::Version::new_gles(310),
            _ => glsl::Version::Desktop(450),
        },
        writer_flags: glsl::WriterFlags::empty(),
        ..glsl::Options::default()
    };
    let pipeline = glsl::PipelineOptions {
        shader_stage: ShaderStage::Fragment,
        entry_point: source.entry.clone(),
        multiview: None,
    };
    let (module, info) = (&source.checked.module, &source.checked.info);
    let mut text = String::new();
    let writer = glsl::Writer::new(&mut text, module, info, &options, &pipeline, UNCHECKED);
    let names = writer.and_then(|mut writer| writer.write()).map_err(|error| ExportError::Inexpressible {
        target: Target::Glsl,
        function: source.entry.clone(),
        reason: error.to_string(),
    })?;
    let mut text = text.split_once(MAIN).map_or(String::new(), |(functions, _)| functions.to_owned());
    for (here, mapping) in &names.texture_mapping {
        let own = module.global_variables[mapping.texture].name.clone().unwrap_or_default();
        text = text.replace(here.as_str(), &own);
    }
    let kept: Vec<String> =
        text.lines().filter(|line| is_kept(line)).map(|line| placed(line, source, profile)).collect();
    Ok(source.comments.add(&squeezed(&kept)))
}

/// Whether a line belongs to the functions, and not to the head or the entry point of a whole shader.
fn is_kept(line: &str) -> bool {
    let is_head = line.starts_with('#') || line.starts_with("precision ");
    let is_passed =
        ["layout(location", "smooth in", "in ", "out "].iter().any(|begin| line.starts_with(begin));
    !is_head && !is_passed
}

/// A line that declares a texture, with its place where the version has such.
fn placed(line: &str, source: &Source, profile: Profile) -> String {
    let texture = source
        .textures
        .iter()
        .find(|(name, ..)| line.starts_with("uniform ") && line.ends_with(&format!(" {name};")));
    match texture {
        Some((_, group, binding)) if profile == Profile::Vulkan450 => {
            format!("layout(set = {group}, binding = {binding}) {line}")
        }
        Some((_, _, binding)) if matches!(profile, Profile::Core450 | Profile::Es310) => {
            format!("layout(binding = {binding}) {line}")
        }
        _ => line.to_owned(),
    }
}

/// Lines with at most one empty line between them.
fn squeezed(lines: &[String]) -> String {
    let mut text = String::new();
    let mut was_empty = true;
    for line in lines {
        if !(line.is_empty() && was_empty) {
            text += line;
            text.push('\n');
        }
        was_empty = line.is_empty();
    }
    text
}
