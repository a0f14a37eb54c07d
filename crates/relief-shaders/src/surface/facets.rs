//! Registry entry of the surface `facets`.

use relief_core::registry::{Entry, Guarantee, Guarantees, Publication, RayClass};

use super::{Names, Paths, Proposal, Refused, Shown};

/// Triangles without relief, shaded by the normals of their vertices.
pub const ENTRY: Entry = Entry {
    name: "facets",
    summary: "the triangles as they are, with their vertices' normals: for what is displaced already",
    publication: Publication { paper: super::SURVEY, section: "3" },
    maps: &[],
    params: &[],
    states: &[],
    guarantee: Guarantees { view: Guarantee::Exact, bent: Guarantee::Impossible, shadow: Guarantee::Exact },
    weakened: &[],
    argument: "A ray ends where it meets the plane of its triangle, to the rounding of f32, and nowhere \
        else.",
};

/// What it makes of rays.
pub const PATHS: Paths = Paths {
    rays: &[RayClass::View],
    proposal: Proposal::Polygons,
    shown: Shown::Triangles,
    refused: &[
        Refused { stage: "search", names: Names::AllBut(&["none"]), reason: FOUND },
        Refused { stage: "refine", names: Names::AllBut(&["none"]), reason: FOUND },
        Refused {
            stage: "detail",
            names: Names::These(&["fade"]),
            reason: "no relief lies on the triangles there that could be made flatter",
        },
        Refused {
            stage: "shadow",
            names: Names::AllBut(&["none", "map", "scene"]),
            reason: "it looks for what is in a light's way in a relief, and none lies on the triangles \
                there; 'map' and 'scene' see triangles",
        },
        Refused {
            stage: "ambient",
            names: Names::Reading("bent-normal"),
            reason: "its vectors are told beside the base, and vertices know the normals of the relief alone",
        },
    ],
};

/// Why nothing is searched.
const FOUND: &str =
    "a ray ends on the triangle that it meets, and nothing is left to be found: choose 'none'";
