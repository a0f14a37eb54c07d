//! Sorting of a packet's paths into groups that descend together, and the packet's answers.

use pulp::NullaryFnOnce;
use pulp::x86::{V3, V4};

use super::cell::CellHits;
use super::incoherent::IncoherentRays;
use super::search::{Group, MOST_NODES, Search, Singles, Stack};
use super::setup::{HalfRays, half_rays};
use super::vector::{Double, Mask, Single, Vector, lanes_of};
use super::{FastTracer, HitPacket, PathPacket};
use crate::Lanes;
use crate::exact::fast::hierarchy::BLOCK;
use crate::exact::fast::traverse::size;

/// Fewest rays in a group. Fewer rays are faster one by one.
const FEWEST: u32 = 3;

/// Average number of a group's rays that must visit each node of its window for packets to pay.
const RAYS_OF_NODE: f32 = 2.5;

/// Number of groups below these limits that show that the rays of a packet are scattered. Then no
/// more groups are formed.
const MOST_SMALL_GROUPS: u32 = 2;

/// Widening of a group's window beyond the range of its rays, as a part of a node. It exceeds the
/// growth of nodes, so that no touched node is left out. It is small, because every further column
/// costs time.
const WIDENING: f64 = 1.0 / (1 << 13) as f64;

/// Columns and rows by which other rays of a group may begin before its first ray.
const BEFORE: f32 = 2.0;

/// Traces packets in vectors. Without such vectors it does nothing and returns false.
pub(super) fn trace(
    tracer: &FastTracer,
    paths: &[PathPacket],
    lanes: Lanes,
    answers: &mut [HitPacket],
) -> bool {
    match lanes {
        Lanes::One | Lanes::Four => None,
        Lanes::Eight => V3::try_new().map(|v| v.vectorize(Trace { v, tracer, paths, answers })),
        Lanes::Sixteen => V4::try_new().map(|v| v.vectorize(Trace { v, tracer, paths, answers })),
    }
    .is_some()
}

/// Finds blocked paths in vectors. Without such vectors it does nothing and returns false.
pub(super) fn blocked(tracer: &FastTracer, paths: &[PathPacket], lanes: Lanes, blocked: &mut [u16]) -> bool {
    match lanes {
        Lanes::One | Lanes::Four => None,
        Lanes::Eight => V3::try_new().map(|v| v.vectorize(Blocked { v, tracer, paths, blocked })),
        Lanes::Sixteen => V4::try_new().map(|v| v.vectorize(Blocked { v, tracer, paths, blocked })),
    }
    .is_some()
}

struct Trace<'a, V> {
    v: V,
    tracer: &'a FastTracer,
    paths: &'a [PathPacket],
    answers: &'a mut [HitPacket],
}

struct Blocked<'a, V> {
    v: V,
    tracer: &'a FastTracer,
    paths: &'a [PathPacket],
    blocked: &'a mut [u16],
}

impl<V: Vector> NullaryFnOnce for Trace<'_, V> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let Self { v, tracer, paths, answers } = self;
        let mut scratch = Scratch::new();
        for (paths, answers) in paths.iter().zip(answers) {
            (answers.found, answers.exhausted) = (0, 0);
            for first in (0..PathPacket::LEN).step_by(V::F32_LANES) {
                let SearchResult { rays, hits, scalar } = search(v, tracer, paths, first, &mut scratch);
                answers.found |= (hits.found << first) as u16;
                for (half, rays) in rays.iter().enumerate() {
                    let first = first + half * V::F64_LANES;
                    write(v, rays, &hits, half, paths, first, answers);
                }
                store(&mut answers.steps, first, hits.steps, V::as_mut_simd_u32s);
                store(&mut answers.bytes, first, hits.bytes, V::as_mut_simd_u32s);
                for lane in lanes_of(scalar) {
                    answers.set(first + lane, &tracer.trace(&paths.path(first + lane)));
                }
            }
        }
    }
}

impl<V: Vector> NullaryFnOnce for Blocked<'_, V> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let Self { v, tracer, paths, blocked } = self;
        let mut scratch = Scratch::new();
        for (paths, blocked) in paths.iter().zip(blocked) {
            *blocked = 0;
            for first in (0..PathPacket::LEN).step_by(V::F32_LANES) {
                let SearchResult { hits, scalar, .. } = search(v, tracer, paths, first, &mut scratch);
                *blocked |= (hits.found << first) as u16;
                for lane in lanes_of(scalar) {
                    *blocked |= u16::from(tracer.is_blocked(&paths.path(first + lane))) << (first + lane);
                }
            }
        }
    }
}

/// Scratch memory of searches. It is created once for many packets.
struct Scratch {
    stack: Stack,
    /// `None` until the first incoherent ray. Creating it for every packet would slow down coherent
    /// shadow rays by a fifth to a third.
    incoherent: Option<IncoherentRays>,
}

impl Scratch {
    fn new() -> Self {
        Self { stack: Stack::new(), incoherent: None }
    }
}

/// Result of searching as many paths as a vector has lanes.
struct SearchResult<V: Vector> {
    rays: [HalfRays<V>; 2],
    hits: CellHits<V>,
    /// Lanes that must be traced by the scalar tracer.
    scalar: u32,
}

/// Searches for the hits of as many paths as a vector has lanes, from lane `first` on.
#[inline(always)]
fn search<V: Vector>(
    v: V,
    tracer: &FastTracer,
    paths: &PathPacket,
    first: usize,
    scratch: &mut Scratch,
) -> SearchResult<V> {
    let low = half_rays(v, tracer, paths, first);
    let high = half_rays(v, tracer, paths, first + V::F64_LANES);
    let rays = [low, high];
    let [low, high] = &rays;
    let both = |low: u32, high: u32| {
        let mask = (1 << V::F64_LANES) - 1;
        low & mask | (high & mask) << V::F64_LANES
    };
    let scalar = both(low.scalar, high.scalar);
    let mut left = both(low.packet, high.packet);
    let mut hits = CellHits::new(v);
    if left == 0 {
        return SearchResult { rays, hits, scalar };
    }
    let falls = both(low.falls, high.falls);
    let backward = [both(low.backward[0], high.backward[0]), both(low.backward[1], high.backward[1])];
    let singles = Singles::new(v, &rays);
    let stack = &mut scratch.stack;
    let (mut incoherent, mut groups) = (0, 0);
    while left != 0 {
        let first = left.trailing_zeros();
        // The lanes that agree with the first ray.
        let alike = |set: u32| if set >> first & 1 == 1 { set } else { !set };
        let same = left & alike(falls) & alike(backward[0]) & alike(backward[1]);
        let (level, same) = same_level(v, tracer, &singles, same, first);
        let (group, pays) = grouped(v, tracer, &rays, level, same, first, backward);
        left &= !group.lanes;
        if !pays {
            incoherent |= group.lanes;
            groups += 1;
            if groups == MOST_SMALL_GROUPS {
                incoherent |= left;
                left = 0;
            }
        } else if falls >> first & 1 == 1 {
            Search::<V, true>::new(v, &tracer.hierarchy, &rays, &singles, &group, &mut hits).run(stack);
        } else {
            Search::<V, false>::new(v, &tracer.hierarchy, &rays, &singles, &group, &mut hits).run(stack);
        }
    }
    if incoherent != 0 {
        let search = scratch.incoherent.get_or_insert_with(IncoherentRays::new);
        search.run(v, &tracer.hierarchy, &rays, incoherent, &mut hits);
    }
    SearchResult { rays, hits, scalar }
}

/// Level at which a ray begins, and the lanes among others that begin there.
#[inline(always)]
fn same_level<V: Vector>(
    v: V,
    tracer: &FastTracer,
    singles: &Singles<V>,
    lanes: u32,
    first: u32,
) -> (usize, u32) {
    let top = tracer.hierarchy.levels().len() - 1;
    let (mut level, mut lanes) = (0, lanes);
    while level < top {
        let fits = singles.travel.le(Single::splat(v, (BLOCK - 1) as f32 * size(level)));
        if fits >> first & 1 == 1 {
            return (level, lanes & fits);
        }
        lanes &= !fits;
        level += 1;
    }
    (level, lanes)
}

/// Group of a ray and its neighbours among some lanes, and whether a common descent pays.
#[inline(always)]
fn grouped<V: Vector>(
    v: V,
    tracer: &FastTracer,
    rays: &[HalfRays<V>; 2],
    level: usize,
    lanes: u32,
    first: u32,
    backward: [u32; 2],
) -> (Group<V>, bool) {
    let sides = tracer.hierarchy.levels()[level].sides;
    let is_backward = [backward[0] >> first & 1 == 1, backward[1] >> first & 1 == 1];
    let across = way(v, rays, 0, level, sides[0], is_backward[0]);
    let along = way(v, rays, 1, level, sides[1], is_backward[1]);
    let mut group = Group {
        lanes,
        level,
        flip: is_backward.map(|is| if is { BLOCK - 1 } else { 0 }),
        window: [across.window(v, lanes), along.window(v, lanes)],
        corner: [across.corner, along.corner],
    };
    let is_wide = |[from, to]: [u32; 2]| to - from >= MOST_NODES as u32;
    if group.window.into_iter().any(is_wide) {
        group.lanes = lanes & across.near(v, first) & along.near(v, first) | 1 << first;
        group.window = [across.window(v, group.lanes), along.window(v, group.lanes)];
    }
    let none = Single::splat(v, 0.0);
    let own = (across.nodes(v) * along.nodes(v)).where_or(group.lanes, none).sum();
    let [x, y] = group.window.map(|[from, to]| to - from + 1);
    let pays = group.lanes.count_ones() >= FEWEST && own >= RAYS_OF_NODE * (x * y) as f32;
    (group, pays)
}

/// Ranges of rays along an axis, in columns or rows of a level's nodes.
struct Way<V: Vector> {
    /// First and last column or row that a ray visits.
    from: Single<V>,
    to: Single<V>,
    /// First column or row of the ray's own window: see `Line::window`.
    corner: Single<V>,
}

#[inline(always)]
fn way<V: Vector>(
    v: V,
    [low, high]: &[HalfRays<V>; 2],
    axis: usize,
    level: usize,
    side: u32,
    is_backward: bool,
) -> Way<V> {
    let low = half_way(v, low, axis, level, side, is_backward);
    let high = half_way(v, high, axis, level, side, is_backward);
    Way {
        from: Single::narrow([low[0], high[0]]),
        to: Single::narrow([low[1], high[1]]),
        corner: Single::narrow([low[2], high[2]]),
    }
}

#[inline(always)]
fn half_way<V: Vector>(
    v: V,
    rays: &HalfRays<V>,
    axis: usize,
    level: usize,
    side: u32,
    is_backward: bool,
) -> [Double<V>; 3] {
    let node = f64::from(size(level));
    let (per_node, wider) = (Double::splat(v, 1.0 / node), Double::splat(v, node * WIDENING));
    let (zero, side) = (Double::splat(v, 0.0), f64::from(side));
    let (start, end) = (rays.start[axis], rays.end[axis]);
    let from = (start.lesser(end) - wider).greater(zero) * per_node;
    let to = (start.greater(end) + wider) * per_node;
    let own = (start.truncate() * per_node).truncate();
    let own = if is_backward { (own - Double::splat(v, (BLOCK - 1) as f64)).greater(zero) } else { own };
    let corner = own.lesser(Double::splat(v, side - BLOCK as f64));
    [from.truncate(), to.lesser(Double::splat(v, side - 1.0)).truncate(), corner]
}

impl<V: Vector> Way<V> {
    /// First and last column or row that some rays visit.
    #[inline(always)]
    fn window(&self, v: V, lanes: u32) -> [u32; 2] {
        let from = self.from.where_or(lanes, Single::splat(v, f32::MAX)).least();
        let to = self.to.where_or(lanes, Single::splat(v, 0.0)).greatest();
        [from as u32, to as u32]
    }

    /// Number of columns or rows that each ray visits.
    #[inline(always)]
    fn nodes(&self, v: V) -> Single<V> {
        self.to - self.from + Single::splat(v, 1.0)
    }

    /// Rays so near to one of them that a window holds them all.
    #[inline(always)]
    fn near(&self, v: V, ray: u32) -> u32 {
        let begin = Single::splat(v, self.from.lane(ray as usize) - BEFORE);
        let end = begin + Single::splat(v, (MOST_NODES - 1) as f32);
        begin.le(self.from) & self.to.le(end)
    }
}

/// Writes the answers of half a packet, as `ExactHit::at` computes them from hits.
#[inline(always)]
fn write<V: Vector>(
    v: V,
    rays: &HalfRays<V>,
    hits: &CellHits<V>,
    half: usize,
    paths: &PathPacket,
    first: usize,
    answers: &mut HitPacket,
) {
    let (zero, one) = (Double::splat(v, 0.0), Double::splat(v, 1.0));
    let found = Mask::of(v, hits.found >> (half * V::F64_LANES));
    let t = (rays.t0 + hits.s[half] * rays.unit).lesser(Double::load(v, &paths.exit, first));
    for k in 0..2 {
        let place = Double::load(v, &paths.uv[k], first) + Double::load(v, &paths.duv[k], first) * t;
        let cell = (hits.cell[k][half] - rays.shift[k]).to_integer();
        let cell = v.select_u64s(found.mask(), cell, v.splat_u64s(0));
        store(&mut answers.uv[k], first, found.choose(place, zero).x, V::as_mut_simd_f64s);
        store(&mut answers.cell[k], first, v.transmute_i64s_u64s(cell), V::as_mut_simd_i64s);
    }
    let [h0, h1, h2] = &paths.h;
    let (h0, h1, h2) = (Double::load(v, h0, first), Double::load(v, h1, first), Double::load(v, h2, first));
    let gap = hits.gap[half];
    let height = one.lesser(zero.greater(h0 + t * (h1 + t * h2) - gap));
    let slope = hits.slope[half] * rays.per_unit;
    store(&mut answers.t, first, found.choose(t, zero).x, V::as_mut_simd_f64s);
    store(&mut answers.height, first, found.choose(height, zero).x, V::as_mut_simd_f64s);
    store(&mut answers.slope, first, found.choose(slope, zero).x, V::as_mut_simd_f64s);
    store(&mut answers.clearance, first, found.choose(gap, zero).x, V::as_mut_simd_f64s);
}

/// Stores a vector from lane `first` on.
#[inline(always)]
fn store<T, X>(
    to: &mut [T; PathPacket::LEN],
    first: usize,
    from: X,
    split: impl Fn(&mut [T]) -> (&mut [X], &mut [T]),
) {
    if let ([to, ..], _) = split(&mut to[first..]) {
        *to = from;
    }
}
