//! Registry entry of the geometry `remesh`.

use relief_core::registry::{Guarantee, Guarantees, Param, Publication};

use super::{Geometry, GeometryRole};
use crate::entry::{Entry, Role};

/// A vertex every so many pixels of the picture, displaced.
pub const ENTRY: Entry = Entry {
    name: "remesh",
    summary: "displaced triangles: the base divided anew for each view, as finely as its pixels are",
    publication: Publication {
        paper: "Gumhold and Hüttner 1999, Multiresolution Rendering With Displacement Mapping",
        section: "3",
    },
    maps: &[],
    params: PARAMS,
    states: &[],
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "Sides are divided by the voxels of the camera's grid space that their ends lie in, so that \
        neighbours have the same points there. Points are spaced on the base: where the relief is steep, or \
        nearer to the eye than the base, triangles are larger in the picture, and so they are where a pixel \
        is smaller than a quarter of a texel, finer than which no base is divided. Where levels of detail \
        are seen, a vertex has the height of the level whose texels are as wide as its voxel.",
    role: Role::Geometry(GeometryRole {
        triangles: Some(|[pixels, ..], _| Geometry::Pixels(pixels)),
        ..GeometryRole::DISPLACED
    }),
};

const PARAMS: &[Param] =
    &[super::spacing("pixels", "pixels of the picture between vertices of the base", 0.25, false)];
