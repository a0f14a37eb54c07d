//! Registry entry of the refinement `none`.

use relief_core::registry::{Guarantee, Guarantees, Publication};

use crate::entry::{Entry, Role};

/// The search's result as it is: the processed point, or the first sample below.
pub const ENTRY: Entry = Entry {
    name: "none",
    summary: "returns the search's result: the processed point, or the first sample below",
    publication: Publication { paper: super::SURVEY, section: "4.1.1" },
    maps: &[],
    params: &[],
    states: super::ALL_STATES,
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "Nothing is added to the search's result.",
    role: Role::Idle,
};
