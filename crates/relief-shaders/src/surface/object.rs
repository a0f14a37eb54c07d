//! Registry entry of the surface `object`.

use relief_core::registry::{Entry, Guarantee, Guarantees, Publication, RayClass};

use super::{Names, Paths, Proposal, Refused, Shown};

/// Images of an object, each of which is a relief on a plane of its own.
pub const ENTRY: Entry = Entry {
    name: "object",
    summary: "what images with depth look at: each is a relief that the ray goes straight through",
    publication: Publication { paper: crate::DEPTH_OBJECTS, section: "4" },
    maps: &[],
    params: &[],
    states: &[],
    guarantee: Guarantees::all(Guarantee::Exact),
    weakened: &[],
    argument: "An image's texture coordinates and heights are linear in the place, so that rays are straight \
        in each. They are cut off where an image ends and just above its lowest height, where it sees \
        nothing.",
};

/// What it makes of rays.
pub const PATHS: Paths = Paths {
    rays: &[RayClass::View, RayClass::Shadow],
    proposal: Proposal::Shells,
    shown: Shown::Object,
    refused: &[
        Refused {
            stage: "search",
            names: Names::AllBut(&["cells", "pyramid"]),
            reason: "rays come into images from all sides: choose 'cells' or 'pyramid'",
        },
        Refused {
            stage: "refine",
            names: Names::AllBut(&["patch"]),
            reason: "heights of images jump from cell to cell: choose 'patch'",
        },
        Refused {
            stage: "detail",
            names: Names::AllBut(&["none"]),
            reason: "images lie side by side in one, and would be mixed in coarser levels",
        },
        Refused {
            stage: "shadow",
            names: Names::AllBut(&["none", "map", "scene"]),
            reason: "one image alone does not know the object: choose 'map', 'scene' or 'none'",
        },
        Refused {
            stage: "ambient",
            names: Names::AllBut(&["constant", "environment"]),
            reason: "one image alone does not know what is around a point of the object",
        },
    ],
};
