//! Registry entry of the slice test `band`.

use relief_core::registry::{Guarantee, Guarantees, Publication};

use crate::entry::{Entry, Role};

/// Draws where the relief is nearer to this slice than to others.
pub const ENTRY: Entry = Entry {
    name: "band",
    summary: "draws within half of the slices' distance from the relief; steps are not joined",
    publication: Publication {
        paper: "Schaufler 1998, Per-Object Image Warping with Layered Impostors",
        section: "",
    },
    maps: &[],
    params: super::PARAMS,
    states: &[],
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "Each point of the relief has a slice within that distance. Between neighbours \
        of other heights rays go through, as in warped pictures.",
    role: Role::NearSurface,
};
