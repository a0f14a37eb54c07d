//! Registry entry of the search `relaxed-cone-resting`.

use relief_core::FoundState;
use relief_core::registry::{Guarantee, Guarantees, MapInput, MapSetting, Publication};

use crate::entry::{Entry, Role};

/// Cone stepping over relaxed cones that stay on their texel.
pub const ENTRY: Entry = Entry {
    name: "relaxed-cone-resting",
    summary: "steps over relaxed cones of texel centres, which stay on their texel",
    publication: Publication { paper: "Relief", section: "" },
    maps: &[MapInput::new("relaxed-cone", "").with(&[("apex", MapSetting::Fixed(0.0))])],
    params: &[super::LIMIT],
    states: &[FoundState::Bracket],
    guarantee: Guarantees {
        view: Guarantee::Approximate,
        bent: Guarantee::Impossible,
        shadow: Guarantee::Impossible,
    },
    weakened: &[],
    argument: "The cones hold for rays over the centre of their texel. Beside it a ray may enter the surface \
        and come out again within a cone: measured on cobbles, up to 0.03 % of the hits are passed at 80 \
        degrees and more.",
    role: Role::Plain,
};
