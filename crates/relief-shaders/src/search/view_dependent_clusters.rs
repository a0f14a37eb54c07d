//! Registry entry of the search `view-dependent-clusters`.

use relief_core::FoundState;
use relief_core::registry::{Guarantee, Guarantees, MapInput, MapSetting, Param, Publication};

use super::{AZIMUTHS, BENDS, DEPTH, ELEVATIONS, RANK};
use crate::entry::{Entry, Role, TracingRole};

/// The hit by place, direction and bend, out of non-negative factors of groups of texels.
pub const ENTRY: Entry = Entry {
    name: "view-dependent-clusters",
    summary: "sums the way to the hit by place and direction, out of non-negative factors of groups of \
              texels",
    publication: Publication {
        paper: "Wang and Dana 2005, Compression of view dependent displacement maps; Szirmay-Kalos and \
                Umenhoffer 2008",
        section: "6.3",
    },
    maps: &[MapInput::new("view-dependent", "").with(&[
        ("azimuths", MapSetting::Param("azimuths")),
        ("elevations", MapSetting::Param("elevations")),
        ("bends", MapSetting::Param("bends")),
        ("depth", MapSetting::Param("depth")),
        ("bits", MapSetting::Fixed(8.0)),
        ("rank", MapSetting::Param("rank")),
        ("clusters", MapSetting::Param("clusters")),
    ])],
    params: &[AZIMUTHS, ELEVATIONS, BENDS, DEPTH, TERMS, CLUSTERS],
    states: &[FoundState::Above],
    guarantee: Guarantees {
        view: Guarantee::Approximate,
        bent: Guarantee::Approximate,
        shadow: Guarantee::Impossible,
    },
    weakened: &[],
    argument: "The sums are near exact hits, from the centres of texels in some directions and bends: groups \
        of texels that are alike have factors of their own, which are not negative. Each factor has 8 bits. \
        Between texels and directions ways are interpolated, although they jump at outlines. A ray that \
        begins at the surface does not come in at the top, so it cannot be looked up.",
    role: Role::Tracing(TracingRole { begins_at_top: true, ..TracingRole::PLAIN }),
};

const TERMS: Param = Param { default: 8.0, ..RANK };

const CLUSTERS: Param = Param {
    name: "clusters",
    summary: "groups of texels that are alike, each with factors of its own",
    default: 8.0,
    ..RANK
};
