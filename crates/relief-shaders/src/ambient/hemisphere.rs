//! Registry entry of the ambient light `hemisphere`.

use relief_core::registry::{Guarantee, Guarantees, Publication};

use super::GROUND;
use crate::entry::{Entry, Role};

/// A sky above and ground below.
pub const ENTRY: Entry = Entry {
    name: "hemisphere",
    summary: "a sky above and ground below, by the normal's direction; needs no baked map",
    publication: Publication {
        paper: "Hargreaves 2003, Hemisphere Lighting With Radiosity Maps",
        section: "",
    },
    maps: &[],
    params: &[GROUND],
    states: &[],
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "Right for a surface that hides nothing of the sky and the ground, each of even \
        radiance and divided by the horizon. The light is linear in the normal: the mean normal in \
        a footprint gets the mean of the light.",
    role: Role::Plain,
};
