//! Geometry: which triangles a picture shows of a surface. A new one is a `.rs` file here and its name in the
//! list below; what makes its triangles is the renderer's. No shader belongs to it: triangles that are
//! displaced are shaded by the surface `facets`.

use relief_core::registry::{Entry, Param};

use crate::slice::Slices;
pub use tessellate::Tessellated;

mod none;
mod object;
mod object_slices;
mod remesh;
mod slices;
mod tessellate;
mod vertex;

/// All of them.
pub const ENTRIES: &[Entry] = &[
    none::ENTRY,
    vertex::ENTRY,
    remesh::ENTRY,
    tessellate::ENTRY,
    slices::ENTRY,
    object::ENTRY,
    object_slices::ENTRY,
];

/// The one that shows the base.
pub const NONE: &str = none::ENTRY.name;

/// The one with a vertex every so many texels.
pub(crate) const VERTEX: &str = vertex::ENTRY.name;

/// The one that is divided by the picture's pixels.
pub(crate) const REMESH: &str = remesh::ENTRY.name;

/// The one whose triangles are each cut by itself.
pub(crate) const TESSELLATE: &str = tessellate::ENTRY.name;

/// The one that is cut through the relief.
pub const SLICES: &str = slices::ENTRY.name;

/// The box around an object.
pub(crate) const OBJECT: &str = object::ENTRY.name;

/// Slices through that box.
pub(crate) const OBJECT_SLICES: &str = object_slices::ENTRY.name;

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
    /// Slices through the box around an object, and whether its images are counted in a stencil buffer.
    ObjectSlices(Slices, bool),
}

/// How many texels or pixels lie between vertices.
const fn spacing(name: &'static str, summary: &'static str, least: f32, integer: bool) -> Param {
    Param { name, summary, unit: name, min: least, max: 4_096.0, default: 1.0, integer, names: &[] }
}
