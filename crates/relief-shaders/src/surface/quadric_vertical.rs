//! Registry entry of quadrics over which heights are measured along the normal.

use relief_core::registry::{Guarantee, Guarantees, Publication, RayClass};

use super::{NO_ENTRY_OF_LIGHT, Paths, Proposal, QUADRIC_PARAMS, Shown};
use crate::entry::{Entry, Role};

/// Quadrics, with heights along the normal of the base point.
pub const ENTRY: Entry = Entry {
    name: "quadric-vertical",
    summary: "quadrics around base points, heights along the normal: silhouettes, one bent \
        segment per ray",
    publication: Publication {
        paper: "Oliveira and Policarpo 2005, An Efficient Representation for Surface Details",
        section: "3.2",
    },
    maps: &[],
    params: QUADRIC_PARAMS,
    states: &[],
    guarantee: Guarantees { view: Guarantee::Exact, bent: Guarantee::Exact, shadow: Guarantee::Approximate },
    weakened: &[],
    argument: "In the frame of the base point the ray's height over the quadric is a quadratic \
        in the metres along it, which the path holds as it is. The path's ends are roots without \
        cancellation: the entry at height 1 to a rounding of f32, the exit a millionth of the \
        relief below height 0 or where the path is above the relief again, which is a silhouette. \
        The quadrics themselves approximate the base near the point, and the less well the farther \
        a ray runs. Relief is seen where its triangle is. Where it would rise above the base, the \
        base moves out along its normals. Shadow rays are straight in the quadric's frame at the \
        hit.",
    role: Role::Surface(PATHS),
};

/// Paths of rays over quadrics.
const PATHS: Paths = Paths {
    rays: &[RayClass::View, RayClass::Bent],
    proposal: Proposal::Polygons,
    shown: Shown::Relief,
    images: None,
    through_frame: true,
    refused: &[NO_ENTRY_OF_LIGHT],
};
