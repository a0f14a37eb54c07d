//! Registry entry of the shadow `visibility`.

use relief_core::registry::{Guarantee, Guarantees, MapSetting, Param, Publication};

use crate::entry::{Entry, Role};
use crate::scene_maps::{AZIMUTHS, ELEVATIONS, scene_map};

/// Precomputed visibility.
pub const ENTRY: Entry = Entry {
    name: "visibility",
    summary: "visibility baked for fixed directions: of the nearest one, or interpolated \
        between three",
    publication: Publication {
        paper: "Heidrich et al. 2000; Szirmay-Kalos and Umenhoffer 2008",
        section: "6.2",
    },
    maps: &[scene_map(
        "visibility",
        &[("azimuths", MapSetting::Param("azimuths")), ("elevations", MapSetting::Param("elevations"))],
    )],
    params: &[
        Param { summary: "azimuths of the directions", ..AZIMUTHS },
        Param {
            summary: "elevations of the directions, at most 256 directions in all",
            default: 8.0,
            ..ELEVATIONS
        },
        Param {
            name: "directions",
            summary: "directions that are looked up: 1, the nearest, or 3, interpolated",
            unit: "",
            min: 1.0,
            max: 3.0,
            default: 3.0,
            integer: true,
            names: &[],
        },
    ],
    states: &[],
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "The texels around a hit see the surface or the sky in each of the directions. \
        The light's own direction lies between them, and a mean of their values stands for it. A \
        light at a point is taken to be behind all of the relief. A light below the lowest \
        elevation is taken to be at it.",
    role: Role::Plain,
};
