//! Registry entry of blended impostors.

use relief_core::registry::{Guarantee, Guarantees, Publication};

use super::{ObjectRole, Solid};
use crate::entry::{Companion, Entry, Role};

/// Octahedral impostors as game engines draw them.
pub const ENTRY: Entry = Entry {
    name: "blend",
    summary: "an octahedral impostor as engines draw it: three frames, blended",
    publication: Publication { paper: "Brucks 2018, Octahedral Impostors", section: "" },
    maps: &[],
    params: super::PARAMS,
    states: &[],
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "Each frame is read at a place that parallax mapping guesses, and the results of \
        three frames are mixed: a point may be where none of them has one.",
    role: Role::Object(ObjectRole {
        solid: Solid::Blend,
        // Lights see blends at other places than the eye does, and would shade all of it.
        companions: &[
            Companion::new("surface", "frames"),
            Companion::new("search", "none"),
            Companion::new("refine", "none"),
            Companion::new("shadow", "none"),
        ],
    }),
};
