//! Slices: what of a slice through the relief is drawn. A new test is a `.wesl` and a `.rs` file here and its
//! name in the list below.

use relief_core::registry::{Entry, Param};

use crate::stages::entry_place;

mod at_least;
mod band;
mod inside;

/// All of them.
pub const ENTRIES: &[Entry] = &[inside::ENTRY, at_least::ENTRY, band::ENTRY];

/// The number of the test `at-least`.
pub(crate) const AT_LEAST: f32 = entry_place(ENTRIES, "at-least") as f32;

/// The settings of slices, which are the same for all tests. Hosts read them, since they make the slices.
const PARAMS: &[Param] = &[
    Param {
        name: "count",
        summary: "slices over the whole displacement",
        unit: "",
        min: 1.0,
        max: 1e9,
        default: 64.0,
        integer: true,
        names: &[],
    },
    Param {
        name: "refine",
        summary: "steps of false position between a slice that is drawn and the one before it; 0: the slice alone",
        unit: "",
        min: 0.0,
        max: 64.0,
        default: 0.0,
        integer: true,
        names: &[],
    },
];
