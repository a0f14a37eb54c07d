//! Registry entry of the search `view-dependent-svd`.

use relief_core::FoundState;
use relief_core::registry::{Guarantee, Guarantees, MapInput, MapSetting, Publication};

use super::{AZIMUTHS, BENDS, DEPTH, ELEVATIONS, RANK};
use crate::entry::{Entry, Role, TracingRole};

/// The hit by place, direction and bend, out of factors of a smaller map.
pub const ENTRY: Entry = Entry {
    name: "view-dependent-svd",
    summary: "sums the way to the hit by place and direction, out of factors by a singular value \
              decomposition",
    publication: Publication {
        paper: "Wang et al. 2003, View-dependent displacement mapping; Szirmay-Kalos and Umenhoffer 2008",
        section: "6.3",
    },
    maps: &[MapInput::new("view-dependent", "").with(&[
        ("azimuths", MapSetting::Param("azimuths")),
        ("elevations", MapSetting::Param("elevations")),
        ("bends", MapSetting::Param("bends")),
        ("depth", MapSetting::Param("depth")),
        ("bits", MapSetting::Fixed(8.0)),
        ("rank", MapSetting::Param("rank")),
    ])],
    params: &[AZIMUTHS, ELEVATIONS, BENDS, DEPTH, RANK],
    states: &[FoundState::Above],
    guarantee: Guarantees {
        view: Guarantee::Approximate,
        bent: Guarantee::Approximate,
        shadow: Guarantee::Impossible,
    },
    weakened: &[],
    argument: "The sums come nearest to exact hits, from the centres of texels in some directions and bends, \
        of all sums of as many products. Each factor has 8 bits. Between texels and directions ways are \
        interpolated, although they jump at outlines. A ray that begins at the surface does not come in at \
        the top, so it cannot be looked up.",
    role: Role::Tracing(TracingRole { begins_at_top: true, ..TracingRole::PLAIN }),
};
