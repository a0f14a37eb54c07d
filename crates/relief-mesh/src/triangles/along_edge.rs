//! The points along an edge.

use glam::{DVec2, DVec3, Vec3};
use relief_core::mesh::{BasePoint, Vertex};

use super::shape::Shape;
use super::{Corners, Numbered, Triangles, level};
use crate::surface::{Frame, Placed, Relief};
use crate::{BaseSurface, cubic, point};

/// An edge as its points are made of it: what belongs to its ends, looked up once for all of them.
#[derive(Debug)]
pub struct AlongEdge<'a> {
    corners: &'a Corners,
    /// By how much all points are displaced farther.
    raise_m: f64,
    /// The ends as the displacement sees them.
    ends: [BasePoint; 2],
    shares: [f64; 2],
    smooth: Smooth,
    /// The ends' depths in the picture, and texels of the map in a voxel where the depth is 1; none where no
    /// coarser level is seen.
    footprints: Option<[[f64; 2]; 2]>,
}

/// How the base surface leaves the straight edge.
#[derive(Debug)]
enum Smooth {
    Flat,
    /// By so many metres: see [`Mesh::lifts`](relief_core::mesh::Mesh::lifts).
    Lift(f64),
    /// As a cubic with those inner control points.
    Cubic([DVec3; 2]),
    /// As a part of that shape, by the weights of the ends in it.
    Part(Box<(Shape, [[f64; 3]; 2])>),
}

impl<'a> AlongEdge<'a> {
    pub fn new(base: &'a Triangles, edge: u32) -> Self {
        let seen = base.seen(edge);
        let ends = base.edges.ends(seen);
        let texels = |vertex: u32| base.footprints.get(vertex as usize).copied();
        let footprints = match ends.map(texels) {
            [Some(a), Some(b)] => Some([ends.map(|vertex| 1.0 / base.share(vertex)), [a, b]]),
            _ => None,
        };
        Self {
            corners: &base.corners,
            raise_m: base.raise_m(),
            ends: ends.map(|end| base.corners.base(end)),
            shares: base.edges.ends(edge).map(|end| base.share(end)),
            smooth: match (&base.parts, base.base) {
                (Some(parts), _) => Smooth::Part(Box::new(parts.of_side(ends))),
                (None, BaseSurface::Flat) => Smooth::Flat,
                (None, BaseSurface::Lift) => Smooth::Lift(base.lift(seen)),
                (None, BaseSurface::Pn) => Smooth::Cubic(base.bent(edge)),
            },
            footprints,
        }
    }

    /// The weights that the ends have where so many steps of all lie before.
    fn weights(&self, [before, all]: [u32; 2]) -> [f64; 2] {
        point::weights(self.shares, before, all)
    }

    /// A point as the displacement sees it: in a welded mesh all sides see the same.
    #[inline(always)]
    pub fn placed(&self, place: [u32; 2]) -> Placed {
        let weights = self.weights(place);
        let [a, b] = &self.ends;
        let mut base = BasePoint {
            position: point::between(a.position, b.position, weights),
            normal: self.corners.direction_on_side([a.normal, b.normal], weights),
            uv: point::between(a.uv, b.uv, weights),
        };
        let [of_a, of_b] = weights;
        let sum = of_a + of_b;
        let parts = [of_a / sum, of_b / sum];
        let lift_m = match &self.smooth {
            Smooth::Flat => 0.0,
            Smooth::Lift(lift_m) => lift_m * (of_b * of_a / (sum * sum)),
            Smooth::Cubic(bent) => {
                base.position = cubic::on_side([a.position, b.position], *bent, parts);
                0.0
            }
            Smooth::Part(part) => {
                let (shape, [from, to]) = &**part;
                let weights = [0, 1, 2].map(|k| from[k] * parts[0] + to[k] * parts[1]);
                base.position = shape.position(weights).unwrap_or(base.position);
                shape.lift_m(weights)
            }
        };
        let level = self.footprints.map_or(0.0, |[depths, texels]| level(depths, texels, parts));
        Placed { base, lift_m: lift_m + self.raise_m, level }
    }

    /// The position of a point.
    #[inline(always)]
    pub fn position(&self, relief: &Relief, place: [u32; 2]) -> Vec3 {
        point::stored(relief.displaced(&self.placed(place)))
    }
}

/// The vertices between the ends of an edge.
#[derive(Debug)]
pub struct EdgeVertices<'a> {
    base: &'a Triangles,
    edge: u32,
    along: AlongEdge<'a>,
    /// The texture coordinates and the frames of its own ends.
    uvs: [DVec2; 2],
    frames: [Frame; 2],
}

impl<'a> EdgeVertices<'a> {
    pub fn new(base: &'a Triangles, edge: u32) -> Self {
        let ends = base.edges.ends(edge);
        Self {
            base,
            edge,
            along: AlongEdge::new(base, edge),
            uvs: ends.map(|end| base.corners.base(end).uv),
            frames: ends.map(|end| base.corners.frame(end)),
        }
    }

    /// The vertex that so many parts lie before, and how it is numbered.
    pub fn at(&self, relief: &Relief, at: u32) -> (Vertex, Numbered) {
        let place = self.base.edges.place(self.edge, at);
        let seen = self.along.placed(place);
        let weights = self.along.weights(place);
        let part = weights[1] / (weights[0] + weights[1]);
        let [a, b] = self.frames;
        let frame = Frame::weighted(&[a, b, a], [1.0 - part, part, 0.0]);
        let uv = point::between(self.uvs[0], self.uvs[1], weights);
        let position = relief.displaced(&seen);
        let own = Placed { base: BasePoint { uv, ..seen.base }, ..seen };
        (relief.vertex_at(position, &own, &frame), self.base.edges.numbered(self.edge, at))
    }
}
