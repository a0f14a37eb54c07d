//! Registry entry of the refinement `none`.

use relief_core::registry::{Guarantee, Guarantees, Publication};

use crate::entry::{Entry, Role};

/// What the search found: the processed point, or the first sample below.
pub const ENTRY: Entry = Entry {
    name: "none",
    summary: "what the search found: the processed point, or the first sample below",
    publication: Publication { paper: super::SURVEY, section: "4.1.1" },
    maps: &[],
    params: &[],
    states: super::ALL_STATES,
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "It adds nothing to what the search knows.",
    role: Role::Idle,
};
