//! Registry entry of the ambient light `environment`.

use relief_core::registry::{Guarantee, Guarantees, Param, Publication};

use crate::entry::{Entry, Role};

/// An environment map.
pub const ENTRY: Entry = Entry {
    name: "environment",
    summary: "an environment map, from a picture or a sky: reflected, scattered, and refracted",
    publication: Publication { paper: "Blinn and Newell 1976; Oh, Ki and Lee 2006", section: "Figure 22" },
    maps: &[],
    params: &[Param {
        name: "intensity",
        summary: "factor on the light of the environment map",
        unit: "",
        min: 0.0,
        max: 1e6,
        default: 1.0,
        integer: false,
        names: &[],
    }],
    states: &[],
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "Right for a surface alone in its environment: the relief neither hides it nor \
        is seen in itself, and refracted light meets no second surface.",
    role: Role::Surroundings,
};
