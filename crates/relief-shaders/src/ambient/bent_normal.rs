//! Registry entry of the ambient light `bent-normal`.

use relief_core::registry::{Guarantee, Guarantees, MapSetting, Publication};

use crate::entry::{Entry, Role};
use crate::scene_maps::{AZIMUTHS, scene_map};

/// Bent normals.
pub const ENTRY: Entry = Entry {
    name: "bent-normal",
    summary: "the visible sky as a baked vector, multiplied with the relief's own normal",
    publication: Publication { paper: "Landis 2002; Szirmay-Kalos and Umenhoffer 2008", section: "6.1" },
    maps: &[scene_map(
        "bent-normal",
        &[("azimuths", MapSetting::Param("azimuths")), ("scaled", MapSetting::Fixed(1.0))],
    )],
    params: &[AZIMUTHS],
    states: &[],
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "The vector is the sum of all directions to the sky, over pi. On a smooth \
        surface all of them lie before its normal, so the product of both is the light that \
        arrives from a uniform sky. On edges, where some lie behind it, the product is too low. \
        Between azimuths a mean stands for the horizon.",
    role: Role::Plain,
};
