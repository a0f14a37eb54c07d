//! Registry entry of motifs.

use relief_core::registry::{Guarantee, Guarantees, Publication};

use super::Solids;
use crate::entry::{Entry, Role};

/// A motif on the surface.
pub const ENTRY: Entry = Entry {
    name: "motif",
    summary: "a mesh in the space of a tile that repeats on the surface: links of mail, threads, blades",
    publication: Publication { paper: crate::SURVEY, section: "5.2" },
    maps: &[],
    params: &[],
    states: &[],
    guarantee: Guarantees::all(Guarantee::Exact),
    weakened: &[],
    argument: "What is hit is by definition the motif's triangles.",
    role: Role::Field(Solids::Motifs),
};
