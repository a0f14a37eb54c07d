//! The bake of a kind, with the quantisation of heights that all kinds share.

use relief_core::{HeightMap, Metric, Watch};

use crate::kind::BITS;
use crate::{BakeError, BakeInput, Kind, Settings, Sink, quantise};

/// Bakes a map of `kind` into `sink`. Kinds with the parameter [`BITS`] are baked from heights of
/// that many bits. For them a copy of the map is made; [`bake_last`] needs none.
///
/// # Errors
///
/// When the kind cannot be baked from this map, the bake is cancelled, or the sink fails.
pub fn bake(
    kind: &Kind,
    map: &HeightMap,
    metric: Metric,
    settings: &Settings,
    watch: &Watch,
    sink: &mut dyn Sink,
) -> Result<(), BakeError> {
    let bits = bits_of_heights(kind, settings);
    let decoded = if bits == 0 { None } else { Some(quantise::heights(map, bits)?) };
    let source = BakeInput { map: decoded.as_ref().unwrap_or(map), metric };
    (kind.bake)(&source, settings, watch, sink)
}

/// Bakes like [`bake`], but takes the map over instead of copying it. Every 2-D kind then needs at
/// most one and a half times the memory of the map and its textures. Each thread takes a few lines
/// of the map more.
///
/// # Errors
///
/// Fails as [`bake`] does.
pub fn bake_last(
    kind: &Kind,
    map: HeightMap,
    metric: Metric,
    settings: &Settings,
    watch: &Watch,
    sink: &mut dyn Sink,
) -> Result<(), BakeError> {
    let bits = bits_of_heights(kind, settings);
    let map = if bits == 0 { map } else { quantise::heights_in_place(map, bits)? };
    (kind.bake)(&BakeInput { map: &map, metric }, settings, watch, sink)
}

/// Returns the bits to which a bake of `kind` rounds heights first; 0 for none. The kind's promise
/// holds for the rounded heights. A search over the map must read these, which
/// [`quantise::heights`] returns.
pub fn bits_of_heights(kind: &Kind, settings: &Settings) -> u32 {
    kind.params.iter().position(|param| *param == BITS).map_or(0, |place| settings.count(place))
}
