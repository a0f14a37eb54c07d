//! Registry entry of the search `dilation-erosion`.

use relief_core::FoundState;
use relief_core::registry::{Guarantee, Guarantees, MapInput, MapSetting, Param, Publication, Weakened};

use crate::entry::{Entry, Role};

/// Steps over the greatest height around each cell.
pub const ENTRY: Entry = Entry {
    name: "dilation-erosion",
    summary: "steps over the greatest height around each cell; visits each cell between it and \
        the least",
    publication: Publication { paper: super::SURVEY, section: "4.3.2" },
    maps: &[MapInput::new("dilation-erosion", "").with(&[("radius", MapSetting::Param("radius"))])],
    params: &[
        super::LIMIT,
        super::PATCHES,
        Param {
            name: "radius",
            summary: "distance around a cell within which heights count, along both axes",
            unit: "texels",
            min: 0.0,
            max: 16_384.0,
            default: 8.0,
            integer: true,
            names: &[],
        },
    ],
    states: &[FoundState::Bracket],
    guarantee: Guarantees::all(Guarantee::Exact),
    weakened: &[Weakened { param: "patches", value: 0.0, to: Guarantees::all(Guarantee::Approximate) }],
    argument: "The dilation of a cell bounds the surface within the radius around it. So a \
        path above it meets nothing until it sinks to the dilation or leaves the window. Where it \
        does so within the cell, the cell's patch is bounded in closed form as in `cells`. In f32 \
        a path must stay above the dilation by 8 roundings of its heights. So the ray is known as \
        well as to `cells`: rays that clear the surface by less than 2 roundings of the path's \
        heights and, times the map's steepest slope, of its places in texels may be judged either \
        way. Without patches a bracket ends below the erosion and may hold several crossings, and \
        what dips less is passed.",
    role: Role::Plain,
};
