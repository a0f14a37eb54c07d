//! Registry entry of the refinement `slope`.

use relief_core::registry::{Guarantee, Guarantees, Param, Publication};

use crate::entry::{Entry, Role};

/// Parallax mapping with the tangent plane at the starting point.
pub const ENTRY: Entry = Entry {
    name: "slope",
    summary: "takes the surface for its tangent plane at the starting point",
    publication: Publication { paper: super::SURVEY, section: "4.1.4" },
    maps: &[],
    params: &[Param {
        name: "divide",
        summary: "1 divides by N·V (ray against plane); 0 is the safer form without",
        unit: "",
        min: 0.0,
        max: 1.0,
        default: 0.0,
        integer: true,
        names: &[],
    }],
    states: super::ANY_INTERVAL,
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "Exact where the map is a plane and `divide` is 1.",
    role: Role::Plain,
};
