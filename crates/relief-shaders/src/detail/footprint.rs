//! Registry entry of the detail `footprint`.

use relief_core::registry::{Entry, Guarantee, Guarantees, Param, Publication};

/// The level of which some texels lie beside each other in the pixel's footprint.
pub const ENTRY: Entry = Entry {
    name: "footprint",
    summary: "the level of which about two texels are beside each other in what a sample of a pixel covers",
    publication: Publication {
        paper: "Oh, Ki and Lee 2006, Pyramidal Displacement Mapping: A GPU-based Artifacts-Free Ray Tracing \
            through an Image Pyramid",
        section: "3.4",
    },
    maps: &[],
    params: &[
        Param {
            name: "anisotropy",
            summary: "the most that a footprint may be longer than it is taken to be wide",
            unit: "",
            min: 1.0,
            max: 64.0,
            default: 8.0,
            integer: false,
        },
        Param {
            name: "texels",
            summary: "texels of the traced level beside each other in a footprint, at least; more show more",
            unit: "",
            min: 1.0,
            max: 64.0,
            default: 2.0,
            integer: false,
        },
    ],
    states: &[],
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "Each level is a bilinear surface of its own, with baked maps of its own heights: what a \
        search and a refinement promise holds for the surface of the level. That lies within the range of \
        the finest heights around it, and is another surface than the finest.",
};
