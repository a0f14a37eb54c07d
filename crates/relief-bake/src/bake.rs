//! A kind's bake, with what is the same for all of them.

use relief_core::{HeightMap, Metric, Watch};

use crate::kind::BITS;
use crate::{BakeError, BakeInput, Kind, Settings, Sink, quantise};

/// Bakes a map of that kind into a sink. Kinds with the parameter [`BITS`] are baked from heights of so many
/// bits, for which a copy of the map is made: see [`bake_last`].
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

/// [`bake`] of a map that is not needed afterwards, so that no copy of it is made. Every 2-D kind then takes
/// at most one and a half times the memory of the map and its textures, and some of the map's lines for each
/// thread.
///
/// # Errors
///
/// As [`bake`].
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

/// To how many bits a bake of that kind rounds heights first; 0 for none. What the kind promises holds for the
/// rounded heights: a search over the map must read those, which [`quantise::heights`] gives.
pub fn bits_of_heights(kind: &Kind, settings: &Settings) -> u32 {
    kind.params.iter().position(|param| *param == BITS).map_or(0, |place| settings.count(place))
}
