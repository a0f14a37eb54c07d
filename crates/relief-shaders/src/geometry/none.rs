//! Registry entry of the geometry `none`.

use relief_core::registry::{Guarantee, Guarantees, Publication};

use crate::entry::{Entry, Role};

/// The base mesh, under a relief that is traced for each pixel.
pub const ENTRY: Entry = Entry {
    name: "none",
    summary: "the base mesh as it is; the relief is traced for each pixel",
    publication: Publication { paper: "Relief", section: "" },
    maps: &[],
    params: &[],
    states: &[],
    guarantee: Guarantees::all(Guarantee::Exact),
    weakened: &[],
    argument: "The mesh is not changed.",
    role: Role::Idle,
};
