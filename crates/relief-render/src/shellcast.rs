//! Which shells of base triangles a ray may meet.
//!
//! A hierarchy of boxes around shells, built by `obvhs`, only proposes triangles: the shaders decide what the
//! ray meets in them.

use std::fmt;

use glam::{DVec3, Vec3, Vec3A};
use obvhs::BvhBuildParams;
use obvhs::aabb::Aabb;
use obvhs::bvh2::{Bvh2, builder::build_bvh2};
use relief_core::Lanes;
use relief_core::pulp::{Simd, WithSimd};
use relief_shaders::cpu::{BLOCK, Corner, Row, Triangle, places};

use crate::camera::Ray;
use crate::triangles::Triangles;

/// How far boxes are grown, relative to the largest coordinate in play: more than the shaders' own slack for
/// rounding, so that no triangle is left out that they would have hit.
const BOX_SLACK: f64 = 4e-6;

/// The shells of a mesh, prepared for rays.
pub struct ShellCaster {
    bvh: Bvh2,
    /// The largest absolute coordinate of a box.
    extent: f64,
}

impl fmt::Debug for ShellCaster {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "ShellCaster({} nodes)", self.bvh.nodes.len())
    }
}

impl ShellCaster {
    /// Prepares shells between two distances along the corners' normals, at which the heights 0 and 1 lie, in
    /// metres; with `both`, those of the mesh turned over as well. Takes about 100 bytes a triangle.
    pub fn new(triangles: &Triangles, shell_m: [f32; 2], both: bool) -> Self {
        let boxes: Vec<Aabb> = triangles.iter().map(|triangle| bounds(&triangle, shell_m, both)).collect();
        let bvh = if boxes.is_empty() {
            Bvh2::default()
        } else {
            build_bvh2(&boxes, BvhBuildParams::medium_build(), &mut Default::default())
        };
        let largest =
            |extent: f32, of: &Aabb| extent.max(of.min.abs().max_element()).max(of.max.abs().max_element());
        Self { bvh, extent: boxes.iter().fold(0.0, largest).into() }
    }

    /// Calls `visit` with the numbers of triangles whose shells the ray may meet, roughly from near to far.
    /// It tells up to which parameter of the ray shells are still of interest.
    pub fn each(&self, ray: &Ray, mut visit: impl FnMut(u32) -> f64) {
        if !goes_somewhere(ray) {
            return;
        }
        let inverse = ray.direction.recip();
        let slack = DVec3::splat(self.extent.max(ray.origin.abs().max_element()) * BOX_SLACK);
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

    /// The same of a block of rays: with the numbers of triangles come those of the rays, a bit for each, and
    /// up to which parameter of each ray shells are still of interest, to be made less.
    pub fn each_of_block(
        &self,
        rays: &BlockRays,
        lanes: Lanes,
        mut visit: impl FnMut(u32, u16, &mut Row<f64>),
    ) {
        let mut reach = [f64::INFINITY; BLOCK];
        let enter = |node: u32, which: u16, reach: &Row<f64>| {
            let bounds = self.bvh.nodes.get(node as usize)?.aabb();
            let (met, nearest) = lanes.run(BoxTest { rays, bounds, extent: self.extent, reach, which });
            (met != 0).then_some((nearest, node, met))
        };
        let mut waiting = Vec::with_capacity(64);
        waiting.extend(enter(0, rays.which, &reach));
        while let Some((_, number, which)) = waiting.pop() {
            // Something may have been found since.
            let Some((_, _, which)) = enter(number, which, &reach) else { continue };
            let node = &self.bvh.nodes[number as usize];
            if node.is_leaf() {
                let first = node.first_index as usize;
                for triangle in &self.bvh.primitive_indices[first..first + node.prim_count as usize] {
                    visit(*triangle, which, &mut reach);
                }
                continue;
            }
            let [left, right] =
                [node.first_index, node.first_index + 1].map(|child| enter(child, which, &reach));
            // The nearer one is taken first.
            let is_right_nearer = right.zip(left).is_some_and(|(right, left)| right.0 < left.0);
            let (first, second) = if is_right_nearer { (right, left) } else { (left, right) };
            waiting.extend(second);
            waiting.extend(first);
        }
    }
}

/// Whether a ray begins somewhere and has a direction.
fn goes_somewhere(ray: &Ray) -> bool {
    ray.direction.abs().max_element() > 0.0 && ray.direction.is_finite() && ray.origin.is_finite()
}

/// The rays of a block, side by side.
pub struct BlockRays {
    origin: [Row<f64>; 3],
    inverse: [Row<f64>; 3],
    /// The largest absolute coordinate of each ray's origin.
    largest: Row<f64>,
    /// Those that there are, and that go somewhere.
    which: u16,
}

impl BlockRays {
    /// Those of these that `which` has bits for.
    pub fn new(rays: Row<Ray>, which: u16) -> Self {
        Self {
            origin: [0, 1, 2].map(|axis| rays.map(|ray| ray.origin[axis])),
            inverse: [0, 1, 2].map(|axis| rays.map(|ray| ray.direction[axis].recip())),
            largest: rays.map(|ray| ray.origin.abs().max_element()),
            which: places(which)
                .filter(|place| goes_somewhere(&rays[*place]))
                .fold(0, |bits, place| bits | 1 << place),
        }
    }
}

/// A box that the rays of a block may meet.
struct BoxTest<'a> {
    rays: &'a BlockRays,
    bounds: &'a Aabb,
    extent: f64,
    reach: &'a Row<f64>,
    which: u16,
}

impl WithSimd for BoxTest<'_> {
    /// Which rays meet it within their reach, and where the first of them does.
    type Output = (u16, f64);

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) -> Self::Output {
        let Self { rays, bounds, extent, reach, which } = self;
        let mut slack = [0.0; BLOCK];
        for (slack, largest) in slack.iter_mut().zip(&rays.largest) {
            *slack = extent.max(*largest) * BOX_SLACK;
        }
        let (mut entry, mut exit) = ([f64::NEG_INFINITY; BLOCK], [f64::INFINITY; BLOCK]);
        for axis in 0..3 {
            let [low, high] = [bounds.min[axis], bounds.max[axis]].map(f64::from);
            let (origin, inverse) = (&rays.origin[axis], &rays.inverse[axis]);
            for place in 0..BLOCK {
                let a = (low - slack[place] - origin[place]) * inverse[place];
                let b = (high + slack[place] - origin[place]) * inverse[place];
                entry[place] = entry[place].max(a.min(b));
                exit[place] = exit[place].min(a.max(b));
            }
        }
        let (mut met, mut nearest) = (0, f64::INFINITY);
        for place in 0..BLOCK {
            let meets = which >> place & 1 == 1
                && entry[place] <= exit[place]
                && exit[place] >= 0.0
                && entry[place] <= reach[place];
            met |= u16::from(meets) << place;
            nearest = if meets { nearest.min(entry[place]) } else { nearest };
        }
        (met, nearest)
    }
}

/// The box around the shell of a triangle.
fn bounds(triangle: &Triangle, shell_m: [f32; 2], both: bool) -> Aabb {
    let Triangle { a, b, c, shell } = triangle;
    let offsets = shell.offsets_m(shell_m);
    let mut points = Vec::with_capacity(12);
    for corner in [a, b, c] {
        let Corner { position, normal, .. } = corner;
        let (position, normal) =
            (Vec3::new(position.x, position.y, position.z), Vec3::new(normal.x, normal.y, normal.z));
        points.extend(offsets.map(|offset| Vec3A::from(position + normal * offset)));
        if both {
            points.extend(offsets.map(|offset| Vec3A::from(position - normal * offset)));
        }
    }
    Aabb::from_points(&points)
}

#[cfg(test)]
mod tests {
    use super::*;
    use relief_shaders::cpu::Shell;

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
        let caster = ShellCaster::new(&row(40), [0.1, 0.3], false);
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
        let both = ShellCaster::new(&row(1), [0.1, 0.3], true);
        let mut count = 0;
        both.each(&Ray { origin: DVec3::new(-5.0, 0.25, -0.2), direction: DVec3::X }, |_| {
            count += 1;
            0.0
        });
        assert_eq!(count, 1);
    }

    #[test]
    fn a_block_is_proposed_what_each_of_its_rays_is() {
        let caster = ShellCaster::new(&row(40), [0.1, 0.3], true);
        // Along the row, across it, past it, and one that goes nowhere.
        let ray = |place: usize| {
            let at = place as f64;
            let origin = DVec3::new(2.3 * at - 4.0, 0.25, 0.25 - 0.1 * at.sin());
            let direction = DVec3::new(at - 5.0, 0.1, -0.05 * (at - 3.0));
            Ray { origin, direction: if place == 11 { DVec3::ZERO } else { direction } }
        };
        let rays: Row<Ray> = std::array::from_fn(ray);
        let which = 0b1011_1111_1111_1101;
        for lanes in Lanes::available() {
            // Rays want to know of nothing behind some place, each behind another one.
            let least = |place: usize| [1.5, f64::INFINITY][place % 2];
            let mut block: Row<Vec<u32>> = Default::default();
            caster.each_of_block(&BlockRays::new(rays, which), lanes, |triangle, which, reach| {
                for place in places(which) {
                    block[place].push(triangle);
                    reach[place] = least(place);
                }
            });
            let mut met = 0;
            for (place, mut of_block) in block.into_iter().enumerate() {
                let mut alone = Vec::new();
                if which >> place & 1 == 1 {
                    caster.each(&rays[place], |triangle| {
                        alone.push(triangle);
                        least(place)
                    });
                }
                alone.sort_unstable();
                of_block.sort_unstable();
                met += alone.len();
                let is_all = least(place).is_infinite() || alone.len() < 2;
                assert!(!is_all || of_block == alone, "{place}: {of_block:?} {alone:?}");
            }
            assert!(met > 60, "{met}");
        }
    }

    #[test]
    fn what_is_behind_the_reach_is_left_out() {
        let caster = ShellCaster::new(&row(40), [0.0, 0.3], false);
        let ray = Ray { origin: DVec3::new(-5.0, 0.25, 0.2), direction: DVec3::X };
        let mut proposed = Vec::new();
        caster.each(&ray, |triangle| {
            proposed.push(triangle);
            7.5
        });
        assert!(proposed.contains(&0) && proposed.contains(&2) && !proposed.contains(&20), "{proposed:?}");
        caster.each(&Ray { direction: DVec3::ZERO, ..ray }, |_| panic!("a ray without a direction"));
        ShellCaster::new(&Triangles::default(), [0.0, 1.0], false)
            .each(&ray, |_| panic!("a mesh without triangles"));
    }
}
