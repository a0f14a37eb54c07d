//! Registry entry of the ambient light `sky`.

use relief_core::registry::{Guarantee, Guarantees, MapInput, MapSetting, Param, Publication};

use super::GROUND;
use crate::entry::{Entry, Role};
use crate::scene_maps::{AZIMUTHS, scene_map};

/// An occluded sky above and ground below.
pub const ENTRY: Entry = Entry {
    name: "sky",
    summary: "like hemisphere, limited to what the relief leaves open; baked from a coarser level",
    publication: Publication { paper: "Landis 2002; Hargreaves 2003", section: "" },
    maps: &[MapInput {
        side: Some(MapSetting::Param("side")),
        ..scene_map(
            "bent-normal",
            &[("azimuths", MapSetting::Param("azimuths")), ("scaled", MapSetting::Fixed(1.0))],
        )
    }],
    params: &[
        GROUND,
        Param { default: 8.0, ..AZIMUTHS },
        Param {
            name: "side",
            summary: "the most texels along the longer side of the height map's level that is baked",
            unit: "texels",
            min: 16.0,
            max: 16384.0,
            default: 512.0,
            integer: true,
            names: &[],
        },
    ],
    states: &[],
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "The visible part of the sky is taken from bent-normal, for heights as fine as \
        the baked level. All of it has the mean radiance that two planes see: one across the mean \
        open direction, one across the normal. This is right where nothing is hidden. The hidden \
        directions give no light.",
    role: Role::Plain,
};
