//! Registry entry of the slice test `at-least`.

use relief_core::registry::{Guarantee, Guarantees, Publication};

use crate::entry::{Entry, Role};

/// What lies at most as high as the relief.
pub const ENTRY: Entry = Entry {
    name: "at-least",
    summary: "what the relief is at least as high as: the lowest slice is whole",
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
