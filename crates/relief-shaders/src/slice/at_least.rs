//! Registry entry of the slice test `at-least`.

use relief_core::registry::{Guarantee, Guarantees, Publication};

use crate::entry::{Entry, Role};

/// Draws where the relief is at least as high.
pub const ENTRY: Entry = Entry {
    name: "at-least",
    summary: "draws where the relief is at least as high; the lowest slice is whole",
    publication: Publication { paper: crate::DEPTH_OBJECTS, section: "3.1" },
    maps: &[],
    params: super::PARAMS,
    states: &[],
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "A point of the slice is drawn exactly where it lies on the relief or under it, to the \
        rounding of f32.",
    role: Role::Plain,
};
