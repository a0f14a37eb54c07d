//! Registry entry of the refinement `half-texel`.

use relief_core::FoundState;
use relief_core::registry::{Guarantee, Guarantees, Publication};

use crate::entry::{Entry, Role};

/// Between half a texel before and behind the hit of a texel's column.
pub const ENTRY: Entry = Entry {
    name: "half-texel",
    summary: "between half a texel before and behind the hit of a texel's column, by the gaps there",
    publication: Publication {
        paper: "Oh, Ki and Lee 2006, Pyramidal Displacement Mapping: A GPU based Artifacts-free Ray Tracing Through an Image Pyramid",
        section: "3.3",
    },
    maps: &[],
    params: &[],
    states: &[FoundState::Below],
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "Right where the surface is a plane for a texel around; wrong where both places are on the \
        same side of it.",
    role: Role::Plain,
};
