//! Registry entry of the surface `object`.

use relief_core::registry::{Guarantee, Guarantees, Publication, RayClass};

use super::{AskedImages, OF_IMAGES_REFUSE, Paths, Proposal, Shown};
use crate::entry::{Entry, Role};

/// Images of an object. Each is a relief on a plane of its own.
pub const ENTRY: Entry = Entry {
    name: "object",
    summary: "images with depth: each is a relief that the ray crosses in a straight line",
    publication: Publication { paper: crate::DEPTH_OBJECTS, section: "4" },
    maps: &[],
    params: &[],
    states: &[],
    guarantee: Guarantees::all(Guarantee::Exact),
    weakened: &[],
    argument: "An image's texture coordinates and heights are linear in the place, so that \
        rays are straight in each. They are cut off where an image ends and just above its lowest \
        height, where it sees nothing.",
    role: Role::Surface(PATHS),
};

/// Paths of rays through the images.
const PATHS: Paths = Paths {
    rays: &[RayClass::View, RayClass::Shadow],
    proposal: Proposal::Shells,
    shown: Shown::Object,
    images: Some(AskedImages::All),
    through_frame: false,
    refused: OF_IMAGES_REFUSE,
};
