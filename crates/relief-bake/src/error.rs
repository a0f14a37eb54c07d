//! Errors of bakes.

use relief_core::{Cancelled, HeightMapError};

use crate::SinkError;

/// Reason why a bake failed.
#[derive(Debug, thiserror::Error)]
pub enum BakeError {
    /// The bake was cancelled.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// The sink cannot take the texture.
    #[error(transparent)]
    Sink(#[from] SinkError),
    /// The height map cannot be used.
    #[error(transparent)]
    HeightMap(#[from] HeightMapError),
    /// The kind cannot be baked from this map with these settings.
    #[error("{kind}: {reason}")]
    Impossible {
        /// The kind.
        kind: &'static str,
        /// Reason and remedy.
        reason: String,
    },
}
