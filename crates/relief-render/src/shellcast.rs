//! BVH over the shells of base triangles.
//!
//! The BVH, built by `obvhs`, only proposes triangles to a ray. The shaders decide what the ray
//! hits in their shells.

use std::fmt;
use std::ops::Range;

use glam::{DVec3, Vec3, Vec3A};
use obvhs::BvhBuildParams;
use obvhs::aabb::Aabb;
use obvhs::bvh2::{Bvh2, reinsertion::ReinsertionOptimizer};
use relief_core::Lanes;
use relief_core::pulp::{Simd, WithSimd};
use relief_shaders::cpu::{BLOCK, Corner, Row, Triangle, Vec3 as ShaderVec3};
use relief_shaders::surface::{SHELL_SLACK, Shown};

use crate::job::JobSurface;
use crate::prepare::Triangles;
use relief_core::camera::Ray;

/// Number of boxes up to which a better BVH is built, with which frames take less time. For more
/// boxes building it would take as long as several frames.
const MANY_BOXES: usize = 1 << 16;

/// Extent of the shells of a mesh, in which rays may hit something.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Displacements of the heights 0 and 1 along the corners' normals, in metres.
    pub shell_m: [f32; 2],
    /// Whether back faces have shells, too.
    pub both_sides: bool,
    /// Distance beside a shell at which hits may lie, in tiles of the texture.
    pub beside_tiles: f32,
    /// Whether hits lie in the hulls of the shells' corners. If not, they lie anywhere in the boxes
    /// around these.
    pub in_hulls: bool,
}

impl Bounds {
    /// Returns the bounds of a surface; objects fill the boxes.
    pub fn of(surface: &JobSurface) -> Self {
        let JobSurface { settings, selection, .. } = surface;
        let texels = settings.height_size.x.max(settings.height_size.y) as f32;
        Self {
            shell_m: [settings.shell_m.x, settings.shell_m.y],
            both_sides: surface.two_sided,
            beside_tiles: selection.beside_shells_texels() / texels,
            in_hulls: selection.paths().shown != Shown::Object,
        }
    }

    /// Returns the corners of a triangle's shell, whose hull holds the shell.
    fn corners(&self, triangle: &Triangle) -> Vec<Vec3A> {
        let Triangle { a, b, c, shell } = triangle;
        let offsets = shell.offsets_m(self.shell_m);
        let mut points = Vec::with_capacity(12);
        for corner in [a, b, c] {
            let Corner { position, normal, .. } = corner;
            let (position, normal) =
                (Vec3::new(position.x, position.y, position.z), Vec3::new(normal.x, normal.y, normal.z));
            points.extend(offsets.map(|offset| Vec3A::from(position + normal * offset)));
            if self.both_sides {
                points.extend(offsets.map(|offset| Vec3A::from(position - normal * offset)));
            }
        }
        points
    }

    /// Returns the distance beside a triangle's shell at which hits may lie, in metres, rounded up.
    fn beside_m(&self, triangle: &Triangle) -> f32 {
        let Triangle { a, b, c, .. } = triangle;
        let mean = |of: fn(&Corner) -> ShaderVec3<f32>| {
            let [a, b, c] = [a, b, c].map(of).map(|v| Vec3::new(v.x, v.y, v.z));
            (a + b + c) / 3.0
        };
        let tile_m = mean(|corner| corner.tangent).length().max(mean(|corner| corner.bitangent).length());
        self.beside_tiles * tile_m * 1.001
    }

    /// Returns the boxes around the shells of triangles.
    pub fn boxes(&self, triangles: &Triangles) -> Vec<Aabb> {
        let around = |triangle: Triangle| {
            let mut around = Aabb::from_points(&self.corners(&triangle));
            let beside = Vec3A::splat(self.beside_m(&triangle));
            (around.min, around.max) = (around.min - beside, around.max + beside);
            around
        };
        triangles.iter().map(around).collect()
    }
}

/// The shells of a mesh, prepared for rays.
pub struct ShellCaster {
    bounds: Bounds,
    bvh: Bvh2,
    /// Hull of each triangle's shell; empty if hits lie anywhere in the boxes.
    hulls: Vec<Hull>,
    /// Largest absolute coordinate of a box.
    extent: f64,
}

impl fmt::Debug for ShellCaster {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "ShellCaster({} nodes)", self.bvh.nodes.len())
    }
}

impl ShellCaster {
    /// Builds the BVH of shells. It takes about 150 bytes a triangle.
    pub fn new(triangles: &Triangles, bounds: Bounds) -> Self {
        let boxes = bounds.boxes(triangles);
        let bvh = hierarchy(&boxes);
        let hull_of =
            |triangle: Triangle| hull(&triangle, &bounds.corners(&triangle), bounds.beside_m(&triangle));
        let hulls = if bounds.in_hulls { triangles.iter().map(hull_of).collect() } else { Vec::new() };
        let largest =
            |extent: f32, of: &Aabb| extent.max(of.min.abs().max_element()).max(of.max.abs().max_element());
        Self { bounds, bvh, hulls, extent: boxes.iter().fold(0.0, largest).into() }
    }

    /// Returns the extent of the shells.
    pub fn bounds(&self) -> Bounds {
        self.bounds
    }

    /// Calls `visit` with the numbers of triangles whose shells the ray may hit, roughly from near
    /// to far. `visit` returns the parameter of the ray beyond which shells no longer matter.
    pub fn each(&self, ray: &Ray, mut visit: impl FnMut(u32) -> f64) {
        if !goes_somewhere(ray) {
            return;
        }
        let inverse = ray.direction.recip();
        let slack = DVec3::splat(self.extent.max(ray.origin.abs().max_element()) * SHELL_SLACK);
        let enter = |node: u32| {
            let bounds = self.bvh.nodes.get(node as usize)?.aabb();
            let a = (bounds.min.as_dvec3() - slack - ray.origin) * inverse;
            let b = (bounds.max.as_dvec3() + slack - ray.origin) * inverse;
            let (entry, exit) = (a.min(b).max_element(), a.max(b).min_element());
            (entry <= exit && exit >= 0.0).then_some((entry, node))
        };
        let mut reach = f64::INFINITY;
        let mut waiting = Vec::with_capacity(64);
        waiting.extend(enter(0));
        while let Some((entry, number)) = waiting.pop() {
            if entry > reach {
                continue;
            }
            let node = &self.bvh.nodes[number as usize];
            if node.is_leaf() {
                let first = node.first_index as usize;
                for triangle in &self.bvh.primitive_indices[first..first + node.prim_count as usize] {
                    reach = reach.min(visit(*triangle));
                }
                continue;
            }
            let [left, right] = [node.first_index, node.first_index + 1].map(enter);
            // The nearer one is taken first.
            let is_right_nearer = right.zip(left).is_some_and(|(right, left)| right.0 < left.0);
            let (first, second) = if is_right_nearer { (right, left) } else { (left, right) };
            waiting.extend(second);
            waiting.extend(first);
        }
    }

    /// Returns the rays of a block whose bits `which` has, at the root of the BVH. They reuse the
    /// memory of `before`, another block's rays.
    pub fn block(&self, rays: &Row<Ray>, which: u16, before: BlockRays) -> BlockRays {
        let mut waiting = before.waiting;
        waiting.clear();
        if !self.bvh.nodes.is_empty() {
            waiting.push(0);
        }
        let of = |place: usize| which >> place & 1 == 1 && goes_somewhere(&rays[place]);
        let (origin, direction) = (
            |axis| rays.map(|ray| ray.origin[axis] as f32),
            |axis| rays.map(|ray| ray.direction[axis] as f32),
        );
        BlockRays {
            origin: [0, 1, 2].map(origin),
            direction: [0, 1, 2].map(direction),
            inverse: [0, 1, 2].map(direction).map(|row| row.map(inverse)),
            slack: rays.map(|ray| (self.extent.max(ray.origin.abs().max_element()) * SHELL_SLACK) as f32),
            reach: std::array::from_fn(|place| if of(place) { f32::INFINITY } else { f32::NEG_INFINITY }),
            waiting,
            leaf: 0..0,
            leaf_bounds: Aabb::default(),
        }
    }

    /// Returns the next triangle whose shell a block's rays may hit, roughly from near to far. `at`
    /// gets the parameter at which each ray reaches the shell. It is infinite for rays that do not,
    /// and for rays that reach it beyond their `reach`.
    pub fn next_of_block(&self, rays: &mut BlockRays, lanes: Lanes, at: &mut Row<f32>) -> Option<u32> {
        loop {
            if let Some(index) = rays.leaf.next() {
                let triangle = self.bvh.primitive_indices[index as usize];
                let (bounds, hull) = (rays.leaf_bounds, self.hulls.get(triangle as usize));
                // Something may have been found since the leaf was put there.
                if lanes.run(Test { rays, bounds: &bounds, hull, at }) < f32::INFINITY {
                    return Some(triangle);
                }
                continue;
            }
            let number = rays.waiting.pop()?;
            let node = &self.bvh.nodes[number as usize];
            let first = node.first_index;
            if node.is_leaf() {
                (rays.leaf, rays.leaf_bounds) = (first..first + node.prim_count, *node.aabb());
                continue;
            }
            let mut enter = |child: u32| {
                let bounds = self.bvh.nodes[child as usize].aabb();
                lanes.run(Test { rays, bounds, hull: None, at })
            };
            let mut children = [first, first + 1].map(|child| (enter(child), child));
            // The nearer one is taken first.
            if children[0].0 < children[1].0 {
                children.reverse();
            }
            let met = children.into_iter().filter(|(nearest, _)| *nearest < f32::INFINITY);
            rays.waiting.extend(met.map(|(_, child)| child));
        }
    }
}

/// Builds a BVH with one box in each leaf, because tracing a shell takes far longer than testing a
/// box.
pub fn hierarchy(boxes: &[Aabb]) -> Bvh2 {
    let params =
        if boxes.len() > MANY_BOXES { BvhBuildParams::medium_build() } else { BvhBuildParams::slow_build() };
    let mut bvh = relief_core::hierarchy::hierarchy(boxes, &params);
    let again = params.reinsertion_batch_ratio * params.post_collapse_reinsertion_batch_ratio_multiplier;
    for ratio in [params.reinsertion_batch_ratio, again] {
        ReinsertionOptimizer::default().run(&mut bvh, ratio, None);
    }
    bvh
}

/// Whether a ray has a finite origin, and a finite direction that is not 0.
fn goes_somewhere(ray: &Ray) -> bool {
    ray.direction.abs().max_element() > 0.0 && ray.direction.is_finite() && ray.origin.is_finite()
}

/// Returns the inverse of a direction's component. For a component near 0 it is large and finite,
/// so that the ray is either outside or inside of a slab along it.
#[inline(always)]
fn inverse(component: f32) -> f32 {
    if component.abs() > 1.0 / ACROSS { 1.0 / component } else { ACROSS }
}

/// Inverse of a component that is nearly 0: larger than the ratio of any two distances, and finite.
const ACROSS: f32 = 1e20;

/// Rays of a block, side by side, with the state of their traversal of the BVH.
#[derive(Default)]
pub struct BlockRays {
    origin: [Row<f32>; 3],
    direction: [Row<f32>; 3],
    inverse: [Row<f32>; 3],
    /// Margin of boxes for each ray.
    slack: Row<f32>,
    /// Greatest parameter of each ray at which shells still matter, which callers reduce; minus
    /// infinity for rays that do not exist.
    pub reach: Row<f32>,
    /// Nodes that are still to be visited.
    waiting: Vec<u32>,
    /// Rest of a leaf, and the box around it.
    leaf: Range<u32>,
    leaf_bounds: Aabb,
}

/// Slabs around a shell: a direction, with the least and the greatest extent along it.
type Hull = [([f32; 3], [f32; 2]); 4];

/// Returns the slabs around a triangle's shell, along its normal and its sides' normals, widened by
/// `beside_m`. The box around a shell is far larger, because most shells lie askew to the axes.
fn hull(triangle: &Triangle, points: &[Vec3A], beside_m: f32) -> Hull {
    let Triangle { a, b, c, .. } = triangle;
    let [a, b, c] =
        [a, b, c].map(|Corner { position: p, .. }| DVec3::new(p.x.into(), p.y.into(), p.z.into()));
    let normal = (b - a).cross(c - a);
    [normal, normal.cross(b - a), normal.cross(c - b), normal.cross(a - c)].map(|direction| {
        let direction = direction.normalize_or_zero().as_vec3();
        let along = points.iter().map(|point| direction.as_dvec3().dot(Vec3::from(*point).as_dvec3()));
        let [low, high] = along
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], along| [low.min(along), high.max(along)]);
        let beside = f64::from(beside_m);
        (direction.to_array(), [((low - beside) as f32).next_down(), ((high + beside) as f32).next_up()])
    })
}

/// Test of a block's rays against a box, and against the slabs in it if there are any.
struct Test<'a> {
    rays: &'a BlockRays,
    bounds: &'a Aabb,
    hull: Option<&'a Hull>,
    /// Parameter at which each ray enters within its reach; infinite for other rays.
    at: &'a mut Row<f32>,
}

/// Parts of rays in slabs.
struct Inside<'a> {
    rays: &'a BlockRays,
    entry: Row<f32>,
    exit: Row<f32>,
}

impl Inside<'_> {
    /// Cuts off what is not in a slab, across which the rays begin and go so.
    #[inline(always)]
    fn cut(&mut self, [low, high]: [f32; 2], origin: &Row<f32>, inverse: &Row<f32>) {
        for place in 0..BLOCK {
            let from = (low - self.rays.slack[place] - origin[place]) * inverse[place];
            let to = (high + self.rays.slack[place] - origin[place]) * inverse[place];
            let (near, far) = if from < to { (from, to) } else { (to, from) };
            let (entry, exit) = (&mut self.entry[place], &mut self.exit[place]);
            *entry = if near > *entry { near } else { *entry };
            *exit = if far < *exit { far } else { *exit };
        }
    }
}

impl WithSimd for Test<'_> {
    /// Where the first ray does.
    type Output = f32;

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) -> Self::Output {
        let Self { rays, bounds, hull, at } = self;
        // Nothing behind a ray's beginning is met, and nothing beyond its reach.
        let mut inside = Inside { rays, entry: [f32::NEG_INFINITY; BLOCK], exit: rays.reach };
        for axis in 0..3 {
            inside.cut([bounds.min[axis], bounds.max[axis]], &rays.origin[axis], &rays.inverse[axis]);
        }
        if let Some(hull) = hull {
            for ([x, y, z], ends) in hull {
                let (mut origin, mut across) = ([0.0; BLOCK], [0.0; BLOCK]);
                for place in 0..BLOCK {
                    let [[px, py, pz], [dx, dy, dz]] = [&rays.origin, &rays.direction];
                    origin[place] = x * px[place] + y * py[place] + z * pz[place];
                    across[place] = inverse(x * dx[place] + y * dy[place] + z * dz[place]);
                }
                inside.cut(*ends, &origin, &across);
            }
        }
        let mut nearest = f32::INFINITY;
        for (at, (entry, exit)) in at.iter_mut().zip(inside.entry.iter().zip(&inside.exit)) {
            *at = if entry <= exit && *exit >= 0.0 { *entry } else { f32::INFINITY };
            nearest = if *at < nearest { *at } else { nearest };
        }
        nearest
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use relief_shaders::cpu::Shell;

    fn bounds(shell_m: [f32; 2], both_sides: bool) -> Bounds {
        Bounds { shell_m, both_sides, beside_tiles: 0.0, in_hulls: true }
    }

    /// Triangles side by side along x, facing along z.
    fn row(count: usize) -> Triangles {
        let corner = |x: f32, y: f32| {
            let (tangent, bitangent) = ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0]);
            Corner::new([x, y, 0.0], [0.0, 0.0, 1.0], tangent, bitangent, [x, y], [0.0; 3])
        };
        let of = |number: usize| {
            let x = number as f32;
            let (a, b, c) = (corner(x, 0.0), corner(x + 1.0, 0.0), corner(x, 1.0));
            Triangle { a, b, c, shell: Shell::whole() }
        };
        (0..count).map(of).collect()
    }

    #[test]
    fn shells_are_proposed_that_a_ray_passes_beside_their_triangles() {
        let caster = ShellCaster::new(&row(40), bounds([0.1, 0.3], false));
        let along = |z: f64| {
            let ray = Ray { origin: DVec3::new(-5.0, 0.25, z), direction: DVec3::X };
            let mut proposed = Vec::new();
            caster.each(&ray, |triangle| {
                proposed.push(triangle);
                f64::INFINITY
            });
            proposed.sort_unstable();
            proposed
        };
        assert_eq!(along(0.2), Vec::from_iter(0..40));
        assert!(along(0.0).is_empty());
        assert!(along(-0.2).is_empty());
        let both = ShellCaster::new(&row(1), bounds([0.1, 0.3], true));
        let mut count = 0;
        both.each(&Ray { origin: DVec3::new(-5.0, 0.25, -0.2), direction: DVec3::X }, |_| {
            count += 1;
            0.0
        });
        assert_eq!(count, 1);
    }

    /// Whether a ray hits the space up to 0.3 m on both sides of a triangle of a row, widened by a
    /// margin on all sides.
    fn meets(ray: &Ray, number: u32, larger: f64) -> bool {
        let origin = ray.origin - DVec3::X * f64::from(number);
        let (mut from, mut to) = (0.0f64, f64::INFINITY);
        let sides = [DVec3::X, DVec3::Y, -DVec3::X - DVec3::Y, DVec3::Z, -DVec3::Z];
        for (side, beside) in sides.into_iter().zip([0.0, 0.0, 1.0, 0.3, 0.3]) {
            let (at, along) = (side.dot(origin) + beside + larger, side.dot(ray.direction));
            let end = -at / along;
            match along {
                0.0 if at < 0.0 => return false,
                along if along > 0.0 => from = from.max(end),
                along if along < 0.0 => to = to.min(end),
                _ => {}
            }
        }
        from <= to
    }

    #[test]
    fn a_block_is_proposed_what_its_rays_meet_and_nothing_else() {
        let caster = ShellCaster::new(&row(40), bounds([0.1, 0.3], true));
        // Along the row, across it, past it, and one that goes nowhere. Its numbers are `f32`.
        let ray = |place: usize| {
            let at = place as f64;
            let origin = DVec3::new(2.3 * at - 4.0, 0.25, 0.25 - 0.1 * at.sin());
            let direction = DVec3::new(at - 5.0, 0.1, -0.05 * (at - 3.0));
            let direction = if place == 11 { DVec3::ZERO } else { direction };
            let [origin, direction] = [origin, direction].map(|v| v.as_vec3().as_dvec3());
            Ray { origin, direction }
        };
        let rays: Row<Ray> = std::array::from_fn(ray);
        let which = 0b1011_1111_1111_1101;
        for lanes in Lanes::available() {
            // Rays want to know of nothing behind some place, each behind another one.
            let least = |place: usize| [1.5, f32::INFINITY][place % 2];
            let mut block: Row<Vec<u32>> = Default::default();
            let mut rays_of_block = caster.block(&rays, which, BlockRays::default());
            let mut at = [0.0; BLOCK];
            while let Some(triangle) = caster.next_of_block(&mut rays_of_block, lanes, &mut at) {
                for place in (0..BLOCK).filter(|place| at[*place] < f32::INFINITY) {
                    block[place].push(triangle);
                    rays_of_block.reach[place] = least(place);
                }
            }
            let mut met = 0;
            for (place, block) in block.into_iter().enumerate() {
                let is_there = which >> place & 1 == 1 && place != 11;
                for number in 0..40 {
                    let [meets, may_meet] =
                        [-1e-4, 1e-4].map(|larger| is_there && meets(&rays[place], number, larger));
                    met += usize::from(meets);
                    let is_proposed = block.contains(&number);
                    assert!(!is_proposed || may_meet, "{place}: {number}");
                    assert!(is_proposed || !meets || least(place) < f32::INFINITY, "{place}: {number}");
                }
                assert!(block.len() <= 40, "{place}: {block:?}");
            }
            assert!(met > 60, "{met}");
        }
    }

    #[test]
    fn what_is_behind_the_reach_is_left_out() {
        let caster = ShellCaster::new(&row(40), bounds([0.0, 0.3], false));
        let ray = Ray { origin: DVec3::new(-5.0, 0.25, 0.2), direction: DVec3::X };
        let mut proposed = Vec::new();
        caster.each(&ray, |triangle| {
            proposed.push(triangle);
            7.5
        });
        assert!(proposed.contains(&0) && proposed.contains(&2) && !proposed.contains(&20), "{proposed:?}");
        caster.each(&Ray { direction: DVec3::ZERO, ..ray }, |_| panic!("a ray without a direction"));
        ShellCaster::new(&Triangles::default(), bounds([0.0, 1.0], false))
            .each(&ray, |_| panic!("a mesh without triangles"));
    }
}
