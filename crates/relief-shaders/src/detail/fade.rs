//! Registry entry of the detail `fade`.

use relief_core::encoding::seen_normal;
use relief_core::registry::{Guarantee, Guarantees, MapInput, MapLevels, MapSetting, Param, Publication};

use super::{ANISOTROPY, TEXELS};
use crate::entry::{Entry, Role};
use crate::scene_maps::scene_map;

/// Flatter with distance, down to bump mapping.
pub const ENTRY: Entry = Entry {
    name: "fade",
    summary: "as footprint, and with distance flatter, down to bump mapping with the normals that are seen",
    publication: Publication {
        paper: "Becker and Max 1993, Smooth transitions between bump rendering algorithms; \
            Szirmay-Kalos and Umenhoffer 2008, Displacement mapping on the GPU",
        section: "4.1.1",
    },
    maps: &[MapInput {
        levels: MapLevels::MeansFrom(seen_normal::FIRST_LEVEL),
        ..scene_map(
            "seen-normal",
            &[
                ("azimuths", MapSetting::Fixed(seen_normal::AZIMUTHS as f32)),
                ("elevations", MapSetting::Fixed(seen_normal::ELEVATIONS as f32)),
            ],
        )
    }],
    params: &[
        ANISOTROPY,
        TEXELS,
        Param {
            name: "flat",
            summary: "how many pixels the relief is deep, at most, where it is traced as a plane",
            unit: "pixels",
            min: 0.01,
            max: 1024.0,
            default: 1.0,
            integer: false,
            names: &[],
        },
        Param {
            name: "begin",
            summary: "how many times as deep it is where it begins to be flattened",
            unit: "",
            min: 1.0,
            max: 1024.0,
            default: 4.0,
            integer: false,
            names: &[],
        },
    ],
    states: &[],
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "Heights are drawn toward the map's mean: what is traced is a flatter surface than the \
        level's, and what a search and a refinement promise holds for that one. With the defaults a point of \
        it moves by two thirds of a pixel at most. Normals, and the rays of shadows, are those of the relief \
        as it is. Where a footprint is wider than \
        four texels, what an eye sees of the normals is looked up by its direction, as baked from 32 \
        directions; elsewhere, and of a given normal map, it is made from the moments of the normals.",
    role: Role::Flattened,
};
