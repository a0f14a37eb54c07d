//! Registry entry of the search `linear`.

use relief_core::FoundState;
use relief_core::registry::{Guarantee, Guarantees, Param, Publication};

use crate::entry::{Entry, Role, TracingRole};
use crate::field::Solids;

/// Equal steps until one is below the surface.
pub const ENTRY: Entry = Entry {
    name: "linear",
    summary: "equal steps until one is below the surface",
    publication: Publication { paper: super::SURVEY, section: "4.3.1" },
    maps: &[],
    params: &[
        Param {
            name: "steps",
            summary: "steps for a ray along the normal",
            unit: "",
            min: 1.0,
            max: 4096.0,
            default: 32.0,
            integer: true,
            names: &[],
        },
        Param {
            name: "grazing",
            summary: "factor on the number of steps of a grazing ray",
            unit: "",
            min: 1.0,
            max: 64.0,
            default: 1.0,
            integer: false,
            names: &[],
        },
    ],
    states: &[FoundState::Bracket],
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "A bracket encloses a crossing, since the gap is read at both ends; a bump thinner than a step \
        is passed over.",
    role: Role::Tracing(TracingRole { only_samples: true, solids: Solids::Points, ..TracingRole::PLAIN }),
};
