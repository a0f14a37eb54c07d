//! Registry entry of the ambient light `bounce`.

use relief_core::registry::{Guarantee, Guarantees, MapSetting, Param, Publication};

use crate::entry::{Entry, Role};
use crate::scene_maps::{AZIMUTHS, ELEVATIONS, scene_map};

/// Light that bounces within the relief.
pub const ENTRY: Entry = Entry {
    name: "bounce",
    summary: "the sky's light, and the light that the relief reflects onto itself, baked",
    publication: Publication {
        paper: "Heidrich et al. 2000; Szirmay-Kalos and Umenhoffer 2008",
        section: "6.2",
    },
    maps: &[scene_map(
        "bounce",
        &[
            ("azimuths", MapSetting::Param("azimuths")),
            ("elevations", MapSetting::Param("elevations")),
            ("albedo", MapSetting::Param("albedo")),
            ("bounces", MapSetting::Param("bounces")),
        ],
    )],
    params: &[
        AZIMUTHS,
        ELEVATIONS,
        Param {
            name: "albedo",
            summary: "part of the light that the relief reflects",
            unit: "",
            min: 0.0,
            max: 1.0,
            default: 0.5,
            integer: false,
            names: &[],
        },
        Param {
            name: "bounces",
            summary: "number of reflections",
            unit: "",
            min: 0.0,
            max: 256.0,
            default: 4.0,
            integer: true,
            names: &[],
        },
    ],
    states: &[],
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "A texel receives a mean over fixed directions of the light that it sees there, \
        about the base's normal. All of the relief reflects the same part; the colours that light \
        takes on are not known.",
    role: Role::Plain,
};
