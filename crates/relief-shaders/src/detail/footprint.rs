//! Registry entry of the detail `footprint`.

use relief_core::registry::{Guarantee, Guarantees, Publication};

use super::{ANISOTROPY, TEXELS};
use crate::entry::{Entry, Role};

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
    params: &[ANISOTROPY, TEXELS],
    states: &[],
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "Each level is a bilinear surface of its own, with baked maps of its own heights: what a \
        search and a refinement promise holds for the surface of the level. That lies within the range of \
        the finest heights around it, and is another surface than the finest.",
    role: Role::Plain,
};
