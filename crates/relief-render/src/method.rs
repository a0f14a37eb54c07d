//! From the names of a method to what is run.

use relief_core::registry::Guarantee;
use relief_shaders::{Selection, SelectionError};

use crate::scene::{MethodChoice, MethodNames};

/// Why a method cannot be run.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum MethodError {
    /// A name is unknown, or a setting does not exist or is out of range.
    #[error(transparent)]
    Selection(#[from] SelectionError),
    /// The stage cannot be used for the rays of a picture.
    #[error(
        "{stage} '{name}' is impossible for view rays: choose another; `relief methods` lists what each can do"
    )]
    Impossible {
        /// "search" or "refinement".
        stage: &'static str,
        /// The variant.
        name: &'static str,
    },
}

/// The stages that a scene's method names, with its settings.
///
/// # Errors
///
/// When a name is unknown, a setting does not exist or is out of range, or the pair cannot trace view rays.
pub fn select(choice: &MethodChoice) -> Result<Selection, MethodError> {
    let mut selection = match &choice.names {
        MethodNames::Method(name) => Selection::method(name)?,
        MethodNames::Pair { search, refine } => Selection::pair(search, refine)?,
    };
    for (key, &value) in &choice.settings {
        selection.set(key, value)?;
    }
    for (stage, entry) in [("search", selection.search), ("refinement", selection.refine)] {
        if entry.guarantee.view == Guarantee::Impossible {
            return Err(MethodError::Impossible { stage, name: entry.name });
        }
    }
    Ok(selection)
}
