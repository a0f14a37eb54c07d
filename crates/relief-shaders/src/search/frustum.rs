//! Registry entry of the search `frustum`.

use relief_core::FoundState;
use relief_core::registry::{Guarantee, Guarantees, MapInput, Publication};

use crate::entry::{Entry, Role};

/// Steps over the empty frustum of each cell along the path.
pub const ENTRY: Entry = Entry {
    name: "frustum",
    summary: "steps over the empty frustum on each cell along the path",
    publication: Publication { paper: "Relief", section: "" },
    maps: &[MapInput::new("frustum", "slopes")],
    params: &[super::LIMIT],
    states: &[FoundState::Bracket],
    guarantee: Guarantees::all(Guarantee::Exact),
    weakened: &[],
    argument: "Over a cell a path above its top is above the surface. Behind the cell it is so \
        as long as it is above the frustum, as the map promises for all of the quadrant ahead. The \
        gap to the frustum is concave, so it closes once; for paths that bend up the first root of \
        each axis' quadratic is taken. Where the path sinks to the top, the cell's patch is \
        bounded in closed form as in `cells`. In f32 a step is shortened by 8 roundings of the \
        heights and, times the slope, of the places that it is computed from. So the ray is known \
        as well as to `cells`: rays that clear the surface by less than 2 roundings of the path's \
        heights and, times the map's steepest slope, of its places in texels may be judged either \
        way.",
    role: Role::Plain,
};
