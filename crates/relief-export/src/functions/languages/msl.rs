//! The Metal Shading Language. Textures are parameters of the functions that read them.

use naga::ResourceBinding;
use naga::back::msl;

use super::Source;
use crate::writers::msl_options;
use crate::{ExportError, Target};

pub fn write(source: &Source) -> Result<String, ExportError> {
    let mut resources = msl::EntryPointResources::default();
    for (slot, (_, group, number)) in (0..).zip(&source.textures) {
        let is_sampler = source.checked.module.global_variables.iter().any(|(_, variable)| {
            let kind = &source.checked.module.types[variable.ty].inner;
            variable.binding.is_some_and(|at| (at.group, at.binding) == (*group, *number))
                && matches!(kind, naga::TypeInner::Sampler { .. })
        });
        let mut target = msl::BindTarget::default();
        if is_sampler {
            target.sampler = Some(msl::BindSamplerTarget::Resource(slot));
        } else {
            target.texture = Some(slot);
        }
        resources.resources.insert(ResourceBinding { group: *group, binding: *number }, target);
    }
    let options = msl_options([(source.entry.clone(), resources)].into());
    let pipeline = msl::PipelineOptions::default();
    let (module, info) = (&source.checked.module, &source.checked.info);
    let (text, _) = msl::write_string(module, info, &options, &pipeline).map_err(|error| {
        let function = source.entry.clone();
        ExportError::Inexpressible { target: Target::Msl, function, reason: error.to_string() }
    })?;
    // The entry point and its structs come last.
    let end = text.find(&format!("struct {}Input", source.entry)).unwrap_or(text.len());
    Ok(source.comments.add(text[..end].trim_end()))
}
