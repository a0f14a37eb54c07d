//! How a mesh is made.

use glam::DVec3;

use crate::{
    BaseSurface, Cull, Directions, EdgeRule, Fit, Interior, Judge, Seams, Shading, Side, View, Weights, edge,
    interior,
};

/// How a mesh is made.
#[derive(Clone, Copy, Debug)]
pub struct MeshSettings {
    /// Where the sides of patches are divided.
    pub edges: &'static EdgeRule,
    /// What fills a patch.
    pub interior: &'static Interior,
    /// For the edge rule `texels`: a point every so many texels, at least 1.
    pub texels: u32,
    /// For the edge rule `pixels`: where the mesh is looked at from.
    pub view: Option<View>,
    /// For the same: what is not made of the mesh since that view does not see it.
    pub cull: Option<Cull>,
    /// For the same, with the interior `dice`: edges that have more or fewer points than voxels.
    pub weights: Weights,
    /// For the edge rule `error` and the interior `adapt`: the farthest that the relief may lie from the
    /// triangles, along the direction of displacement, in metres.
    pub error_m: f64,
    /// For the same: where that is looked at.
    pub judge: Judge,
    /// For the same: which heights points get.
    pub fit: Fit,
    /// For the same: on which side of the relief triangles lie.
    pub side: Side,
    /// Walls and an underside that make an open mesh a closed solid, so many metres thick at least.
    ///
    /// Under a plane the bottom is flat, as far below the lowest point of the relief. Another mesh gets its
    /// own triangles once more, all displaced by the same: under each vertex of the relief the solid is as
    /// thick along the direction there, as long as interpolated normals are not shorter than half of one. It
    /// faces the way that the mesh does. Pieces that are closed stay as they are.
    ///
    /// All triangles at a position share its vertex, so that a solid is closed by the numbers of its vertices,
    /// too: normals are smooth at its edges, and of a seam of the texture one side is kept.
    ///
    /// A plane with [holes](Self::holes) gets walls along the outline of what they leave, and its triangles
    /// once more at the bottom. Where pieces touch at a point, all but the largest are drawn back from it, by
    /// a sixteenth of a texel at most.
    pub solid_m: Option<f64>,
    /// Which part of a plane is made.
    pub part: Part,
    /// The most memory, in bytes, that may be held of a mesh whose triangles must be made to be counted.
    pub max_bytes: u64,
    /// The surface that is displaced.
    pub base: BaseSurface,
    /// Along what it is displaced.
    pub directions: Directions,
    /// The normals of the vertices.
    pub shading: Shading,
    /// What becomes of seams and hard edges.
    pub seams: Seams,
    /// Whether triangles are left out whose middle lies in a cell of the map with a
    /// [hole](relief_core::HeightMap::holes) at a corner, with all vertices that no others have. With the
    /// interior `adapt` there are points around holes, so that their outlines are within a texel; with others
    /// they are as fine as the triangles are.
    pub holes: bool,
    /// Where the mesh that was made is put.
    pub put: Put,
}

/// Where a mesh is put when it was made: turned about `y`, then moved along it. A factor on its size comes after
/// both (see [`Stream`](crate::Stream)).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Put {
    /// Cosine and sine of the angle about `y`, from `+x` toward `-z`.
    pub turn: [f64; 2],
    /// Metres along `y`.
    pub lift_m: f64,
}

impl Put {
    /// Where it was made.
    pub const STAY: Self = Self { turn: [1.0, 0.0], lift_m: 0.0 };

    /// A direction, turned.
    pub(crate) fn turned(&self, of: DVec3) -> DVec3 {
        let [cos, sin] = self.turn;
        if self.turn == Self::STAY.turn {
            return of;
        }
        DVec3::new(cos * of.x + sin * of.z, of.y, cos * of.z - sin * of.x)
    }

    /// A position, made larger by a factor in the end.
    pub(crate) fn position(&self, of: DVec3, size: f64) -> DVec3 {
        (self.turned(of) + DVec3::Y * self.lift_m) * DVec3::splat(size)
    }
}

impl Default for Put {
    /// Where it was made.
    fn default() -> Self {
        Self::STAY
    }
}

/// A part of a plane that is cut into columns and rows: a mesh of its own. Parts meet at centres of texels,
/// and have the same points there, bit by bit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Part {
    /// Columns and rows of parts.
    pub of: [u32; 2],
    /// The column and the row of this one, from 0.
    pub at: [u32; 2],
}

impl Part {
    /// All of it.
    pub const WHOLE: Self = Self { of: [1, 1], at: [0, 0] };
}

impl MeshSettings {
    /// A coarser level of detail of the same mesh: points are `2^level` times as far apart, in texels or in
    /// pixels, and the tolerance is as many times as large. Each level has about a quarter of the triangles
    /// of the one before where points are as far apart as they are told to be; with a tolerance it is what
    /// the relief makes of it, from a half where it is smooth to a quarter where it is rough.
    #[must_use]
    pub fn coarser(&self, level: u32) -> Self {
        let factor = 2.0_f64.powi(level.min(1000) as i32);
        let texels = self.texels.saturating_mul(1_u32.checked_shl(level).unwrap_or(u32::MAX));
        let view = self.view.map(|view| View { pixels: view.pixels * factor, ..view });
        Self { texels, view, error_m: self.error_m * factor, ..*self }
    }

    /// As few triangles as a tolerance in metres allows: within it on a plane, and on other meshes by a
    /// bound, see [`Certificate`](crate::Certificate).
    pub fn within(error_m: f64) -> Self {
        Self { edges: &edge::ERROR, interior: &interior::ADAPT, error_m, ..Self::default() }
    }

    /// As fine as the voxels of a view are.
    pub fn seen_by(view: View) -> Self {
        Self { edges: &edge::PIXELS, interior: &interior::SWEEP, view: Some(view), ..Self::default() }
    }
}

impl Default for MeshSettings {
    /// A point every texel, in a fixed pattern, on flat triangles along interpolated normals, without gaps.
    fn default() -> Self {
        Self {
            edges: &edge::TEXELS,
            interior: &interior::DICE,
            texels: 1,
            view: None,
            cull: None,
            weights: Weights::NONE,
            error_m: f64::INFINITY,
            judge: Judge::default(),
            fit: Fit::default(),
            side: Side::default(),
            solid_m: None,
            part: Part::WHOLE,
            max_bytes: u64::MAX,
            base: BaseSurface::default(),
            directions: Directions::default(),
            shading: Shading::default(),
            seams: Seams::default(),
            holes: false,
            put: Put::STAY,
        }
    }
}
