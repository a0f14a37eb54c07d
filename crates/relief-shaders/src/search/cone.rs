//! Registry entry of the search `cone`.

use relief_core::FoundState;
use relief_core::registry::{Guarantee, Guarantees, MapInput, MapSetting, Publication};

use crate::entry::{Entry, Role};

/// Cone stepping over the empty cone on the texel nearest to the path.
pub const ENTRY: Entry = Entry {
    name: "cone",
    summary: "steps over the empty cone on each texel along the path",
    publication: Publication { paper: super::SURVEY, section: "4.3.5" },
    maps: &[MapInput::new("cone", "").with(&[("apex", MapSetting::Fixed(0.0))])],
    params: &[super::LIMIT],
    states: &[FoundState::Bracket],
    guarantee: Guarantees::all(Guarantee::Exact),
    weakened: &[],
    argument: "The cone stays on the centre of the texel that it was baked for and holds no \
        surface. So a path inside it, anywhere over the texel, is above the surface until it \
        leaves the cone. A cone is convex: a line that is inside at both ends of a step is inside \
        between, and a path that bends stays above its tangent or its chord. Where the path is \
        outside, or leaves the cone within the cell, the cell's patch is bounded in closed form as \
        in `cells`. In f32 both ends of a step must be inside by 8 roundings of the heights and, \
        times the slope, of the places. So the ray is known as well as to `cells`: rays that clear \
        the surface by less than 2 roundings of the path's heights and, times the map's steepest \
        slope, of its places in texels may be judged either way.",
    role: Role::Plain,
};
