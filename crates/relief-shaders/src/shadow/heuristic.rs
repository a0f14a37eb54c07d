//! Registry entry of the shadow `heuristic`.

use relief_core::registry::{Guarantee, Guarantees, Param, Publication};

use crate::entry::{Entry, Role};

/// The heuristic of interactive engines.
pub const ENTRY: Entry = Entry {
    name: "heuristic",
    summary: "darkens by the heights above some points of the ray to the light, nearer ones more",
    publication: Publication {
        paper: "Tatarchuk 2006, Practical Parallax Occlusion Mapping; Szirmay-Kalos and Umenhoffer 2008",
        section: "6",
    },
    maps: &[],
    params: &[
        Param {
            name: "samples",
            summary: "points along the ray",
            unit: "",
            min: 2.0,
            max: 256.0,
            default: 16.0,
            integer: true,
            names: &[],
        },
        Param {
            name: "strength",
            summary: "darkness of what stands one height out of the ray",
            unit: "",
            min: 0.0,
            max: 1024.0,
            default: 16.0,
            integer: false,
            names: &[],
        },
    ],
    states: &[],
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "The result is plausible, no more. Occluders between two points are missed, and \
        the softness does not depend on the size of the light.",
    role: Role::Plain,
};
