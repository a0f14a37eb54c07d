//! Registry entry of the shadow `horizon`.

use relief_core::registry::{Entry, Guarantee, Guarantees, MapInput, MapMetric, MapSetting, Publication};

/// Looked up in a map of horizons.
pub const ENTRY: Entry = Entry {
    name: "horizon",
    summary: "looked up in a map of horizons",
    publication: Publication { paper: "", section: "" },
    maps: &[MapInput { metric: MapMetric::Scene, ..MapInput::new("horizon", "") }
        .with(&[("azimuths", MapSetting::Fixed(16.0))])],
    params: &[],
    guarantee: Guarantees::all(Guarantee::Approximate),
    argument: "",
};
