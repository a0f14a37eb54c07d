//! Registry entry of the search `generalised`.

use relief_core::FoundState;
use relief_core::registry::{Guarantee, Guarantees, MapInput, MapSetting, Param, Publication};

use crate::entry::{Entry, Role, TracingRole};
use crate::field::Solids;

/// The distance to the solid by place and direction, looked up.
pub const ENTRY: Entry = Entry {
    name: "generalised",
    summary: "looks up the way to the solid of a volume by place and direction, once a segment",
    publication: Publication {
        paper: "Wang et al. 2004, Generalized displacement maps; Szirmay-Kalos and Umenhoffer 2008",
        section: "6.3",
    },
    maps: &[MapInput::new("generalised", "").with(&[
        ("columns", MapSetting::Volume(0)),
        ("rows", MapSetting::Volume(1)),
        ("slices", MapSetting::Volume(2)),
        ("azimuths", MapSetting::Param("azimuths")),
        ("elevations", MapSetting::Param("elevations")),
        ("way", MapSetting::Param("way")),
        ("bits", MapSetting::Fixed(8.0)),
    ])],
    params: &[super::LIMIT, AZIMUTHS, ELEVATIONS, WAY],
    states: &[FoundState::Above],
    guarantee: Guarantees {
        view: Guarantee::Approximate,
        bent: Guarantee::Approximate,
        shadow: Guarantee::Impossible,
    },
    weakened: &[],
    argument: "The map holds exact ways from the centres of voxels in some directions, in 8 bits. Between \
        them ways are interpolated, although they jump at outlines; whether there is a hit at all, the \
        greater part of the weights decides. A bent path is taken for its tangent. A ray that begins at the \
        surface begins between voxels inside and outside, so it cannot be told from one that hits.",
    role: Role::Tracing(TracingRole { solids: Solids::Volumes, ..TracingRole::PLAIN }),
};

const AZIMUTHS: Param = Param {
    name: "azimuths",
    summary: "directions around the base's normal that are baked",
    unit: "",
    min: 4.0,
    max: 64.0,
    default: 16.0,
    integer: true,
    names: &[],
};

const ELEVATIONS: Param = Param {
    name: "elevations",
    summary: "directions from straight down to straight up that are baked; layers are azimuths times these",
    min: 2.0,
    ..AZIMUTHS
};

const WAY: Param = Param {
    name: "way",
    summary: "longest way that is baked; longer ones take another look-up",
    unit: "voxels",
    min: 4.0,
    max: 1024.0,
    default: 64.0,
    integer: true,
    names: &[],
};
