//! Registry entry of the procedure `waves`.

use relief_core::registry::Param;

use super::{count, entry};
use crate::entry::Entry;

/// Waves on water.
pub const ENTRY: Entry = entry(
    "waves",
    "water waves of many lengths, each as fast as its length allows",
    &[
        count("the longest waves along the tile", 64.0, 3.0),
        Param {
            name: "waves",
            summary: "number of waves that are added",
            unit: "waves",
            min: 1.0,
            max: 64.0,
            default: 16.0,
            integer: true,
            names: &[],
        },
        Param {
            name: "spread",
            summary: "spread of their directions: 0, all along u; 2, anywhere",
            unit: "",
            min: 0.0,
            max: 2.0,
            default: 0.8,
            integer: false,
            names: &[],
        },
        Param {
            name: "sharpness",
            summary: "sharpness of their crests",
            unit: "",
            min: 0.0,
            max: 1.0,
            default: 0.7,
            integer: false,
            names: &[],
        },
    ],
);
