//! Base meshes: triangles with texture coordinates and true tangent frames.
//!
//! A [`Mesh`] is a built-in shape, or is made from a [`RawMesh`], the content of a file. Lengths
//! are metres, and `y` is up. The built-in shapes stand on the plane of `x` and `z`. Seen along
//! `-z` they show the middle of their texture.

mod base_point;
mod block;
mod builtin;
mod chart_texels;
mod cube;
mod cylinder;
mod folds;
mod framing;
mod least_norm;
mod lift;
mod measures;
mod patch;
mod placement;
mod position_grid;
mod projection;
mod quadric;
mod raw;
mod rectangle;
mod sphere;
mod topology;
mod torus;

use glam::{Vec2, Vec3};

pub use base_point::BasePoint;
pub use block::MeshBlock;
pub use builtin::Builtin;
pub use chart_texels::{ChartError, ChartTexels};
pub use cube::cube;
pub use cylinder::cylinder;
pub use measures::{MeshMeasures, Spread};
pub use placement::Placement;
pub use position_grid::{GridError, PositionGrid};
pub use projection::UvProjection;
pub use quadric::QuadricCoefficients;
pub use raw::{Framed, FramingError, RawCorner, RawMesh};
pub use rectangle::{rectangle, square};
pub use sphere::sphere;
pub use torus::torus;

/// Most divisions of a side of a built-in mesh. A plane with that number has a million quads.
pub const MAX_DIVISIONS: u32 = 1024;

/// One corner of a mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vertex {
    /// Position in the world, in metres.
    pub position: Vec3,
    /// Unit outward normal.
    pub normal: Vec3,
    /// Derivative of the position by `u`: it points along growing `u` and is as long as one tile in
    /// metres. It is neither normalised nor orthogonal to the bitangent.
    pub tangent: Vec3,
    /// Derivative of the position by `v`: it points along growing `v` and is as long as one tile in
    /// metres.
    pub bitangent: Vec3,
    /// Texture coordinates: `(0, 0)` is the top-left corner of the map, `v` points downward. Not
    /// wrapped.
    pub uv: Vec2,
}

/// Triangles over shared vertices.
///
/// Corners run counter-clockwise seen from the front. Every index is below the number of vertices,
/// and all numbers of the vertices are finite.
#[derive(Clone, Debug, PartialEq)]
pub struct Mesh {
    vertices: Vec<Vertex>,
    triangles: Vec<[u32; 3]>,
}

/// Why data does not make a mesh, or why a mesh cannot be changed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum MeshError {
    /// A triangle refers to a vertex that does not exist.
    #[error("triangle {triangle} has the corner {index}, but there are {vertices} vertices")]
    NoSuchVertex {
        /// Number of the first such triangle.
        triangle: usize,
        /// Index of the missing vertex.
        index: u32,
        /// Number of vertices.
        vertices: usize,
    },
    /// A number of a vertex is NaN or infinite.
    #[error("vertex {0} has a number that is not finite")]
    NotFinite(usize),
    /// The number of triangles does not fit into 32 bits.
    #[error("a mesh of {0} triangles is too large")]
    TooLarge(usize),
    /// A tile of the texture at a vertex is shorter than 1e-19 m, so that `f32` cannot represent
    /// the square of its length.
    #[error("vertex {0} has a tile of the texture shorter than 1e-19 m: give the mesh in metres")]
    ShortTile(usize),
    /// A tile factor is not finite and positive, or tiles become too short or long for `f32`.
    #[error(
        "the tile factors are {0} and {1}: they must be positive, with tiles from 1e-19 m to 1e19 m long"
    )]
    BadTile(f32, f32),
    /// A placement is impossible: a number is not finite or the size is not positive. Or the placed
    /// mesh is not finite, or its tiles are too short or long for `f32`.
    #[error(
        "the mesh cannot have this placement: its numbers must be finite and its size positive, \
         with tiles from 1e-19 m to 1e19 m long"
    )]
    BadPlacement,
    /// The sides of a rectangle are not finite and positive, or too small or large for `f32`.
    #[error("a rectangle of {0} m by {1} m: both sides must be finite and positive")]
    BadSides(f64, f64),
    /// A number of divisions is outside its range.
    #[error("{given} divisions {direction}: use {least} to {MAX_DIVISIONS}")]
    BadDivisions {
        /// Description of the divided side.
        direction: &'static str,
        /// Number given.
        given: u32,
        /// Least possible number.
        least: u32,
    },
}

impl Mesh {
    /// Creates a mesh from vertices and triangles.
    ///
    /// # Errors
    ///
    /// When an index is not below the number of vertices, or a number is not finite.
    pub fn new(vertices: Vec<Vertex>, triangles: Vec<[u32; 3]>) -> Result<Self, MeshError> {
        if u32::try_from(triangles.len()).is_err() {
            return Err(MeshError::TooLarge(triangles.len()));
        }
        if let Some(at) = vertices.iter().position(|vertex| !vertex.is_finite()) {
            return Err(MeshError::NotFinite(at));
        }
        for (triangle, corners) in triangles.iter().enumerate() {
            if let Some(&index) = corners.iter().find(|&&index| index as usize >= vertices.len()) {
                return Err(MeshError::NoSuchVertex { triangle, index, vertices: vertices.len() });
            }
        }
        Ok(Self { vertices, triangles })
    }

    /// All vertices.
    #[inline]
    pub fn vertices(&self) -> &[Vertex] {
        &self.vertices
    }

    /// Corners of every triangle, as indices into [`Self::vertices`].
    #[inline]
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// For every vertex, the index of the first one at the same position.
    pub fn welded(&self) -> Vec<u32> {
        topology::weld(self.vertices.iter().map(|vertex| vertex.position))
    }

    /// Corners of one triangle. Panics if there is no such triangle.
    #[inline]
    pub fn corners(&self, triangle: u32) -> [&Vertex; 3] {
        self.triangles[triangle as usize].map(|index| &self.vertices[index as usize])
    }

    /// Interpolates all numbers of a triangle's corners with the barycentric `weights`, which must
    /// add up to 1. Nothing is normalised. Panics if there is no such triangle.
    pub fn interpolated(&self, triangle: u32, weights: [f32; 3]) -> Vertex {
        let [a, b, c] = self.corners(triangle);
        let [wa, wb, wc] = weights;
        Vertex {
            position: a.position * wa + b.position * wb + c.position * wc,
            normal: a.normal * wa + b.normal * wb + c.normal * wc,
            tangent: a.tangent * wa + b.tangent * wb + c.tangent * wc,
            bitangent: a.bitangent * wa + b.bitangent * wb + c.bitangent * wc,
            uv: a.uv * wa + b.uv * wb + c.uv * wc,
        }
    }

    /// Length of a tile along `u` and `v` in metres, averaged over the mesh's area. 0 for a mesh
    /// without area.
    pub fn tile_m(&self) -> [f64; 2] {
        let (mut lengths, mut areas) = ([0.0; 2], 0.0);
        for triangle in 0..self.triangles.len() as u32 {
            let corners = self.corners(triangle);
            let [a, b, c] = corners.map(|corner| corner.position);
            let area = 0.5 * f64::from((b - a).cross(c - a).length());
            for corner in corners {
                lengths[0] += area / 3.0 * f64::from(corner.tangent.length());
                lengths[1] += area / 3.0 * f64::from(corner.bitangent.length());
            }
            areas += area;
        }
        lengths.map(|length| if areas > 0.0 { length / areas } else { 0.0 })
    }

    /// Returns the mesh with `tile` times as many tiles along `u` and `v`. Texture coordinates are
    /// multiplied, tangents and bitangents divided.
    ///
    /// # Errors
    ///
    /// When a factor is not finite and positive, or so large or small that a coordinate is no
    /// longer finite.
    pub fn tiled(mut self, tile: Vec2) -> Result<Self, MeshError> {
        if !(tile.is_finite() && tile.cmpgt(Vec2::ZERO).all()) {
            return Err(MeshError::BadTile(tile.x, tile.y));
        }
        let mut has_lengths = true;
        for vertex in &mut self.vertices {
            let had_lengths = vertex.has_lengths();
            vertex.uv *= tile;
            vertex.tangent /= tile.x;
            vertex.bitangent /= tile.y;
            has_lengths &= vertex.has_lengths() || !had_lengths;
        }
        if has_lengths && self.vertices.iter().all(Vertex::is_finite) {
            Ok(self)
        } else {
            Err(MeshError::BadTile(tile.x, tile.y))
        }
    }
}

impl Vertex {
    /// Whether `f32` can represent the squared lengths of tangent and bitangent. Otherwise a length
    /// is computed as 0 or infinite, and displacement along the frame is wrong.
    fn has_lengths(&self) -> bool {
        [self.tangent, self.bitangent].iter().all(|along| along.length_squared().is_normal())
    }

    fn is_finite(&self) -> bool {
        self.position.is_finite()
            && self.normal.is_finite()
            && self.tangent.is_finite()
            && self.bitangent.is_finite()
            && self.uv.is_finite()
    }
}

/// Refuses a number of divisions outside `least..=MAX_DIVISIONS`.
fn check_divisions(direction: &'static str, given: u32, least: u32) -> Result<(), MeshError> {
    if (least..=MAX_DIVISIONS).contains(&given) {
        Ok(())
    } else {
        Err(MeshError::BadDivisions { direction, given, least })
    }
}

#[cfg(test)]
mod tests;
