//! Registry entry of the geometry `slices`.

use relief_core::registry::{Guarantee, Guarantees, Param, Publication};

use super::{Geometry, GeometryRole};
use crate::Family;
use crate::entry::{Companion, Entry, Role};
use crate::slice::Slices;
use crate::surface::Shown;

/// Polygons through the space that the relief fills.
pub const ENTRY: Entry = Entry {
    name: "slices",
    summary: "slices: polygons through the space above the base that the relief fills",
    publication: Publication { paper: crate::DEPTH_OBJECTS, section: "3" },
    maps: &[],
    params: &[Param::of_names(
        "clip",
        "where slices at equal depths end: at the sides of the space that the relief fills; or all are quads \
         of one size over flat polygons, which the texture's border clips",
        &["volume", "border"],
    )],
    states: &[],
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "A slice is drawn where the relief is as high as it is. Between two slices there is nothing, \
        so that a ray sees the relief as far behind it as slices are apart, and past what is thinner.",
    role: Role::Geometry(GeometryRole {
        family: Family::Slices,
        shown: Shown::Slices,
        triangles: Some(|[clip, ..], slices| Geometry::Slices(Slices::of(slices, clip))),
        stencil: None,
        companions: &[
            Companion::new("surface", "slices"),
            Companion::new("search", "none"),
            Companion::new("refine", "none"),
            Companion::new("shadow", "ray"),
        ],
    }),
};
