//! Registry entry of the refinement `offset`.

use relief::registry::{Entry, Guarantee, Guarantees, Source};

/// Parallax mapping: a level surface at the starting point's height.
pub const ENTRY: Entry = Entry {
    id: 1,
    name: "offset",
    summary: "parallax mapping: a level surface at the starting point's height",
    source: Source { paper: super::SURVEY, section: "4.1.2" },
    maps: &[],
    params: &[],
    guarantee: Guarantees::all(Guarantee::Approximate),
    argument: "Exact where the map is constant.",
};
