//! Light from all around: what of a uniform sky's light a hit reflects. A new one is a `.wesl` and a `.rs`
//! file here and its name in the list below; the first is what is run where nothing is said.

use relief_core::registry::Param;

use crate::entry::Entry;

mod bent_normal;
mod bounce;
mod constant;
mod environment;
mod hemisphere;
mod occlusion;
mod sky;

/// All of them.
pub static ENTRIES: &[Entry] = &[
    constant::ENTRY,
    occlusion::ENTRY,
    bent_normal::ENTRY,
    bounce::ENTRY,
    environment::ENTRY,
    hemisphere::ENTRY,
    sky::ENTRY,
];

/// How bright the ground is under a sky.
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
