//! Registry entry of the detail `fade`.

use relief_core::registry::{Entry, Guarantee, Guarantees, Param, Publication};

use super::{ANISOTROPY, TEXELS};

/// Flatter with distance, down to bump mapping.
pub const ENTRY: Entry = Entry {
    name: "fade",
    summary: "as footprint, and with distance flatter, down to bump mapping with the normals that are seen",
    publication: Publication {
        paper: "Becker and Max 1993, Smooth transitions between bump rendering algorithms; \
            Szirmay-Kalos and Umenhoffer 2008, Displacement mapping on the GPU",
        section: "4.1.1",
    },
    maps: &[],
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
        },
        Param {
            name: "begin",
            summary: "how many times as deep it is where it begins to be flattened",
            unit: "",
            min: 1.0,
            max: 1024.0,
            default: 4.0,
            integer: false,
        },
    ],
    states: &[],
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "Heights are drawn toward the map's mean, so a ray meets another surface than that of the level, \
        with a search's and a refinement's promises for that one. A point of it moves by at most the part that \
        is flattened of the relief's depth: with the defaults by two thirds of a pixel, seen from the side. \
        Normals, and the rays of shadows, are those of the relief as it is. What an eye at the side sees of \
        the normals is made from their moments, for every direction: no tables of directions are baked.",
};
