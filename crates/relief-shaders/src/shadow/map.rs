//! Registry entry of the shadow `map`.

use relief_core::registry::{Guarantee, Guarantees, Param, Publication};

use super::ShadowRole;
use crate::entry::{Entry, Role};

/// A shadow map.
pub const ENTRY: Entry = Entry {
    name: "map",
    summary: "shadow maps: all surfaces of the scene cast shadows on each other",
    publication: Publication {
        paper: "Williams 1978, Casting curved shadows; Oliveira and Policarpo 2005",
        section: "3.5",
    },
    maps: &[],
    params: &[
        Param {
            name: "size",
            summary: "most texels of a shadow map's side; small frames take fewer; the largest \
                value of all surfaces counts",
            unit: "",
            min: 16.0,
            max: 16_384.0,
            default: 2_048.0,
            integer: true,
            names: &[],
        },
        Param {
            name: "cascades",
            summary: "shadow maps of a distant light, each for a part of the view; the largest \
                value of all surfaces counts",
            unit: "",
            min: 1.0,
            max: super::MAX_CASCADES as f32,
            default: 1.0,
            integer: true,
            names: &[],
        },
        Param {
            name: "filter",
            summary: "width of the square in which texels are compared and averaged, for a map of the full \
                      size",
            unit: "texels",
            min: 0.0,
            max: 16.0,
            default: 1.0,
            integer: false,
            names: &[],
        },
        Param {
            name: "bias",
            summary: "height above the surface at which a point is compared, so that it does \
                not shadow itself",
            unit: "texels",
            min: 0.0,
            max: 64.0,
            default: 0.5,
            integer: false,
            names: &[],
        },
    ],
    states: &[],
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "Depths come from the first hits of the light's rays in the finest level of \
        detail, by the surface's own search. A point is compared in the plane that touches the \
        surface's patch, so that a straight slope does not shadow itself. Errors come from between \
        two of the light's rays: a shadow's edge is known to about a texel. A point outside all \
        shadow maps is lit.",
    role: Role::Shadow(ShadowRole::LightViews { size: "size", cascades: "cascades" }),
};
