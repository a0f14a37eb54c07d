//! MSL: one file with both entry points, and slots for buffers, textures and samplers.

use naga::back::msl;
use naga::valid::ModuleInfo;
use naga::{Module, ResourceBinding, TypeInner};
use relief_shaders::bindings::Binding;

use super::{Body, Text, UNCHECKED, entry_points, same_name};
use crate::manifest::{BindingPoint, ShaderFile, SizesBuffer};
use crate::program::Program;
use crate::{ExportError, Options, Target, binding_points};

/// The options for the resources of entry points.
pub fn text_options(per_entry_point_map: msl::EntryPointResourceMap) -> msl::Options {
    msl::Options {
        lang_version: (2, 0),
        per_entry_point_map,
        fake_missing_bindings: false,
        bounds_check_policies: UNCHECKED,
        force_loop_bounding: false,
        ..msl::Options::default()
    }
}

pub fn write(
    program: &Program,
    points: &[BindingPoint],
    name: &str,
    options: &Options,
) -> Result<Text, ExportError> {
    let checked = &program.checked;
    let bindings = &program.parts.bindings;
    let sizes = sizes(program, points, options)?;
    let mut resources = msl::EntryPointResources {
        sizes_buffer: sizes.as_ref().map(|sizes| sizes.buffer as u8),
        ..msl::EntryPointResources::default()
    };
    for (binding, place) in bindings.iter().zip(points) {
        let mut target = msl::BindTarget::default();
        // The slots were checked to fit.
        match place {
            BindingPoint::Buffer { buffer } => target.buffer = Some(*buffer as u8),
            BindingPoint::Texture { texture } => target.texture = Some(*texture as u8),
            BindingPoint::Sampler { sampler_state } => {
                target.sampler = Some(msl::BindSamplerTarget::Resource(*sampler_state as u8));
            }
            _ => {}
        }
        let resource = ResourceBinding { group: binding.group, binding: binding.number };
        resources.resources.insert(resource, target);
    }
    let per_entry_point = program.entry_points.map(|name| (name.to_owned(), resources.clone()));
    let options = text_options(per_entry_point.into());
    let pipeline = msl::PipelineOptions::default();
    let written = |module: &Module, info: &ModuleInfo| {
        msl::write_string(module, info, &options, &pipeline).map_err(|error| error.to_string())
    };
    let refused = |error| checked.refused(Target::Msl, error, written);
    let (text, info) = written(&checked.module, &checked.info).map_err(refused)?;
    let names = info.entry_point_names.into_iter().collect::<Result<Vec<String>, _>>();
    let names = names.map_err(|error| ExportError::Invalid(error.to_string()))?;
    let [vertex, fragment] = names.as_slice() else {
        return Err(ExportError::Invalid(format!("{} entry points", names.len())));
    };
    let file = ShaderFile {
        file: format!("{name}.metal"),
        entry_points: entry_points([vertex, fragment]),
        bindings: bindings.iter().zip(points).map(|(binding, at)| same_name(binding, at)).collect(),
        sizes,
    };
    Ok(Text { file, body: Body::Source(text, 0) })
}

/// The buffer of sizes, if one is needed. Metal's arrays do not know their lengths: arrays without
/// one in the shader come with their buffers' sizes, in the order of the module's variables.
fn sizes(
    program: &Program,
    points: &[BindingPoint],
    options: &Options,
) -> Result<Option<SizesBuffer>, ExportError> {
    let checked = &program.checked;
    let is_open = |binding: &&Binding| {
        checked.variable(binding).is_some_and(|(_, variable)| {
            let inner = &checked.module.types[variable.ty].inner;
            matches!(inner, TypeInner::Array { size: naga::ArraySize::Dynamic, .. })
        })
    };
    let mut of: Vec<&Binding> = program.parts.bindings.iter().filter(is_open).collect();
    of.sort_by_key(|binding| checked.variable(binding).map(|(handle, _)| handle.index()));
    if of.is_empty() {
        return Ok(None);
    }
    let buffer = binding_points::next_buffer(points, options)?;
    Ok(Some(SizesBuffer { buffer, of: of.into_iter().map(|binding| binding.name).collect() }))
}
