//! Errors of meshes.

use relief_core::Cancelled;
use relief_core::registry::UnknownName;

use crate::{Part, Weights};

/// Reason why a base, a height map and settings make no mesh.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum MesherError {
    /// The edge rule and the interior do not go together.
    #[error("the edge rule '{edges}' and the interior '{interior}' do not go together: {why}")]
    Pair {
        /// Name of the edge rule.
        edges: &'static str,
        /// Name of the interior.
        interior: &'static str,
        /// The reason.
        why: &'static str,
    },
    /// The distance of points is 0 texels.
    #[error("points cannot be 0 texels apart: use 1 or more")]
    NoTexels,
    /// Edges are divided by voxels, but no view defines these.
    #[error("the edge rule '{edges}' needs a view: a camera and the size of its picture")]
    NoView {
        /// Name of the edge rule.
        edges: &'static str,
    },
    /// A weight is out of its range.
    #[error(
        "weights of {} for the silhouette, {} for slopes and {} for variation cannot be used: the first must \
         be from 0 to 1, the others at least 0 and finite",
        weights.silhouette, weights.slope, weights.variation
    )]
    BadWeights {
        /// The weights.
        weights: Weights,
    },
    /// Weights are set, but the interior fixes the number of points on sides.
    #[error("the interior '{interior}' takes no weights: {why}")]
    Weighted {
        /// Name of the interior.
        interior: &'static str,
        /// The reason.
        why: &'static str,
    },
    /// Levels of the map are set, but no view selects one of them.
    #[error(
        "the edge rule '{edges}' has no view, and cannot use coarser levels of the height map: use 'pixels'"
    )]
    LevelsOfNoView {
        /// Name of the edge rule.
        edges: &'static str,
    },
    /// Culling is set, but there is no view.
    #[error("the edge rule '{edges}' has no view, and nothing can be left out as invisible: use 'pixels'")]
    CullOfNoView {
        /// Name of the edge rule.
        edges: &'static str,
    },
    /// Culling is set together with normals of the triangles.
    #[error(
        "normals of the triangles need all triangles, and invisible ones are left out: use normals of the \
         relief"
    )]
    CullOfMeshNormals,
    /// The view is empty or not finite.
    #[error(
        "a view of {width}x{height} pixels, {pixels} to a voxel, near {near_m} m cannot be used: all must be \
         greater than 0, and finite"
    )]
    BadView {
        /// Width of the picture.
        width: u32,
        /// Height of the picture.
        height: u32,
        /// Width of a voxel in pixels.
        pixels: f64,
        /// Distance of the near plane in metres.
        near_m: f64,
    },
    /// The view has more voxels on a side than its grid holds.
    #[error(
        "{pixels} pixels to a voxel are too fine for a picture of {width}x{height}: use at least {least}"
    )]
    FineView {
        /// Width of the picture.
        width: u32,
        /// Height of the picture.
        height: u32,
        /// Width of a voxel in pixels.
        pixels: f64,
        /// Least possible width of a voxel in pixels.
        least: f64,
    },
    /// The base mesh has no triangles.
    #[error("the base mesh has no triangles")]
    Empty,
    /// The tolerance is not greater than 0, or not finite.
    #[error("a tolerance of {error_m} m cannot be used: it must be greater than 0, and finite")]
    BadTolerance {
        /// The tolerance.
        error_m: f64,
    },
    /// The tolerance is finer than this relief allows.
    #[error(
        "a tolerance of {error_m} m is too fine for this relief: {:.2e} m is possible, on a lattice \
         of 1/16 of a texel with 32-bit heights",
        least_m * 1.01
    )]
    TooFine {
        /// The tolerance.
        error_m: f64,
        /// The least.
        least_m: f64,
    },
    /// The tolerance was not reached.
    #[error("a tolerance of {error_m} m was not reached: the mesh is up to {reached_m} m off the relief")]
    NotReached {
        /// The tolerance.
        error_m: f64,
        /// The error of the mesh.
        reached_m: f64,
    },
    /// An option that works with a tolerance on planes alone is set for another mesh.
    #[error("a tolerance on a mesh that is not a plane does not go together with {what}")]
    OnPlanesAlone {
        /// The option.
        what: &'static str,
    },
    /// The thickness of a solid is not greater than 0, or not finite.
    #[error("a solid {solid_m} m thick cannot be made: the thickness must be greater than 0, and finite")]
    BadSolid {
        /// Thickness in metres.
        solid_m: f64,
    },
    /// A solid is asked for, but the mesh has no border.
    #[error("the mesh is closed, and is solid already: only a mesh with open edges can be made solid")]
    SolidOfClosed,
    /// A solid is asked for, but the mesh's seams are kept.
    #[error(
        "the mesh gapes at its seams and hard edges, first around {}: weld them to make a solid",
        place(*at_m)
    )]
    SolidOfSeams {
        /// The middle of one of them, in metres.
        at_m: [f64; 3],
    },
    /// A solid is asked for, but the surface branches or its triangles face opposite ways.
    #[error(
        "{edges} edges of the mesh have more than two triangles, or two that face opposite ways, the first \
         around {}: the mesh has no inside there",
        place(*at_m)
    )]
    SolidBranches {
        /// Number of such edges.
        edges: u64,
        /// Middle of one of them, in metres.
        at_m: [f64; 3],
    },
    /// A solid is asked for, but the mesh's border touches itself.
    #[error(
        "the border of the mesh goes twice through {}: the walls of a solid would touch in a line; \
         add or remove a triangle there",
        place(*at_m)
    )]
    SolidTouches {
        /// Position in metres.
        at_m: [f64; 3],
    },
    /// A solid is asked for, but the mesh is made for a view.
    #[error("a mesh for a view cannot be made solid: use points every N texels, or a tolerance")]
    SolidOfView,
    /// One side of the relief is asked for, but the mesh folds over.
    #[error(
        "the displaced mesh folds over, or nearly, at {:.4}, {:.4}, {:.4}: no triangle lies on one side of \
         it there", at_m[0], at_m[1], at_m[2]
    )]
    SideOfFold {
        /// Middle of a triangle that folds, in metres.
        at_m: [f64; 3],
    },
    /// One side of the relief is asked for, but the two sides of a seam read different heights.
    #[error(
        "the two sides of a seam read heights of the map that are {seams_m} m apart: triangles between \
         them lie on both sides"
    )]
    SideOfSeams {
        /// Greatest difference of the heights, in metres.
        seams_m: f64,
    },
    /// A solid is asked for, but the map has holes and the mesh is not a plane.
    #[error("only a plane with holes can be made solid: other meshes get no walls around holes")]
    SolidOfHoles,
    /// All triangles lie over holes.
    #[error("every triangle lies over a hole of the height map: no triangle remains")]
    AllHoles,
    /// A part is asked for, but the mesh is not a plane.
    #[error("only planes can be cut into parts: two triangles that make a rectangle with straight texture")]
    PartOfNoPlane,
    /// The part does not exist.
    #[error(
        "part {},{} does not exist: there are {}x{} parts, counted from 0",
        part.at[0], part.at[1], part.of[0], part.of[1]
    )]
    NoPart {
        /// The part.
        part: Part,
    },
    /// The parts are smaller than two texels.
    #[error(
        "{}x{} parts are too many: each must be at least two texels wide and high",
        part.of[0], part.of[1]
    )]
    TooManyParts {
        /// One of the parts.
        part: Part,
    },
    /// The mesh has more triangles than are allowed.
    #[error("even the coarsest mesh has more than {most} triangles: allow more")]
    MoreThan {
        /// Greatest number allowed.
        most: u64,
    },
    /// The mesh needs more memory than is allowed.
    #[error("the mesh takes more than {limit} bytes while it is made: allow more, or make it coarser")]
    NoMemory {
        /// Greatest number of bytes allowed.
        limit: u64,
    },
    /// The work was cancelled.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// The mesh has more vertices than 32-bit numbers count.
    #[error(
        "the mesh would have {vertices} vertices and {triangles} triangles, or more: at most {MOST} are \
         possible"
    )]
    TooLarge {
        /// Vertices that were counted until there were too many.
        vertices: u64,
        /// Triangles that were counted until then.
        triangles: u64,
    },
    /// The tiles of a plane are not a valid mesh.
    #[error(transparent)]
    Mesh(#[from] relief_core::mesh::MeshError),
    /// A map derived from the height map is not valid.
    #[error(transparent)]
    Map(#[from] relief_core::HeightMapError),
    /// A name is unknown.
    #[error(transparent)]
    Unknown(#[from] UnknownName),
}

/// Formats a position for an error.
fn place([x, y, z]: [f64; 3]) -> String {
    format!("({x:.6}, {y:.6}, {z:.6})")
}

/// Greatest number of vertices, and of triangles, of a mesh.
pub const MOST: u64 = u32::MAX as u64 - 1;

/// Reason why a mesh was not streamed to its end.
#[derive(Debug, thiserror::Error)]
pub enum StreamError<E> {
    /// The sink returned an error.
    #[error(transparent)]
    Sink(E),
    /// The work was cancelled.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// A vertex is displaced beyond the range of `f32`.
    #[error(
        "a vertex is displaced beyond the range of 32-bit numbers: choose a smaller displacement or mesh"
    )]
    NotFinite,
    /// The whole mesh does not fit into memory.
    #[error(
        "{count} {what} do not fit into memory at once: stream the mesh block by block, or make it coarser"
    )]
    OutOfMemory {
        /// Number of items.
        count: u64,
        /// Kind of items.
        what: &'static str,
    },
    /// The vertices and triangles of all parts are not a valid mesh.
    #[error(transparent)]
    Mesh(#[from] relief_core::mesh::MeshError),
}
