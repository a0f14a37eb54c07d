//! Registry entry of the search `view-dependent`.

use relief_core::FoundState;
use relief_core::registry::{Guarantee, Guarantees, MapInput, MapSetting, Publication};

use super::{AZIMUTHS, BENDS, DEPTH, ELEVATIONS};
use crate::entry::{Entry, Role, TracingRole};

/// The hit by place, direction and bend, looked up.
pub const ENTRY: Entry = Entry {
    name: "view-dependent",
    summary: "looks up the hit by place and direction, once a ray",
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
    ])],
    params: &[AZIMUTHS, ELEVATIONS, BENDS, DEPTH],
    states: &[FoundState::Above],
    guarantee: Guarantees {
        view: Guarantee::Approximate,
        bent: Guarantee::Approximate,
        shadow: Guarantee::Impossible,
    },
    weakened: &[],
    argument: "The map holds exact hits from the centres of texels in some directions and bends, in 8 bits. \
        Between them ways are interpolated, although they jump at outlines; whether there is a hit at all, \
        the greater part of the weights decides. A ray that begins at the surface does not come in at the \
        top, so it cannot be looked up.",
    role: Role::Tracing(TracingRole { begins_at_top: true, ..TracingRole::PLAIN }),
};
