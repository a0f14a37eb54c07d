//! Registry entry of the ambient light `occlusion`.

use relief_core::registry::{Guarantee, Guarantees, MapSetting, Publication};

use crate::entry::{Entry, Role};
use crate::scene_maps::{AZIMUTHS, scene_map};

/// Ambient occlusion.
pub const ENTRY: Entry = Entry {
    name: "occlusion",
    summary: "the visible part of the sky, baked, as a factor on the light",
    publication: Publication {
        paper: "Zhukov, Iones and Kronin 1998; Szirmay-Kalos and Umenhoffer 2008",
        section: "6.1",
    },
    maps: &[scene_map("occlusion", &[("azimuths", MapSetting::Param("azimuths"))])],
    params: &[AZIMUTHS],
    states: &[],
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "The part holds for a plane parallel to the base: slopes receive as much as \
        level ground that sees as much of the sky. Between azimuths a mean stands for the \
        horizon.",
    role: Role::Plain,
};
