//! Registry entry of the surface `slices`.

use relief_core::registry::{Guarantee, Guarantees, Publication, RayClass};

use super::{Paths, Proposal, Refused, Shown};
use crate::entry::{Entry, Role};

/// Triangles through the relief, drawn where the stage `slices` says so.
pub const ENTRY: Entry = Entry {
    name: "slices",
    summary: "slices through the relief, drawn where the relief is at least as high",
    publication: Publication { paper: crate::DEPTH_OBJECTS, section: "3" },
    maps: &[],
    params: &[],
    states: &[],
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "A ray ends on the first slice that passes the test, or, with a refinement, \
        between that slice and the one before. The first hit lies between both, if the relief did \
        not pass a slice in between.",
    role: Role::Surface(PATHS),
};

/// Paths of rays on slices.
const PATHS: Paths = Paths {
    rays: &[RayClass::View],
    proposal: Proposal::Polygons,
    shown: Shown::Slices,
    images: None,
    through_frame: false,
    refused: &[
        super::SLICES_ARE_SEARCHED,
        Refused {
            stage: "refine",
            refuses: |entry| super::is_active(entry) && !entry.tracing().joins_slices,
            reason: |others| {
                format!(
                    "only a slice and the one before it are known: choose {}, or set 'slices.refine'",
                    others.idle().or()
                )
            },
        },
        Refused {
            stage: "detail",
            refuses: Entry::flattens,
            reason: |_| {
                "slices are made for the whole displacement, and the relief would be flatter".to_owned()
            },
        },
        super::NO_ENTRY_OF_LIGHT,
    ],
};
