//! Registry entry of the search `pyramid`.

use relief_core::FoundState;
use relief_core::registry::{Guarantee, Guarantees, MapInput, MapLevels, MapSetting, Publication};

use crate::entry::{Entry, Role, TracingRole};

/// Steps over the nodes of the maximum pyramid that the path stays above.
pub const ENTRY: Entry = Entry {
    name: "pyramid",
    summary: "skips the nodes of the maximum pyramid that the path stays above",
    publication: Publication { paper: super::SURVEY, section: "4.3.3" },
    // The finest level is the height map's own; four heights are read together. With levels of
    // detail, the nodes bound the surface of each level.
    maps: &[MapInput {
        levels: MapLevels::ChainFrom(1),
        settings: &[("over", MapSetting::Levels(0.0, 2.0))],
        ..MapInput::new("pyramid", "")
    }],
    params: &[super::LIMIT],
    states: &[FoundState::Bracket],
    guarantee: Guarantees::all(Guarantee::Exact),
    weakened: &[],
    argument: "A node's maximum bounds the surface over its cells. So a path that stays above \
        it meets nothing until it leaves the node, and a path that sinks to it meets nothing until \
        there. Where the path comes down to a single cell, the cell's patch is bounded in closed \
        form as in `cells`. In f32 a path must stay above a node by 8 roundings of its heights. So \
        the ray is known as well as to `cells`: rays that clear the surface by less than 2 \
        roundings of the path's heights and, times the map's steepest slope, of its places in \
        texels may be judged either way.",
    role: Role::Tracing(TracingRole { serves_images: true, ..TracingRole::PLAIN }),
};
