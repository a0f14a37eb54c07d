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
        "the end of slices at equal depths; volume: at the sides of the space that the relief fills; border: \
         at the texture's border, which clips quads of one size over flat polygons",
        &["volume", "border"],
    )],
    states: &[],
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "A slice is drawn where the relief is at least as high. Between two slices there \
        is nothing, so a ray sees the relief up to the distance of two slices too far behind, and \
        passes thinner parts.",
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
