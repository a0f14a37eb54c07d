//! What goes wrong.

use relief_core::registry::UnknownName;

/// Why there can be no mesh of a base, a height map and settings.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum MesherError {
    /// An edge rule and an interior that make no sense together.
    #[error("the edges '{edges}' and the interior '{interior}' make no mesh: {why}")]
    Pair {
        /// Name of the edge rule.
        edges: &'static str,
        /// Name of the interior.
        interior: &'static str,
        /// The reason.
        why: &'static str,
    },
    /// A point every no texels.
    #[error("a point every 0 texels: at least every texel is possible")]
    NoTexels,
    /// A base without triangles.
    #[error("the base mesh has no triangles")]
    Empty,
    /// The mesh has more vertices than 32-bit numbers count.
    #[error(
        "the mesh would have {vertices} vertices and {triangles} triangles, or more: {MOST} are possible"
    )]
    TooLarge {
        /// Vertices that were counted until there were too many.
        vertices: u64,
        /// Triangles that were counted until then.
        triangles: u64,
    },
    /// Nothing of that name.
    #[error(transparent)]
    Unknown(#[from] UnknownName),
}

/// The most vertices and triangles of a mesh.
pub const MOST: u64 = u32::MAX as u64 - 1;

/// Why a mesh was not handed over to its end.
#[derive(Debug, thiserror::Error)]
pub enum StreamError<E> {
    /// Whoever takes it did not want any more.
    #[error(transparent)]
    Sink(E),
    /// It was cancelled.
    #[error("cancelled")]
    Cancelled,
    /// A vertex is displaced too far.
    #[error("a vertex is displaced beyond what 32-bit numbers hold")]
    NotFinite,
    /// The numbers of all parts are no mesh.
    #[error(transparent)]
    Mesh(#[from] relief_core::mesh::MeshError),
}
