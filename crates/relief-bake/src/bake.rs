//! A kind's bake, with what is the same for all of them.

use relief::{HeightMap, HeightMapError};

use crate::kind::BITS;
use crate::{Cancelled, Kind, Metric, Progress, Settings, Sink, SinkError, Source, quantise};

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

/// Bakes a map of that kind into a sink. Kinds with the parameter [`BITS`] are baked from heights of so many bits.
///
/// # Errors
///
/// When the kind cannot be baked from this map, the bake is cancelled, or the sink fails.
pub fn bake(
    kind: &Kind,
    map: &HeightMap,
    metric: Metric,
    settings: &Settings,
    progress: &Progress,
    sink: &mut dyn Sink,
) -> Result<(), BakeError> {
    let bits = kind.params.iter().position(|param| *param == BITS).map_or(0, |place| settings.count(place));
    let decoded = if bits == 0 { None } else { Some(quantise::heights(map, bits)?) };
    let source = Source { map: decoded.as_ref().unwrap_or(map), metric };
    (kind.bake)(&source, settings, progress, sink)
}
