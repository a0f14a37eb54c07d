//! Registry entry of the procedure `bumps`.

use relief_core::registry::Param;

use super::{count, entry};
use crate::entry::Entry;

/// Round bumps.
pub const ENTRY: Entry = entry(
    "bumps",
    "round bumps on level ground, which grow and shrink in time",
    &[
        count("bumps along the tile", 256.0, 12.0),
        Param {
            name: "radius",
            summary: "radius, as a part of the distance from one bump to the next",
            unit: "",
            min: 0.01,
            max: 1.0,
            default: 0.45,
            integer: false,
            names: &[],
        },
        Param {
            name: "jitter",
            summary: "distance from a regular pattern",
            unit: "",
            min: 0.0,
            max: 1.0,
            default: 0.5,
            integer: false,
            names: &[],
        },
    ],
);
