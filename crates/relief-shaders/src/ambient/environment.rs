//! Registry entry of the ambient light `environment`.

use relief_core::registry::{Guarantee, Guarantees, Param, Publication};

use crate::entry::{Entry, Role};

/// The surroundings.
pub const ENTRY: Entry = Entry {
    name: "environment",
    summary: "the surroundings, from a picture or a sky: reflected, scattered, and refracted",
    publication: Publication { paper: "Blinn and Newell 1976; Oh, Ki and Lee 2006", section: "Figure 22" },
    maps: &[],
    params: &[Param {
        name: "intensity",
        summary: "the factor on the light of the surroundings",
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
    argument: "Right for a surface alone in its surroundings: the relief neither hides them nor is seen in \
        itself, and refracted light meets no second surface.",
    role: Role::Surroundings,
};
