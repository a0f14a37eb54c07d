//! GLSL: a file for each stage, whose entry point is `main`.

use naga::back::glsl;
use naga::valid::ModuleInfo;
use naga::{Module, ResourceBinding, ShaderStage};
use relief_shaders::bindings::{Binding, BindingKind};

use super::{Body, Text, UNCHECKED, stage_name};
use crate::manifest::{BindingPoint, EntryPoint, FileBinding, ShaderFile};
use crate::program::{Checked, Program};
use crate::{ExportError, Profile, Target};

/// The summand that naga adds to the number of an instance: the first instance, which is always 0
/// here.
const FIRST_INSTANCE: [&str; 2] = ["uniform uint naga_vs_first_instance;\n\n", " + naga_vs_first_instance"];

/// The name of every entry point.
const MAIN: &str = "main";

pub fn write(
    program: &Program,
    profile: Profile,
    points: &[BindingPoint],
    name: &str,
) -> Result<Vec<Text>, ExportError> {
    [ShaderStage::Vertex, ShaderStage::Fragment]
        .map(|stage| of_stage(program, profile, points, name, stage))
        .into_iter()
        .collect()
}

fn of_stage(
    program: &Program,
    profile: Profile,
    points: &[BindingPoint],
    name: &str,
    stage: ShaderStage,
) -> Result<Text, ExportError> {
    let checked = program.checked.of_stage(stage)?;
    let mut options = glsl::Options {
        version: match profile {
            Profile::Es310 => glsl::Version::new_gles(310),
            _ => glsl::Version::Desktop(450),
        },
        writer_flags: glsl::WriterFlags::empty(),
        ..glsl::Options::default()
    };
    for (binding, place) in program.parts.bindings.iter().zip(points) {
        if let BindingPoint::Binding { binding: number } = place {
            let resource = ResourceBinding { group: binding.group, binding: binding.number };
            // The number was checked to fit.
            options.binding_map.insert(resource, *number as u8);
        }
    }
    let entry_point = checked.entry(stage).map_or(String::new(), |(name, _)| name.to_owned());
    let pipeline = glsl::PipelineOptions { shader_stage: stage, entry_point, multiview: None };
    let written = |module: &Module, info: &ModuleInfo| {
        let mut text = String::new();
        let writer = glsl::Writer::new(&mut text, module, info, &options, &pipeline, UNCHECKED);
        let names = writer.and_then(|mut writer| writer.write()).map_err(|error| error.to_string())?;
        Ok((text, names))
    };
    let refused = |error| checked.refused(Target::Glsl, error, written);
    let (text, names) = written(&checked.module, &checked.info).map_err(refused)?;
    let [declared, added] = FIRST_INSTANCE;
    let text = text.replacen(declared, "", 1).replace(added, "");
    let renamed = program.parts.bindings.iter().zip(points);
    let renamed = renamed.filter_map(|(binding, at)| renamed_of(&checked, binding, at, &names, program));
    let ending = if stage == ShaderStage::Vertex { "vert" } else { "frag" };
    let file = ShaderFile {
        file: format!("{name}.{ending}.glsl"),
        entry_points: vec![EntryPoint { stage: stage_name(stage), name: MAIN.to_owned() }],
        bindings: renamed.collect(),
        sizes: None,
    };
    // The version must be the first line.
    Ok(Text { file, body: Body::Source(text, 1) })
}

/// A binding under its name in a stage's file; none if the stage does not read it, and for
/// samplers, which are parts of textures here.
fn renamed_of(
    checked: &Checked,
    binding: &Binding,
    at: &BindingPoint,
    names: &glsl::ReflectionInfo,
    program: &Program,
) -> Option<FileBinding> {
    let (variable, _) = checked.variable(binding)?;
    let (here, sampler) = match binding.kind {
        BindingKind::Sampler => return None,
        BindingKind::Uniform(_) | BindingKind::Storage { .. } => {
            (names.uniforms.get(&variable)?.clone(), None)
        }
        _ => {
            let mut textures = names.texture_mapping.iter();
            let (name, mapping) = textures.find(|(_, mapping)| mapping.texture == variable)?;
            let is_sampler = |other: &&Binding| {
                checked.variable(other).map(|(handle, _)| handle) == mapping.sampler
                    && mapping.sampler.is_some()
            };
            (name.clone(), program.parts.bindings.iter().find(is_sampler).map(|binding| binding.name))
        }
    };
    Some(FileBinding { name: binding.name, here, at: at.clone(), sampler })
}
