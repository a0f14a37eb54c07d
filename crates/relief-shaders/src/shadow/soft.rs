//! Registry entry of the shadow `soft`.

use relief_core::FoundState;
use relief_core::registry::{Guarantee, Guarantees, Param, Publication};

use super::ShadowRole;
use crate::entry::{Entry, Role};

/// Rays from the hit to points of the light's disc.
pub const ENTRY: Entry = Entry {
    name: "soft",
    summary: "rays from the hit to points all over the light's disc",
    publication: Publication { paper: super::SURVEY, section: "6" },
    maps: &[],
    params: &[Param {
        name: "samples",
        summary: "points of the disc that rays are sent to",
        unit: "",
        min: 1.0,
        max: 256.0,
        default: 16.0,
        integer: true,
        names: &[],
    }],
    states: &[FoundState::Above, FoundState::Below, FoundState::Bracket],
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "Each ray is one of the shadow `ray`. The points lie in rings of the same area of the disc, at \
        random in each and turned at random together, by the bits of the hit's texture coordinates: the \
        part that is free is the disc's visible part at the mean, and its squared error falls at least \
        as fast as the number of points grows.",
    role: Role::Shadow(ShadowRole::ToLights { rays: Some("samples") }),
};
