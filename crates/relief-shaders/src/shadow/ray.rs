//! Registry entry of the shadow `ray`.

use relief_core::FoundState;
use relief_core::registry::{Guarantee, Guarantees, Publication};

use super::ShadowRole;
use crate::entry::{Entry, Role};

/// A ray from the hit to the light.
pub const ENTRY: Entry = Entry {
    name: "ray",
    summary: "a ray from the hit to the light, through the relief of the same surface",
    publication: Publication { paper: super::SURVEY, section: "6" },
    maps: &[],
    params: &[],
    states: &[FoundState::Above, FoundState::Below, FoundState::Bracket],
    guarantee: Guarantees::all(Guarantee::Exact),
    weakened: &[],
    argument: "The ray begins on the surface. In the cell of the hit the gap between ray and \
        surface is a quadratic with one known root, the hit itself. It is taken out, and the other \
        root tells whether the cell's own patch is in the way. The search begins where the ray \
        leaves the cell, as far above the surface as that quadratic says and 8 roundings of a \
        height more. So no hit shadows itself. With an exact search light is cut exactly where the \
        surface is in its way, but for rays that clear the surface, or are below it, by less than \
        these roundings. A search that ends before the surface is taken to have met it.",
    role: Role::Shadow(ShadowRole::ToLights { rays: None }),
};
