//! Registry entry of the refinement `secant`.

use relief_core::registry::{Guarantee, Guarantees, Param, Publication};

use crate::entry::{Entry, Role, TracingRole};
use crate::field::Solids;

/// False position: takes the surface between the two ends for a plane.
pub const ENTRY: Entry = Entry {
    name: "secant",
    summary: "false position: takes the surface between the two ends for a plane",
    publication: Publication { paper: super::SURVEY, section: "4.2.3" },
    maps: &[],
    params: &[Param {
        name: "steps",
        summary: "steps; the last needs no read",
        unit: "",
        min: 1.0,
        max: 64.0,
        default: 2.0,
        integer: true,
        names: &[],
    }],
    states: super::ANY_INTERVAL,
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "Keeps a crossing enclosed; exact after one step where the gap is linear.",
    role: Role::Tracing(TracingRole { joins_slices: true, solids: Solids::Points, ..TracingRole::PLAIN }),
};
