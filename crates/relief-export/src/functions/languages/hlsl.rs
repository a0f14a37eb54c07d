//! HLSL.

use naga::back::hlsl;

use super::Source;
use crate::writers::{hlsl_options, with_listed_zeros, with_plain_samplers};
use crate::{ExportError, Profile, Target};

pub fn write(source: &Source, profile: Profile) -> Result<String, ExportError> {
    let options = hlsl_options(profile, source.textures.iter().map(|(_, group, number)| (*group, *number)));
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
