//! Geometry: which triangles a picture shows of a surface. A new one is a `.rs` file here and its name in the
//! list below; what makes its triangles is the renderer's. No shader belongs to it: triangles that are
//! displaced are shaded by the surface `facets`.

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

/// All of them.
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
    /// The family of methods that it makes.
    pub family: Family,
    /// What the triangles show: surfaces that show the same go with it.
    pub shown: Shown,
    /// The triangles for its parameters and the ones of the stage `slices`; none where the mesh itself is drawn.
    pub triangles: Option<TrianglesOf>,
    /// The parameter that asks for a stencil buffer where it is not 0.
    pub stencil: Option<&'static str>,
    /// The variants of other stages that are chosen with it. Without any the surface is the first that shows
    /// the same.
    pub companions: &'static [Companion],
}

impl GeometryRole {
    /// The base mesh, on which a relief lies.
    pub const BASE: Self =
        Self { family: Family::Ray, shown: Shown::Relief, triangles: None, stencil: None, companions: &[] };

    /// Displaced triangles, on which nothing is searched. Lights see them, as no relief lies on them.
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

/// Which triangles a selection shows in place of the base's.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Geometry {
    /// The base with a vertex every so many texels of the height map.
    Texels(u32),
    /// The base divided by voxels that are so many pixels of the picture wide.
    Pixels(f32),
    /// The same, each triangle cut by itself.
    Tessellated(Tessellated),
    /// Slices through the relief.
    Slices(Slices),
    /// Slices through the box around an object.
    ObjectSlices(Slices),
}

impl Geometry {
    /// Why such triangles can't be made; none where they can.
    pub(crate) fn refused(&self) -> Option<&'static str> {
        match self {
            Geometry::Tessellated(tessellated) => tessellated.refused(),
            Geometry::Slices(slices) => slices.refused(),
            Geometry::Texels(_) | Geometry::Pixels(_) | Geometry::ObjectSlices(_) => None,
        }
    }
}

/// How many texels or pixels lie between vertices.
const fn spacing(name: &'static str, summary: &'static str, least: f32, integer: bool) -> Param {
    Param { name, summary, unit: name, min: least, max: 4_096.0, default: 1.0, integer, names: &[] }
}
