//! Registry entry of the refinement `offset-limited`.

use relief::registry::{Entry, Guarantee, Guarantees, Source};

/// Parallax mapping with offset limiting: never farther than the height.
pub const ENTRY: Entry = Entry {
    id: 2,
    name: "offset-limited",
    summary: "parallax mapping with offset limiting: never farther than the height",
    source: Source { paper: super::SURVEY, section: "4.1.3" },
    maps: &[],
    params: &[],
    guarantee: Guarantees::all(Guarantee::Approximate),
    argument: "Never moves farther along the ray than the height difference; the point lies beside the ray.",
};
