//! Registry entry of the search `relaxed-cone`.

use relief_core::FoundState;
use relief_core::registry::{Guarantee, Guarantees, MapInput, MapSetting, Publication, Weakened};

use crate::entry::{Entry, Role};

/// Relaxed cone stepping: over cones that a view ray leaves after at most one entry.
pub const ENTRY: Entry = Entry {
    name: "relaxed-cone",
    summary: "steps over cones that a view ray leaves after at most one entry into the surface",
    publication: Publication { paper: super::SURVEY, section: "4.4.3" },
    maps: &[MapInput::new("relaxed-cone", "").with(&[("apex", MapSetting::Fixed(1.0))])],
    params: &[super::LIMIT, super::PATCHES],
    states: &[FoundState::Bracket, FoundState::Above],
    guarantee: Guarantees {
        view: Guarantee::Exact,
        bent: Guarantee::Impossible,
        shadow: Guarantee::Impossible,
    },
    weakened: &[Weakened {
        param: "patches",
        value: 0.0,
        to: Guarantees {
            view: Guarantee::Conservative,
            bent: Guarantee::Impossible,
            shadow: Guarantee::Impossible,
        },
    }],
    argument: "Over any place of the texel's square, a falling ray that is below the surface \
        inside the cone stays below until it leaves the cone. So where it is above behind a step \
        it has met nothing, and where it is below it has entered exactly once, and halving finds \
        the entry. A step that ends before the cone's border is as good. Where a step ends within \
        the cell, the cell's patch is bounded in closed form as in `cells`. In f32 a step is \
        shortened by 8 roundings of the heights and, times the slope, of the places. So the ray is \
        known as well as to `cells`: rays that clear the surface by less than 2 roundings of the \
        path's heights and, times the map's steepest slope, of its places in texels may be judged \
        either way. Rays that rise or bend may enter several times. Without patches the search may \
        stop before the surface, where steps get no further.",
    role: Role::Plain,
};
