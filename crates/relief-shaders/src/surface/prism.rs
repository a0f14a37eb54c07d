//! Registry entry of shells as they are.

use relief_core::registry::{Guarantee, Guarantees, Param, Publication, RayClass};

use super::{LIFT, Paths, Proposal, SEGMENTS_REFUSE, Shown};
use crate::entry::{Entry, Role};

/// Shells with normals interpolated over the triangle.
pub const ENTRY: Entry = Entry {
    name: "prism",
    summary: "the triangle's shell, spanned by interpolated normals: silhouettes, with bent rays",
    publication: Publication {
        paper: "Ogaki 2023, Nonlinear Ray Tracing for Displacement and Shell Mapping",
        section: "",
    },
    maps: &[],
    params: &[
        Param {
            name: "tolerance",
            summary: "greatest distance of a segment from its ray, before the hit is corrected",
            unit: "texels",
            min: 0.000_976_562_5,
            max: 1.0,
            default: 0.05,
            integer: false,
            names: &[],
        },
        LIFT,
    ],
    states: &[],
    guarantee: Guarantees { view: Guarantee::Exact, bent: Guarantee::Exact, shadow: Guarantee::Exact },
    weakened: &[],
    argument: "The displaced surface follows normals that are interpolated over the triangle \
        and not normalised; neighbours agree on them along their common side. A ray is cut into \
        chords whose ends lie on its way through the shell and whose heights bend with it, in a \
        number that the tolerance gives; what they miss is at most that wide. The hit is moved by \
        the chord's distance from the ray. Chords reach beyond the sides by rounding and \
        tolerance, so that nothing passes between neighbours. In a shell that overlaps itself the \
        ray's line meets the flat triangle at each offset along the normals in one point. The \
        weights of that point are quotients of quadratics in the offset. All pieces of the curve \
        inside the triangle are cut into chords, and the nearest hit of all counts. Shadows go \
        straight through the relief in the frame of the hit, as on `plane`.",
    role: Role::Surface(PATHS),
};

/// Paths of rays through a shell.
const PATHS: Paths = Paths {
    rays: &[RayClass::View, RayClass::Bent, RayClass::Shadow],
    proposal: Proposal::Shells,
    shown: Shown::Relief,
    images: None,
    through_frame: false,
    refused: SEGMENTS_REFUSE,
};
