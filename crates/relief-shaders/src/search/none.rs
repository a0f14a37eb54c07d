//! Registry entry of the search `none`.

use relief_core::FoundState;
use relief_core::registry::{Guarantee, Guarantees, Publication};

use crate::entry::{Entry, Role};

/// No search: the path's entry and exit.
pub const ENTRY: Entry = Entry {
    name: "none",
    summary: "no search: returns entry and exit",
    publication: Publication { paper: super::SURVEY, section: "4.1" },
    maps: &[],
    params: &[],
    states: &[FoundState::Unbracketed],
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "Nothing is claimed: both ends are returned unbracketed.",
    role: Role::Idle,
};
