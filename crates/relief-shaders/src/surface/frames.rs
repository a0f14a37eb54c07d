//! Registry entry of the surface `frames`.

use relief_core::registry::{Guarantee, Guarantees, Publication, RayClass};

use super::{AskedImages, OF_IMAGES_REFUSE, Paths, Proposal, Shown};
use crate::entry::{Entry, Role};

/// The three images of a grid that look along the ray most.
pub const ENTRY: Entry = Entry {
    name: "frames",
    summary: "the three images of a grid with depth that look along the ray most",
    publication: Publication { paper: "Brucks 2018, Octahedral Impostors", section: "" },
    maps: &[],
    params: &[],
    states: &[],
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "In each of the three images rays are straight, as on the surface 'object'. \
        Other images are not used, so the object may reach farther back than all of them allow.",
    role: Role::Surface(PATHS),
};

/// Paths of rays through those images.
const PATHS: Paths = Paths {
    rays: &[RayClass::View, RayClass::Shadow],
    proposal: Proposal::Shells,
    shown: Shown::Object,
    images: Some(AskedImages::OfGrid),
    through_frame: false,
    refused: OF_IMAGES_REFUSE,
};
