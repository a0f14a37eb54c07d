//! Registry entry of the search `pyramid`.

use relief_core::registry::{Entry, Guarantee, Guarantees, MapInput, MapLevels, Param, Publication};

/// Over the nodes of the pyramid of least and greatest heights.
pub const ENTRY: Entry = Entry {
    name: "pyramid",
    summary: "over the nodes of the pyramid that the path stays above",
    publication: Publication { paper: super::SURVEY, section: "4.3.3" },
    maps: &[MapInput { levels: MapLevels::ChainFrom(0), ..MapInput::new("pyramid", "") }],
    params: &[Param {
        name: "limit",
        summary: "most reads before the search gives up",
        unit: "",
        min: 1.0,
        max: 16_777_216.0,
        default: 1_048_576.0,
        integer: true,
    }],
    guarantee: Guarantees::all(Guarantee::Approximate),
    argument: "",
};
