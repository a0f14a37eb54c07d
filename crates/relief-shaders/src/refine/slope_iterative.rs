//! Registry entry of the refinement `slope-iterative`.

use relief_core::registry::{Guarantee, Guarantees, Param, Publication};

use crate::entry::{Entry, Role};

/// Iterative parallax mapping: the slope correction, repeated.
pub const ENTRY: Entry = Entry {
    name: "slope-iterative",
    summary: "iterative parallax mapping: repeats the slope correction",
    publication: Publication { paper: super::SURVEY, section: "4.2.1" },
    maps: &[],
    params: &[
        Param {
            name: "steps",
            summary: "number of corrections",
            unit: "",
            min: 1.0,
            max: 64.0,
            default: 4.0,
            integer: true,
            names: &[],
        },
        Param {
            name: "divide",
            summary: "1 divides by N·V (Newton's method); 0 is the safer form without",
            unit: "",
            min: 0.0,
            max: 1.0,
            default: 0.0,
            integer: true,
            names: &[],
        },
    ],
    states: super::ANY_INTERVAL,
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "Convergence is not guaranteed, nor is the first crossing.",
    role: Role::Plain,
};
