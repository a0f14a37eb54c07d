//! Registry entry of the surface `object-slices`.

use relief_core::registry::{Guarantee, Guarantees, Publication, RayClass};

use super::{AskedImages, Paths, Proposal, Refused, Shown};
use crate::entry::{Entry, Role};

/// Triangles through an object that is known from images.
pub const ENTRY: Entry = Entry {
    name: "object-slices",
    summary: "slices through an object, drawn where all its images see something at least as high",
    publication: Publication { paper: crate::DEPTH_OBJECTS, section: "4.1" },
    maps: &[],
    params: &[],
    states: &[],
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "A ray ends on the first slice at which it is in the solids of all images. The \
        first hit lies between that slice and the one before, if the object did not pass a slice \
        in between.",
    role: Role::Surface(PATHS),
};

/// Paths of rays on slices through the box.
const PATHS: Paths = Paths {
    rays: &[RayClass::View],
    proposal: Proposal::Polygons,
    shown: Shown::ObjectSlices,
    images: Some(AskedImages::All),
    through_frame: false,
    refused: &[
        Refused {
            stage: "slices",
            refuses: Entry::is_near_surface,
            reason: |others| {
                format!("only edges are near the surfaces of all images: choose {}", others.or())
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
                format!("slices face the eye, and light passes between them: choose {}", others.or())
            },
        },
        super::IMAGES_HAVE_NO_LEVELS,
        super::IMAGES_KNOW_NO_SURROUNDINGS,
    ],
};
