//! Registry entry of the refinement `patch`.

use relief_core::registry::{Guarantee, Guarantees, Publication};

use crate::entry::{Entry, Role, TracingRole};
use crate::search::CELLS_LIMIT;

/// The exact refinement: ray against bilinear patch in closed form, cell by cell.
pub const ENTRY: Entry = Entry {
    name: "patch",
    summary: "solves ray against bilinear patch in closed form, cell by cell",
    publication: Publication { paper: super::SURVEY, section: "4.3.1" },
    maps: &[],
    params: &[CELLS_LIMIT],
    states: super::ANY_INTERVAL,
    guarantee: Guarantees::all(Guarantee::Exact),
    weakened: &[],
    argument: "Each cell's gap is a quadratic solved in closed form with the stable formula; cells are \
        visited in order, so the first root is the first crossing of the interval. In f32 a root is known to \
        the gap's rounding over its slope.",
    role: Role::Tracing(TracingRole { is_reference: true, serves_images: true, ..TracingRole::PLAIN }),
};
