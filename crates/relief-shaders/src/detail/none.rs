//! Registry entry of the detail `none`.

use relief_core::registry::{Guarantee, Guarantees, Publication};

use crate::entry::{Entry, Role};

/// The finest level of all maps.
pub const ENTRY: Entry = Entry {
    name: "none",
    summary: "the finest level of all maps, at any distance",
    publication: Publication { paper: "Relief", section: "" },
    maps: &[],
    params: &[],
    states: &[],
    guarantee: Guarantees::all(Guarantee::Exact),
    weakened: &[],
    argument: "The traced surface is the height map's own.",
    role: Role::Idle,
};
