//! Smooth bases over triangles, and over parts of them.
//!
//! A triangle with sides of too many texels is halved before it is filled. Halves of a smooth base
//! are parts of the whole one, not smooth bases of their own. Their points are computed in the
//! whole triangle. Points on a whole side depend on that side's ends alone.

use std::collections::HashMap;

use glam::DVec3;
use relief_core::mesh::{BasePoint, Mesh};

use super::corners::Corners;
use super::edges::{Division, Edges};
use super::halves::{Halved, PartWeights, sorted};
use crate::{BaseSurface, MesherError, cubic};

/// Deviation of a base from a flat triangle. Side `k` goes from corner `k` to the next.
#[derive(Clone, Copy, Debug)]
pub enum Shape {
    /// None.
    Flat,
    /// Lifts in metres, one for each side: see [`Mesh::lifts`](relief_core::mesh::Mesh::lifts).
    Lift([f64; 3]),
    /// A cubic: its corners, and the inner control points of its sides.
    Cubic([DVec3; 3], [[DVec3; 2]; 3]),
}

impl Shape {
    /// Returns the lift above the flat triangle in metres, along the direction of displacement.
    #[inline(always)]
    pub fn lift_m(&self, weights: [f64; 3]) -> f64 {
        let Self::Lift(lifts) = self else { return 0.0 };
        let lift = |k: usize| lifts[k] * weights[k] * weights[(k + 1) % 3];
        lift(0) + lift(1) + lift(2)
    }

    /// Returns the position of a point, or `None` if it lies on the flat triangle.
    #[inline(always)]
    pub fn position(&self, weights: [f64; 3]) -> Option<DVec3> {
        let Self::Cubic(corners, sides) = self else { return None };
        Some(cubic::inside(*corners, *sides, weights))
    }

    /// Creates the shape along an edge: a triangle whose last two corners are its second end.
    pub fn along(edge: &WholeEdge, base: BaseSurface) -> Self {
        let [a, b] = edge.ends.map(|end| end.position);
        match base {
            BaseSurface::Flat => Self::Flat,
            BaseSurface::Lift => Self::Lift([edge.lift_m, 0.0, 0.0]),
            BaseSurface::Pn => Self::Cubic([a, b, b], [cubic::bent(edge.ends), [b; 2], [b, a]]),
        }
    }
}

/// Edge of a smooth base.
#[derive(Clone, Copy, Debug)]
pub struct WholeEdge {
    pub ends: [BasePoint; 2],
    /// Lift of the smooth base along it in metres.
    pub lift_m: f64,
}

/// Carrier of points: an edge of the whole mesh, with the weights of its two ends and 0, or a
/// triangle, with the weights of its corners.
#[derive(Clone, Copy, Debug)]
pub enum On {
    Edge(u32),
    Triangle(u32),
}

/// Parts of the triangles of a whole mesh, whose base is smooth.
#[derive(Debug)]
pub struct Parts {
    base: BaseSurface,
    /// Edges of the whole mesh. In a welded mesh each is the first one at its seam.
    edges: Vec<WholeEdge>,
    /// Shapes of its triangles.
    shapes: Vec<Shape>,
    /// Whole triangle of each patch, and the weights of the patch's corners in it.
    patches: Vec<(u32, PartWeights)>,
    /// Sides of patches, by their vertices, the lower one first.
    sides: HashMap<[u32; 2], (On, [[f64; 3]; 2])>,
    /// Vertices that are no corners of the whole mesh.
    vertices: HashMap<u32, (On, [f64; 3])>,
}

impl Parts {
    /// Finds the parts of a halved mesh. `mesh` and `corners` belong to the whole mesh.
    pub fn new(
        mesh: &Mesh,
        point_of: &[u32],
        corners: &Corners,
        (is_welded, base): (bool, BaseSurface),
        halved: &Halved,
    ) -> Result<Self, MesherError> {
        let all = Edges::new(mesh, point_of, corners, |_| Ok(Division::WHOLE))?;
        let edges = (0..all.count()).map(|edge| {
            let leader = if is_welded { all.first_at_seam(edge) } else { edge };
            let lift_m = if base == BaseSurface::Lift { all.lift(leader) } else { 0.0 };
            WholeEdge { ends: all.ends(leader).map(|end| corners.base(end)), lift_m }
        });
        let edges: Vec<WholeEdge> = edges.collect();
        let shapes = (0..).zip(mesh.triangles()).map(|(triangle, vertices)| {
            let sides = all.sides(triangle);
            match base {
                BaseSurface::Flat => Shape::Flat,
                BaseSurface::Lift => Shape::Lift(sides.map(|side| edges[side as usize].lift_m)),
                BaseSurface::Pn => {
                    let bent = [0, 1, 2].map(|k| {
                        let [first, second] = cubic::bent(edges[sides[k] as usize].ends);
                        let is_forth = all.ends(sides[k])[0] == vertices[k];
                        if is_forth { [first, second] } else { [second, first] }
                    });
                    Shape::Cubic(vertices.map(|vertex| corners.base(vertex).position), bent)
                }
            }
        });
        let mut parts = Self {
            base,
            shapes: shapes.collect(),
            edges,
            patches: halved.whole.iter().copied().zip(halved.weights.iter().copied()).collect(),
            sides: HashMap::new(),
            vertices: HashMap::new(),
        };
        // Weights in a triangle lie on a side if all of them are 0 at one of its corners.
        let on = |triangle: u32, weights: &[[f64; 3]]| -> (On, Vec<[f64; 3]>) {
            let opposite = (0..3).find(|&corner| weights.iter().all(|of| of[corner] == 0.0));
            let Some(opposite) = opposite else { return (On::Triangle(triangle), weights.to_vec()) };
            let [from, to] = [(opposite + 1) % 3, (opposite + 2) % 3];
            let edge = all.sides(triangle)[from];
            let is_forth = all.ends(edge)[0] == mesh.triangles()[triangle as usize][from];
            let [first, second] = if is_forth { [from, to] } else { [to, from] };
            (On::Edge(edge), weights.iter().map(|of| [of[first], of[second], 0.0]).collect())
        };
        for (patch, &(triangle, weights)) in halved.mesh.triangles().iter().zip(&parts.patches) {
            for k in 0..3 {
                let next = (k + 1) % 3;
                let [from, to] = if patch[k] < patch[next] { [k, next] } else { [next, k] };
                let key = sorted([patch[k], patch[next]]);
                parts.sides.entry(key).or_insert_with(|| {
                    let (on, ends) = on(triangle, &[weights[from], weights[to]]);
                    (on, [ends[0], ends[1]])
                });
                if !weights[k].contains(&1.0) {
                    parts.vertices.entry(patch[k]).or_insert_with(|| {
                        let (on, at) = on(triangle, &[weights[k]]);
                        (on, at[0])
                    });
                }
            }
        }
        Ok(parts)
    }

    /// Returns the shape of a carrier.
    fn shape(&self, on: On) -> Shape {
        match on {
            On::Edge(edge) => Shape::along(&self.edges[edge as usize], self.base),
            On::Triangle(triangle) => self.shapes[triangle as usize],
        }
    }

    /// Returns the shape of the triangle that contains a patch, and the weights of the patch's
    /// corners there.
    pub fn of_patch(&self, patch: u32) -> (Shape, PartWeights) {
        let (triangle, weights) = self.patches[patch as usize];
        (self.shapes[triangle as usize], weights)
    }

    /// Returns the shape of the carrier of a side, and the weights of its ends there.
    pub fn of_side(&self, ends: [u32; 2]) -> (Shape, [[f64; 3]; 2]) {
        let Some(&(on, weights)) = self.sides.get(&sorted(ends)) else { return (Shape::Flat, [[0.0; 3]; 2]) };
        let [low, high] = weights;
        (self.shape(on), if ends[0] < ends[1] { [low, high] } else { [high, low] })
    }

    /// Returns the shape of the carrier of a vertex, and its weights there. Returns `None` for a
    /// corner of the whole mesh.
    pub fn of_vertex(&self, vertex: u32) -> Option<(Shape, [f64; 3])> {
        let (on, weights) = *self.vertices.get(&vertex)?;
        Some((self.shape(on), weights))
    }

    /// Returns a bound on the lift of each patch: the sum of the lifts of its whole triangle's
    /// sides.
    pub fn lifts_m(&self) -> Vec<f64> {
        let lift_m = |(triangle, _): &(u32, PartWeights)| match self.shapes[*triangle as usize] {
            Shape::Lift(lifts_m) => lifts_m.map(f64::abs).iter().sum(),
            Shape::Flat | Shape::Cubic(..) => 0.0,
        };
        self.patches.iter().map(lift_m).collect()
    }

    /// Returns the edges of the whole mesh.
    pub fn edges(&self) -> &[WholeEdge] {
        &self.edges
    }
}

/// Returns a bound on the lift of each triangle: the sum of the greatest lifts at its sides' seams.
pub fn lifts_m(mesh: &Mesh, point_of: &[u32]) -> Vec<f64> {
    let lifts = mesh.lifts();
    let points = |triangle: &[u32; 3], side: usize| {
        sorted([0, 1].map(|end| point_of[triangle[(side + end) % 3] as usize]))
    };
    let mut most: HashMap<[u32; 2], f64> = HashMap::new();
    for (triangle, lifts) in mesh.triangles().iter().zip(&lifts) {
        for side in 0..3 {
            // Lifts are listed by the corner across from the side.
            let lift_m = f64::from(lifts[(side + 2) % 3]).abs();
            let known = most.entry(points(triangle, side)).or_default();
            *known = known.max(lift_m);
        }
    }
    let of_side = |triangle: &[u32; 3], side: usize| most.get(&points(triangle, side)).copied();
    let sum = |triangle: &[u32; 3]| (0..3).filter_map(|side| of_side(triangle, side)).sum();
    mesh.triangles().iter().map(sum).collect()
}

/// Returns the weights of a point in a whole triangle, given its weights in a part and the part's
/// corners.
#[inline(always)]
pub fn in_whole(corners: &PartWeights, weights: [f64; 3]) -> [f64; 3] {
    let [a, b, c] = corners;
    [0, 1, 2].map(|k| a[k] * weights[0] + b[k] * weights[1] + c[k] * weights[2])
}
