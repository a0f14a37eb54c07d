//! Registry entry of the search `sphere`.

use relief_core::FoundState;
use relief_core::registry::{Guarantee, Guarantees, MapInput, MapSetting, Param, Publication, Weakened};

use crate::entry::{Entry, Role};

/// Sphere tracing: steps as far as the distance field is empty.
pub const ENTRY: Entry = Entry {
    name: "sphere",
    summary: "sphere tracing: steps as far as a distance field is empty",
    publication: Publication { paper: super::SURVEY, section: "4.3.4" },
    maps: &[MapInput::new("distance", "").with(&[("slices", MapSetting::Param("slices"))])],
    params: &[
        super::LIMIT,
        super::PATCHES,
        Param {
            name: "slices",
            summary: "height slices of the distance field",
            unit: "slices",
            min: 2.0,
            max: 256.0,
            default: 64.0,
            integer: true,
            names: &[],
        },
    ],
    states: &[FoundState::Bracket, FoundState::Above],
    guarantee: Guarantees::all(Guarantee::Exact),
    weakened: &[Weakened { param: "patches", value: 0.0, to: Guarantees::all(Guarantee::Conservative) }],
    argument: "A fetch from the field is at most the distance to the surface, so a step of that length meets \
        nothing; a bent path is nowhere faster than at one of its ends. Where a step ends within the cell, \
        the cell's patch is bounded in closed form as in `cells`. In f32 a step is shortened by 8 roundings \
        of the places and heights of the path. So the ray is known as well as to `cells`: rays that clear \
        the surface by less than 2 roundings of the path's heights and, times the map's steepest slope, of \
        its places in texels may be judged either way. Without patches the search stops before the surface \
        where the field allows no more way.",
    role: Role::Plain,
};
