//! Searches: each brackets the first hit of a path.
//!
//! A new search is a `.wesl` and a `.rs` file here and its name in the list below. If it reads a
//! baked map, its entry names the map, and the shader finds it bound.

use relief_core::registry::Param;

use crate::SURVEY;
use crate::entry::Entry;

mod cells;
mod cone;
mod cone_moved;
mod dilation_erosion;
mod frustum;
mod generalised;
mod linear;
mod none;
mod pyramid;
mod pyramid_texels;
mod relaxed_cone;
mod relaxed_cone_resting;
mod shell_map;
mod sphere;
mod translucent;
mod view_dependent;
mod view_dependent_clusters;
mod view_dependent_free;
mod view_dependent_svd;
mod voxels;

/// All searches, in the order of their numbers in the shaders.
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
    voxels::ENTRY,
    generalised::ENTRY,
    view_dependent::ENTRY,
    view_dependent_free::ENTRY,
    translucent::ENTRY,
    shell_map::ENTRY,
    view_dependent_svd::ENTRY,
    view_dependent_clusters::ENTRY,
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

/// The parameter of walks from cell to cell.
pub(crate) const CELLS_LIMIT: Param = Param {
    name: "limit",
    summary: "most cells visited before it gives up",
    unit: "cells",
    min: 1.0,
    max: 16_777_216.0,
    default: 1_048_576.0,
    integer: true,
    names: &[],
};

/// The parameter of searches that were published without a test of the surface's patches.
const PATCHES: Param = Param {
    name: "patches",
    summary: "1 tests the surface's patch where steps are shorter than a cell; 0 is as published",
    unit: "",
    min: 0.0,
    max: 1.0,
    default: 1.0,
    integer: true,
    names: &[],
};

/// Parameters of searches that read view-dependent maps: the steps of the map's axes.
const AZIMUTHS: Param = Param {
    name: "azimuths",
    summary: "directions along the base plane that are baked",
    unit: "",
    min: 4.0,
    max: 64.0,
    default: 8.0,
    integer: true,
    names: &[],
};

const ELEVATIONS: Param = Param {
    name: "elevations",
    summary: "directions from upright to level that are baked; layers are azimuths times these",
    min: 2.0,
    ..AZIMUTHS
};

const BENDS: Param = Param {
    name: "bends",
    summary: "bends of paths that are baked: 1 for straight paths, more for quadrics",
    min: 1.0,
    default: 1.0,
    ..AZIMUTHS
};

const DEPTH: Param = Param {
    name: "depth",
    summary: "depth of the relief for which the middle elevation is 45 degrees, as a part of a tile's side",
    unit: "tiles",
    min: 0.0001,
    max: 100.0,
    default: 0.1,
    integer: false,
    names: &[],
};

/// The parameter of searches that read compressed maps: the products whose sum a way is.
const RANK: Param = Param {
    name: "rank",
    summary: "products that are summed to each way: fewer make the map smaller, and the errors larger",
    unit: "",
    min: 1.0,
    max: 256.0,
    default: 16.0,
    integer: true,
    names: &[],
};
