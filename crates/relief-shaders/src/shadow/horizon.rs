//! Registry entry of the shadow `horizon`.

use relief_core::registry::{Guarantee, Guarantees, MapSetting, Publication};

use super::ShadowRole;
use crate::entry::{Entry, Role};
use crate::scene_maps::{AZIMUTHS, scene_map};

/// Horizons, baked for some azimuths.
pub const ENTRY: Entry = Entry {
    name: "horizon",
    summary: "horizons baked for some azimuths and interpolated: equally fast for any light \
        and disc",
    publication: Publication { paper: "Max 1988; Szirmay-Kalos and Umenhoffer 2008", section: "6.1" },
    maps: &[scene_map("horizon", &[("azimuths", MapSetting::Param("azimuths"))])],
    params: &[AZIMUTHS],
    states: &[],
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "Where a horizon changes from one azimuth or one texel to the next, a mean of \
        both stands for it: more azimuths come nearer. The part of the disc above a straight \
        horizon is known. Height and texture coordinates along the light's direction give the \
        horizon in the hit's own frame, so that it follows a curved mesh. A light at a point is \
        taken to be behind all of the relief.",
    role: Role::Shadow(ShadowRole::Discs),
};
