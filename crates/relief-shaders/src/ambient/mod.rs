//! Ambient light: each variant gives the light from all around that a hit reflects.
//!
//! A new variant is a `.wesl` and a `.rs` file here and its name in the list below; the first is
//! the default.

use relief_core::registry::Param;

use crate::entry::Entry;

mod bent_normal;
mod bounce;
mod constant;
mod environment;
mod hemisphere;
mod occlusion;
mod sky;

/// All ambient lights, in the order of their numbers in the shaders. The first is the default.
pub static ENTRIES: &[Entry] = &[
    constant::ENTRY,
    occlusion::ENTRY,
    bent_normal::ENTRY,
    bounce::ENTRY,
    environment::ENTRY,
    hemisphere::ENTRY,
    sky::ENTRY,
];

/// Brightness of the ground under a sky.
const GROUND: Param = Param {
    name: "ground",
    summary: "the ground's light, as a part of the sky's",
    unit: "",
    min: 0.0,
    max: 1.0,
    default: 0.03,
    integer: false,
    names: &[],
};
