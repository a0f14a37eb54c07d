//! Reasons why there is no picture.

use relief_compare::CompareError;
use relief_core::Cancelled;
use relief_render::RenderError;
use relief_render::false_color::NotOfObjects;
use relief_scene::{SceneError, ValueError};

/// Reason why there is no picture.
#[derive(Debug, thiserror::Error)]
pub enum NotDrawn {
    /// It was cancelled.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// The scene cannot be loaded.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// A scene of the picture's size and samples is refused.
    #[error(transparent)]
    Value(#[from] ValueError),
    /// Rendering failed.
    #[error(transparent)]
    Render(RenderError),
    /// There is no exact picture to compare with.
    #[error(transparent)]
    Compare(CompareError),
    /// The scene has no such numbers.
    #[error(transparent)]
    Quantity(#[from] NotOfObjects),
    /// The scene has no such numbers, as its values tell.
    #[error("{0}")]
    NotShown(&'static str),
    /// A link needs files that have not come yet.
    #[error("drop {0} here, or the folder that holds it; its name does not matter")]
    Wanted(String),
    /// No view could be drawn; says why the first one could not.
    #[error("{0}")]
    NoView(String),
}

impl From<RenderError> for NotDrawn {
    fn from(error: RenderError) -> Self {
        match error {
            RenderError::Cancelled(cancelled) => Self::Cancelled(cancelled),
            other => Self::Render(other),
        }
    }
}

impl From<CompareError> for NotDrawn {
    fn from(error: CompareError) -> Self {
        match error {
            CompareError::Cancelled(cancelled) => Self::Cancelled(cancelled),
            other => Self::Compare(other),
        }
    }
}
