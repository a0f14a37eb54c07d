//! Registry entry of objects of images with depth.

use relief_core::registry::{Guarantee, Guarantees, Publication};

use super::{ObjectRole, Solid};
use crate::entry::{Companion, Entry, Role};

/// The intersection of the solids of all images.
pub const ENTRY: Entry = Entry {
    name: "depth",
    summary: "the intersection of what all images with depth show",
    publication: Publication { paper: crate::DEPTH_OBJECTS, section: "4" },
    maps: &[],
    params: super::PARAMS,
    states: &[],
    guarantee: Guarantees::all(Guarantee::Exact),
    weakened: &[],
    argument: "A ray only leaves a point that some image shows as empty, for the first one \
        beyond that this image does not. So it never passes a point of the intersection, and where \
        all images agree is one, to two millionths of the distance. Searches that may miss \
        surfaces weaken that.",
    role: Role::Object(ObjectRole {
        solid: Solid::Depth,
        companions: &[Companion::new("search", "pyramid"), Companion::new("refine", "patch")],
    }),
};
