//! Registry entry of the procedure `fbm`.

use relief_core::registry::Param;

use super::{count, entry};
use crate::entry::Entry;

/// Fractal ground.
pub const ENTRY: Entry = entry(
    "fbm",
    "fractal ground: gradient noise in octaves, which flows in time",
    &[
        count("points of the coarsest lattice along the tile", 64.0, 4.0),
        Param {
            name: "octaves",
            summary: "octaves, each twice as fine as the one before",
            unit: "octaves",
            min: 1.0,
            max: 16.0,
            default: 7.0,
            integer: true,
            names: &[],
        },
        Param {
            name: "gain",
            summary: "strength of an octave relative to the one before",
            unit: "",
            min: 0.0,
            max: 1.0,
            default: 0.5,
            integer: false,
            names: &[],
        },
    ],
);
