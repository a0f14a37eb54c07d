//! Points inside a patch.

use glam::{DVec2, DVec3, Vec3};
use relief_core::mesh::{BasePoint, Vertex};

use super::Triangles;
use super::halves::PartWeights;
use super::shape::{Shape, in_whole};
use crate::patch::PatchPoint;
use crate::surface::{Frame, Relief, SurfacePoint};
use crate::{direction, point};

/// Patch with the values at its corners and sides, looked up once for all of its inner points.
#[derive(Debug)]
pub struct Inside {
    bases: [BasePoint; 3],
    /// Whether directions between the corners are interpolated by angles.
    is_by_angle: bool,
    frames: [Frame; 3],
    /// Extra displacement of all points in metres.
    raise_m: f64,
    /// Shares of the corners in the picture, if sides are divided by voxels.
    shares: Option<[f64; 3]>,
    /// Shape of a smooth base over the whole triangle, and the weights of this patch in it. Without
    /// weights the patch is the whole triangle.
    shape: Shape,
    part: Option<PartWeights>,
    /// Depths of the corners in the picture, and texels of the map in a voxel where the depth is 1.
    /// `None` if there are no coarser levels.
    footprints: Option<[[f64; 3]; 2]>,
}

impl Inside {
    pub fn new(base: &Triangles, patch: u32) -> Self {
        let corners = base.triangles[patch as usize];
        let (shape, part) = base.shape(patch);
        let shares = corners.map(|vertex| base.share(vertex));
        let texels = |vertex: u32| base.footprints.get(vertex as usize).copied();
        let footprints = match corners.map(texels) {
            [Some(a), Some(b), Some(c)] => Some([shares.map(|share| 1.0 / share), [a, b, c]]),
            _ => None,
        };
        Self {
            bases: corners.map(|vertex| base.corners.base(vertex)),
            is_by_angle: base.corners.is_by_angle(),
            raise_m: base.raise_m(),
            frames: corners.map(|vertex| base.corners.frame(vertex)),
            shares: (!base.voxels.is_empty()).then_some(shares),
            shape,
            part,
            footprints,
        }
    }

    /// Returns the weights of all corners, from the weights of the second and the third one in the
    /// picture.
    #[inline(always)]
    fn weights(&self, [b, c]: [f64; 2]) -> [f64; 3] {
        let weights = [1.0 - b - c, b, c];
        match self.shares {
            None => weights,
            Some(shares) => {
                let of = [weights[0] * shares[0], weights[1] * shares[1], weights[2] * shares[2]];
                let sum = of[0] + of[1] + of[2];
                [of[0] / sum, of[1] / sum, of[2] / sum]
            }
        }
    }

    #[inline(always)]
    fn surface_point(&self, weights: [f64; 3]) -> SurfacePoint {
        let mut base = self.base(weights);
        let lift_m = match &self.shape {
            Shape::Flat => 0.0,
            shape => {
                let in_whole = self.part.as_ref().map_or(weights, |part| in_whole(part, weights));
                base.position = shape.position(in_whole).unwrap_or(base.position);
                shape.lift_m(in_whole)
            }
        };
        let level = match &self.footprints {
            None => 0.0,
            Some([depths, texels]) => super::level(*depths, *texels, weights),
        };
        SurfacePoint { base, lift_m: lift_m + self.raise_m, level }
    }

    /// Returns the direction of displacement at a point, of any length.
    pub fn direction(&self, weights: [f64; 2]) -> DVec3 {
        self.base(self.weights(weights)).normal
    }

    /// Returns the point of the flat triangle, with the direction of displacement there.
    #[inline(always)]
    fn base(&self, weights: [f64; 3]) -> BasePoint {
        let base = BasePoint::weighted(self.bases, weights);
        if !self.is_by_angle {
            return base;
        }
        BasePoint { normal: direction::mean(self.bases.map(|corner| corner.normal), weights), ..base }
    }

    /// Returns the texture coordinates of a point of the patch, interpolated from the patch's own
    /// corners.
    pub fn uv(&self, base: &Triangles, patch: u32, point: &PatchPoint) -> DVec2 {
        let weights = match *point {
            PatchPoint::Inner { weights, .. } => self.weights(weights),
            PatchPoint::Border { side, at } => {
                let mut weights = [0.0; 3];
                let [from, to] = base.parts_before(patch, side, at);
                weights[side as usize] = from;
                weights[(side as usize + 1) % 3] = to;
                weights
            }
        };
        BasePoint::weighted(self.bases, weights).uv
    }

    /// Returns the position of a point.
    #[inline(always)]
    pub fn position(&self, relief: &Relief, weights: [f64; 2]) -> Vec3 {
        let point = self.surface_point(self.weights(weights));
        point::stored(relief.displaced(&point))
    }

    /// Returns the vertex at a point.
    #[inline(always)]
    pub fn vertex(&self, relief: &Relief, weights: [f64; 2]) -> Vertex {
        let weights = self.weights(weights);
        let point = self.surface_point(weights);
        let displacement = relief.displacement(&point);
        relief.vertex_of(&point.base, displacement, &Frame::weighted(&self.frames, weights))
    }

    /// Returns the vertex at a point that lies at a height of the map.
    #[inline(always)]
    pub fn vertex_at(&self, relief: &Relief, weights: [f64; 2], height: f64) -> Vertex {
        let weights = self.weights(weights);
        let point = self.surface_point(weights);
        let displacement = relief.displacement(&point).at_metres(relief.metres(height) + point.lift_m);
        relief.vertex_of(&point.base, displacement, &Frame::weighted(&self.frames, weights))
    }
}
