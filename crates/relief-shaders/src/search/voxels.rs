//! Registry entry of the search `voxels`.

use relief_core::FoundState;
use relief_core::registry::{Guarantee, Guarantees, Publication};

use crate::entry::{Entry, Role, TracingRole};
use crate::field::Solids;

/// Every dual cell of a volume along the path, in order.
pub const ENTRY: Entry = Entry {
    name: "voxels",
    summary: "visits every dual cell of a volume along the path, in order",
    publication: Publication { paper: super::SURVEY, section: "5.2" },
    maps: &[],
    params: &[super::CELLS_LIMIT],
    states: &[FoundState::Bracket],
    guarantee: Guarantees::all(Guarantee::Exact),
    weakened: &[],
    argument: "Every cell on the path is visited, also where a bent path turns. In a cell the field is a \
        polynomial of degree 4 on the path. Its inflections and extrema part it into monotone pieces, so its \
        first root is found. In f32 the field of a cell is known to some ulp: rays that graze the surface by \
        less may be judged either way.",
    role: Role::Tracing(TracingRole { solids: Solids::Volumes, ..TracingRole::PLAIN }),
};
