//! Registry entry of the search `voxels`.

use relief_core::FoundState;
use relief_core::registry::{Guarantee, Guarantees, MapInput, MapSetting, Publication};

use crate::entry::{Entry, Role, TracingRole};
use crate::field::Solids;

/// The dual cells of a volume along the path, in order, without the empty ones.
pub const ENTRY: Entry = Entry {
    name: "voxels",
    summary: "visits the dual cells of a volume along the path, and skips empty ones by their distance",
    publication: Publication { paper: super::SURVEY, section: "5.2" },
    maps: &[MapInput::new("volume-distance", "").with(&[
        ("columns", MapSetting::Volume(0)),
        ("rows", MapSetting::Volume(1)),
        ("slices", MapSetting::Volume(2)),
    ])],
    params: &[super::CELLS_LIMIT],
    states: &[FoundState::Bracket],
    guarantee: Guarantees::all(Guarantee::Exact),
    weakened: &[],
    argument: "Every cell on the path is visited, also where a bent path turns, but for those that the map \
        promises to be empty: the path leaves their box in one step. In a cell the field is a \
        polynomial of degree 4 on the path. Its inflections and extrema part it into monotone pieces, so its \
        first root is found. In f32 the field of a cell is known to some ulp: rays that graze the surface by \
        less may be judged either way.",
    role: Role::Tracing(TracingRole { solids: Solids::Volumes, ..TracingRole::PLAIN }),
};
