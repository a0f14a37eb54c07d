//! WGSL: the sources as they are, with their comments.

use super::{Body, Text, entry_points, same_name};
use crate::manifest::{BindingPoint, ShaderFile};
use crate::program::Program;

pub fn write(program: &Program, points: &[BindingPoint], name: &str) -> Text {
    let bindings = program.parts.bindings.iter().zip(points);
    let file = ShaderFile {
        file: format!("{name}.wgsl"),
        entry_points: entry_points(program.entry_points),
        bindings: bindings.map(|(binding, at)| same_name(binding, at)).collect(),
        sizes: None,
    };
    Text { file, body: Body::Source(program.code.clone(), 0) }
}
