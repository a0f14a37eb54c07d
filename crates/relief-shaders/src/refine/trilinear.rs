//! Registry entry of the refinement `trilinear`.

use relief_core::registry::{Guarantee, Guarantees, Publication};

use crate::entry::{Entry, Role, TracingRole};
use crate::field::Solids;
use crate::search::CELLS_LIMIT;

/// The first root of a volume's field in the interval, cell by cell.
pub const ENTRY: Entry = Entry {
    name: "trilinear",
    summary: "solves ray against the trilinear field of a volume, cell by cell",
    publication: Publication { paper: super::SURVEY, section: "5.2" },
    maps: &[],
    params: &[CELLS_LIMIT],
    states: super::ANY_INTERVAL,
    guarantee: Guarantees::all(Guarantee::Exact),
    weakened: &[],
    argument: "The cells of the interval are visited in order, and the first root of the field's polynomial \
        in a cell is found between its extrema, to the rounding of the field over its slope.",
    role: Role::Tracing(TracingRole { solids: Solids::Volumes, ..TracingRole::PLAIN }),
};
