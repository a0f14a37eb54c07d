//! Registry entry of the slice test `inside`.

use relief_core::registry::{Guarantee, Guarantees, Publication};

use crate::entry::{Entry, Role};

/// Draws where the relief is higher.
pub const ENTRY: Entry = Entry {
    name: "inside",
    summary: "draws where the relief is higher; nothing where its height is 0",
    publication: Publication { paper: crate::DEPTH_OBJECTS, section: "3.2" },
    maps: &[],
    params: super::PARAMS,
    states: &[],
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "A point of the slice is drawn exactly where it lies under the relief, to the rounding of f32.",
    role: Role::Plain,
};
