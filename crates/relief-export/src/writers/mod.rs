//! Files of each target, through naga's writers.
//!
//! No writer flips the picture or changes depths: the program's matrix gives the clip space. Loops
//! are not bounded a second time, and indices are not checked, since the shaders do both.

mod glsl;
mod hlsl;
mod hlsl_samplers;
mod hlsl_zeros;
mod msl;
mod spirv;
mod wgsl;

pub use hlsl::text_options as hlsl_options;
pub use hlsl_samplers::with_plain_samplers;
pub use hlsl_zeros::with_listed_zeros;
pub use msl::text_options as msl_options;
use naga::ShaderStage;
use naga::proc::{BoundsCheckPolicies, BoundsCheckPolicy};
use relief_shaders::bindings::Binding;

use crate::manifest::{BindingPoint, EntryPoint, FileBinding, ShaderFile};
use crate::program::Program;
use crate::{ExportError, Options, Profile, Target, binding_points};

/// Textures and buffers are indexed without further checks.
pub const UNCHECKED: BoundsCheckPolicies = BoundsCheckPolicies {
    index: BoundsCheckPolicy::Unchecked,
    buffer: BoundsCheckPolicy::Unchecked,
    image_load: BoundsCheckPolicy::Unchecked,
    binding_array: BoundsCheckPolicy::Unchecked,
};

/// A written file, without a head.
pub struct Text {
    pub file: ShaderFile,
    pub body: Body,
}

/// The content of a file.
pub enum Body {
    /// A text, and the number of its first lines that must stay first.
    Source(String, usize),
    /// SPIR-V.
    Words(Vec<u32>),
}

/// Writes the files of a profile.
pub fn write(
    program: &Program,
    profile: Profile,
    name: &str,
    options: &Options,
) -> Result<Vec<Text>, ExportError> {
    let target = profile.target();
    let points = binding_points::points(target, &program.parts.bindings, options)?;
    match target {
        Target::Wgsl => Ok(vec![wgsl::write(program, &points, name)]),
        Target::Glsl => glsl::write(program, profile, &points, name),
        Target::Hlsl => hlsl::write(program, profile, &points, name).map(|text| vec![text]),
        Target::Msl => msl::write(program, &points, name, options).map(|text| vec![text]),
        Target::Spirv => spirv::write(program, &points, name).map(|text| vec![text]),
        Target::Wesl | Target::Godot | Target::Unreal => {
            Err(ExportError::OnlyFunctions { profile: profile.name() })
        }
    }
}

/// Returns the name of a stage in manifests.
pub fn stage_name(stage: ShaderStage) -> &'static str {
    match stage {
        ShaderStage::Vertex => "vertex",
        _ => "fragment",
    }
}

/// The functions of both stages, under their names in a file.
fn entry_points(names: [&str; 2]) -> Vec<EntryPoint> {
    let stages = [ShaderStage::Vertex, ShaderStage::Fragment].map(stage_name);
    let entry = |(stage, name): (&'static str, &str)| EntryPoint { stage, name: name.to_owned() };
    stages.into_iter().zip(names).map(entry).collect()
}

/// A binding that keeps its name.
fn same_name(binding: &Binding, at: &BindingPoint) -> FileBinding {
    FileBinding { name: binding.name, here: binding.name.to_owned(), at: at.clone(), sampler: None }
}
