//! What is exported, and how.

use relief_shaders::MapNeed;
use relief_shaders::wgsl::Sampling;

use crate::{ExportError, Profile};

/// How a selection is exported.
#[derive(Clone, Debug)]
pub struct Options {
    /// What files are called before their endings; the names of search and refinement where it is not given.
    pub name: Option<String>,
    /// How textures are read.
    pub sampling: Sampling,
    /// Whether fragments write the depth of what they show. Boxes around shells lie one before the other, so
    /// shaders of shells write it always.
    pub depth: bool,
    /// What is written, each in files of its own.
    pub profiles: Vec<Profile>,
    /// Where bindings go; where the project's own programs have them if it is not given.
    pub placement: Option<Placement>,
    /// How the program that exports calls the bake of a map, as in a command line. Heads and manifests quote
    /// it.
    pub bake: Option<fn(&MapNeed) -> String>,
}

/// Where all bindings go, one after the other in the order of the table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Placement {
    /// The bind group: the descriptor set of SPIR-V, the register space of HLSL. GLSL and MSL have none.
    pub group: u32,
    /// The number of the first. MSL counts buffers, textures and samplers from it, each for itself.
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

/// A name that files may have everywhere.
pub(crate) fn checked_name(name: &str) -> Result<&str, ExportError> {
    let is_fine = |letter: char| letter.is_alphanumeric() || matches!(letter, '-' | '_' | '.');
    if name.is_empty() || name.starts_with('.') || !name.chars().all(is_fine) {
        return Err(ExportError::Name(name.to_owned()));
    }
    Ok(name)
}
