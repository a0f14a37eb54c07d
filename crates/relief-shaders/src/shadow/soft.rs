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
        summary: "points on the disc, one ray each",
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
    argument: "Each ray is traced like the shadow `ray`'s. The points lie at random in \
        rings of equal area of the disc, and are turned at random together, by the bits of the \
        hit's texture coordinates. The mean free part is the disc's visible part, and its squared \
        error falls at least as fast as the number of points grows.",
    role: Role::Shadow(ShadowRole::ToLights { rays: Some("samples") }),
};
