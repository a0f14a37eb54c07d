//! The points inside of a patch.

use glam::{DVec2, DVec3, Vec3};
use relief_core::mesh::{BasePoint, Vertex};

use super::Triangles;
use crate::patch::PatchPoint;
use crate::surface::{Frame, Placed, Relief};
use crate::{BaseSurface, cubic, direction, point};

/// A patch as its inner points are made of it: what belongs to its corners and sides, looked up once for all
/// of them.
#[derive(Debug)]
pub struct Inside {
    bases: [BasePoint; 3],
    /// Whether directions between the corners are found by angles.
    is_by_angle: bool,
    frames: [Frame; 3],
    /// By how much all points are displaced farther.
    raise_m: f64,
    /// What the corners count in the picture, where sides go by that.
    shares: Option<[f64; 3]>,
    smooth: Smooth,
    /// The corners' depths in the picture, and texels of the map in a voxel where the depth is 1; none where
    /// no coarser level is seen.
    footprints: Option<[[f64; 3]; 2]>,
}

/// How the base surface leaves the flat triangle.
#[derive(Debug)]
enum Smooth {
    Flat,
    /// By so much for each side, in metres: see [`Mesh::lifts`](relief_core::mesh::Mesh::lifts).
    Lift([f64; 3]),
    /// As a cubic with those inner control points on each side.
    Cubic([[DVec3; 2]; 3]),
}

impl Inside {
    pub fn new(base: &Triangles, patch: u32) -> Self {
        let corners = base.triangles[patch as usize];
        let sides = base.edges.sides(patch);
        let smooth = match base.base {
            BaseSurface::Flat => Smooth::Flat,
            BaseSurface::Lift => Smooth::Lift(sides.map(|side| base.lift(base.seen(side)))),
            BaseSurface::Pn => Smooth::Cubic([0, 1, 2].map(|k| {
                let [first, second] = base.bent(sides[k]);
                let is_forth = base.edges.ends(sides[k])[0] == corners[k];
                if is_forth { [first, second] } else { [second, first] }
            })),
        };
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
            smooth,
            footprints,
        }
    }

    /// The weights of all corners, by those of the second and the third one in the picture.
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
    fn placed(&self, weights: [f64; 3]) -> Placed {
        let mut base = self.base(weights);
        let lift_m = match &self.smooth {
            Smooth::Flat => 0.0,
            Smooth::Lift(lifts) => {
                let lift = |k: usize| lifts[k] * weights[k] * weights[(k + 1) % 3];
                lift(0) + lift(1) + lift(2)
            }
            Smooth::Cubic(bent) => {
                base.position = cubic::inside(self.bases.map(|base| base.position), *bent, weights);
                0.0
            }
        };
        let level = match &self.footprints {
            None => 0.0,
            Some([depths, texels]) => super::level(*depths, *texels, weights),
        };
        Placed { base, lift_m: lift_m + self.raise_m, level }
    }

    /// The direction of displacement at a point, of any length.
    pub fn direction(&self, weights: [f64; 2]) -> DVec3 {
        self.base(self.weights(weights)).normal
    }

    /// The point of the flat triangle, with the direction of displacement there.
    #[inline(always)]
    fn base(&self, weights: [f64; 3]) -> BasePoint {
        let base = BasePoint::weighted(self.bases, weights);
        if !self.is_by_angle {
            return base;
        }
        BasePoint { normal: direction::mean(self.bases.map(|corner| corner.normal), weights), ..base }
    }

    /// The texture coordinates of a point of the patch that this is, as its own corners have them.
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

    /// The position of a point.
    #[inline(always)]
    pub fn position(&self, relief: &Relief, weights: [f64; 2]) -> Vec3 {
        let placed = self.placed(self.weights(weights));
        point::stored(relief.displaced(&placed))
    }

    /// The vertex at a point.
    #[inline(always)]
    pub fn vertex(&self, relief: &Relief, weights: [f64; 2]) -> Vertex {
        let weights = self.weights(weights);
        let placed = self.placed(weights);
        let seen = relief.seen(&placed);
        relief.vertex_of(&placed.base, seen, &Frame::weighted(&self.frames, weights))
    }

    /// The vertex at a point that lies at a height of the map.
    #[inline(always)]
    pub fn vertex_at(&self, relief: &Relief, weights: [f64; 2], height: f64) -> Vertex {
        let weights = self.weights(weights);
        let placed = self.placed(weights);
        let seen = relief.seen(&placed).at_metres(relief.metres(height) + placed.lift_m);
        relief.vertex_of(&placed.base, seen, &Frame::weighted(&self.frames, weights))
    }
}
