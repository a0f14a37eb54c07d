//! Registry entry of the detail `fade`.

use relief_core::encoding::seen_normal;
use relief_core::registry::{Guarantee, Guarantees, MapInput, MapLevels, MapSetting, Param, Publication};

use super::{ANISOTROPY, TEXELS};
use crate::entry::{Entry, Role};
use crate::scene_maps::scene_map;

/// Displacement that flattens with distance, down to bump mapping.
pub const ENTRY: Entry = Entry {
    name: "fade",
    summary: "like footprint; flattens the relief with distance, down to bump mapping with \
        visible normals",
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
            summary: "greatest depth of a relief that is traced as a plane",
            unit: "pixels",
            min: 0.01,
            max: 1024.0,
            default: 1.0,
            integer: false,
            names: &[],
        },
        Param {
            name: "begin",
            summary: "factor on that depth at which flattening begins",
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
    argument: "Heights are drawn toward the map's mean: the traced surface is flatter than the \
        level's, and the promises of search and refinement hold for the flatter one. With the \
        defaults a point of it moves by two thirds of a pixel at most. Normals and shadow rays use \
        the relief as it is. Where a footprint is wider than four texels, the visible normals are \
        looked up by the direction of view, as baked from 32 directions. Elsewhere, and for a \
        given normal map, they follow from the moments of the normals.",
    role: Role::Flattened,
};
