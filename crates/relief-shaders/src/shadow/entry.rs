//! Registry entry of the shadow `entry`.

use relief_core::registry::{Guarantee, Guarantees, Param, Publication};

use super::ShadowRole;
use crate::entry::{Entry, Role};

/// A ray from where the light enters the relief, down to the hit.
pub const ENTRY: Entry = Entry {
    name: "entry",
    summary: "traces a view ray from the light's entry into the relief; lit if it ends at the hit",
    publication: Publication {
        paper: "Oliveira and Policarpo 2005, An Efficient Representation for Surface Details",
        section: "2.1",
    },
    maps: &[],
    params: &[Param {
        name: "tolerance",
        summary: "greatest distance between the two ends",
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
    argument: "The ray enters at the top of the relief, at the footprint's edge or at the \
        light, and descends to the hit. Search and refinement of the view serve it, with their \
        map. If it ends within the tolerance of the hit, nothing is taken to be in the way, though \
        a thin ridge may be. Where light grazes the surface, rounding alone can exceed the \
        tolerance.",
    role: Role::Shadow(ShadowRole::FromEntry),
};
