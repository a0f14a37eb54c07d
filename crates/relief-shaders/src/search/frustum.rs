//! Registry entry of the search `frustum`.

use relief_core::FoundState;
use relief_core::registry::{Guarantee, Guarantees, MapInput, Publication};

use crate::entry::{Entry, Role};

/// Over the empty frustum of each cell that the path comes to.
pub const ENTRY: Entry = Entry {
    name: "frustum",
    summary: "over the empty frustum on each cell that the path comes to",
    publication: Publication { paper: "Relief", section: "" },
    maps: &[MapInput::new("frustum", "slopes")],
    params: &[super::LIMIT],
    states: &[FoundState::Bracket],
    guarantee: Guarantees::all(Guarantee::Exact),
    weakened: &[],
    argument: "Over a cell a path above its top is above the surface, and after it as far as it is above the \
        frustum, as the map promises for all of the quadrant ahead; the gap to the frustum is concave, or \
        for paths that bend up the first root of each axis' quadratic is taken, so it closes once. Where the \
        path sinks to the top, the cell's patch is bounded in closed form as in `cells`. In f32 a step is \
        shortened by 8 roundings of the heights and, times the slope, of the places that it is computed \
        from. So the ray is known as well as to `cells`: rays that clear the surface by less than 2 \
        roundings of the path's heights and, times the map's steepest slope, of its places in texels may be \
        judged either way.",
    role: Role::Plain,
};
