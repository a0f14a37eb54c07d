//! Options of an export.

use relief_shaders::MapNeed;
use relief_shaders::wgsl::Sampling;

use crate::{ExportError, Profile};

/// Options of an export.
#[derive(Clone, Debug)]
pub struct Options {
    /// The files' name before their endings; by default the names of search and refinement.
    pub name: Option<String>,
    /// The way in which textures are read.
    pub sampling: Sampling,
    /// Whether fragments write the depth of their hits. Boxes around shells hide each other, so
    /// shaders of shells always write it.
    pub depth: bool,
    /// The profiles to write, each in files of its own.
    pub profiles: Vec<Profile>,
    /// The place of all bindings; by default the project's own numbers.
    pub placement: Option<Placement>,
    /// A function that returns instructions for baking a map, such as a command line. Heads and
    /// manifests quote it.
    pub bake: Option<fn(&MapNeed) -> String>,
}

/// The place of all bindings, which follow each other in the order of the table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Placement {
    /// The bind group: the descriptor set of SPIR-V, the register space of HLSL. GLSL and MSL have none.
    pub group: u32,
    /// The number of the first binding. MSL counts buffers, textures and samplers from it, each by
    /// itself.
    pub first_binding: u32,
}

impl Default for Options {
    /// WGSL with exact sampling, without depth.
    fn default() -> Self {
        Self {
            name: None,
            sampling: Sampling::Exact,
            depth: false,
            profiles: vec![Profile::Wgsl],
            placement: None,
            bake: None,
        }
    }
}

/// Returns the name, if files may have it everywhere.
pub(crate) fn checked_name(name: &str) -> Result<&str, ExportError> {
    let is_fine = |letter: char| letter.is_alphanumeric() || matches!(letter, '-' | '_' | '.');
    if name.is_empty() || name.starts_with('.') || !name.chars().all(is_fine) {
        return Err(ExportError::Name(name.to_owned()));
    }
    Ok(name)
}
