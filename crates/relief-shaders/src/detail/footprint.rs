//! Registry entry of the detail `footprint`.

use relief_core::registry::{Guarantee, Guarantees, Publication};

use super::{ANISOTROPY, TEXELS};
use crate::entry::{Entry, Role};

/// The level with a few texels side by side in the pixel's footprint.
pub const ENTRY: Entry = Entry {
    name: "footprint",
    summary: "traces the level with about two texels side by side in the area that a pixel's \
        sample covers",
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
    argument: "Each level is a bilinear surface of its own, with baked maps of its own \
        heights: the promises of search and refinement hold for the surface of the level. This \
        surface lies within the range of the finest heights around it, and differs from the \
        finest.",
    role: Role::Plain,
};
