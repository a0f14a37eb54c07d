//! Registry entry of the shadow `scene`.

use relief_core::registry::{Guarantee, Guarantees, Param, Publication};

use super::ShadowRole;
use crate::entry::{Entry, Role};

/// Rays through the whole scene.
pub const ENTRY: Entry = Entry {
    name: "scene",
    summary: "rays from the light through all surfaces of the scene, on the CPU",
    publication: Publication { paper: "Relief", section: "" },
    maps: &[],
    params: &[Param {
        name: "samples",
        summary: "rays to each light's disc; 1 goes to its centre",
        unit: "",
        min: 1.0,
        max: 4_096.0,
        default: 1.0,
        integer: true,
        names: &[],
    }],
    states: &[],
    guarantee: Guarantees::all(Guarantee::Exact),
    weakened: &[],
    argument: "A ray from the light ends a little before its target; what it hits before \
        blocks the light. It is traced like the camera's rays, in the finest level of detail, by \
        each surface's own search, and is as exact. Segments run at most a hundredth of a texel \
        beside it. The ray ends three thousandths of the displacement and the rounding of places \
        early, so that no point shadows itself. On the surface `plane` each polygon has a relief \
        of its own: where polygons meet at an angle, rays from elsewhere see another relief.",
    role: Role::Shadow(ShadowRole::ThroughScene { rays: "samples" }),
};
