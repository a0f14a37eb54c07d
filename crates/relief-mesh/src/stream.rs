//! How a mesh is handed over, and what is known of it then.

use glam::{Vec2, Vec3};
use relief_core::Watch;
use relief_core::mesh::PositionGrid;

use crate::{Cracks, Folds};

/// How a mesh is handed over.
#[derive(Clone, Copy, Debug)]
pub struct Stream<'a> {
    /// Factor on all positions.
    pub size: f64,
    /// Whether the mesh is looked at for cracks.
    pub check: bool,
    /// The lattice that positions are rounded to, after they are made larger or smaller. Cracks are looked
    /// for in what this leaves.
    pub grid: Option<PositionGrid>,
    /// Whether the triangles of a block are put in an order in which a GPU finds most of their corners in
    /// its cache.
    pub cache_order: bool,
    /// Hears how far it is, and may cancel it.
    pub watch: Watch<'a>,
}

/// What is known of a mesh that was handed over.
#[derive(Clone, Debug, PartialEq)]
pub struct Streamed {
    /// The least and the greatest corner of a box around it, in metres.
    pub bounds_m: [Vec3; 2],
    /// What there is of cracks, if it was looked at.
    pub cracks: Option<Cracks>,
    /// What was folded over.
    pub folds: Folds,
    /// What was folded over of the underside of a solid.
    pub folds_below: Folds,
    /// What a lattice changed, if there was one.
    pub rounded: Option<Rounded>,
}

/// What became of a mesh whose positions were rounded to a lattice.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rounded {
    /// The farthest that a vertex was moved, in metres. No point of the surface was moved farther.
    pub greatest_m: f64,
    /// Triangles that had an area and have none now.
    pub without_area: u64,
}

impl Rounded {
    /// What became of two meshes together.
    #[must_use]
    pub fn with(self, other: Self) -> Self {
        Self {
            greatest_m: self.greatest_m.max(other.greatest_m),
            without_area: self.without_area + other.without_area,
        }
    }
}

/// The least and the greatest numbers of a mesh's vertices.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// The positions, in metres.
    pub positions_m: [Vec3; 2],
    /// The texture coordinates.
    pub uvs: [Vec2; 2],
}

impl Bounds {
    /// Those of two meshes together.
    #[must_use]
    pub fn with(&self, other: &Self) -> Self {
        let ([a, b], [c, d]) = (self.positions_m, other.positions_m);
        let ([e, f], [g, h]) = (self.uvs, other.uvs);
        Self { positions_m: [a.min(c), b.max(d)], uvs: [e.min(g), f.max(h)] }
    }
}
