//! Registry entry of blended impostors.

use relief_core::registry::{Entry, Guarantee, Guarantees, Publication};

/// What game engines draw of a grid of frames.
pub const ENTRY: Entry = Entry {
    name: "blend",
    summary: "an octahedral impostor as engines draw it: three frames, blended",
    publication: Publication { paper: "Brucks 2018, Octahedral Impostors", section: "" },
    maps: &[],
    params: super::PARAMS,
    states: &[],
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "Each frame is asked at a place that parallax mapping guesses, and what three of them show is \
        mixed: a point may be where none of them has one.",
};
