//! Registry entry of the surface `object-slices`.

use relief_core::registry::{Entry, Guarantee, Guarantees, Publication, RayClass};

use super::{Names, Paths, Proposal, Refused, Shown};

/// Triangles through an object that is known from images.
pub const ENTRY: Entry = Entry {
    name: "object-slices",
    summary: "slices through an object, drawn where all its images see something as high as they are",
    publication: Publication { paper: crate::DEPTH_OBJECTS, section: "4.1" },
    maps: &[],
    params: &[],
    states: &[],
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "A ray ends on the first slice at which it is in the solids of all images: the first hit lies \
        between that one and the one before where the object passed no slice in between.",
};

/// What it makes of rays.
pub const PATHS: Paths = Paths {
    rays: &[RayClass::View],
    proposal: Proposal::Polygons,
    shown: Shown::ObjectSlices,
    refused: &[
        Refused {
            stage: "slices",
            names: Names::These(&["band"]),
            reason: "what is near the surfaces of all images are only edges: choose 'inside' or 'at-least'",
        },
        super::SLICES_ARE_SEARCHED,
        Refused {
            stage: "refine",
            names: Names::AllBut(&["none"]),
            reason: "between two slices any of the images may end the object: choose 'none', which \
                'slices.refine' at 0 does",
        },
        Refused {
            stage: "shadow",
            names: Names::AllBut(&["none"]),
            reason: "lights see between slices that stand as an eye sees them: choose 'none'",
        },
        super::IMAGES_HAVE_NO_LEVELS,
        super::IMAGES_KNOW_NO_SURROUNDINGS,
    ],
};
