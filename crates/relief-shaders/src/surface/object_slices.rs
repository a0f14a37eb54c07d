//! Registry entry of the surface `object-slices`.

use relief_core::registry::{Guarantee, Guarantees, Publication, RayClass};

use super::{AskedImages, Paths, Proposal, Refused, Shown};
use crate::entry::{Entry, Role};

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
    role: Role::Surface(PATHS),
};

/// What it makes of rays.
const PATHS: Paths = Paths {
    rays: &[RayClass::View],
    proposal: Proposal::Polygons,
    shown: Shown::ObjectSlices,
    images: Some(AskedImages::All),
    refused: &[
        Refused {
            stage: "slices",
            refuses: Entry::is_near_surface,
            reason: |others| {
                format!("what is near the surfaces of all images are only edges: choose {}", others.or())
            },
        },
        super::SLICES_ARE_SEARCHED,
        Refused {
            stage: "refine",
            refuses: super::is_active,
            reason: |others| {
                format!(
                    "between two slices any of the images may end the object: choose {}, which \
                     'slices.refine' at 0 does",
                    others.or()
                )
            },
        },
        Refused {
            stage: "shadow",
            refuses: super::is_active,
            reason: |others| {
                format!("lights see between slices that stand as an eye sees them: choose {}", others.or())
            },
        },
        super::IMAGES_HAVE_NO_LEVELS,
        super::IMAGES_KNOW_NO_SURROUNDINGS,
    ],
};
