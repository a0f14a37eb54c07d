//! Registry entry of visual hulls.

use relief_core::registry::{Guarantee, Guarantees, Publication};

use super::{ObjectRole, Solid};
use crate::entry::{Companion, Entry, Role};

/// The visual hull: the intersection of all silhouettes.
pub const ENTRY: Entry = Entry {
    name: "hull",
    summary: "the visual hull: the intersection of all silhouettes",
    publication: Publication { paper: crate::DEPTH_OBJECTS, section: "5" },
    maps: &[],
    params: super::PARAMS,
    states: &[],
    guarantee: Guarantees::all(Guarantee::Exact),
    weakened: &[],
    argument: "A ray only leaves a point that some silhouette does not hold, as for `depth`. \
        Along it the mask of a cell is a quadratic, whose first place at a half is found without \
        sampling. Silhouettes know no depth: the hull ends where the images' heights do.",
    role: Role::Object(ObjectRole {
        solid: Solid::Hull,
        companions: &[Companion::new("search", "cells"), Companion::new("refine", "patch")],
    }),
};
