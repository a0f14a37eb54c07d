//! Registry entry for no object.

use relief_core::registry::{Guarantee, Guarantees, Publication};

use crate::entry::{Entry, Role};

/// A relief.
pub const ENTRY: Entry = Entry {
    name: "none",
    summary: "no object: a ray's segments through a relief, in their order",
    publication: Publication { paper: crate::SURVEY, section: "4" },
    maps: &[],
    params: super::PARAMS,
    states: &[],
    guarantee: Guarantees::all(Guarantee::Exact),
    weakened: &[],
    argument: "The segments follow each other along the ray, so that the first hit on any is \
        the first of all. In a shell that overlaps itself they do not, and the nearest of all hits \
        is taken.",
    role: Role::Idle,
};
