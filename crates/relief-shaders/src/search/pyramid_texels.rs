//! Registry entry of the search `pyramid-texels`.

use relief_core::FoundState;
use relief_core::registry::{Guarantee, Guarantees, MapInput, MapLevels, MapSetting, Param, Publication};

use crate::entry::{Entry, Role};

/// The maximum pyramid of the texels, as published.
pub const ENTRY: Entry = Entry {
    name: "pyramid-texels",
    summary: "pyramidal displacement mapping as published: texels as level columns",
    publication: Publication {
        paper: "Oh, Ki and Lee 2006, Pyramidal Displacement Mapping: A GPU based Artifacts-free Ray Tracing \
                Through an Image Pyramid",
        section: "3.2, 3.4",
    },
    // The finest level is the height map's own.
    maps: &[MapInput {
        levels: MapLevels::ChainFrom(1),
        ..MapInput::new("pyramid", "").with(&[("over", MapSetting::Fixed(1.0))])
    }],
    params: &[
        super::LIMIT,
        Param {
            name: "level",
            summary: "finest level of the pyramid for view rays; 0 is the level of texels",
            unit: "",
            min: 0.0,
            max: 20.0,
            default: 0.0,
            integer: true,
            names: &[],
        },
    ],
    states: &[FoundState::Below],
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "The result is exact for the surface of level columns over texels, which differs \
        from the bilinear surface: by up to half a texel, and where the bilinear surface is steep \
        by as much in height. Above level 0 a column is as high as the highest texel in it.",
    role: Role::Plain,
};
