//! Registry entry of the search `translucent`.

use relief_core::FoundState;
use relief_core::registry::{Guarantee, Guarantees, MapInput, MapSetting, Param, Publication};

use crate::entry::{Entry, Role, TracingRole};
use crate::field::Solids;

/// Light gathered along the path, through a volume that absorbs and scatters it.
pub const ENTRY: Entry = Entry {
    name: "translucent",
    summary: "gathers the light that a volume scatters toward the eye, and lets the rest through",
    publication: Publication { paper: super::SURVEY, section: "5.2" },
    maps: &[MapInput::new("volume-distance", "").with(&[
        ("columns", MapSetting::Volume(0)),
        ("rows", MapSetting::Volume(1)),
        ("slices", MapSetting::Volume(2)),
        ("above", MapSetting::Fixed(1e-6)),
    ])],
    params: &[
        Param {
            name: "extinction",
            summary: "optical depth of a metre of way where the volume is 1; scenes have 8 over the scale",
            unit: "per metre",
            min: 0.0,
            max: 1e12,
            default: 100.0,
            integer: false,
            names: &[],
        },
        Param {
            name: "looks",
            summary: "looks at the light that arrives, on a ray until nothing comes through; dense cells \
                      have more",
            unit: "",
            min: 1.0,
            max: 65536.0,
            default: 16.0,
            integer: true,
            names: &[],
        },
        Param { default: 16_384.0, ..super::CELLS_LIMIT },
    ],
    states: &[FoundState::Above],
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "In a cell the field is a polynomial of degree 4 on the path, whose integral is exact but \
        for rounding. So is the optical depth. The light that arrives is looked at once for each part of \
        the light that is scattered, in the middle of it, and at least in every other cell and in each \
        segment. It is scattered once, the same in all directions. Walks toward lights go straight on in \
        the frame of the place, as shadows do on `plane`.",
    role: Role::Tracing(TracingRole { gathers: true, solids: Solids::Volumes, ..TracingRole::PLAIN }),
};
