//! The texts and words of each target, through naga's writers.
//!
//! No writer turns the picture around or changes depths: the clip space is that of the matrix that a program
//! gives. Loops are not bounded a second time, and indices are not checked, since the shaders do both.

mod glsl;
mod hlsl;
mod hlsl_samplers;
mod hlsl_zeros;
mod msl;
mod spirv;
mod wgsl;

use naga::ShaderStage;
use naga::proc::{BoundsCheckPolicies, BoundsCheckPolicy};
use relief_shaders::bindings::Binding;

use crate::manifest::{At, EntryPoint, Renamed, ShaderFile};
use crate::program::Program;
use crate::{ExportError, Options, Profile, Target, places};

/// Textures are read and buffers indexed as the shaders say.
const UNCHECKED: BoundsCheckPolicies = BoundsCheckPolicies {
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

/// What a file holds.
pub enum Body {
    /// A text, and how many of its first lines must stay first.
    Source(String, usize),
    /// SPIR-V.
    Words(Vec<u32>),
}

/// The files of a profile.
pub fn write(
    program: &Program,
    profile: Profile,
    name: &str,
    options: &Options,
) -> Result<Vec<Text>, ExportError> {
    let target = profile.target();
    let places = places::places(target, &program.parts.bindings, options)?;
    match target {
        Target::Wgsl => Ok(vec![wgsl::write(program, &places, name)]),
        Target::Glsl => glsl::write(program, profile, &places, name),
        Target::Hlsl => hlsl::write(program, profile, &places, name).map(|text| vec![text]),
        Target::Msl => msl::write(program, &places, name, options).map(|text| vec![text]),
        Target::Spirv => spirv::write(program, &places, name).map(|text| vec![text]),
    }
}

/// The name of a stage in manifests.
pub fn stage_name(stage: ShaderStage) -> &'static str {
    match stage {
        ShaderStage::Vertex => "vertex",
        _ => "fragment",
    }
}

/// Both stages' functions under the names that they have in a file.
fn entry_points(names: [&str; 2]) -> Vec<EntryPoint> {
    let stages = [ShaderStage::Vertex, ShaderStage::Fragment].map(stage_name);
    let entry = |(stage, name): (&'static str, &str)| EntryPoint { stage, name: name.to_owned() };
    stages.into_iter().zip(names).map(entry).collect()
}

/// A binding that keeps its name.
fn same_name(binding: &Binding, at: &At) -> Renamed {
    Renamed { name: binding.name, here: binding.name.to_owned(), at: at.clone(), sampler: None }
}
