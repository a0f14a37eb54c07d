//! Errors of an export.

use relief_shaders::surface::Shown;
use relief_shaders::{SURFACE, SelectionError, Variants};

use crate::Target;

/// Reason why a selection cannot be exported.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ExportError {
    /// The stages do not go together.
    #[error(transparent)]
    Selection(#[from] SelectionError),
    /// The selection shows displaced triangles, which no shader of these stages makes.
    #[error(
        "the geometry '{geometry}' shows triangles that no shader of these stages makes or counts, so there \
         is none to export: export a displaced mesh, which the surface {} shades",
        Variants::of(SURFACE, |entry| entry.paths().shown == Shown::Triangles).or()
    )]
    Displaced {
        /// The geometry.
        geometry: &'static str,
    },
    /// A variant that runs only on CPUs.
    #[error("the {stage} '{entry}' sends rays through the whole scene, on the CPU: choose another {stage}")]
    OnlyCpu {
        /// The stage's title.
        stage: &'static str,
        /// The chosen variant.
        entry: &'static str,
    },
    /// A variant that has no functions.
    #[error("the {stage} '{entry}' has no functions to call: {reason}")]
    NoFunctions {
        /// The stage's title.
        stage: &'static str,
        /// The chosen variant.
        entry: &'static str,
        /// The stage's key.
        key: &'static str,
        /// The reason, with what has.
        reason: String,
    },
    /// A target that functions are not written in.
    #[error("functions are not written in {target}: choose {}", names(&Target::OF_FUNCTIONS))]
    NoFunctionsIn {
        /// The target.
        target: Target,
    },
    /// A target or a profile that whole shaders are not written in.
    #[error("whole shaders are not written in {profile}: it is for functions alone")]
    OnlyFunctions {
        /// The profile's name.
        profile: &'static str,
    },
    /// The prefix of functions is no name.
    #[error("'{prefix}' is no prefix of names: {reason}")]
    Prefix {
        /// The prefix.
        prefix: String,
        /// What is wrong.
        reason: &'static str,
    },
    /// No target was given.
    #[error("there is nothing to write: choose a target")]
    NoTarget,
    /// The name is not usable for files.
    #[error(
        "'{0}' is not a name for files: use letters, digits, '-', '_' and '.', and no '.' at the beginning"
    )]
    Name(String),
    /// Two files would have the same name.
    #[error("{0} would be written twice: choose each target once, with one profile")]
    SameFile(String),
    /// A bind group, a binding, a register or a slot is beyond the target's limit.
    #[error("{target} has no {what} {given}: the last is {most}")]
    Placement {
        /// The target.
        target: Target,
        /// The counted thing, such as `binding`.
        what: &'static str,
        /// The number that is needed.
        given: u32,
        /// The greatest number.
        most: u32,
    },
    /// The target cannot express a function.
    #[error("{target} cannot express the function '{function}': {reason}")]
    Inexpressible {
        /// The target.
        target: Target,
        /// The function.
        function: String,
        /// The reason.
        reason: String,
    },
    /// The assembled shader is not valid: a mistake in this library.
    #[error("the assembled shader is not valid, which is a mistake in relief: {0}")]
    Invalid(String),
}

/// The names of targets, as the end of a sentence.
fn names(targets: &[Target]) -> String {
    let names: Vec<&str> = targets.iter().map(|target| target.name()).collect();
    names.join(", ")
}
