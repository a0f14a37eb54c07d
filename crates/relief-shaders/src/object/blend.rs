//! Registry entry of blended impostors.

use relief_core::registry::{Guarantee, Guarantees, Publication};

use super::{ObjectRole, Solid};
use crate::entry::{Companion, Entry, Role};

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
    role: Role::Object(ObjectRole {
        solid: Solid::Blend,
        // What lights see of blends lies elsewhere than what eyes do, and would shade all of it.
        companions: &[
            Companion::new("surface", "frames"),
            Companion::new("search", "none"),
            Companion::new("refine", "none"),
            Companion::new("shadow", "none"),
        ],
    }),
};
