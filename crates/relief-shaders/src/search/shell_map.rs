//! Registry entry of the search `shell-map`.

use relief_core::FoundState;
use relief_core::registry::{Guarantee, Guarantees, Param, Publication};

use crate::entry::{Entry, Role, TracingRole};
use crate::field::Solids;

/// The triangles of a motif in the tiles along the path.
pub const ENTRY: Entry = Entry {
    name: "shell-map",
    summary: "visits the tiles along the path in order, and in each the tree of a motif's triangles",
    publication: Publication {
        paper: "Porumbescu et al. 2005, Shell maps; Szirmay-Kalos and Umenhoffer 2008",
        section: "5.2",
    },
    maps: &[],
    params: &[LIMIT],
    states: &[FoundState::Bracket],
    guarantee: Guarantees { view: Guarantee::Exact, bent: Guarantee::Impossible, shadow: Guarantee::Exact },
    weakened: &[],
    argument: "A straight path meets a triangle where it meets it in the world, as the shell maps lines to \
        lines. Triangles that reach into several tiles are in the tree once for each, so the nearest one in \
        the first tile with any is the first. Seen along the path, both triangles at an edge judge by the \
        same two corners, and each reaches beyond the edge by some roundings, so that nothing passes between \
        them. Places are rounded to 2^-19 of a tile.",
    role: Role::Tracing(TracingRole { solids: Solids::Motifs, ..TracingRole::PLAIN }),
};

/// The parameter that ends a walk.
const LIMIT: Param = Param {
    summary: "most boxes visited before it gives up",
    unit: "boxes",
    default: 16_777_216.0,
    ..super::CELLS_LIMIT
};
