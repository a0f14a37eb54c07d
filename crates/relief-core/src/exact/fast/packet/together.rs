//! A packet's paths sorted into groups that go down together, and its answers.

use pulp::NullaryFnOnce;
use pulp::x86::{V3, V4};

use super::cell::CellHits;
use super::search::{Group, MOST_NODES, Search, Singles};
use super::setup::{HalfRays, half_rays};
use super::vector::{Double, Mask, Single, Vector};
use super::{FastTracer, HitPacket, PathPacket};
use crate::Lanes;
use crate::exact::fast::hierarchy::BLOCK;
use crate::exact::fast::traverse::size;

/// The fewest rays that go down together. Fewer are faster one by one.
const FEWEST: u32 = 3;

/// By how much of a node the window of a group is larger than the way of its rays: more than nodes are grown
/// by, so that no node that a ray touches is left out, and little, as every further column costs time.
const WIDENING: f64 = 1.0 / (1 << 13) as f64;

/// Columns and rows by which others of a group may begin before the first of its rays.
const BEFORE: f32 = 2.0;

/// Traces packets in vectors; does nothing and says so where there are none.
pub(super) fn trace(
    tracer: &FastTracer,
    paths: &[PathPacket],
    lanes: Lanes,
    answers: &mut [HitPacket],
) -> bool {
    match lanes {
        Lanes::One => None,
        Lanes::Eight => V3::try_new().map(|v| v.vectorize(Trace { v, tracer, paths, answers })),
        Lanes::Sixteen => V4::try_new().map(|v| v.vectorize(Trace { v, tracer, paths, answers })),
    }
    .is_some()
}

/// Finds blocked paths in vectors; does nothing and says so where there are none.
pub(super) fn blocked(tracer: &FastTracer, paths: &[PathPacket], lanes: Lanes, blocked: &mut [u16]) -> bool {
    match lanes {
        Lanes::One => None,
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
        for (paths, answers) in paths.iter().zip(answers) {
            (answers.found, answers.exhausted) = (0, 0);
            for first in (0..PathPacket::LEN).step_by(V::F32_LANES) {
                let (rays, hits, alone) = search(v, tracer, paths, first);
                answers.found |= (hits.found << first) as u16;
                for (half, rays) in rays.iter().enumerate() {
                    let first = first + half * V::F64_LANES;
                    write(v, rays, &hits, half, paths, first, answers);
                }
                store(&mut answers.steps, first, hits.steps, V::as_mut_simd_u32s);
                store(&mut answers.bytes, first, hits.bytes, V::as_mut_simd_u32s);
                for lane in lanes_of(alone) {
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
        for (paths, blocked) in paths.iter().zip(blocked) {
            *blocked = 0;
            for first in (0..PathPacket::LEN).step_by(V::F32_LANES) {
                let (_, hits, alone) = search(v, tracer, paths, first);
                *blocked |= (hits.found << first) as u16;
                for lane in lanes_of(alone) {
                    *blocked |= u16::from(tracer.is_blocked(&paths.path(first + lane))) << (first + lane);
                }
            }
        }
    }
}

/// The lanes of a set, one after the other.
fn lanes_of(mut set: u32) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let lane = set.trailing_zeros() as usize;
        set &= set.wrapping_sub(1);
        (lane < PathPacket::LEN).then_some(lane)
    })
}

/// Searches for the hits of as many paths as a vector has lanes, from a lane on: the rays, their hits, and
/// the lanes that are left to the search one by one.
#[inline(always)]
fn search<V: Vector>(
    v: V,
    tracer: &FastTracer,
    paths: &PathPacket,
    first: usize,
) -> ([HalfRays<V>; 2], CellHits<V>, u32) {
    let low = half_rays(v, tracer, paths, first);
    let high = half_rays(v, tracer, paths, first + V::F64_LANES);
    let rays = [low, high];
    let [low, high] = &rays;
    let both = |low: u32, high: u32| {
        let mask = (1 << V::F64_LANES) - 1;
        low & mask | (high & mask) << V::F64_LANES
    };
    let mut alone = both(low.alone, high.alone);
    let mut left = both(low.together, high.together);
    let mut hits = CellHits::new(v);
    if left == 0 {
        return (rays, hits, alone);
    }
    let falls = both(low.falls, high.falls);
    let backward = [0, 1].map(|k: usize| both(low.backward[k], high.backward[k]));
    let singles = Singles::new(v, &rays);
    while left != 0 {
        let first = left.trailing_zeros();
        // Those on whose side of a choice the first ray is.
        let alike = |set: u32| if set >> first & 1 == 1 { set } else { !set };
        let same = left & alike(falls) & alike(backward[0]) & alike(backward[1]);
        let (level, same) = same_level(v, tracer, &singles, same, first);
        let group = grouped(v, tracer, &rays, &singles, level, same, first, backward);
        left &= !group.lanes;
        if group.lanes.count_ones() < FEWEST {
            alone |= group.lanes;
        } else if falls >> first & 1 == 1 {
            Search::<V, true>::new(v, &tracer.hierarchy, &rays, &singles, &group, &mut hits).run();
        } else {
            Search::<V, false>::new(v, &tracer.hierarchy, &rays, &singles, &group, &mut hits).run();
        }
    }
    (rays, hits, alone)
}

/// The level at which a ray begins, and those of some others that begin there.
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

/// The group of a ray and its neighbours among some lanes.
#[inline(always)]
fn grouped<V: Vector>(
    v: V,
    tracer: &FastTracer,
    rays: &[HalfRays<V>; 2],
    singles: &Singles<V>,
    level: usize,
    lanes: u32,
    first: u32,
    backward: [u32; 2],
) -> Group<V> {
    let _ = singles;
    let sides = tracer.hierarchy.levels()[level].sides;
    let splat = |x: f64| Double::splat(v, x);
    let node = f64::from(size(level));
    let (per_node, wider, zero) = (splat(1.0 / node), splat(node * WIDENING), splat(0.0));
    let is_backward = backward.map(|set| set >> first & 1 == 1);
    let corner = |k: usize, half: usize| {
        let own = (rays[half].start[k].truncate() * per_node).truncate();
        let own = if is_backward[k] { (own - splat((BLOCK - 1) as f64)).greater(zero) } else { own };
        own.lesser(splat(f64::from(sides[k]) - BLOCK as f64))
    };
    let reach = |k: usize, half: usize| {
        let (start, end) = (rays[half].start[k], rays[half].end[k]);
        let low = (start.lesser(end) - wider).greater(zero) * per_node;
        let high = (start.greater(end) + wider) * per_node;
        (low.truncate(), high.lesser(splat(f64::from(sides[k] - 1))).truncate())
    };
    let reaches = [0, 1].map(|k| {
        let (low, high) = (reach(k, 0), reach(k, 1));
        (Single::narrow([low.0, high.0]), Single::narrow([low.1, high.1]))
    });
    let widest = Single::splat(v, f32::MAX);
    let nothing = Single::splat(v, 0.0);
    let window = |lanes: u32| {
        let [x, y] = reaches.map(|(from, to)| {
            [from.where_or(lanes, widest).least() as u32, to.where_or(lanes, nothing).greatest() as u32]
        });
        [x, y]
    };
    let mut group = Group {
        lanes,
        level,
        flip: is_backward.map(|is| if is { BLOCK - 1 } else { 0 }),
        window: window(lanes),
        corner: [0, 1].map(|k| Single::narrow([corner(k, 0), corner(k, 1)])),
    };
    let is_wide = |[from, to]: [u32; 2]| to - from >= MOST_NODES as u32;
    if group.window.into_iter().any(is_wide) {
        let [x, y] = reaches.map(|(from, to)| {
            let begin = Single::splat(v, from.lane(first as usize) - BEFORE);
            begin.le(from) & to.le(begin + Single::splat(v, (MOST_NODES - 1) as f32))
        });
        group.lanes = lanes & x & y | 1 << first;
        group.window = window(group.lanes);
    }
    group
}

/// Writes the answers of half a packet: what `ExactHit::at` makes of hits.
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
    let load = |numbers: &[f64; PathPacket::LEN]| Double::load(v, numbers, first);
    let zero = Double::splat(v, 0.0);
    let found = Mask::of(v, hits.found >> (half * V::F64_LANES));
    let t = (rays.t0 + hits.s[half] * rays.unit).lesser(load(&paths.exit));
    let at = |numbers: &[[f64; PathPacket::LEN]; 2], steps: &[[f64; PathPacket::LEN]; 2], k: usize| {
        found.choose(load(&numbers[k]) + load(&steps[k]) * t, zero)
    };
    let h = load(&paths.h[0]) + t * (load(&paths.h[1]) + t * load(&paths.h[2]));
    let gap = hits.gap[half];
    let height = Double::splat(v, 1.0).lesser(zero.greater(h - gap));
    let cell = |k: usize| {
        let whole = hits.cell[k][half] - rays.shift[k];
        v.select_u64s(found.mask(), whole.to_integer(), v.splat_u64s(0))
    };
    let slope = hits.slope[half] * rays.per_unit;
    store(&mut answers.t, first, found.choose(t, zero).x, V::as_mut_simd_f64s);
    store(&mut answers.uv[0], first, at(&paths.uv, &paths.duv, 0).x, V::as_mut_simd_f64s);
    store(&mut answers.uv[1], first, at(&paths.uv, &paths.duv, 1).x, V::as_mut_simd_f64s);
    store(&mut answers.height, first, found.choose(height, zero).x, V::as_mut_simd_f64s);
    store(&mut answers.slope, first, found.choose(slope, zero).x, V::as_mut_simd_f64s);
    store(&mut answers.clearance, first, found.choose(gap, zero).x, V::as_mut_simd_f64s);
    for k in 0..2 {
        store(&mut answers.cell[k], first, v.transmute_i64s_u64s(cell(k)), V::as_mut_simd_i64s);
    }
}

/// Stores a vector from a lane on.
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
