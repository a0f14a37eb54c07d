//! Registry entry of quadrics from which distances are measured across the view.

use relief_core::registry::{Guarantee, Guarantees, Param, Publication, RayClass};

use super::{NO_ENTRY_OF_LIGHT, Paths, Proposal, QUADRIC_PARAMS, Refused, Shown};
use crate::entry::{Entry, Role};

/// Quadrics, with distances at right angles to the ray.
pub const ENTRY: Entry = Entry {
    name: "quadric-perpendicular",
    summary: "quadrics around base points, distances across the view: silhouettes, for sampling searches",
    publication: Publication {
        paper: "Oliveira and Policarpo 2005, An Efficient Representation for Surface Details",
        section: "3.1",
    },
    maps: &[],
    params: &[
        QUADRIC_PARAMS[0],
        QUADRIC_PARAMS[1],
        Param {
            name: "chords",
            summary: "pieces that a ray is cut into; best half the number of the search's steps",
            unit: "",
            min: 1.0,
            max: 64.0,
            default: 16.0,
            integer: true,
            names: &[],
        },
    ],
    states: &[],
    guarantee: Guarantees {
        view: Guarantee::Approximate,
        bent: Guarantee::Approximate,
        shadow: Guarantee::Approximate,
    },
    weakened: &[],
    argument: "The distance across the view is no quadratic in the metres along the ray, and \
        jumps to the distance along the normal where the line across misses the quadric. Chords \
        are right only at their ends and in their middle, where a search with twice as many steps \
        samples. Seen along its normal a relief is flat, as the distance across the view grows \
        beyond all bounds there.",
    role: Role::Surface(PATHS),
};

/// Paths of rays over quadrics.
const PATHS: Paths = Paths {
    rays: &[RayClass::Bent],
    proposal: Proposal::Polygons,
    shown: Shown::Relief,
    images: None,
    through_frame: true,
    refused: &[
        Refused {
            stage: "search",
            refuses: |entry| !entry.tracing().only_samples,
            reason: |_| {
                "the distance from the quadric jumps along a ray; only searches by samples can trace it"
                    .to_owned()
            },
        },
        Refused {
            stage: "detail",
            refuses: Entry::flattens,
            reason: |_| {
                "a chord may begin anywhere in the relief there, and a flatter one may be above it".to_owned()
            },
        },
        NO_ENTRY_OF_LIGHT,
    ],
};
