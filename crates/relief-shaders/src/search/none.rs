//! Registry entry of the search `none`.

use relief_core::FoundState;
use relief_core::registry::{Guarantee, Guarantees, Publication};

use crate::entry::{Entry, Role};

/// Nothing is searched: entry and exit.
pub const ENTRY: Entry = Entry {
    name: "none",
    summary: "nothing is searched: entry and exit",
    publication: Publication { paper: super::SURVEY, section: "4.1" },
    maps: &[],
    params: &[],
    states: &[FoundState::Unbracketed],
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "It claims nothing: both ends are returned unbracketed.",
    role: Role::Idle,
};
