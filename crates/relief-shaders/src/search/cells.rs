//! Registry entry of the search `cells`.

use relief_core::FoundState;
use relief_core::registry::{Guarantee, Guarantees, Publication};

use crate::entry::{Entry, Role, TracingRole};

/// Every dual cell along the path, in order.
pub const ENTRY: Entry = Entry {
    name: "cells",
    summary: "visits every dual cell along the path, in order",
    publication: Publication { paper: super::SURVEY, section: "4.3.1" },
    maps: &[],
    params: &[super::CELLS_LIMIT],
    states: &[FoundState::Bracket],
    guarantee: Guarantees::all(Guarantee::Exact),
    weakened: &[],
    argument: "Every cell on the path is visited. The gap is a quadratic there and is bounded \
        below in closed form, so the first cell that holds a crossing ends the walk. In f32 the \
        gap of a cell is known to 8 ulp of its terms: rays that clear the surface by less may be \
        judged either way.",
    role: Role::Tracing(TracingRole { is_reference: true, serves_images: true, ..TracingRole::PLAIN }),
};
