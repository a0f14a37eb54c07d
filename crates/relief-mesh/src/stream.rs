//! Streaming of a mesh: options and results.

use glam::{Vec2, Vec3};
use relief_core::Watch;
use relief_core::mesh::PositionGrid;

use crate::{Cracks, Folds};

/// Options of streaming a mesh.
#[derive(Clone, Copy, Debug)]
pub struct Stream<'a> {
    /// Factor on all positions.
    pub size: f64,
    /// Whether the mesh is tested for cracks.
    pub check: bool,
    /// Lattice to which positions are rounded, after scaling. The test for cracks uses rounded
    /// positions.
    pub grid: Option<PositionGrid>,
    /// Whether the triangles of a block are reordered for a GPU's vertex cache.
    pub cache_order: bool,
    /// Progress and cancellation.
    pub watch: Watch<'a>,
}

/// Results of streaming a mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct Streamed {
    /// Least and greatest corner of the bounding box, in metres.
    pub bounds_m: [Vec3; 2],
    /// Cracks, if the mesh was tested.
    pub cracks: Option<Cracks>,
    /// Folded triangles.
    pub folds: Folds,
    /// Folded triangles of a solid's underside.
    pub folds_below: Folds,
    /// Effects of the lattice, if there was one.
    pub rounded: Option<Rounded>,
}

/// Effects of rounding positions to a lattice.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rounded {
    /// Greatest move of a vertex in metres. No point of the surface moved farther.
    pub greatest_m: f64,
    /// Number of triangles that lost their area.
    pub without_area: u64,
}

impl Rounded {
    /// Returns the effects on two meshes together.
    #[must_use]
    pub fn with(self, other: Self) -> Self {
        Self {
            greatest_m: self.greatest_m.max(other.greatest_m),
            without_area: self.without_area + other.without_area,
        }
    }
}

/// Bounds of a mesh's vertices: least and greatest values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Positions in metres.
    pub positions_m: [Vec3; 2],
    /// Texture coordinates.
    pub uvs: [Vec2; 2],
}

impl Bounds {
    /// Returns the bounds of two meshes together.
    #[must_use]
    pub fn with(&self, other: &Self) -> Self {
        let ([a, b], [c, d]) = (self.positions_m, other.positions_m);
        let ([e, f], [g, h]) = (self.uvs, other.uvs);
        Self { positions_m: [a.min(c), b.max(d)], uvs: [e.min(g), f.max(h)] }
    }
}
