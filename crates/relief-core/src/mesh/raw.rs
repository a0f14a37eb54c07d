//! Unchecked meshes, as files contain them, without frames.

use super::topology::weld;
use super::{Mesh, MeshError};
use glam::{DVec3, Vec2, Vec3};
use std::collections::HashSet;

/// The largest coordinate of a position in metres, and the longest tile.
pub(super) const MAX_METRES: f64 = 1e9;

/// Largest texture coordinate. Beyond it `f32` does not distinguish the texels of a tile.
const MAX_UV: f32 = 1e6;

/// A mesh as files contain it: positions, and optional normals and texture coordinates, each with
/// its own indices.
///
/// [`framed`](Self::framed) converts any content to a [`Mesh`], or returns an error.
///
/// ```
/// use relief_core::mesh::{RawCorner, RawMesh};
/// use glam::{Vec2, Vec3};
///
/// // A square of 2 m with one tile on it, of two triangles.
/// let uvs = vec![Vec2::ZERO, Vec2::Y, Vec2::ONE, Vec2::X];
/// let raw = RawMesh {
///     positions: uvs.iter().map(|uv| 2.0 * Vec3::new(uv.x, 0.0, uv.y)).collect(),
///     uvs,
///     triangles: [[0, 1, 2], [0, 2, 3]].map(|corners| corners.map(RawCorner::all)).to_vec(),
///     ..RawMesh::default()
/// };
/// let mesh = raw.framed()?.mesh;
/// let corner = mesh.vertices()[0];
/// assert_eq!((corner.tangent, corner.bitangent, corner.normal), (2.0 * Vec3::X, 2.0 * Vec3::Z, Vec3::Y));
/// # Ok::<(), relief_core::mesh::FramingError>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RawMesh {
    /// Positions in metres, `y` up.
    pub positions: Vec<Vec3>,
    /// Outward normals of any length. Zero vectors count as missing.
    pub normals: Vec<Vec3>,
    /// Texture coordinates: `(0, 0)` is the top-left corner of the map, `v` points downward. Not
    /// wrapped.
    pub uvs: Vec<Vec2>,
    /// Corners of every triangle, counter-clockwise seen from the front.
    pub triangles: Vec<[RawCorner; 3]>,
}

/// A corner of a triangle, as indices into the lists of a [`RawMesh`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct RawCorner {
    /// Index into [`RawMesh::positions`].
    pub position: u32,
    /// Index into [`RawMesh::normals`], or [`RawCorner::NONE`].
    pub normal: u32,
    /// Index into [`RawMesh::uvs`], or [`RawCorner::NONE`].
    pub uv: u32,
}

impl RawCorner {
    /// Index of a missing normal or missing texture coordinates.
    pub const NONE: u32 = u32::MAX;

    /// A corner with one index for position and texture coordinates, without a normal.
    pub const fn all(place: u32) -> Self {
        Self { position: place, normal: Self::NONE, uv: place }
    }
}

/// A mesh with frames, and counts of the triangles that were removed.
#[derive(Clone, Debug, PartialEq)]
pub struct Framed {
    /// The mesh.
    pub mesh: Mesh,
    /// For each triangle its number before the removal.
    pub numbers: Vec<u32>,
    /// Number of removed triangles without an area, which are invisible.
    pub degenerate: usize,
    /// Number of removed triangles that repeat an earlier one, with the same three corners and the
    /// same front.
    pub double: usize,
}

/// Why a [`RawMesh`] does not make a [`Mesh`].
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum FramingError {
    /// No triangle has an area.
    #[error("there is no triangle with an area: a mesh needs faces")]
    NoTriangles,
    /// A corner has an index that does not exist.
    #[error("triangle {triangle} refers to {what} {index}, but there are only {count}")]
    NoSuch {
        /// Number of the triangle.
        triangle: usize,
        /// Name of the list: position, normal or texture coordinates.
        what: &'static str,
        /// Missing index, counted from 0.
        index: u32,
        /// Length of the list.
        count: usize,
    },
    /// A number is NaN, infinite or too large.
    #[error("a corner of triangle {triangle} has {what}: correct the mesh")]
    BadNumber {
        /// Number of the triangle.
        triangle: usize,
        /// Description of the bad number.
        what: &'static str,
    },
    /// Triangles have no texture coordinates.
    #[error("{missing} of {triangles} triangles have no texture coordinates, which a map needs")]
    NoTextureCoordinates {
        /// Number of triangles without texture coordinates.
        missing: usize,
        /// Number of all triangles.
        triangles: usize,
    },
    /// Texture coordinates of triangles lie on a line or a point, so that `u` and `v` have no
    /// directions.
    #[error("the texture coordinates of {count} triangles have no area, beginning with triangle {first}")]
    NoTextureArea {
        /// Number of the first such triangle.
        first: usize,
        /// Number of such triangles.
        count: usize,
    },
    /// The number of corners does not fit into 32 bits.
    #[error("a mesh of {0} triangles is too large")]
    TooLarge(usize),
    /// The result is not a mesh.
    #[error(transparent)]
    Mesh(#[from] MeshError),
}

impl From<&Mesh> for RawMesh {
    /// Takes the positions and normals of a mesh, without its texture coordinates.
    fn from(mesh: &Mesh) -> Self {
        let vertices = mesh.vertices();
        let corner = |number| RawCorner { position: number, normal: number, uv: RawCorner::NONE };
        Self {
            positions: vertices.iter().map(|vertex| vertex.position).collect(),
            normals: vertices.iter().map(|vertex| vertex.normal).collect(),
            uvs: Vec::new(),
            triangles: mesh.triangles().iter().map(|corners| corners.map(corner)).collect(),
        }
    }
}

impl RawMesh {
    /// Most memory that [`framed`](Self::framed) takes per triangle, in bytes, including its
    /// result.
    pub const BYTES_PER_TRIANGLE: u64 = 480;

    /// Most memory that [`framed`](Self::framed) takes per position, in bytes.
    pub const BYTES_PER_POSITION: u64 = 100;

    /// Positions of the corners of every triangle, in metres. Normals and texture coordinates are
    /// not needed.
    ///
    /// # Errors
    ///
    /// When there is no triangle, a corner has an index that does not exist, or a number cannot be
    /// used.
    pub fn triangle_positions(&self) -> Result<impl Iterator<Item = [Vec3; 3]> + '_, FramingError> {
        self.check()?;
        if self.triangles.is_empty() {
            return Err(FramingError::NoTriangles);
        }
        let place = |corner: RawCorner| self.positions[corner.position as usize];
        Ok(self.triangles.iter().map(move |corners| corners.map(place)))
    }

    /// Cross product of a triangle's sides: its normal with twice its area as length, or 0.
    pub(super) fn cross(&self, corners: &[RawCorner; 3]) -> DVec3 {
        let [a, b, c] = corners.map(|corner| self.positions[corner.position as usize].as_dvec3());
        (b - a).cross(c - a)
    }

    /// Checks that all indices exist and all numbers are usable. Missing texture coordinates are
    /// not an error here.
    pub(super) fn check(&self) -> Result<(), FramingError> {
        let count = self.triangles.len();
        let counts = [count, self.positions.len(), self.normals.len(), self.uvs.len()];
        if counts.iter().any(|&count| count > (u32::MAX / 3) as usize) {
            return Err(FramingError::TooLarge(count));
        }
        for (triangle, corners) in self.triangles.iter().enumerate() {
            for corner in corners {
                self.check_corner(triangle, corner)?;
            }
        }
        Ok(())
    }

    fn check_corner(&self, triangle: usize, corner: &RawCorner) -> Result<(), FramingError> {
        let RawCorner { position, normal, uv } = *corner;
        let no_such = |what, index, count| FramingError::NoSuch { triangle, what, index, count };
        let bad = |what| Err(FramingError::BadNumber { triangle, what });
        let point = self.positions.get(position as usize);
        let point = point.ok_or_else(|| no_such("position", position, self.positions.len()))?;
        if !(point.abs().max_element() <= MAX_METRES as f32 && point.is_finite()) {
            return bad("a position that is not a number, or is beyond 1e9 m");
        }
        if normal != RawCorner::NONE {
            let vector = self.normals.get(normal as usize);
            let vector = vector.ok_or_else(|| no_such("normal", normal, self.normals.len()))?;
            if !vector.is_finite() {
                return bad("a normal that is not a number");
            }
        }
        if uv != RawCorner::NONE {
            let at = self.uvs.get(uv as usize);
            let at = at.ok_or_else(|| no_such("texture coordinates", uv, self.uvs.len()))?;
            if !(at.is_finite() && at.abs().max_element() <= MAX_UV) {
                return bad("texture coordinates that are not numbers, or are beyond 1e6");
            }
        }
        Ok(())
    }

    /// Merges equal positions, and removes triangles without an area and repeated triangles.
    /// Returns the original numbers of the remaining ones, and the counts of both kinds.
    pub(super) fn weld_and_drop(&mut self) -> (Vec<u32>, [usize; 2]) {
        let point_of = weld(self.positions.iter().copied());
        for corner in self.triangles.iter_mut().flatten() {
            corner.position = point_of[corner.position as usize];
        }
        let triangles = std::mem::take(&mut self.triangles);
        let mut seen = HashSet::with_capacity(triangles.len());
        let (mut kept, mut numbers) =
            (Vec::with_capacity(triangles.len()), Vec::with_capacity(triangles.len()));
        let (mut degenerate, mut double) = (0, 0);
        for (number, corners) in (0u32..).zip(triangles) {
            let mut points = corners.map(|corner| corner.position);
            let least = (0..3).min_by_key(|&place| points[place]).unwrap_or_default();
            points.rotate_left(least);
            if self.cross(&corners) == DVec3::ZERO {
                degenerate += 1;
            } else if seen.insert(points) {
                kept.push(corners);
                numbers.push(number);
            } else {
                double += 1;
            }
        }
        self.triangles = kept;
        (numbers, [degenerate, double])
    }
}
