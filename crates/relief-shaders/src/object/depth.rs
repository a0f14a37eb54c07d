//! Registry entry of objects of images with depth.

use relief_core::registry::{Guarantee, Guarantees, Publication};

use super::{ObjectRole, Solid};
use crate::entry::{Companion, Entry, Role};

/// What all images see.
pub const ENTRY: Entry = Entry {
    name: "depth",
    summary: "the intersection of what images with depth see",
    publication: Publication { paper: crate::DEPTH_OBJECTS, section: "4" },
    maps: &[],
    params: super::PARAMS,
    states: &[],
    guarantee: Guarantees::all(Guarantee::Exact),
    weakened: &[],
    argument: "A ray only goes on from a point that some image says is empty, to the first one beyond that \
        it does not say so of. So it never passes a point of the intersection, and where all images agree is \
        one, to two millionths of the distance; searches that may pass what they look for weaken that.",
    role: Role::Object(ObjectRole {
        solid: Solid::Depth,
        companions: &[Companion::new("search", "pyramid"), Companion::new("refine", "patch")],
    }),
};
