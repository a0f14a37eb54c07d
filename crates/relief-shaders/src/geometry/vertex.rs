//! Registry entry of the geometry `vertex`.

use relief_core::registry::{Guarantee, Guarantees, Param, Publication};

use super::{Geometry, GeometryRole};
use crate::entry::{Entry, Role};

/// Displaced triangles with vertices a fixed number of texels apart.
pub const ENTRY: Entry = Entry {
    name: "vertex",
    summary: "displaced triangles: the base with vertices at a fixed distance in texels",
    publication: Publication { paper: crate::SURVEY, section: "3.1" },
    maps: &[],
    params: PARAMS,
    states: &[],
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "Vertices lie on the displaced surface, with its normals. Between them triangles \
        replace it: on a plane, at one texel, two for the bilinear patch of four texels; elsewhere \
        across patches.",
    role: Role::Geometry(GeometryRole {
        triangles: Some(|[texels, ..], _| Geometry::Texels(texels as u32)),
        ..GeometryRole::DISPLACED
    }),
};

const PARAMS: &[Param] = &[super::spacing("texels", "texels of the height map between vertices", 1.0, true)];
