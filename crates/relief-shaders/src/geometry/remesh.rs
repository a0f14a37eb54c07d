//! Registry entry of the geometry `remesh`.

use relief_core::registry::{Guarantee, Guarantees, Param, Publication};

use super::{Geometry, GeometryRole};
use crate::entry::{Entry, Role};

/// Displaced triangles, a fixed number of the picture's pixels wide.
pub const ENTRY: Entry = Entry {
    name: "remesh",
    summary: "displaced triangles: the base divided anew for each view, as fine as its pixels",
    publication: Publication {
        paper: "Gumhold and Hüttner 1999, Multiresolution Rendering With Displacement Mapping",
        section: "3",
    },
    maps: &[],
    params: PARAMS,
    states: &[],
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "Sides are divided by the voxels of the camera's grid space that their ends lie \
        in, so that neighbours have the same points there. Points are spaced on the base. So \
        triangles are larger in the picture where the relief is steep, or nearer to the eye than \
        the base. They also are where a pixel is smaller than a quarter of a texel; no base is \
        divided finer than that. With levels of detail a vertex has the height of the level whose \
        texels are as wide as its voxel.",
    role: Role::Geometry(GeometryRole {
        triangles: Some(|[pixels, ..], _| Geometry::Pixels(pixels)),
        ..GeometryRole::DISPLACED
    }),
};

const PARAMS: &[Param] =
    &[super::spacing("pixels", "pixels of the picture between vertices of the base", 0.25, false)];
