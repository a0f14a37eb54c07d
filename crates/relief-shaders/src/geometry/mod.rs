//! Geometries: each chooses the triangles that a picture shows of a surface.
//!
//! A new geometry is a `.rs` file here and its name in the list below; the renderer makes its
//! triangles. No shader belongs to it: the surface `facets` shades displaced triangles.

use relief_core::registry::{MAX_PARAMS, Param};

use crate::Family;
use crate::entry::{Companion, Entry};
use crate::slice::Slices;
use crate::surface::Shown;
pub use tessellate::Tessellated;

mod none;
mod object;
mod object_slices;
mod remesh;
mod slices;
mod tessellate;
mod vertex;

/// All geometries, in the order of their numbers.
pub static ENTRIES: &[Entry] = &[
    none::ENTRY,
    vertex::ENTRY,
    remesh::ENTRY,
    tessellate::ENTRY,
    slices::ENTRY,
    object::ENTRY,
    object_slices::ENTRY,
];

/// The triangles for the parameters of a geometry and of the stage `slices`.
pub type TrianglesOf = fn(params: [f32; MAX_PARAMS], slices: [f32; MAX_PARAMS]) -> Geometry;

/// The triangles that a geometry draws in place of the base's.
#[derive(Clone, Copy, Debug)]
pub struct GeometryRole {
    /// The family of methods to which it belongs.
    pub family: Family,
    /// The content of the triangles; surfaces with the same content go with it.
    pub shown: Shown,
    /// The triangles by its parameters and the parameters of the stage `slices`; none if the mesh
    /// itself is drawn.
    pub triangles: Option<TrianglesOf>,
    /// The parameter that asks for a stencil buffer where it is not 0.
    pub stencil: Option<&'static str>,
    /// The variants of other stages that are chosen with it. Without any, the surface is the first
    /// with the same content.
    pub companions: &'static [Companion],
}

impl GeometryRole {
    /// The base mesh, on which a relief lies.
    pub const BASE: Self =
        Self { family: Family::Ray, shown: Shown::Relief, triangles: None, stencil: None, companions: &[] };

    /// Displaced triangles, on which nothing is searched. Shadow maps serve them, as no relief lies
    /// on them.
    const DISPLACED: Self = Self {
        shown: Shown::Triangles,
        companions: &[
            Companion::new("surface", "facets"),
            Companion::new("search", "none"),
            Companion::new("refine", "none"),
            Companion::new("shadow", "map"),
        ],
        ..Self::BASE
    };
}

/// The triangles that a selection shows in place of the base's.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Geometry {
    /// The base with vertices this number of texels of the height map apart.
    Texels(u32),
    /// The base divided by voxels this number of pixels of the picture wide.
    Pixels(f32),
    /// The base divided in the same ways, each triangle cut by itself.
    Tessellated(Tessellated),
    /// Slices through the relief.
    Slices(Slices),
    /// Slices through the box around an object.
    ObjectSlices(Slices),
}

impl Geometry {
    /// Reason why such triangles can't be made, if they can't.
    pub(crate) fn refused(&self) -> Option<&'static str> {
        match self {
            Geometry::Tessellated(tessellated) => tessellated.refused(),
            Geometry::Slices(slices) => slices.refused(),
            Geometry::Texels(_) | Geometry::Pixels(_) | Geometry::ObjectSlices(_) => None,
        }
    }
}

/// A parameter with the number of texels or pixels between vertices.
const fn spacing(name: &'static str, summary: &'static str, least: f32, integer: bool) -> Param {
    Param { name, summary, unit: name, min: least, max: 4_096.0, default: 1.0, integer, names: &[] }
}
