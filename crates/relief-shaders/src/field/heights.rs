//! Registry entry of heights.

use relief_core::registry::{Guarantee, Guarantees, Publication};

use crate::entry::{Entry, Role};

/// A relief of heights.
pub const ENTRY: Entry = Entry {
    name: "heights",
    summary: "what lies below the bilinear surface of a height map is solid",
    publication: Publication { paper: crate::SURVEY, section: "2" },
    maps: &[],
    params: &[],
    states: &[],
    guarantee: Guarantees::all(Guarantee::Exact),
    weakened: &[],
    argument: "The surface is the bilinear one by definition.",
    role: Role::Idle,
};
