//! Registry entry of the geometry `vertex`.

use relief_core::registry::{Guarantee, Guarantees, Param, Publication};

use super::{Geometry, GeometryRole};
use crate::entry::{Entry, Role};

/// A vertex every so many texels, displaced.
pub const ENTRY: Entry = Entry {
    name: "vertex",
    summary: "displaced triangles: the base with a vertex every so many texels",
    publication: Publication { paper: crate::SURVEY, section: "3.1" },
    maps: &[],
    params: PARAMS,
    states: &[],
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "Vertices lie on the displaced surface, with its normals. Between them it is replaced by \
        triangles: at one texel by two for the bilinear patch of four texels on a plane, elsewhere across \
        patches.",
    role: Role::Geometry(GeometryRole {
        triangles: Some(|[texels, ..], _| Geometry::Texels(texels as u32)),
        ..GeometryRole::DISPLACED
    }),
};

const PARAMS: &[Param] = &[super::spacing("texels", "texels of the height map between vertices", 1.0, true)];
