//! Registry entry of the refinement `offset`.

use relief_core::FoundState;
use relief_core::registry::{Guarantee, Guarantees, Publication};

use crate::entry::{Entry, Role};

/// Parallax mapping: a level surface at the starting point's height.
pub const ENTRY: Entry = Entry {
    name: "offset",
    summary: "parallax mapping: takes the surface for level at the starting point's height",
    publication: Publication { paper: super::SURVEY, section: "4.1.2" },
    maps: &[],
    params: &[],
    states: &[FoundState::Unbracketed],
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "Exact where the map is constant.",
    role: Role::Plain,
};
