//! Registry entry of the shadow `march`.

use relief_core::registry::{Entry, Guarantee, Guarantees, Param, Publication};

/// Steps toward the light.
pub const ENTRY: Entry = Entry {
    name: "march",
    summary: "steps toward the light over the heights",
    publication: Publication { paper: "", section: "" },
    maps: &[],
    params: &[Param {
        name: "steps",
        summary: "steps toward the light",
        unit: "",
        min: 1.0,
        max: 1024.0,
        default: 64.0,
        integer: true,
    }],
    guarantee: Guarantees::all(Guarantee::Approximate),
    argument: "",
};
