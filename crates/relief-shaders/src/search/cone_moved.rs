//! Registry entry of the search `cone-moved`.

use relief_core::FoundState;
use relief_core::registry::{Guarantee, Guarantees, MapInput, MapSetting, Param, Publication, Weakened};

use crate::entry::{Entry, Role};

/// Cone stepping as published.
pub const ENTRY: Entry = Entry {
    name: "cone-moved",
    summary: "cone stepping as published: steps over cones that are moved to the ray",
    publication: Publication { paper: super::SURVEY, section: "4.3.5" },
    maps: &[MapInput::new("cone", "").with(&[("apex", MapSetting::Param("apex"))])],
    params: &[
        Param {
            name: "steps",
            summary: "number of steps; the last point is the answer",
            unit: "",
            min: 1.0,
            max: 4096.0,
            default: 32.0,
            integer: true,
            names: &[],
        },
        Param {
            name: "apex",
            summary: "where cones are safe: 0 on texel centres, as their author had them; 1 \
                over a texel; 2 through a filter",
            unit: "",
            min: 0.0,
            max: 2.0,
            default: 2.0,
            integer: true,
            names: &[],
        },
    ],
    states: &[FoundState::Above, FoundState::Bracket],
    guarantee: Guarantees::all(Guarantee::Conservative),
    weakened: &[
        Weakened { param: "apex", value: 0.0, to: Guarantees::all(Guarantee::Approximate) },
        Weakened { param: "apex", value: 1.0, to: Guarantees::all(Guarantee::Approximate) },
    ],
    argument: "A cone that is safe through a filter holds no surface wherever it stands, so a \
        step to the cone's border passes nothing. Steps get shorter toward the surface, and the \
        last point is the answer. In f32 a step is shortened by 8 roundings of the heights and, \
        times the slope, of the places that it is computed from.",
    role: Role::Plain,
};
