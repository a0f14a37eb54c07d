//! Watertight ray casting against a mesh of flat triangles.
//!
//! The BVH is built by `obvhs`; traversal and triangle test are ours. The test shears space so that
//! the ray runs along an axis. It then checks on which side of each projected edge the ray passes
//! (after Woop, Benthin and Wald, *Watertight Ray/Triangle Intersection*, JCGT 2013).
//!
//! It works in `f64` throughout. A product of rounded numbers keeps its order under rounding. So
//! the sign of `a b - c d` is never wrong; it can only be lost to 0, which counts as inside. Both
//! triangles at an edge use the same two projected corners, so a ray cannot pass between them.

use self::collector::{HitBatch, HitCollector, Nearest};
use crate::hierarchy::collapsed;
use crate::mesh::Mesh;
use glam::{DVec2, DVec3, Vec3};
use obvhs::bvh2::Bvh2;
use obvhs::triangle::Triangle;
use obvhs::{Boundable, BvhBuildParams};
use std::fmt;

mod collector;
pub mod tiles;

/// Growth of boxes, relative to the largest coordinate involved. It must exceed the triangle test's
/// rounding (a few 1e-16); otherwise a box could reject what the test would accept. A larger value
/// only costs visits.
const BOX_SLACK: f64 = 1e-12;

/// Depth up to which a BVH is traversed without allocating memory. Only contrived meshes have
/// deeper ones.
const STACK_DEPTH: usize = 64;

/// A straight ray in the world, such as the ray through a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// Beginning of the ray, in metres.
    pub origin: DVec3,
    /// Direction, not normalised. The parameter `t` of a point `origin + t * direction` is in units
    /// of this vector.
    pub direction: DVec3,
}

impl Ray {
    /// Point at parameter `t`.
    #[inline]
    pub fn at(&self, t: f64) -> DVec3 {
        self.origin + self.direction * t
    }
}

/// Sides of a triangle that a ray can hit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Sides {
    /// Only fronts: the corners are counter-clockwise seen from the ray's origin.
    #[default]
    Front,
    /// Fronts and backs.
    Both,
}

/// A hit of a ray with a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfaceHit {
    /// Parameter of the point along the ray, at least 0. For a camera's ray it is the depth along
    /// the view axis in metres.
    pub t: f64,
    /// Number of the triangle in the mesh.
    pub triangle: u32,
    /// Barycentric weights of the triangle's corners at the point. None is negative, and they add
    /// up to 1.
    pub weights: [f64; 3],
    /// Whether the ray hits the front.
    pub front: bool,
}

/// A mesh prepared for ray casting, with a BVH.
///
/// Answers depend on the mesh and the ray alone, not on the BVH. Hits are ordered by
/// `(t, triangle)`. A ray through an edge or a corner hits every adjacent triangle.
#[derive(Clone)]
pub struct RayCaster {
    corners: Vec<[DVec3; 3]>,
    bvh: Bvh2,
    depth: usize,
    /// Largest absolute coordinate of the mesh.
    extent: f64,
}

impl fmt::Debug for RayCaster {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "RayCaster({} triangles)", self.corners.len())
    }
}

impl RayCaster {
    /// Most memory per triangle during the preparation, in bytes.
    pub const BYTES_PER_TRIANGLE: u64 = 300;

    /// Prepares a mesh. It takes about 300 bytes per triangle.
    pub fn new(mesh: &Mesh) -> Self {
        let numbers = 0..mesh.triangles().len() as u32;
        Self::of_corners(numbers.map(|triangle| mesh.corners(triangle).map(|corner| corner.position)))
    }

    /// Prepares triangles from their corners.
    pub fn of_corners(corners: impl Iterator<Item = [Vec3; 3]>) -> Self {
        let triangle = |corners: [Vec3; 3]| {
            let [v0, v1, v2] = corners.map(Into::into);
            Triangle { v0, v1, v2 }
        };
        let triangles: Vec<Triangle> = corners.map(triangle).collect();
        let bvh = if triangles.is_empty() {
            Bvh2::default()
        } else {
            collapsed(
                &triangles.iter().map(Boundable::aabb).collect::<Vec<_>>(),
                &BvhBuildParams::medium_build(),
            )
        };
        let corners: Vec<[DVec3; 3]> = triangles
            .iter()
            .map(|triangle| [triangle.v0, triangle.v1, triangle.v2].map(|corner| corner.as_dvec3()))
            .collect();
        let extent =
            corners.iter().flatten().fold(0.0f64, |extent, corner| extent.max(corner.abs().max_element()));
        let depth = depth_below(&bvh);
        Self { corners, bvh, depth, extent }
    }

    /// Number of triangles.
    pub fn triangles(&self) -> usize {
        self.corners.len()
    }

    /// Returns the hit with the least `(t, triangle)` behind the hit `after`, or the first hit if
    /// that is `None`. A ray whose numbers are not finite, or whose direction is 0, hits nothing.
    pub fn next_hit(&self, ray: &Ray, sides: Sides, after: Option<&SurfaceHit>) -> Option<SurfaceHit> {
        self.next_after(ray, sides, after.map(|hit| (hit.t, hit.triangle)))
    }

    /// Returns the next hit as [`Self::next_hit`], behind a hit with this `(t, triangle)`.
    fn next_after(&self, ray: &Ray, sides: Sides, after: Option<(f64, u32)>) -> Option<SurfaceHit> {
        let mut nearest = Nearest::default();
        self.find_after(ray, sides, after, &mut nearest);
        nearest.hit
    }

    /// Collects the first hits behind one with this `(t, triangle)`.
    fn find_after(
        &self,
        ray: &Ray,
        sides: Sides,
        after: Option<(f64, u32)>,
        collector: &mut impl HitCollector,
    ) {
        let Some(query) = Query::new(ray, sides, after, self.extent) else { return };
        if self.depth <= STACK_DEPTH {
            self.walk(&query, &mut [(0.0, 0); STACK_DEPTH], collector);
        } else {
            self.walk(&query, &mut vec![(0.0, 0); self.depth], collector);
        }
    }

    /// Returns all hits in the order of `(t, triangle)`. They are found on demand: the first one
    /// alone, the later ones in batches.
    pub fn hits<'a>(&'a self, ray: &'a Ray, sides: Sides) -> impl Iterator<Item = SurfaceHit> + 'a {
        self.hits_after(*ray, sides, None)
    }

    /// Returns the hits behind one with this `(t, triangle)`.
    fn hits_after(
        &self,
        ray: Ray,
        sides: Sides,
        after: Option<(f64, u32)>,
    ) -> impl Iterator<Item = SurfaceHit> {
        let (mut last, mut batch) = (after, None::<HitBatch>);
        std::iter::from_fn(move || {
            let hit = match batch.as_mut().and_then(HitBatch::next) {
                Some(hit) => hit,
                None if last.is_none() => self.next_after(&ray, sides, None)?,
                None => {
                    let mut next = batch.take().map_or_else(|| Some(HitBatch::new()), HitBatch::more)?;
                    self.find_after(&ray, sides, last, &mut next);
                    next.sort();
                    batch.insert(next).next()?
                }
            };
            last = Some((hit.t, hit.triangle));
            Some(hit)
        })
    }

    /// Traverses the BVH from near to far. `stack` must hold a node per level.
    fn walk(&self, query: &Query, stack: &mut [(f64, u32)], collector: &mut impl HitCollector) {
        let mut waiting = 0;
        let mut next = self.enter(query, 0).map(|entry| (entry, 0));
        loop {
            let Some((entry, index)) = next.take().or_else(|| {
                waiting = usize::checked_sub(waiting, 1)?;
                Some(stack[waiting])
            }) else {
                return;
            };
            if entry > collector.reach() {
                continue;
            }
            let node = &self.bvh.nodes[index as usize];
            if node.is_leaf() {
                let first = node.first_index as usize;
                for &triangle in &self.bvh.primitive_indices[first..first + node.prim_count as usize] {
                    if let Some(hit) = query.triangle(triangle, &self.corners[triangle as usize]) {
                        collector.offer(hit);
                    }
                }
                continue;
            }
            let (left, right) = (node.first_index, node.first_index + 1);
            match (self.enter(query, left), self.enter(query, right)) {
                (Some(a), Some(b)) => {
                    let (near, far) = if a <= b { ((a, left), (b, right)) } else { ((b, right), (a, left)) };
                    stack[waiting] = far;
                    waiting += 1;
                    next = Some(near);
                }
                (Some(a), None) => next = Some((a, left)),
                (None, Some(b)) => next = Some((b, right)),
                (None, None) => {}
            }
        }
    }

    /// Parameter at which the ray enters a node's grown box. `None` if it misses the box or leaves
    /// it before the hits that are still wanted.
    #[inline]
    fn enter(&self, query: &Query, node: u32) -> Option<f64> {
        let bounds = self.bvh.nodes.get(node as usize)?.aabb();
        let (min, max) = (bounds.min.as_dvec3(), bounds.max.as_dvec3());
        let a = (min - query.slack - query.ray.origin) * query.inverse;
        let b = (max + query.slack - query.ray.origin) * query.inverse;
        let entry = a.min(b).max_element();
        let exit = a.max(b).min_element();
        (entry <= exit && exit >= query.after.0).then_some(entry)
    }
}

/// A ray with the values that are computed once for all triangles.
struct Query {
    ray: Ray,
    sides: Sides,
    /// Hits at or before this `(t, triangle)` are skipped.
    after: (f64, Option<u32>),
    inverse: DVec3,
    slack: DVec3,
    /// Axes that the shear maps to x, y and z. z is the axis along which the direction is longest.
    axes: [usize; 3],
    /// `(x, y)` of the direction, divided by its `z`.
    shear: DVec2,
    inverse_z: f64,
}

impl Query {
    fn new(ray: &Ray, sides: Sides, after: Option<(f64, u32)>, extent: f64) -> Option<Self> {
        let longest = ray.direction.abs().max_element();
        if !(longest > 0.0 && ray.direction.is_finite() && ray.origin.is_finite()) {
            return None;
        }
        let z = ray.direction.abs().max_position();
        // A cyclic order keeps the handedness, and with it the front side. A negative z mirrors it.
        let (mut x, mut y) = ((z + 1) % 3, (z + 2) % 3);
        if ray.direction[z] < 0.0 {
            std::mem::swap(&mut x, &mut y);
        }
        let inverse_z = 1.0 / ray.direction[z];
        let largest = extent.max(ray.origin.abs().max_element()).max(f64::MIN_POSITIVE);
        Some(Self {
            ray: *ray,
            sides,
            after: after.map_or((0.0, None), |(t, triangle)| (t, Some(triangle))),
            inverse: ray.direction.recip(),
            slack: DVec3::splat(largest * BOX_SLACK),
            axes: [x, y, z],
            shear: DVec2::new(ray.direction[x], ray.direction[y]) * inverse_z,
            inverse_z,
        })
    }

    /// Transforms a corner to the space in which the ray runs along `+z` from the origin. The
    /// result depends on corner and ray alone.
    #[inline]
    fn sheared(&self, corner: DVec3) -> DVec3 {
        let p = corner - self.ray.origin;
        let [x, y, z] = self.axes;
        DVec3::new(p[x] - self.shear.x * p[z], p[y] - self.shear.y * p[z], p[z] * self.inverse_z)
    }

    #[inline]
    fn triangle(&self, triangle: u32, corners: &[DVec3; 3]) -> Option<SurfaceHit> {
        let [a, b, c] = [self.sheared(corners[0]), self.sheared(corners[1]), self.sheared(corners[2])];
        // Twice the areas of the parts of the projected triangle opposite each corner. Seen along
        // the ray, the corners of a front run clockwise in these right-handed axes.
        let wa = c.x * b.y - c.y * b.x;
        let wb = a.x * c.y - a.y * c.x;
        let wc = b.x * a.y - b.y * a.x;
        let front = wa >= 0.0 && wb >= 0.0 && wc >= 0.0;
        let back = wa <= 0.0 && wb <= 0.0 && wc <= 0.0;
        if !(front || back && self.sides == Sides::Both) {
            return None;
        }
        let area = wa + wb + wc;
        if area == 0.0 {
            // The triangle is seen exactly from its edge. Its neighbours are hit there.
            return None;
        }
        let weights = [wa / area, wb / area, wc / area];
        let t = a.z + weights[1] * (b.z - a.z) + weights[2] * (c.z - a.z);
        let wanted = match self.after {
            (_, None) => t >= 0.0,
            (after, Some(number)) => precedes((after, number), (t, triangle)),
        };
        wanted.then_some(SurfaceHit { t, triangle, weights, front })
    }
}

/// Order of hits.
#[inline]
fn precedes(a: (f64, u32), b: (f64, u32)) -> bool {
    a.0 < b.0 || a.0 == b.0 && a.1 < b.1
}

/// Number of levels of inner nodes below the root, itself included: the most nodes that can wait on
/// the stack.
fn depth_below(bvh: &Bvh2) -> usize {
    let mut deepest = 0;
    let mut waiting = vec![(0u32, 1)];
    while let Some((index, depth)) = waiting.pop() {
        deepest = deepest.max(depth);
        match bvh.nodes.get(index as usize) {
            Some(node) if !node.is_leaf() => {
                waiting.push((node.first_index, depth + 1));
                waiting.push((node.first_index + 1, depth + 1));
            }
            _ => {}
        }
    }
    deepest
}

#[cfg(test)]
mod tests;
