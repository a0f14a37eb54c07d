//! Registry entry of the refinement `binary`.

use relief_core::registry::{Guarantee, Guarantees, Param, Publication};

use crate::entry::{Entry, Role, TracingRole};
use crate::field::Solids;

/// Binary search: halves the interval.
pub const ENTRY: Entry = Entry {
    name: "binary",
    summary: "halves the interval in each step",
    publication: Publication { paper: super::SURVEY, section: "4.2.2" },
    maps: &[],
    params: &[Param {
        name: "steps",
        summary: "number of halvings",
        unit: "",
        min: 1.0,
        max: 64.0,
        default: 8.0,
        integer: true,
        names: &[],
    }],
    states: super::ANY_INTERVAL,
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "Converges to a crossing in the interval, which is the first when the interval holds one.",
    role: Role::Tracing(TracingRole { solids: Solids::Points, ..TracingRole::PLAIN }),
};
