//! Registry entry of the slice test `band`.

use relief_core::registry::{Guarantee, Guarantees, Publication};

use crate::entry::{Entry, Role};

/// What lies nearer to the relief than to that of other slices.
pub const ENTRY: Entry = Entry {
    name: "band",
    summary: "what lies within half of the slices' distance from the relief: steps are not joined",
    publication: Publication {
        paper: "Schaufler 1998, Per-Object Image Warping with Layered Impostors",
        section: "",
    },
    maps: &[],
    params: super::PARAMS,
    states: &[],
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "Each point of the relief has a slice that is so near. Between neighbours of other heights \
        rays go through, as in warped pictures.",
    role: Role::NearSurface,
};
