//! Registry entry of the surface `slices`.

use relief_core::registry::{Entry, Guarantee, Guarantees, Publication, RayClass};

use super::{Names, Paths, Proposal, Refused, Shown};

/// Triangles through the relief, drawn where the stage `slices` says so.
pub const ENTRY: Entry = Entry {
    name: "slices",
    summary: "slices through the relief, drawn where the relief is as high as they are",
    publication: Publication { paper: crate::DEPTH_OBJECTS, section: "3" },
    maps: &[],
    params: &[],
    states: &[],
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "A ray ends on the first slice that passes the test, or by a refinement between that one and \
        the one before it: the first hit lies between both where the relief passed no slice in between.",
};

/// What it makes of rays.
pub const PATHS: Paths = Paths {
    rays: &[RayClass::View],
    proposal: Proposal::Polygons,
    shown: Shown::Slices,
    refused: &[
        super::SLICES_ARE_SEARCHED,
        Refused {
            stage: "refine",
            names: Names::AllBut(&["none", "secant"]),
            reason: "what is known are a slice and the one before it: choose 'none', or set 'slices.refine'",
        },
        Refused {
            stage: "detail",
            names: Names::These(&["fade"]),
            reason: "slices are made for the whole displacement, and the relief would be flatter",
        },
        super::NO_ENTRY_OF_LIGHT,
    ],
};
