//! Registry entry of the surface `frames`.

use relief_core::registry::{Guarantee, Guarantees, Publication, RayClass};

use super::{AskedImages, OF_IMAGES_REFUSE, Paths, Proposal, Shown};
use crate::entry::{Entry, Role};

/// Of the images of an object that make a grid the three that look along the ray most.
pub const ENTRY: Entry = Entry {
    name: "frames",
    summary: "of a grid of images with depth the three that look along the ray most",
    publication: Publication { paper: "Brucks 2018, Octahedral Impostors", section: "" },
    maps: &[],
    params: &[],
    states: &[],
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "In each of the three rays are straight, as on the surface 'object'. What other images know of \
        the object is not asked, so that it may reach farther back than all of them say.",
    role: Role::Surface(PATHS),
};

/// What it makes of rays.
const PATHS: Paths = Paths {
    rays: &[RayClass::View, RayClass::Shadow],
    proposal: Proposal::Shells,
    shown: Shown::Object,
    images: Some(AskedImages::OfGrid),
    refused: OF_IMAGES_REFUSE,
};
