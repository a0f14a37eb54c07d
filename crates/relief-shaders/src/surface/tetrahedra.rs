//! Registry entry of shells in tetrahedra.

use relief_core::registry::{Guarantee, Guarantees, Publication, RayClass};

use super::{Paths, Proposal, SEGMENTS_REFUSE, Shown};
use crate::entry::{Entry, Role};

/// Shells in tetrahedra.
pub const ENTRY: Entry = Entry {
    name: "tetrahedra",
    summary: "the triangle's shell in three tetrahedra: silhouettes, up to three straight \
        segments per ray",
    publication: Publication { paper: super::SURVEY, section: "5.2" },
    maps: &[],
    params: &[],
    states: &[],
    guarantee: Guarantees { view: Guarantee::Exact, bent: Guarantee::Impossible, shadow: Guarantee::Exact },
    weakened: &[],
    argument: "A tetrahedron maps linearly onto texture coordinates and heights, so a ray is \
        straight in it. The displaced surface follows this map: it bends at the tetrahedra's \
        faces, and lies up to some texels beside the surface of interpolated normals. Neighbours \
        share their sides, cut along the same diagonal, and reach beyond them by the rounding of \
        the ray's place, so that nothing passes between. A segment that begins under the surface \
        by more than rounding begins where it comes out. Shadows go straight through the relief in \
        the frame of the hit, as on `plane`.",
    role: Role::Surface(PATHS),
};

/// Paths of rays through tetrahedra.
const PATHS: Paths = Paths {
    rays: &[RayClass::View, RayClass::Shadow],
    proposal: Proposal::Shells,
    shown: Shown::Relief,
    images: None,
    through_frame: false,
    refused: SEGMENTS_REFUSE,
};
