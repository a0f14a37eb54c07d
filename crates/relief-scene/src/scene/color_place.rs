//! Placement of a colour picture: texture coordinates and wrap of its own.

use glam::{DMat2, DVec2};
use relief_core::Wrap;
use relief_core::mesh::Mesh;
use relief_io::{MeshColors, MeshMaterial};

/// Largest difference of entries of affine maps that count as the same.
const SAME: f64 = 1e-4;

/// Placement of a colour picture on a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ColorPlace {
    /// Two rows of an affine map. Their products with the surface's texture coordinates `(u, v, 1)`
    /// are the picture's coordinates.
    pub rows: [[f32; 3]; 2],
    /// Wrap along both axes of the picture. `None` stands for the height map's wrap.
    pub wrap: Option<[Wrap; 2]>,
}

impl Default for ColorPlace {
    /// The surface's texture coordinates and the height map's wrap.
    fn default() -> Self {
        Self { rows: MeshMaterial::IDENTITY, wrap: None }
    }
}

/// Affine map from a mesh's texture coordinates to the coordinates of a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Affine {
    linear: DMat2,
    offset: DVec2,
}

impl Affine {
    /// Identity.
    pub const SAME: Affine = Affine { linear: DMat2::IDENTITY, offset: DVec2::ZERO };

    /// Returns the map from a triangle's texture coordinates in the mesh to coordinates in its
    /// picture. `None` if the triangle has no area in the mesh's coordinates.
    pub fn of_triangle(mesh: &Mesh, colors: &MeshColors, triangle: u32) -> Option<Self> {
        let Some(corners) = colors.uvs.get(triangle as usize) else { return Some(Self::SAME) };
        let [a, b, c] = mesh.corners(triangle).map(|corner| corner.uv.as_dvec2());
        let [x, y, z] = corners.map(|corner| DVec2::from(corner.map(f64::from)));
        let from = DMat2::from_cols(b - a, c - a);
        if from.determinant() == 0.0 {
            return None;
        }
        let linear = DMat2::from_cols(y - x, z - x) * from.inverse();
        let map = Self { linear, offset: x - linear * a };
        (linear.is_finite() && map.offset.is_finite()).then_some(map)
    }

    /// Returns whether both maps are the same except for rounding.
    pub fn is_near(&self, other: &Self) -> bool {
        self.linear.abs_diff_eq(other.linear, SAME) && self.offset.abs_diff_eq(other.offset, SAME)
    }

    /// Returns this map followed by a material's transform, given as two rows as in
    /// [`ColorPlace::rows`].
    pub fn then(&self, [u, v]: [[f32; 3]; 2]) -> Self {
        let [u, v] = [u, v].map(|row| row.map(f64::from));
        let linear = DMat2::from_cols_array(&[u[0], v[0], u[1], v[1]]);
        Self { linear: linear * self.linear, offset: linear * self.offset + DVec2::new(u[2], v[2]) }
    }

    /// Returns both rows of the map, as in [`ColorPlace::rows`]. Their products with the mesh's
    /// texture coordinates `(u, v, 1)` are the picture's coordinates.
    pub fn rows(&self) -> [[f32; 3]; 2] {
        let Self { linear, offset } = self;
        let row = |axis: usize| [linear.x_axis[axis], linear.y_axis[axis], offset[axis]].map(|n| n as f32);
        [row(0), row(1)]
    }
}
