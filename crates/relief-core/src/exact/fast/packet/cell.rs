//! Intersection of rays with cells, in `f64` lanes.

use super::PathPacket;
use super::setup::HalfRays;
use super::vector::{Double, Mask, Vector};

/// Rays of a packet, in two halves.
pub(super) type Rays<V> = [HalfRays<V>; 2];

/// Bilinear patch of a cell, or of a different cell in each lane. It holds the beginning and the
/// end of the cell. The height from its beginning is `h00 + bx u + by v + d u v`.
#[derive(Clone, Copy, Default)]
pub(super) struct Patch<T> {
    first: [T; 2],
    last: [T; 2],
    h00: T,
    bx: T,
    by: T,
    d: T,
}

impl Patch<f64> {
    /// Patch of a cell with these corners.
    #[inline(always)]
    pub fn new(cell: [u32; 2], corners: [f32; 4]) -> Self {
        let first = cell.map(f64::from);
        let [h00, h10, h01, h11] = corners.map(f64::from);
        let (bx, by, d) = (h10 - h00, h01 - h00, (h00 - h10) + (h11 - h01));
        Self { first, last: [first[0] + 1.0, first[1] + 1.0], h00, bx, by, d }
    }

    /// Copies the patch to every lane.
    #[inline(always)]
    fn splat<V: Vector>(self, v: V) -> Patch<Double<V>> {
        let splat = |x: f64| Double::splat(v, x);
        let [x, y] = self.first;
        let [to_x, to_y] = self.last;
        Patch {
            first: [splat(x), splat(y)],
            last: [splat(to_x), splat(to_y)],
            h00: splat(self.h00),
            bx: splat(self.bx),
            by: splat(self.by),
            d: splat(self.d),
        }
    }
}

/// A patch for each lane.
pub(super) type Patches = Patch<[f64; PathPacket::LEN]>;

impl Patches {
    /// Stores a patch in a lane.
    #[inline(always)]
    pub fn set(&mut self, lane: usize, patch: Patch<f64>) {
        for k in 0..2 {
            self.first[k][lane] = patch.first[k];
            self.last[k][lane] = patch.last[k];
        }
        self.h00[lane] = patch.h00;
        self.bx[lane] = patch.bx;
        self.by[lane] = patch.by;
        self.d[lane] = patch.d;
    }

    /// Patches of half a packet, from lane `first` on.
    #[inline(always)]
    fn load<V: Vector>(&self, v: V, first: usize) -> Patch<Double<V>> {
        let load = |numbers: &[f64; PathPacket::LEN]| Double::load(v, numbers, first);
        Patch {
            first: [load(&self.first[0]), load(&self.first[1])],
            last: [load(&self.last[0]), load(&self.last[1])],
            h00: load(&self.h00),
            bx: load(&self.bx),
            by: load(&self.by),
            d: load(&self.d),
        }
    }
}

/// Hits of the rays of a packet found yet, and their cost.
pub(super) struct CellHits<V: Vector> {
    /// Lanes with a hit, as bits.
    pub found: u32,
    /// See `traverse::CellHit`, for both halves.
    pub s: [Double<V>; 2],
    pub gap: [Double<V>; 2],
    pub slope: [Double<V>; 2],
    pub cell: [[Double<V>; 2]; 2],
    /// Steps, each of one read, and bytes.
    pub steps: V::u32s,
    pub bytes: V::u32s,
    v: V,
}

impl<V: Vector> CellHits<V> {
    #[inline(always)]
    pub fn new(v: V) -> Self {
        let (zero, none) = ([Double::splat(v, 0.0); 2], v.splat_u32s(0));
        Self { found: 0, s: zero, gap: zero, slope: zero, cell: [zero; 2], steps: none, bytes: none, v }
    }

    /// Adds a step to some lanes.
    #[inline(always)]
    pub fn count(&mut self, lanes: u32, bytes: u32) {
        let (v, mask) = (self.v, self.v.mask32(lanes));
        self.steps = v.select_u32s(mask, v.add_u32s(self.steps, v.splat_u32s(1)), self.steps);
        self.bytes = v.select_u32s(mask, v.add_u32s(self.bytes, v.splat_u32s(bytes)), self.bytes);
    }

    /// Solves one cell for some lanes and returns the lanes that hit. It is
    /// `traverse::Search::cell` in lanes, with `Gap::first_root` without its branches.
    #[inline(always)]
    pub fn cell(&mut self, v: V, rays: &Rays<V>, corners: [f32; 4], cell: [u32; 2], lanes: u32) -> u32 {
        let patch = Patch::new(cell, corners);
        self.solve(v, rays, [patch.splat(v); 2], lanes)
    }

    /// Solves a different cell for each of some lanes and returns the lanes that hit.
    #[inline(always)]
    pub fn cells(&mut self, v: V, rays: &Rays<V>, patches: &Patches, lanes: u32) -> u32 {
        self.solve(v, rays, [patches.load(v, 0), patches.load(v, V::F64_LANES)], lanes)
    }

    #[inline(always)]
    fn solve(&mut self, v: V, rays: &Rays<V>, [low, high]: [Patch<Double<V>>; 2], lanes: u32) -> u32 {
        let low = self.half_cell(v, rays, low, lanes, 0);
        let high = self.half_cell(v, rays, high, lanes >> V::F64_LANES, 1);
        let hit = low | high << V::F64_LANES;
        self.found |= hit;
        hit
    }

    #[inline(always)]
    fn half_cell(&mut self, v: V, rays: &Rays<V>, patch: Patch<Double<V>>, lanes: u32, half: usize) -> u32 {
        let lanes = lanes & ((1 << V::F64_LANES) - 1);
        if lanes == 0 {
            return 0;
        }
        let ray = &rays[half];
        let splat = |x: f64| Double::splat(v, x);
        let zero = splat(0.0);
        let Patch { first: [x, y], last, h00, bx, by, d } = patch;
        let (near_x, far_x) = crossings(ray, 0, x, last[0]);
        let (near_y, far_y) = crossings(ray, 1, y, last[1]);
        let enter = near_x.greater(near_y).greater(zero);
        let leave = far_x.lesser(far_y).lesser(ray.length);
        let inside = Mask::of(v, lanes).and(enter.le(leave));

        // `Gap::in_cell`
        let [du, dv] = ray.step;
        let u = ray.start[0] + du * enter - x;
        let v_ = ray.start[1] + dv * enter - y;
        let [r0, r1, r2] = ray.height;
        let height = [r0 + enter * (r1 + enter * r2), r1 + splat(2.0) * enter * r2, r2];
        let slope_v = by + d * u;
        let c0 = height[0] - (h00 + bx * u + slope_v * v_);
        let c1 = height[1] - ((bx + d * v_) * du + slope_v * dv);
        let c2 = height[2] - d * du * dv;

        // `Gap::first_root`
        let way = leave - enter;
        let begins_below = c0.le(zero);
        let crosses = (c0 + way * (c1 + way * c2)).le(zero);
        let turns = c1.lt(zero).and(c1.negated().lt(splat(2.0) * c2 * way));
        // There is no early return if no lane may hit: a mispredicted branch costs more than the
        // root.
        let may_hit = inside.and(begins_below.or(crosses).or(turns));
        let disc = c1 * c1 - splat(4.0) * c0 * c2;
        let real = zero.le(disc);
        let sqrt = disc.sqrt();
        let falls_first = c1.le(zero);
        let over = falls_first.choose(splat(2.0) * c0, c1 + sqrt);
        let under = falls_first.choose(sqrt - c1, splat(-2.0) * c2);
        let root = over / under;
        let root = root.lt(way).choose(zero.lt(root).choose(root, zero), way);
        let root = real.choose(root, way);
        let tau = begins_below.choose(zero, root);
        let hit = may_hit.and(begins_below.or(crosses).or(real));

        self.s[half] = hit.choose(enter + tau, self.s[half]);
        self.gap[half] = hit.choose(zero.lt(tau).choose(zero, c0), self.gap[half]);
        self.slope[half] = hit.choose(c1 + splat(2.0) * tau * c2, self.slope[half]);
        self.cell[0][half] = hit.choose(x, self.cell[0][half]);
        self.cell[1][half] = hit.choose(y, self.cell[1][half]);
        hit.bits()
    }
}

/// Crossings of rays with a cell's first and last edge on an axis, in their order.
#[inline(always)]
fn crossings<V: Vector>(
    ray: &HalfRays<V>,
    axis: usize,
    first: Double<V>,
    last: Double<V>,
) -> (Double<V>, Double<V>) {
    let low = (first - ray.start[axis]) * ray.per_cell[axis];
    let high = (last - ray.start[axis]) * ray.per_cell[axis];
    (low.lesser(high), low.greater(high))
}
