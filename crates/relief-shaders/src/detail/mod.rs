//! Detail: each variant chooses the level of its maps in which a pixel is traced.
//!
//! A new variant is a `.wesl` and a `.rs` file here and its name in the list below.

use relief_core::registry::Param;

use crate::entry::Entry;

mod fade;
mod footprint;
mod none;

/// All levels of detail, in the order of their numbers in the shaders.
pub static ENTRIES: &[Entry] = &[none::ENTRY, footprint::ENTRY, fade::ENTRY];

/// The greatest length of a footprint beside its width.
const ANISOTROPY: Param = Param {
    name: "anisotropy",
    summary: "greatest length of a footprint, relative to the width that is used",
    unit: "",
    min: 1.0,
    max: 64.0,
    default: 8.0,
    integer: false,
    names: &[],
};

/// The fineness of the traced level. Texels of a level are twice as wide as on the finer one. With
/// 1.4, the footprint has 1.4 to 2.8 texels side by side: the traced level comes nearest to two.
const TEXELS: Param = Param {
    name: "texels",
    summary: "least number of texels of the traced level side by side in a footprint; more \
        show more detail",
    unit: "",
    min: 1.0,
    max: 64.0,
    default: 1.4,
    integer: false,
    names: &[],
};
