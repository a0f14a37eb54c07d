//! Registry entry of the geometry `object`.

use relief_core::registry::{Guarantee, Guarantees, Publication};

use super::GeometryRole;
use crate::Family;
use crate::entry::{Companion, Entry, Role};
use crate::surface::Shown;

/// A box around an object that is known from images.
pub const ENTRY: Entry = Entry {
    name: "object",
    summary: "object: the box around an object of images with depth",
    publication: Publication { paper: crate::DEPTH_OBJECTS, section: "4" },
    maps: &[],
    params: &[],
    states: &[],
    guarantee: Guarantees::all(Guarantee::Exact),
    weakened: &[],
    argument: "The box holds all that every image may see: rays that miss the box see nothing \
        of the object.",
    role: Role::Geometry(GeometryRole {
        family: Family::Object,
        shown: Shown::Object,
        triangles: None,
        stencil: None,
        companions: &[
            Companion::new("surface", "object"),
            Companion::new("object", "depth"),
            Companion::new("search", "pyramid"),
            Companion::new("refine", "patch"),
            Companion::new("shadow", "map").with(&[("size", SHADOW_MAP_TEXELS)]),
        ],
    }),
};

/// Texels of a shadow map's side: about as fine as an object's images. More take long on CPUs,
/// since each texel is a ray through all images.
const SHADOW_MAP_TEXELS: f32 = 512.0;
