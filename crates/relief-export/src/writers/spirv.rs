//! SPIR-V: one module with both entry points.

use naga::back::spv;

use super::{Body, Text, UNCHECKED, entry_points, same_name};
use crate::manifest::{BindingPoint, ShaderFile};
use crate::program::Program;
use crate::{ExportError, Target};

pub fn write(program: &Program, points: &[BindingPoint], name: &str) -> Result<Text, ExportError> {
    let options = spv::Options {
        lang_version: (1, 3),
        // Names of variables and members stay, so that reflection finds them.
        flags: spv::WriterFlags::DEBUG,
        fake_missing_bindings: true,
        bounds_check_policies: UNCHECKED,
        force_loop_bounding: false,
        ..spv::Options::default()
    };
    let written = |module: &_, info: &_| {
        spv::write_vec(module, info, &options, None).map_err(|error| error.to_string())
    };
    let checked = &program.checked;
    let words = written(&checked.module, &checked.info);
    let words = words.map_err(|error| checked.refused(Target::Spirv, error, written))?;
    let bindings = program.parts.bindings.iter().zip(points);
    let file = ShaderFile {
        file: format!("{name}.spv"),
        entry_points: entry_points(program.entry_points),
        bindings: bindings.map(|(binding, at)| same_name(binding, at)).collect(),
        sizes: None,
    };
    Ok(Text { file, body: Body::Words(words) })
}
