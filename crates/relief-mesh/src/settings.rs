//! Settings of a displaced mesh.

use glam::DVec3;

use crate::{
    BaseSurface, Cull, Directions, EdgeRule, Fit, Interior, Judge, Seams, Shading, Side, View, Weights, edge,
    interior,
};

/// Settings of a displaced mesh.
#[derive(Clone, Copy, Debug)]
pub struct MeshSettings {
    /// Rule that divides the sides of patches. Default: `texels`.
    pub edges: &'static EdgeRule,
    /// Rule that fills a patch. Default: `dice`.
    pub interior: &'static Interior,
    /// Edge rule `texels`: the distance between points in texels, at least 1. Default: 1.
    pub texels: u32,
    /// Edge rule `pixels`: the view for which the mesh is made. Default: none.
    pub view: Option<View>,
    /// Edge rule `pixels`: the parts that are left out because the view does not show them.
    /// Default: none.
    pub cull: Option<Cull>,
    /// Edge rule `pixels`, interior `dice`: weights that give edges more or fewer parts than
    /// voxels. Default: none.
    pub weights: Weights,
    /// Edge rule `error`, interior `adapt`: the tolerance. It is the greatest distance of the
    /// relief from the triangles along the direction of displacement, in metres.
    /// Must be greater than 0 and finite. Default: infinite, so that it must be set.
    pub error_m: f64,
    /// Edge rule `error`, interior `adapt`: the places at which this distance is measured. Default:
    /// everywhere on the surface.
    pub judge: Judge,
    /// Edge rule `error`, interior `adapt`: the heights of inserted points. Default: fitted ones.
    pub fit: Fit,
    /// Edge rule `error`, interior `adapt`: the side of the relief on which triangles lie. Default: both.
    pub side: Side,
    /// Least thickness in metres of a solid: walls and an underside close an open mesh. Default:
    /// none.
    ///
    /// Under a plane the bottom is flat, this far below the lowest point of the relief. Another
    /// mesh gets its own triangles once more, all displaced by the same amount. Under each vertex
    /// of the relief the solid has this thickness along the direction there. This holds while
    /// interpolated normals are at least half as long as normals. The underside faces as the mesh
    /// does. Closed pieces do not change.
    ///
    /// All triangles at a position share its vertex, so that a solid is closed by vertex numbers,
    /// too. Normals are then smooth at its edges, and a seam of the texture keeps one of its sides.
    ///
    /// A plane with [holes](Self::holes) gets walls along the outline of the remaining triangles,
    /// and these triangles once more at the bottom. Where pieces touch at a point, all but the
    /// largest are drawn back from it, by at most 1/16 of a texel.
    pub solid_m: Option<f64>,
    /// Part of a plane that is made. Default: the whole plane.
    pub part: Part,
    /// Greatest memory in bytes for a mesh whose triangles must be made to be counted.
    /// Default: no limit.
    pub max_bytes: u64,
    /// Surface that is displaced. Default: flat triangles.
    pub base: BaseSurface,
    /// Direction of displacement. Default: interpolated normals, not normalised.
    pub directions: Directions,
    /// Method that computes the normals of the vertices. Default: exact.
    pub shading: Shading,
    /// Treatment of seams and hard edges. Default: welded.
    pub seams: Seams,
    /// Whether triangles over holes are left out, with the vertices that no other triangle has.
    /// Default: no.
    ///
    /// A triangle is left out if its middle lies in a cell of the map with a
    /// [hole](relief_core::HeightMap::holes) at a corner. The interior `adapt` adds points around
    /// holes, so that outlines are within a texel. With other interiors outlines are as fine as the
    /// triangles.
    pub holes: bool,
    /// Pose of the finished mesh. Default: no turn and no lift.
    pub pose: Pose,
}

/// Pose of a finished mesh: it is turned about `y`, then moved along `y`. The factor `size` of
/// [`Stream`](crate::Stream) applies after both.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// Cosine and sine of the angle about `y`, from `+x` toward `-z`.
    pub turn: [f64; 2],
    /// Metres along `y`.
    pub lift_m: f64,
}

impl Pose {
    /// No turn and no lift.
    pub const IDENTITY: Self = Self { turn: [1.0, 0.0], lift_m: 0.0 };

    /// Returns a turned direction.
    pub(crate) fn turned(&self, of: DVec3) -> DVec3 {
        let [cos, sin] = self.turn;
        if self.turn == Self::IDENTITY.turn {
            return of;
        }
        DVec3::new(cos * of.x + sin * of.z, of.y, cos * of.z - sin * of.x)
    }

    /// Returns a turned and moved position, scaled by `size` at the end.
    pub(crate) fn position(&self, of: DVec3, size: f64) -> DVec3 {
        (self.turned(of) + DVec3::Y * self.lift_m) * DVec3::splat(size)
    }
}

impl Default for Pose {
    /// No turn and no lift.
    fn default() -> Self {
        Self::IDENTITY
    }
}

/// Part of a plane that is cut into columns and rows: a mesh by itself. Parts meet at centres of
/// texels, where they have the same points, bit by bit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Part {
    /// Number of columns and rows of parts.
    pub of: [u32; 2],
    /// Column and row of this part, from 0.
    pub at: [u32; 2],
}

impl Part {
    /// The whole plane.
    pub const WHOLE: Self = Self { of: [1, 1], at: [0, 0] };
}

impl MeshSettings {
    /// Returns the settings of a coarser level of detail of the same mesh.
    ///
    /// Points are `2^level` times as far apart, in texels or in pixels, and the tolerance is
    /// `2^level` times as large. With a fixed distance of points, each level has about a quarter of
    /// the triangles of the level before. With a tolerance it depends on the relief: half where it
    /// is smooth, a quarter where it is rough.
    #[must_use]
    pub fn coarser(&self, level: u32) -> Self {
        let factor = 2.0_f64.powi(level.min(1000) as i32);
        let texels = self.texels.saturating_mul(1_u32.checked_shl(level).unwrap_or(u32::MAX));
        let view = self.view.map(|view| View { pixels: view.pixels * factor, ..view });
        Self { texels, view, error_m: self.error_m * factor, ..*self }
    }

    /// Returns settings for as few triangles as a tolerance in metres allows. On a plane the error
    /// is exact. On other meshes it is a bound: see [`Certificate`](crate::Certificate).
    pub fn within(error_m: f64) -> Self {
        Self { edges: &edge::ERROR, interior: &interior::ADAPT, error_m, ..Self::default() }
    }

    /// Returns settings for a mesh as fine as the voxels of a view.
    pub fn seen_by(view: View) -> Self {
        Self { edges: &edge::PIXELS, interior: &interior::SWEEP, view: Some(view), ..Self::default() }
    }
}

impl Default for MeshSettings {
    /// Returns settings for a point every texel, in a fixed pattern, on flat triangles along
    /// interpolated normals, without gaps.
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
            pose: Pose::IDENTITY,
        }
    }
}
