//! HLSL: one file with both entry points, registers and spaces as they are numbered.

use naga::back::hlsl;
use naga::valid::ModuleInfo;
use naga::{Module, ResourceBinding};

use super::hlsl_samplers::with_plain_samplers;
use super::hlsl_zeros::with_listed_zeros;
use super::{Body, Text, entry_points, same_name};
use crate::manifest::{BindingPoint, ShaderFile};
use crate::program::Program;
use crate::{ExportError, Profile, Target};

/// The options of a profile, for bindings of these groups and numbers, which were checked to fit.
pub fn text_options(profile: Profile, bindings: impl Iterator<Item = (u32, u32)>) -> hlsl::Options {
    let mut options = hlsl::Options {
        shader_model: match profile {
            Profile::Hlsl60 | Profile::Unreal5 => hlsl::ShaderModel::V6_0,
            _ => hlsl::ShaderModel::V5_1,
        },
        fake_missing_bindings: false,
        restrict_indexing: false,
        force_loop_bounding: false,
        ..hlsl::Options::default()
    };
    for (group, number) in bindings {
        let space = group as u8;
        let target = hlsl::BindTarget { space, register: number, ..hlsl::BindTarget::default() };
        options.binding_map.insert(ResourceBinding { group, binding: number }, target);
        let key = hlsl::SamplerIndexBufferKey { group };
        options.sampler_buffer_binding_map.insert(key, hlsl::BindTarget { space, ..Default::default() });
    }
    options
}

pub fn write(
    program: &Program,
    profile: Profile,
    points: &[BindingPoint],
    name: &str,
) -> Result<Text, ExportError> {
    let bindings = &program.parts.bindings;
    let options = text_options(profile, bindings.iter().map(|binding| (binding.group, binding.number)));
    let pipeline = hlsl::PipelineOptions::default();
    let written = |module: &Module, info: &ModuleInfo| {
        let mut text = String::new();
        let mut writer = hlsl::Writer::new(&mut text, &options, &pipeline);
        let written = writer.write(module, info, None).map_err(|error| error.to_string())?;
        Ok((text, written.entry_point_names))
    };
    let checked = &program.checked;
    let refused = |error| checked.refused(Target::Hlsl, error, written);
    let (text, names) = written(&checked.module, &checked.info).map_err(refused)?;
    let text = with_listed_zeros(&with_plain_samplers(&text).map_err(ExportError::Invalid)?);
    let names = names.into_iter().collect::<Result<Vec<String>, _>>();
    let names = names.map_err(|error| ExportError::Invalid(error.to_string()))?;
    let [vertex, fragment] = names.as_slice() else {
        return Err(ExportError::Invalid(format!("{} entry points", names.len())));
    };
    let bindings = bindings.iter().zip(points);
    let file = ShaderFile {
        file: format!("{name}.hlsl"),
        entry_points: entry_points([vertex, fragment]),
        bindings: bindings.map(|(binding, at)| same_name(binding, at)).collect(),
        sizes: None,
    };
    Ok(Text { file, body: Body::Source(text, 0) })
}
