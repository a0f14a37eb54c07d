//! Registry entry of the surface `facets`.

use relief_core::registry::{Guarantee, Guarantees, Publication, RayClass};

use super::{Paths, Proposal, Refused, Shown};
use crate::Variants;
use crate::entry::{Entry, Role};

/// Triangles without relief, shaded by the normals of their vertices.
pub const ENTRY: Entry = Entry {
    name: "facets",
    summary: "the triangles as they are, with their vertices' normals, for displaced geometry",
    publication: Publication { paper: super::SURVEY, section: "3" },
    maps: &[],
    params: &[],
    states: &[],
    guarantee: Guarantees { view: Guarantee::Exact, bent: Guarantee::Impossible, shadow: Guarantee::Exact },
    weakened: &[],
    argument: "A ray ends where it meets the plane of its triangle, to the rounding of f32, \
        and nowhere else.",
    role: Role::Surface(PATHS),
};

/// Paths of rays on triangles: none through a relief.
const PATHS: Paths = Paths {
    rays: &[RayClass::View],
    proposal: Proposal::Polygons,
    shown: Shown::Triangles,
    images: None,
    through_frame: false,
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
                    "it tests a relief for shadows, and none lies on the triangles there; \
                     {} see triangles",
                    others.active().and()
                )
            },
        },
        Refused {
            stage: "ambient",
            refuses: |entry| entry.reads("bent-normal"),
            reason: |_| {
                "its vectors are relative to the base, and displaced vertices have only the relief's normals"
                    .to_owned()
            },
        },
    ],
};

/// Reason why nothing is searched.
fn is_found(others: &Variants) -> String {
    format!(
        "a ray ends on the triangle that it meets, and there is nothing to search: choose {}",
        others.or()
    )
}
