//! Points along an edge.

use glam::{DVec2, DVec3, Vec3};
use relief_core::mesh::{BasePoint, Vertex};

use super::shape::Shape;
use super::{Corners, Numbered, Triangles, level};
use crate::surface::{Frame, Relief, SurfacePoint};
use crate::{BaseSurface, cubic, point};

/// Edge with the values at its ends, looked up once for all of its points.
#[derive(Debug)]
pub struct AlongEdge<'a> {
    corners: &'a Corners,
    /// Extra displacement of all points in metres.
    raise_m: f64,
    /// Ends whose texture coordinates define the displacement.
    ends: [BasePoint; 2],
    shares: [f64; 2],
    smooth: Smooth,
    /// Depths of the ends in the picture, and texels of the map in a voxel where the depth is 1.
    /// `None` if there are no coarser levels.
    footprints: Option<[[f64; 2]; 2]>,
}

/// Deviation of the base surface from the straight edge.
#[derive(Debug)]
enum Smooth {
    Flat,
    /// By metres: see [`Mesh::lifts`](relief_core::mesh::Mesh::lifts).
    Lift(f64),
    /// Cubic with these inner control points.
    Cubic([DVec3; 2]),
    /// Part of a shape, by the weights of the ends in it.
    Part(Box<(Shape, [[f64; 3]; 2])>),
}

impl<'a> AlongEdge<'a> {
    pub fn new(base: &'a Triangles, edge: u32) -> Self {
        let leader = base.leader(edge);
        let ends = base.edges.ends(leader);
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
                (None, BaseSurface::Lift) => Smooth::Lift(base.lift(leader)),
                (None, BaseSurface::Pn) => Smooth::Cubic(base.bent(edge)),
            },
            footprints,
        }
    }

    /// Returns the weights of the ends for a point with `before` of `all` steps before it.
    fn weights(&self, [before, all]: [u32; 2]) -> [f64; 2] {
        point::weights(self.shares, before, all)
    }

    /// Returns a point on the side that defines the displacement: in a welded mesh all sides use
    /// the same.
    #[inline(always)]
    pub fn surface_point(&self, place: [u32; 2]) -> SurfacePoint {
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
        SurfacePoint { base, lift_m: lift_m + self.raise_m, level }
    }

    /// Returns the position of a point.
    #[inline(always)]
    pub fn position(&self, relief: &Relief, place: [u32; 2]) -> Vec3 {
        point::stored(relief.displaced(&self.surface_point(place)))
    }
}

/// Vertices between the ends of an edge.
#[derive(Debug)]
pub struct EdgeVertices<'a> {
    base: &'a Triangles,
    edge: u32,
    along: AlongEdge<'a>,
    /// Texture coordinates and frames of its own ends.
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

    /// Returns the vertex with `at` parts before it, and its numbers.
    pub fn at(&self, relief: &Relief, at: u32) -> (Vertex, Numbered) {
        let place = self.base.edges.place(self.edge, at);
        let leading = self.along.surface_point(place);
        let weights = self.along.weights(place);
        let part = weights[1] / (weights[0] + weights[1]);
        let [a, b] = self.frames;
        let frame = Frame::weighted(&[a, b, a], [1.0 - part, part, 0.0]);
        let uv = point::between(self.uvs[0], self.uvs[1], weights);
        let position = relief.displaced(&leading);
        let own = SurfacePoint { base: BasePoint { uv, ..leading.base }, ..leading };
        (relief.vertex_at(position, &own, &frame), self.base.edges.numbered(self.edge, at))
    }
}
