//! Registry entry of the flat base surface.

use relief_core::registry::{Guarantee, Guarantees, Publication};

use crate::entry::{Entry, Role};

/// The flat base surface.
pub const ENTRY: Entry = Entry {
    name: "plane",
    summary: "the polygon itself with an interpolated frame: one straight segment per ray",
    publication: Publication { paper: super::SURVEY, section: "4" },
    maps: &[],
    params: &[],
    states: &[],
    guarantee: Guarantees { view: Guarantee::Exact, bent: Guarantee::Impossible, shadow: Guarantee::Exact },
    weakened: &[],
    argument: "A straight ray stays straight in texture space when the frame is constant along \
        it. This holds on flat polygons and is an approximation on curved meshes. The entry lies \
        at height 1 to a rounding of f32, the exit a millionth of the relief below height 0, so \
        that rounding cannot end a path above a floor.",
    role: Role::Plain,
};
