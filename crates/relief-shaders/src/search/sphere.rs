//! Registry entry of the search `sphere`.

use relief_core::registry::{Entry, Guarantee, Guarantees, MapInput, MapSetting, Param, Publication};

/// Sphere tracing through a distance field.
pub const ENTRY: Entry = Entry {
    name: "sphere",
    summary: "as far as a field of distances says that nothing is met",
    publication: Publication { paper: super::SURVEY, section: "4.3.4" },
    maps: &[MapInput::new("distance", "").with(&[("slices", MapSetting::Fixed(32.0))])],
    params: &[Param {
        name: "steps",
        summary: "most steps",
        unit: "",
        min: 1.0,
        max: 1024.0,
        default: 64.0,
        integer: true,
    }],
    guarantee: Guarantees::all(Guarantee::Approximate),
    argument: "",
};
