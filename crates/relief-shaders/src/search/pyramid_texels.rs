//! Registry entry of the search `pyramid-texels`.

use relief_core::FoundState;
use relief_core::registry::{Entry, Guarantee, Guarantees, MapInput, MapLevels, MapSetting, Publication};

/// The maximum pyramid of the texels, as published.
pub const ENTRY: Entry = Entry {
    name: "pyramid-texels",
    summary: "pyramidal displacement mapping as published: texels as level columns",
    publication: Publication {
        paper: "Oh, Ki and Lee 2006, Pyramidal Displacement Mapping: A GPU based Artifacts-free Ray Tracing Through an Image Pyramid",
        section: "3.2",
    },
    // The finest level is the heights' own.
    maps: &[MapInput {
        levels: MapLevels::ChainFrom(1),
        ..MapInput::new("pyramid", "").with(&[("over", MapSetting::Fixed(1.0))])
    }],
    params: &[super::LIMIT],
    states: &[FoundState::Below],
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "It is exact for the surface of level columns over texels, which is another one than the \
        bilinear surface: it is off by up to half a texel, and where the bilinear surface is steep by as \
        much in height.",
};
