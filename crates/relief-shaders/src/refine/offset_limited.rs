//! Registry entry of the refinement `offset-limited`.

use relief_core::FoundState;
use relief_core::registry::{Guarantee, Guarantees, Publication};

use crate::entry::{Entry, Role};

/// Parallax mapping with offset limiting: never farther than the height.
pub const ENTRY: Entry = Entry {
    name: "offset-limited",
    summary: "parallax mapping with offset limiting: never moves farther than the height",
    publication: Publication { paper: super::SURVEY, section: "4.1.3" },
    maps: &[],
    params: &[],
    states: &[FoundState::Unbracketed],
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "Never moves farther along the ray than the height difference; the point lies beside the ray.",
    role: Role::Plain,
};
