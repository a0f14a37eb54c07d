//! Registry entry of the surface `facets`.

use relief_core::registry::{Guarantee, Guarantees, Publication, RayClass};

use super::{Paths, Proposal, Refused, Shown};
use crate::Variants;
use crate::entry::{Entry, Role};

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
    role: Role::Surface(PATHS),
};

/// What it makes of rays.
const PATHS: Paths = Paths {
    rays: &[RayClass::View],
    proposal: Proposal::Polygons,
    shown: Shown::Triangles,
    images: None,
    refused: &[
        Refused { stage: "search", refuses: super::is_active, reason: is_found },
        Refused { stage: "refine", refuses: super::is_active, reason: is_found },
        Refused {
            stage: "detail",
            refuses: Entry::flattens,
            reason: |_| "no relief lies on the triangles there that could be made flatter".to_owned(),
        },
        Refused {
            stage: "shadow",
            refuses: super::is_shadow_of_one_surface,
            reason: |others| {
                format!(
                    "it looks for what is in a light's way in a relief, and none lies on the triangles there; \
                     {} see triangles",
                    others.active().and()
                )
            },
        },
        Refused {
            stage: "ambient",
            refuses: |entry| entry.reads("bent-normal"),
            reason: |_| {
                "its vectors are told beside the base, and vertices know the normals of the relief alone"
                    .to_owned()
            },
        },
    ],
};

/// Why nothing is searched.
fn is_found(others: &Variants) -> String {
    format!(
        "a ray ends on the triangle that it meets, and nothing is left to be found: choose {}",
        others.or()
    )
}
