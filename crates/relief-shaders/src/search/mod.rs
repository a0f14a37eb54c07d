//! Searches: what brackets the first hit. A new one is a `.wesl` and a `.rs` file here and its name in the
//! list below; one that reads a baked map names it in its entry, and finds it bound.

use relief_core::registry::Param;

use crate::SURVEY;
use crate::entry::Entry;

mod cells;
mod cone;
mod cone_moved;
mod dilation_erosion;
mod frustum;
mod linear;
mod none;
mod pyramid;
mod pyramid_texels;
mod relaxed_cone;
mod relaxed_cone_resting;
mod sphere;

/// All of them.
pub static ENTRIES: &[Entry] = &[
    none::ENTRY,
    linear::ENTRY,
    cells::ENTRY,
    frustum::ENTRY,
    cone::ENTRY,
    pyramid::ENTRY,
    pyramid_texels::ENTRY,
    dilation_erosion::ENTRY,
    sphere::ENTRY,
    cone_moved::ENTRY,
    relaxed_cone::ENTRY,
    relaxed_cone_resting::ENTRY,
];

/// The parameter of searches that end by themselves.
const LIMIT: Param = Param {
    name: "limit",
    summary: "most reads before the search gives up",
    unit: "",
    min: 1.0,
    max: 16_777_216.0,
    default: 1_048_576.0,
    integer: true,
    names: &[],
};

/// The parameter of searches that were published without a look at the surface's patches.
const PATCHES: Param = Param {
    name: "patches",
    summary: "1 looks at the surface's patch where steps are shorter than a cell, 0 is as published",
    unit: "",
    min: 0.0,
    max: 1.0,
    default: 1.0,
    integer: true,
    names: &[],
};
