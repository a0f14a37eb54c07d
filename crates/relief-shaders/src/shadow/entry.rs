//! Registry entry of the shadow `entry`.

use relief_core::registry::{Guarantee, Guarantees, Param, Publication};

use super::ShadowRole;
use crate::entry::{Entry, Role};

/// A ray from where the light enters the relief, down to the hit.
pub const ENTRY: Entry = Entry {
    name: "entry",
    summary: "a view ray from where the light enters the relief; lit where it ends at the hit",
    publication: Publication {
        paper: "Oliveira and Policarpo 2005, An Efficient Representation for Surface Details",
        section: "2.1",
    },
    maps: &[],
    params: &[Param {
        name: "tolerance",
        summary: "how far apart the two ends may be",
        unit: "texels",
        min: 0.0,
        max: 16.0,
        default: 0.05,
        integer: false,
        names: &[],
    }],
    states: &[],
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "The ray enters at the top of the relief, at the footprint's edge or at the light, and \
        descends to the hit: search and refinement of the view serve it, with their map. Where it ends \
        within the tolerance of the hit nothing is taken to be in the way, though a thin ridge may be; where \
        light grazes the surface, rounding alone can be more than the tolerance.",
    role: Role::Shadow(ShadowRole::FromEntry),
};
