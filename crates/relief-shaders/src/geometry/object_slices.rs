//! Registry entry of the geometry `object-slices`.

use relief_core::registry::{Guarantee, Guarantees, Param, Publication};

use super::{Geometry, GeometryRole};
use crate::Family;
use crate::entry::{Companion, Entry, Role};
use crate::slice::Slices;
use crate::surface::Shown;

/// Polygons through the box around an object.
pub const ENTRY: Entry = Entry {
    name: "object-slices",
    summary: "object: polygons through the box around an object of images with depth",
    publication: Publication { paper: crate::DEPTH_OBJECTS, section: "4.1" },
    maps: &[],
    params: &[Param::of_names(
        "pass",
        "product: each point of a slice reads all images; stencil: one pass per image, counted in a GPU's \
         stencil buffer, slice by slice from front to back",
        &["product", "stencil"],
    )],
    states: &[],
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "A slice is drawn where all images see something at least as high. Between two \
        slices there is nothing, so a ray sees the object up to the distance of two slices too far \
        behind, and passes thinner parts.",
    role: Role::Geometry(GeometryRole {
        family: Family::Object,
        shown: Shown::ObjectSlices,
        triangles: Some(|_, slices| Geometry::ObjectSlices(Slices::of(slices, 0.0))),
        stencil: Some("pass"),
        companions: &[
            Companion::new("surface", "object-slices"),
            Companion::new("object", "depth"),
            Companion::new("search", "none"),
            Companion::new("refine", "none"),
            Companion::new("shadow", "none"),
        ],
    }),
};
