//! Parameters of entries that read baked maps of a texel's surroundings.

use relief_core::registry::{MapInput, MapMetric, MapSetting, Param};

/// The number of baked azimuths.
pub const AZIMUTHS: Param = Param {
    name: "azimuths",
    summary: "azimuths that are baked",
    unit: "",
    min: 4.0,
    max: 256.0,
    default: 16.0,
    integer: true,
    names: &[],
};

/// The number of baked elevations of each azimuth.
pub const ELEVATIONS: Param = Param {
    name: "elevations",
    summary: "elevations of the directions in which light is gathered",
    min: 1.0,
    max: 64.0,
    default: 4.0,
    ..AZIMUTHS
};

/// The only texture of a kind, baked in the metres of the surface.
pub const fn scene_map(kind: &'static str, settings: &'static [(&'static str, MapSetting)]) -> MapInput {
    MapInput { metric: MapMetric::Scene, ..MapInput::new(kind, "").with(settings) }
}
