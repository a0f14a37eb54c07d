//! Registry entry of the refinement `half-texel`.

use relief_core::FoundState;
use relief_core::registry::{Guarantee, Guarantees, Publication};

use crate::entry::{Entry, Role};

/// Interpolation between half a texel before and behind the hit of a texel's column.
pub const ENTRY: Entry = Entry {
    name: "half-texel",
    summary: "interpolates the gaps half a texel before and behind the hit of a texel's column",
    publication: Publication {
        paper: "Oh, Ki and Lee 2006, Pyramidal Displacement Mapping: A GPU based Artifacts-free Ray Tracing \
                Through an Image Pyramid",
        section: "3.3",
    },
    maps: &[],
    params: &[],
    states: &[FoundState::Below],
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "Right where the surface is a plane for a texel around; wrong where both places \
        are on the same side of the surface.",
    role: Role::Plain,
};
