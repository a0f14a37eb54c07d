//! Registry entry of volumes.

use relief_core::registry::{Guarantee, Guarantees, Publication};

use super::Solids;
use crate::entry::{Entry, Role};

/// A volume on the surface.
pub const ENTRY: Entry = Entry {
    name: "volume",
    summary: "what is solid in a volume of voxels, with overhangs, threads and hollows",
    publication: Publication { paper: crate::SURVEY, section: "5.2" },
    maps: &[],
    params: &[],
    states: &[],
    guarantee: Guarantees::all(Guarantee::Exact),
    weakened: &[],
    argument: "The solid is by definition where the trilinear field is half or more.",
    role: Role::Field(Solids::Volumes),
};
