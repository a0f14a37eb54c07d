//! HLSL.

use naga::ResourceBinding;
use naga::back::hlsl;

use super::Source;
use crate::writers::{with_listed_zeros, with_plain_samplers};
use crate::{ExportError, Profile, Target};

pub fn write(source: &Source, profile: Profile) -> Result<String, ExportError> {
    let mut options = hlsl::Options {
        shader_model: match profile {
            Profile::Hlsl60 => hlsl::ShaderModel::V6_0,
            _ => hlsl::ShaderModel::V5_1,
        },
        fake_missing_bindings: false,
        restrict_indexing: false,
        force_loop_bounding: false,
        ..hlsl::Options::default()
    };
    for (_, group, number) in &source.textures {
        // A register space and a register fit: the numbers were checked.
        let space = *group as u8;
        let target = hlsl::BindTarget { space, register: *number, ..hlsl::BindTarget::default() };
        let resource = ResourceBinding { group: *group, binding: *number };
        options.binding_map.insert(resource, target);
        let key = hlsl::SamplerIndexBufferKey { group: *group };
        options.sampler_buffer_binding_map.insert(key, hlsl::BindTarget { space, ..Default::default() });
    }
    let pipeline = hlsl::PipelineOptions::default();
    let mut text = String::new();
    let mut writer = hlsl::Writer::new(&mut text, &options, &pipeline);
    writer.write(&source.checked.module, &source.checked.info, None).map_err(|error| {
        let function = source.entry.clone();
        ExportError::Inexpressible { target: Target::Hlsl, function, reason: error.to_string() }
    })?;
    let text = with_listed_zeros(&with_plain_samplers(&text).map_err(ExportError::Invalid)?);
    Ok(source.comments.add(&without_entry(&text, &source.entry)))
}

/// The text without the entry point and the structs of its inputs and outputs, which stand before others.
fn without_entry(text: &str, entry: &str) -> String {
    let mut kept: Vec<&str> = Vec::new();
    let mut is_inside = false;
    for line in text.lines() {
        is_inside |= line.starts_with("struct FragmentInput_")
            || (line.contains(&format!(" {entry}(")) && !line.starts_with(' '));
        let is_second_empty = line.is_empty() && kept.last().is_none_or(|last| last.is_empty());
        if !is_inside && !is_second_empty {
            kept.push(line);
        }
        if line.starts_with('}') {
            is_inside = false;
        }
    }
    kept.join("\n") + "\n"
}
