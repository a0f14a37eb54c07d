//! Why a bake fails.

use relief_core::{Cancelled, HeightMapError};

use crate::SinkError;

/// Why there is no baked map.
#[derive(Debug, thiserror::Error)]
pub enum BakeError {
    /// It was cancelled.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// Where it was to go cannot take it.
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
        /// Why, and what to do.
        reason: String,
    },
}
