//! Registry entry of visual hulls.

use relief_core::registry::{Guarantee, Guarantees, Publication};

use super::{ObjectRole, Solid};
use crate::entry::{Companion, Entry, Role};

/// What lies in all silhouettes.
pub const ENTRY: Entry = Entry {
    name: "hull",
    summary: "the visual hull: what lies in all silhouettes",
    publication: Publication { paper: crate::DEPTH_OBJECTS, section: "5" },
    maps: &[],
    params: super::PARAMS,
    states: &[],
    guarantee: Guarantees::all(Guarantee::Exact),
    weakened: &[],
    argument: "As with depths a ray only goes on from a point that some silhouette does not hold. Along it \
        the mask of a cell is a quadratic, whose first place at a half is found without sampling. \
        Silhouettes know no depth: the hull ends where the images' heights do.",
    role: Role::Object(ObjectRole {
        solid: Solid::Hull,
        companions: &[Companion::new("search", "cells"), Companion::new("refine", "patch")],
    }),
};
