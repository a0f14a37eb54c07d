//! Detail: in which level of its maps a pixel is seen. A new one is a `.wesl` and a `.rs` file here and its
//! name in the list below.

use relief_core::registry::Param;

use crate::entry::Entry;

mod fade;
mod footprint;
mod none;

/// All of them.
pub static ENTRIES: &[Entry] = &[none::ENTRY, footprint::ENTRY, fade::ENTRY];

/// How long a footprint may be beside its width.
const ANISOTROPY: Param = Param {
    name: "anisotropy",
    summary: "the most that a footprint may be longer than it is taken to be wide",
    unit: "",
    min: 1.0,
    max: 64.0,
    default: 8.0,
    integer: false,
    names: &[],
};

/// How fine a level is traced. Texels of a level are twice as wide as those of the finer one: with 1.4, 1.4 to
/// 2.8 of them are beside each other, and so the level is traced that comes nearest to two.
const TEXELS: Param = Param {
    name: "texels",
    summary: "texels of the traced level beside each other in a footprint, at least; more show more",
    unit: "",
    min: 1.0,
    max: 64.0,
    default: 1.4,
    integer: false,
    names: &[],
};
