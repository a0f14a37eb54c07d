//! Azimuths of baked maps: their parameters, their directions, and the notes in textures.
//!
//! The kinds `horizon`, `occlusion`, `bent-normal`, `visibility`, `bounce` and `seen-normal` use
//! them.

use relief_core::registry::Param;

use crate::{BakeInput, Channel, Texture};

/// Parameter for the number of azimuths.
pub(crate) const AZIMUTHS: Param = Param {
    name: "azimuths",
    summary: "number of directions along the base plane in which horizons are searched",
    unit: "",
    min: 4.0,
    max: 256.0,
    default: 16.0,
    integer: true,
    names: &[],
};

/// Parameter for the reach of the horizon, in tiles.
pub(crate) const TILES: Param = Param {
    name: "tiles",
    summary: "reach of the search for the horizon, in tiles",
    unit: "tiles",
    min: 1.0,
    max: 16.0,
    default: 1.0,
    integer: true,
    names: &[],
};

/// Direction along the base plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Direction {
    /// Step in texels. The component along the major axis is 1 or -1, the other at most as large.
    pub step: [f64; 2],
    /// Length of the step in metres.
    pub step_m: f64,
}

impl Direction {
    /// Returns azimuth `index` of `azimuths`: at the angle `2π index / azimuths`, in metres, from
    /// `+u` towards `+v`.
    pub fn azimuth(index: u32, azimuths: u32, texel_m: [f64; 2]) -> Self {
        let [cos, sin] = unit_vector(index, azimuths);
        let along = [cos / texel_m[0], sin / texel_m[1]];
        let major = along[0].abs().max(along[1].abs());
        Self { step: along.map(|x| snap(x / major)), step_m: 1.0 / major }
    }

    /// Whether the major axis is `v`.
    pub fn is_steep(&self) -> bool {
        self.step[1].abs() > self.step[0].abs()
    }
}

/// Cosine and sine of azimuth number `index` of `azimuths`, with exact quarters.
pub(crate) fn unit_vector(index: u32, azimuths: u32) -> [f64; 2] {
    let angle = std::f64::consts::TAU * f64::from(index) / f64::from(azimuths);
    [snap(angle.cos()), snap(angle.sin())]
}

/// Restores zero and one where rounding spoilt them. A line a hair off an axis would read a second
/// row for nothing.
fn snap(x: f64) -> f64 {
    const ROUNDING: f64 = 1e-12;
    if x.abs() < ROUNDING {
        0.0
    } else if (x.abs() - 1.0).abs() < ROUNDING {
        x.signum()
    } else {
        x
    }
}

/// Describes a texture of `slices` slices of the map's size, with notes on its azimuths.
pub(crate) fn texture(source: &BakeInput, azimuths: u32, slices: u32, channels: Vec<Channel>) -> Texture {
    let [u, v] = source.metric.tile_m;
    let notes = vec![
        ("azimuths", format!("{azimuths}: 2 pi k / {azimuths}, in metres from +u towards +v")),
        ("tile_m", format!("{u} {v}")),
        ("scale_m", source.metric.scale_m.to_string()),
        ("wrap", source.map.wrap().name().to_owned()),
    ];
    let size = [source.map.width(), source.map.height(), slices];
    Texture { name: "", size, mips: Vec::new(), channels, notes }
}
