//! Registry entry of the refinement `true-secant`.

use relief_core::registry::{Guarantee, Guarantees, Param, Publication};

use crate::entry::{Entry, Role, TracingRole};
use crate::field::Solids;

/// The secant method proper: always uses the last two guesses.
pub const ENTRY: Entry = Entry {
    name: "true-secant",
    summary: "the secant method proper: always uses the last two guesses",
    publication: Publication { paper: super::SURVEY, section: "4.2.3" },
    maps: &[],
    params: &[Param {
        name: "steps",
        summary: "steps; the last needs no read",
        unit: "",
        min: 1.0,
        max: 64.0,
        default: 3.0,
        integer: true,
        names: &[],
    }],
    states: super::ANY_INTERVAL,
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "Converges faster than false position near a simple crossing and may leave the bracket; \
        guesses are kept in the search's interval.",
    role: Role::Tracing(TracingRole { solids: Solids::Points, ..TracingRole::PLAIN }),
};
