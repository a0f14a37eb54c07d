//! Why there is no export.

use relief_shaders::surface::Shown;
use relief_shaders::{SURFACE, SelectionError, Variants};

use crate::Target;

/// Why a selection cannot be exported.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ExportError {
    /// The stages make no sense together.
    #[error(transparent)]
    Selection(#[from] SelectionError),
    /// The selection shows displaced triangles, which no shader of these stages makes.
    #[error(
        "the geometry '{geometry}' shows triangles that no shader of these stages makes or counts, so there \
         is none to export: displaced ones are those of a mesh, which the surface {} shades",
        Variants::of(SURFACE, |entry| entry.paths().shown == Shown::Triangles).or()
    )]
    Displaced {
        /// The geometry.
        geometry: &'static str,
    },
    /// A variant that runs on CPUs alone.
    #[error("the {stage} '{entry}' sends rays through the whole scene, on the CPU: choose another {stage}")]
    OnlyCpu {
        /// The stage's title.
        stage: &'static str,
        /// The chosen variant.
        entry: &'static str,
    },
    /// No target is asked for.
    #[error("there is nothing to write: choose a target")]
    NoTarget,
    /// The name is none for files.
    #[error(
        "'{0}' is no name for files: letters, digits, '-', '_' and '.' are, not with '.' at the beginning"
    )]
    Name(String),
    /// Two files would have the same name.
    #[error("{0} would be written twice: choose each target once, with one profile")]
    SameFile(String),
    /// A bind group, a binding, a register or a slot is beyond what the target has.
    #[error("{target} has no {what} {given}: the last is {most}")]
    Placement {
        /// The target.
        target: Target,
        /// What is counted.
        what: &'static str,
        /// The number that is needed.
        given: u32,
        /// The greatest that there is.
        most: u32,
    },
    /// The target cannot express a function.
    #[error("{target} cannot express the function '{function}': {reason}")]
    Inexpressible {
        /// The target.
        target: Target,
        /// The function.
        function: String,
        /// Why.
        reason: String,
    },
    /// The assembled shader is not valid: a mistake of this library.
    #[error("the assembled shader is not valid, which is a mistake of relief: {0}")]
    Invalid(String),
}
