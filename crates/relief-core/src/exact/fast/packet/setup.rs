//! Conversion of paths to the rays of the search, in lanes: clipped to the heights of the map, in
//! cells, in their tile.

use super::vector::{Double, Mask, Vector};
use super::{FastTracer, PathPacket};
use crate::Wrap;
use crate::exact::fast::ray::{MOST_PER_CELL, TileRay};
use crate::exact::{MAX_RATE, MAX_START, MAX_TRAVEL};

/// Greatest height, in texel values, at which rays of packets may begin. Clipping is so inaccurate
/// for higher ones that they are left to the scalar search.
const MOST_HEIGHT: f64 = 4.0;

/// Rays of half a packet, computed from paths as in `FastTracer::search` and `TileRay::new`,
/// operation by operation.
///
/// Lanes that are in no set hold meaningless numbers.
#[derive(Clone, Copy)]
pub(super) struct HalfRays<V: Vector> {
    /// See `TileRay`.
    pub start: [Double<V>; 2],
    pub end: [Double<V>; 2],
    pub step: [Double<V>; 2],
    pub per_cell: [Double<V>; 2],
    pub height: [Double<V>; 3],
    pub length: Double<V>,
    /// `t = t0 + s unit`.
    pub t0: Double<V>,
    pub unit: Double<V>,
    pub per_unit: Double<V>,
    /// Offset of positions to the hierarchy's domain.
    pub shift: [Double<V>; 2],
    /// Rays that can be searched in packets.
    pub packet: u32,
    /// Lanes that must be traced by the scalar tracer.
    pub scalar: u32,
    /// Rays that fall.
    pub falls: u32,
    /// Rays that go left, and rays that go up.
    pub backward: [u32; 2],
}

impl<V: Vector> HalfRays<V> {
    /// Ray of a lane.
    pub fn lane(&self, lane: usize) -> TileRay {
        TileRay {
            start: [self.start[0].lane(lane), self.start[1].lane(lane)],
            step: [self.step[0].lane(lane), self.step[1].lane(lane)],
            per_cell: [self.per_cell[0].lane(lane), self.per_cell[1].lane(lane)],
            height: [self.height[0].lane(lane), self.height[1].lane(lane), self.height[2].lane(lane)],
            length: self.length.lane(lane),
        }
    }
}

/// Rays of `V::F64_LANES` paths of a packet, from lane `first` on.
#[inline(always)]
pub(super) fn half_rays<V: Vector>(
    v: V,
    tracer: &FastTracer,
    paths: &PathPacket,
    first: usize,
) -> HalfRays<V> {
    let load = |numbers: &[f64; PathPacket::LEN]| Double::load(v, numbers, first);
    let splat = |x: f64| Double::splat(v, x);
    let sides = tracer.sides.map(f64::from);
    let [w, h] = sides.map(splat);
    let (zero, one) = (splat(0.0), splat(1.0));
    let uv = [load(&paths.uv[0]), load(&paths.uv[1])];
    let duv = [load(&paths.duv[0]), load(&paths.duv[1])];
    let [h0, h1, h2] = [load(&paths.h[0]), load(&paths.h[1]), load(&paths.h[2])];
    let exit = load(&paths.exit);

    // `is_traceable`
    let across = [uv[0] * w, uv[1] * h];
    let speed = [duv[0] * w, duv[1] * h];
    let (most_start, most_rate) = (splat(MAX_START), splat(MAX_RATE));
    let near = across[0].abs().lt(most_start).and(across[1].abs().lt(most_start));
    let slow = speed[0].abs().lt(most_rate).and(speed[1].abs().lt(most_rate));
    let smooth = h0.abs().lt(most_rate).and(h1.abs().lt(most_rate)).and(h2.abs().lt(most_rate));
    let traceable = near.and(slow).and(smooth).and(zero.le(exit)).bits();

    // The part between the map's lowest and highest texel.
    let straight = h2.equals(zero).bits();
    let (lowest, highest) = (splat(tracer.lowest), splat(tracer.highest));
    let above = highest.lt(h0).and(zero.le(h1)).bits();
    let below = h0.lt(lowest).bits();
    let per_height = one / h1;
    let margin = splat(FastTracer::MARGIN);
    let top = (highest + margin - h0) * per_height;
    let bottom = (lowest - margin - h0) * per_height;
    let t0 = top.lesser(bottom).greater(zero);
    let t1 = top.greater(bottom).lesser(exit);
    let passes = t1.lt(t0).or(t0.equals(splat(f64::INFINITY))).bits();

    // `TileRay::new`
    let half = splat(0.5);
    let place = [across[0] - half, across[1] - half];
    let travel = speed[0].abs().greater(speed[1].abs());
    let span = t1 - t0;
    let short = (span * travel).le(splat(MAX_TRAVEL)).and(t1.lt(splat(f64::INFINITY))).bits();
    let exponent = v.and_u64s(v.transmute_u64s_f64s(span.x), v.splat_u64s(0x7ff << 52));
    let exponent = Double::new(v, v.transmute_f64s_u64s(exponent));
    let unit = splat(f64::from_bits(2045 << 52)).lesser(splat(f64::from_bits(1 << 52)).greater(exponent));
    let per_unit = v.sub_u64s(v.splat_u64s(2046 << 52), v.transmute_u64s_f64s(unit.x));
    let per_unit = Double::new(v, v.transmute_f64s_u64s(per_unit));
    let step = [speed[0] * unit, speed[1] * unit];
    let per_cell = [units_per_cell(speed[0], per_unit), units_per_cell(speed[1], per_unit)];
    let slope = (h1 + splat(2.0) * h2 * t0) * unit;
    let height = [h0 + t0 * (h1 + t0 * h2), slope, h2 * unit * unit];
    let length = span * per_unit;
    let begin = [place[0] + speed[0] * t0, place[1] + speed[1] * t0];
    let end = [begin[0] + step[0] * length, begin[1] + step[1] * length];

    let (tile_x, in_x) = common_tile(tracer, [begin[0], end[0]], sides[0]);
    let (tile_y, in_y) = common_tile(tracer, [begin[1], end[1]], sides[1]);
    let extra = splat(tracer.extra);
    let shift = [extra - tile_x * w, extra - tile_y * h];

    // For rays in packets every number in `f32` is finite.
    let missed = !traceable | (straight & !below & (above | passes));
    let moves = zero.lt(length).and(height[0].abs().lt(splat(MOST_HEIGHT))).bits();
    let packet = !missed & straight & !below & short & in_x & in_y & moves;
    HalfRays {
        start: [begin[0] + shift[0], begin[1] + shift[1]],
        end: [end[0] + shift[0], end[1] + shift[1]],
        step,
        per_cell,
        height,
        length,
        t0,
        unit,
        per_unit,
        shift,
        packet,
        scalar: !(missed | packet),
        falls: (height[1] + length * height[2]).lt(zero).bits(),
        backward: [per_cell[0].lt(zero).bits(), per_cell[1].lt(zero).bits()],
    }
}

/// `ray::units_per_cell` in lanes.
#[inline(always)]
fn units_per_cell<V: Vector>(speed: Double<V>, per_unit: Double<V>) -> Double<V> {
    let v = speed.token();
    let (most, least) = (Double::splat(v, MOST_PER_CELL), Double::splat(v, -MOST_PER_CELL));
    let per_cell = Double::splat(v, 1.0) / (speed + Double::splat(v, 0.0)) * per_unit;
    least.greater(per_cell.lesser(most))
}

/// `FastTracer::common_tile` in lanes: the tile, and the lanes that have one.
#[inline(always)]
fn common_tile<V: Vector>(tracer: &FastTracer, [a, b]: [Double<V>; 2], side: f64) -> (Double<V>, u32) {
    let v = a.token();
    let splat = |x: f64| Double::splat(v, x);
    let (side, zero, first_edge) = (splat(side), splat(0.0), splat(tracer.first_edge));
    let (low, high) = (a.lesser(b) - first_edge, a.greater(b) - first_edge);
    let in_first = zero.le(low).and(high.le(side));
    let first = in_first.bits();
    if tracer.wrap != Wrap::Repeat || first == Mask::all(v).bits() {
        return (zero, first);
    }
    let tile = (low / side).floor();
    let in_tile = high.le((tile + splat(1.0)) * side);
    (in_first.choose(zero, tile), in_first.or(in_tile).bits())
}
