//! Intersection of triangles with the rays of a tile, several rays at once.

use glam::DVec3;
use pulp::{Simd, WithSimd};

use super::bins::Entry;
use super::view::View;
use super::{Corners, PictureRays, STORED, TILE, TILE_POINTS, TileCaster, TileHits};
use crate::raycast::Sides;

/// A number for each ray of a tile.
type Each = [f64; TILE_POINTS];

/// Work that casts the rays of a tile.
pub struct Casting<'a, 'b> {
    pub tiles: &'a TileCaster<'b>,
    pub view: &'a View,
    pub entries: &'a [Entry],
    pub hits: &'a mut TileHits,
}

impl WithSimd for Casting<'_, '_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let Self { tiles, view, entries, hits } = self;
        let rays = Rays::new(&tiles.rays, view.is_parallel(), hits.first, hits.offset);
        let Some(sheared) = Sheared::new(simd, &rays) else { return };
        hits.one_by_one = false;
        hits.count = [0.0; TILE_POINTS];
        hits.t = [[f64::INFINITY; TILE_POINTS]; STORED];
        hits.key = [[f64::INFINITY; TILE_POINTS]; STORED];
        let corners = &tiles.caster.corners;
        match (view.is_parallel(), tiles.sides) {
            (false, Sides::Front) => sheared.cast::<S, false, false>(simd, corners, entries, hits),
            (false, Sides::Both) => sheared.cast::<S, false, true>(simd, corners, entries, hits),
            (true, Sides::Front) => sheared.cast::<S, true, false>(simd, corners, entries, hits),
            (true, Sides::Both) => sheared.cast::<S, true, true>(simd, corners, entries, hits),
        }
    }
}

/// Rays of a tile, axis by axis.
struct Rays {
    /// Origin of the first ray, and of each ray if they are parallel.
    eye: DVec3,
    origin: [Each; 3],
    direction: [Each; 3],
}

impl Rays {
    /// Computes the rays as [`PictureRays::ray`] does.
    #[inline(always)]
    fn new(rays: &PictureRays, is_parallel: bool, first: [u32; 2], offset: [f32; 2]) -> Self {
        let mut points = [[0.0f32; TILE]; 2];
        for (number, step) in (0..TILE as u32).enumerate() {
            let point = PictureRays::point([first[0] + step, first[1] + step], offset);
            (points[0][number], points[1][number]) = (point[0], point[1]);
        }
        let along = |[first, right, down]: [glam::Vec3; 3]| {
            let mut along = [[0.0; TILE_POINTS]; 3];
            for axis in 0..3 {
                let (first, right, down) = (first[axis], right[axis], down[axis]);
                for (row, values) in along[axis].chunks_exact_mut(TILE).enumerate() {
                    let down = down * points[1][row];
                    for (value, column) in values.iter_mut().zip(points[0]) {
                        *value = f64::from((first + right * column) + down);
                    }
                }
            }
            along
        };
        let eye = rays.ray([points[0][0], points[1][0]]).origin;
        let origin = if is_parallel { along(rays.origin) } else { [[0.0; TILE_POINTS]; 3] };
        Self { eye, origin, direction: along(rays.direction) }
    }
}

/// Rays that have the same longest axis, and the same sign along it.
struct Sheared<'a> {
    /// Axes of the shear, as in [`super::super::Query`].
    axes: [usize; 3],
    rays: &'a Rays,
    shear: [Each; 2],
    inverse_z: Each,
}

impl<'a> Sheared<'a> {
    /// Returns `None` if the rays differ in their longest axis or are invalid.
    #[inline(always)]
    fn new<S: Simd>(simd: S, rays: &'a Rays) -> Option<Self> {
        let Rays { origin, direction, .. } = rays;
        let first = DVec3::from_array(direction.map(|along| along[0]));
        let z = first.abs().max_position();
        let (mut x, mut y) = ((z + 1) % 3, (z + 2) % 3);
        let is_negative = first[z] < 0.0;
        if is_negative {
            std::mem::swap(&mut x, &mut y);
        }
        let axes = [x, y, z];
        let mut sheared = Self { axes, rays, shear: [[0.0; TILE_POINTS]; 2], inverse_z: [0.0; TILE_POINTS] };
        let (one, zero) = (simd.splat_f64s(1.0), simd.splat_f64s(0.0));
        let infinity = simd.splat_f64s(f64::INFINITY);
        let mut proper = simd.less_than_f64s(zero, one);
        for part in 0..TILE_POINTS / S::F64_LANES {
            let [dx, dy, dz] = axes.map(|axis| S::as_simd_f64s(&direction[axis]).0[part]);
            let longest = if is_negative { simd.neg_f64s(dz) } else { dz };
            // The longest axis must be longer than the others, with the right sign.
            for other in [dx, dy] {
                proper = simd.and_m64s(proper, simd.less_than_f64s(simd.abs_f64s(other), longest));
            }
            proper = simd.and_m64s(proper, simd.less_than_f64s(longest, infinity));
            for along in origin {
                let along = simd.abs_f64s(S::as_simd_f64s(along).0[part]);
                proper = simd.and_m64s(proper, simd.less_than_f64s(along, infinity));
            }
            let inverse_z = simd.div_f64s(one, dz);
            S::as_mut_simd_f64s(&mut sheared.inverse_z).0[part] = inverse_z;
            S::as_mut_simd_f64s(&mut sheared.shear[0]).0[part] = simd.mul_f64s(dx, inverse_z);
            S::as_mut_simd_f64s(&mut sheared.shear[1]).0[part] = simd.mul_f64s(dy, inverse_z);
        }
        let mut all = [0.0; TILE];
        S::as_mut_simd_f64s(&mut all).0[0] = simd.select_f64s(proper, one, zero);
        all[..S::F64_LANES].iter().all(|proper| *proper == 1.0).then_some(sheared)
    }

    /// Tests triangles by the formula of [`super::super::Query::triangle`], and stores the first
    /// hits.
    #[inline(always)]
    fn cast<S: Simd, const PARALLEL: bool, const BOTH: bool>(
        &self,
        simd: S,
        corners: &[Corners],
        entries: &[Entry],
        hits: &mut TileHits,
    ) {
        let [x, y, z] = self.axes;
        for entry in entries {
            // Parallel rays have different origins.
            let from = if PARALLEL { DVec3::ZERO } else { self.rays.eye };
            let corners = corners[entry.triangle as usize].map(|corner| {
                let corner = corner - from;
                [corner[x], corner[y], corner[z]].map(|along| simd.splat_f64s(along))
            });
            let [left, right] = entry.columns.map(|column| column as usize / S::F64_LANES);
            for row in entry.rows[0]..=entry.rows[1] {
                let row = row as usize * (TILE / S::F64_LANES);
                for part in row + left..=row + right {
                    self.test::<S, PARALLEL, BOTH>(simd, part, corners, entry.triangle, hits);
                }
            }
        }
    }

    #[inline(always)]
    fn test<S: Simd, const PARALLEL: bool, const BOTH: bool>(
        &self,
        simd: S,
        part: usize,
        corners: [[S::f64s; 3]; 3],
        triangle: u32,
        hits: &mut TileHits,
    ) {
        let of = |each: &Each| S::as_simd_f64s(each).0[part];
        let shear = [of(&self.shear[0]), of(&self.shear[1])];
        let mut places = [[simd.splat_f64s(0.0); 3]; 3];
        for corner in 0..3 {
            let mut p = corners[corner];
            if PARALLEL {
                for (along, axis) in p.iter_mut().zip(self.axes) {
                    *along = simd.sub_f64s(*along, of(&self.rays.origin[axis]));
                }
            }
            places[corner] = [
                simd.sub_f64s(p[0], simd.mul_f64s(shear[0], p[2])),
                simd.sub_f64s(p[1], simd.mul_f64s(shear[1], p[2])),
                p[2],
            ];
        }
        let [a, b, c] = places;
        let zero = simd.splat_f64s(0.0);
        let wa = simd.sub_f64s(simd.mul_f64s(c[0], b[1]), simd.mul_f64s(c[1], b[0]));
        let wb = simd.sub_f64s(simd.mul_f64s(a[0], c[1]), simd.mul_f64s(a[1], c[0]));
        let wc = simd.sub_f64s(simd.mul_f64s(b[0], a[1]), simd.mul_f64s(b[1], a[0]));
        let mut front = simd.less_than_or_equal_f64s(zero, wa);
        front = simd.and_m64s(front, simd.less_than_or_equal_f64s(zero, wb));
        front = simd.and_m64s(front, simd.less_than_or_equal_f64s(zero, wc));
        let mut met = front;
        if BOTH {
            let mut back = simd.less_than_or_equal_f64s(wa, zero);
            back = simd.and_m64s(back, simd.less_than_or_equal_f64s(wb, zero));
            back = simd.and_m64s(back, simd.less_than_or_equal_f64s(wc, zero));
            met = simd.or_m64s(met, back);
        }
        if !any::<S>(met) {
            return;
        }
        let area = simd.add_f64s(simd.add_f64s(wa, wb), wc);
        let (weight_b, weight_c) = (simd.div_f64s(wb, area), simd.div_f64s(wc, area));
        let inverse_z = of(&self.inverse_z);
        let [az, bz, cz] =
            [simd.mul_f64s(a[2], inverse_z), simd.mul_f64s(b[2], inverse_z), simd.mul_f64s(c[2], inverse_z)];
        let t = simd.add_f64s(az, simd.mul_f64s(weight_b, simd.sub_f64s(bz, az)));
        let t = simd.add_f64s(t, simd.mul_f64s(weight_c, simd.sub_f64s(cz, az)));
        met = simd.and_m64s(met, simd.less_than_f64s(zero, simd.abs_f64s(area)));
        met = simd.and_m64s(met, simd.less_than_or_equal_f64s(zero, t));
        let number = f64::from(triangle) * 2.0;
        let key = simd.select_f64s(front, simd.splat_f64s(number + 1.0), simd.splat_f64s(number));
        hits.store(simd, part, met, t, key);
    }
}

impl TileHits {
    /// Counts the hits of some rays, and stores those that are among the first.
    #[inline(always)]
    fn store<S: Simd>(&mut self, simd: S, part: usize, met: S::m64s, t: S::f64s, key: S::f64s) {
        let count = &mut S::as_mut_simd_f64s(&mut self.count).0[part];
        let one = simd.select_f64s(met, simd.splat_f64s(1.0), simd.splat_f64s(0.0));
        *count = simd.add_f64s(*count, one);
        // A missing hit is treated as infinitely far away.
        let (mut t, mut key) = (t, key);
        for (stored_t, stored_key) in self.t.iter_mut().zip(&mut self.key) {
            let stored_t = &mut S::as_mut_simd_f64s(stored_t).0[part];
            let stored_key = &mut S::as_mut_simd_f64s(stored_key).0[part];
            let same = simd.and_m64s(simd.equal_f64s(t, *stored_t), simd.less_than_f64s(key, *stored_key));
            let before = simd.or_m64s(simd.less_than_f64s(t, *stored_t), same);
            let before = simd.and_m64s(met, before);
            let (old_t, old_key) = (*stored_t, *stored_key);
            *stored_t = simd.select_f64s(before, t, old_t);
            *stored_key = simd.select_f64s(before, key, old_key);
            // The previous hit moves to the next slot.
            t = simd.select_f64s(before, old_t, t);
            key = simd.select_f64s(before, old_key, key);
        }
    }
}

/// Whether any lane of a mask is set.
#[inline(always)]
fn any<S: Simd>(mask: S::m64s) -> bool {
    pulp::bytemuck::bytes_of(&mask).iter().fold(0, |all, byte| all | byte) != 0
}
