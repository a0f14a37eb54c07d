//! Light from all around: what of a uniform sky's light a hit reflects. A new one is a `.wesl` and a `.rs`
//! file here and its name in the list below; the first is what is run where nothing is said.

use relief_core::registry::{Entry, MapInput, MapMetric, MapSetting, Param};

mod bent_normal;
mod bounce;
mod constant;
mod occlusion;

/// All of them.
pub const ENTRIES: &[Entry] = &[constant::ENTRY, occlusion::ENTRY, bent_normal::ENTRY, bounce::ENTRY];

/// How many azimuths are baked.
const AZIMUTHS: Param = Param {
    name: "azimuths",
    summary: "azimuths that are baked",
    unit: "",
    min: 4.0,
    max: 256.0,
    default: 16.0,
    integer: true,
};

/// A map of that kind, in the metres of the surface.
const fn scene_map(kind: &'static str, settings: &'static [(&'static str, MapSetting)]) -> MapInput {
    MapInput { metric: MapMetric::Scene, ..MapInput::new(kind, "").with(settings) }
}
