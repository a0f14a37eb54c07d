//! What goes wrong.

use relief_core::Cancelled;
use relief_core::registry::UnknownName;

use crate::{Part, Weights};

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
    /// Edges by voxels without a view that says what these are.
    #[error("the edges '{edges}' need a view: a camera and the size of its picture")]
    NoView {
        /// Name of the edge rule.
        edges: &'static str,
    },
    /// Weights that are none.
    #[error(
        "weights of {} for the silhouette, {} for slopes and {} for variation cannot be used: the first must \
         be from 0 to 1, the others at least 0 and finite",
        weights.silhouette, weights.slope, weights.variation
    )]
    BadWeights {
        /// The weights.
        weights: Weights,
    },
    /// Weights where sides must have as many points as they have.
    #[error("the interior '{interior}' takes no weights: {why}")]
    Weighted {
        /// Name of the interior.
        interior: &'static str,
        /// The reason.
        why: &'static str,
    },
    /// Levels of a map where no view says which of them is seen.
    #[error("the edges '{edges}' see the height map itself: levels of it are for a view")]
    LevelsOfNoView {
        /// Name of the edge rule.
        edges: &'static str,
    },
    /// Something to be left out that no view says.
    #[error("the edges '{edges}' are those of no view: nothing can be left out of the mesh as not seen")]
    CullOfNoView {
        /// Name of the edge rule.
        edges: &'static str,
    },
    /// Something left out where normals are those of all triangles.
    #[error(
        "where triangles are left out as not seen, normals cannot be those of the triangles: normals of the \
         relief can be had"
    )]
    CullOfMeshNormals,
    /// A view that sees nothing.
    #[error(
        "a view of {width}x{height} pixels, {pixels} to a voxel, near {near_m} m cannot be used: all must be \
         greater than 0, and finite"
    )]
    BadView {
        /// Width of its picture.
        width: u32,
        /// Height of its picture.
        height: u32,
        /// Pixels that a voxel is wide.
        pixels: f64,
        /// Metres to where it begins.
        near_m: f64,
    },
    /// A view with more voxels a side than its grid holds.
    #[error(
        "{pixels} pixels to a voxel are too fine for a picture of {width}x{height}: at least {least} are \
         possible"
    )]
    FineView {
        /// Width of its picture.
        width: u32,
        /// Height of its picture.
        height: u32,
        /// Pixels that a voxel is wide.
        pixels: f64,
        /// The least that are possible.
        least: f64,
    },
    /// A base without triangles.
    #[error("the base mesh has no triangles")]
    Empty,
    /// A tolerance that is none.
    #[error("a tolerance of {error_m} m cannot be used: it must be greater than 0, and finite")]
    BadTolerance {
        /// The tolerance.
        error_m: f64,
    },
    /// A tolerance below what this relief allows.
    #[error(
        "a tolerance of {error_m} m is too fine for this relief: {:.2e} m is possible, on a lattice of a \
         sixteenth of a texel with heights of 32 bits",
        least_m * 1.01
    )]
    TooFine {
        /// The tolerance.
        error_m: f64,
        /// The least.
        least_m: f64,
    },
    /// A tolerance that was not kept.
    #[error("a tolerance of {error_m} m was not reached: {reached_m} m is what this relief allows")]
    NotReached {
        /// The tolerance.
        error_m: f64,
        /// The error of the mesh.
        reached_m: f64,
    },
    /// A tolerance and something else that do not go together on a mesh that is not a plane.
    #[error("{what} cannot be kept to a tolerance on a mesh that is not a plane")]
    OnPlanesAlone {
        /// What it is.
        what: &'static str,
    },
    /// A solid that is none.
    #[error("a solid {solid_m} m thick cannot be made: it must be greater than 0, and finite")]
    BadSolid {
        /// How thick it would be.
        solid_m: f64,
    },
    /// A solid of a mesh without a border.
    #[error("the mesh is closed, and solid as it is: one with open edges can be made solid")]
    SolidOfClosed,
    /// A solid of a mesh whose seams are kept.
    #[error(
        "a mesh whose seams and hard edges are kept gapes there, around {}: no solid is closed, unless they \
         are welded", place(*at_m)
    )]
    SolidOfSeams {
        /// The middle of one of them, in metres.
        at_m: [f64; 3],
    },
    /// A solid of a mesh whose surface has no two sides.
    #[error(
        "{edges} edges of the mesh have more than two triangles, or two that face opposite ways, the first \
         around {}: nothing says on which side of them its inside would be", place(*at_m)
    )]
    SolidBranches {
        /// How many there are.
        edges: u64,
        /// The middle of one of them, in metres.
        at_m: [f64; 3],
    },
    /// A solid of a mesh whose border touches itself.
    #[error(
        "the border of the mesh goes twice through {}: its walls would touch in a line, which is no solid; \
         another triangle there, or one less, parts them", place(*at_m)
    )]
    SolidTouches {
        /// Where that is, in metres.
        at_m: [f64; 3],
    },
    /// A solid of a mesh that is made for a view.
    #[error(
        "what is made for a view is not made solid: a point every so many texels, or a tolerance, can be"
    )]
    SolidOfView,
    /// One side of what is folded over.
    #[error(
        "the mesh folds over where it is displaced, or nearly, at {:.4}, {:.4}, {:.4}: nothing is on one \
         side of it there", at_m[0], at_m[1], at_m[2]
    )]
    SideOfFold {
        /// The middle of a triangle where it does, in metres.
        at_m: [f64; 3],
    },
    /// One side where two that meet see other heights.
    #[error(
        "the two sides of a seam see heights of the map that are {seams_m} m apart: what bridges them is on \
         both sides"
    )]
    SideOfSeams {
        /// How far they are apart at most, in metres.
        seams_m: f64,
    },
    /// A solid with holes of a mesh that is no plane.
    #[error("only a plane is made solid around holes: on other meshes there are no walls around them")]
    SolidOfHoles,
    /// Nothing but holes.
    #[error("every triangle lies over a hole of the height map: nothing is left")]
    AllHoles,
    /// A part of a mesh that is not a plane.
    #[error("only planes are cut into parts: two triangles that make a rectangle with straight texture")]
    PartOfNoPlane,
    /// A part that there is not.
    #[error("there is no part {},{} of {}x{} parts", part.at[0], part.at[1], part.of[0], part.of[1])]
    NoPart {
        /// The part.
        part: Part,
    },
    /// Parts of less than two texels.
    #[error("{}x{} parts are too many: each must be two texels wide and high", part.of[0], part.of[1])]
    TooManyParts {
        /// One of them.
        part: Part,
    },
    /// More triangles than were allowed.
    #[error("the coarsest mesh has more than {most} triangles")]
    MoreThan {
        /// How many were allowed.
        most: u64,
    },
    /// More memory than was allowed.
    #[error("the mesh takes more than {limit} bytes while it is made")]
    NoMemory {
        /// How many were allowed.
        limit: u64,
    },
    /// The work was cancelled.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
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
    /// A plane's tiles are no mesh.
    #[error(transparent)]
    Mesh(#[from] relief_core::mesh::MeshError),
    /// What was made of a map is none.
    #[error(transparent)]
    Map(#[from] relief_core::HeightMapError),
    /// Nothing of that name.
    #[error(transparent)]
    Unknown(#[from] UnknownName),
}

/// A position in a text.
fn place([x, y, z]: [f64; 3]) -> String {
    format!("({x:.6}, {y:.6}, {z:.6})")
}

/// The most vertices and triangles of a mesh.
pub const MOST: u64 = u32::MAX as u64 - 1;

/// Why a mesh was not handed over to its end.
#[derive(Debug, thiserror::Error)]
pub enum StreamError<E> {
    /// Whoever takes it did not want any more.
    #[error(transparent)]
    Sink(E),
    /// The work was cancelled.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// A vertex is displaced too far.
    #[error("a vertex is displaced beyond what 32-bit numbers hold")]
    NotFinite,
    /// All of it at once is more than there is memory for.
    #[error(
        "{count} {what} do not fit into the memory at once: take the mesh block by block, or make it coarser"
    )]
    OutOfMemory {
        /// How many there are.
        count: u64,
        /// Of what.
        what: &'static str,
    },
    /// The numbers of all parts are no mesh.
    #[error(transparent)]
    Mesh(#[from] relief_core::mesh::MeshError),
}
