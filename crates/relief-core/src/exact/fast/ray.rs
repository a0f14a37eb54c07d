//! A piece of a path as the search wants it: monotone in height, inside one tile of the texture, in cells.

use crate::Wrap;

/// A piece of a path on which the height only falls or only rises.
///
/// Its parameter `s` is the path's, from the piece's start and divided by the power of two at or below its
/// length, so that no number overflows in `f32` whatever the unit of `t` is.
#[derive(Clone, Copy, Debug)]
pub(super) struct TileRay {
    /// Cells from the domain's corner at `s = 0`.
    pub start: [f64; 2],
    /// Cells a unit of `s`.
    pub step: [f64; 2],
    /// Units of `s` a cell; finite also where the step is 0.
    pub per_cell: [f64; 2],
    /// The height as a polynomial in `s`.
    pub height: [f64; 3],
    /// The last `s`, below 2.
    pub length: f64,
}

/// Stands for the infinite reciprocal of a step of 0 without making `0 * inf`. A ray is shorter than 2, so
/// moving by one cell in so many units of `s` is as good as standing still.
pub(super) const MOST_PER_CELL: f64 = (1u64 << 62) as f64;

/// The lesser of two numbers, the second if one is NaN: a single instruction, which `f64::min` is not.
#[inline(always)]
pub(super) fn lesser(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

/// The greater of two numbers, the second if one is NaN.
#[inline(always)]
pub(super) fn greater(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

/// Units of `s` a cell. Adding 0 makes -0 positive. The division does not wait for the unit to be known.
#[inline(always)]
fn units_per_cell(speed: f64, per_unit: f64) -> f64 {
    greater(-MOST_PER_CELL, lesser(1.0 / (speed + 0.0) * per_unit, MOST_PER_CELL))
}

impl TileRay {
    /// The piece from `t0` to `t1` of a path with that place and speed, in cells, and the unit of `s` in `t`.
    #[inline(always)]
    pub fn new(place: [f64; 2], speed: [f64; 2], h: [f64; 3], t0: f64, t1: f64) -> (Self, f64) {
        const EXPONENT: u64 = 0x7ff << 52;
        // The exponents of the least and greatest powers of two whose reciprocals are normal numbers too.
        let exponent = ((t1 - t0).to_bits() & EXPONENT).clamp(1 << 52, 2045 << 52);
        let (unit, per_unit) = (f64::from_bits(exponent), f64::from_bits((2046 << 52) - exponent));
        let start = [place[0] + speed[0] * t0, place[1] + speed[1] * t0];
        let step = [speed[0] * unit, speed[1] * unit];
        let per_cell = [units_per_cell(speed[0], per_unit), units_per_cell(speed[1], per_unit)];
        let height = [h[0] + t0 * (h[1] + t0 * h[2]), (h[1] + 2.0 * h[2] * t0) * unit, h[2] * unit * unit];
        (Self { start, step, per_cell, height, length: (t1 - t0) * per_unit }, unit)
    }

    /// The height at `s`, and its first two Taylor coefficients there.
    #[inline(always)]
    pub fn height_at(&self, s: f64) -> [f64; 3] {
        let [h0, h1, h2] = self.height;
        [h0 + s * (h1 + s * h2), h1 + 2.0 * s * h2, h2]
    }

    /// The place at `s`.
    #[inline(always)]
    pub fn place_at(&self, s: f64) -> [f64; 2] {
        [self.start[0] + self.step[0] * s, self.start[1] + self.step[1] * s]
    }

    /// The part of the ray from `from` to `to` inside a tile, from that tile's corner.
    pub fn inside(&self, axes: &[Axis; 2], from: f64, to: f64) -> Self {
        let place = self.place_at(from);
        let mut part = Self { height: self.height_at(from), length: to - from, ..*self };
        for (k, axis) in axes.iter().enumerate() {
            part.start[k] = axis.sign * place[k] + axis.shift;
            part.step[k] *= axis.sign;
            part.per_cell[k] = if axis.sign == 0.0 { MOST_PER_CELL } else { part.per_cell[k] * axis.sign };
        }
        part
    }
}

/// Where the ray is among the tiles along one axis, and how places there become places in the domain:
/// `sign * place + shift`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Axis {
    wrap: Wrap,
    side: f64,
    /// The tile's number; under clamp -1 and 1 stand for all that is outside.
    tile: f64,
    sign: f64,
    shift: f64,
}

impl Axis {
    /// Where tile 0 begins, in cells. It ends as many cells later as there are texels. For clamp and mirror
    /// tiles run from edge to edge of the texels, half a cell before their centres, and the domain's first
    /// cell is the half cell there.
    pub fn first_edge(wrap: Wrap) -> f64 {
        if wrap == Wrap::Repeat { 0.0 } else { -0.5 }
    }

    /// The tile around a place, along an axis with that many texels.
    pub fn at(wrap: Wrap, side: u32, place: f64) -> Self {
        let side = f64::from(side);
        let tile = ((place - Self::first_edge(wrap)) / side).floor();
        let mut axis = Self { wrap, side, tile, sign: 1.0, shift: 0.0 };
        axis.place_tile();
        axis
    }

    fn place_tile(&mut self) {
        match self.wrap {
            Wrap::Repeat => self.shift = -self.tile * self.side,
            Wrap::Mirror if self.tile.rem_euclid(2.0) == 0.0 => {
                (self.sign, self.shift) = (1.0, 1.0 - self.tile * self.side);
            }
            Wrap::Mirror => (self.sign, self.shift) = (-1.0, (self.tile + 1.0) * self.side),
            Wrap::Clamp => {
                self.tile = self.tile.clamp(-1.0, 1.0);
                (self.sign, self.shift) = match self.tile {
                    -1.0 => (0.0, 0.5),
                    1.0 => (0.0, self.side + 0.5),
                    _ => (1.0, 1.0),
                };
            }
        }
    }

    /// The `s` where a ray that is at `start` and moves by `step` leaves the tile.
    pub fn leave(&self, start: f64, step: f64, per_cell: f64) -> f64 {
        let forward = step > 0.0;
        if step == 0.0 || (self.wrap == Wrap::Clamp && self.tile == if forward { 1.0 } else { -1.0 }) {
            return f64::INFINITY;
        }
        let edge = (self.tile + f64::from(u8::from(forward))) * self.side + Self::first_edge(self.wrap);
        (edge - start) * per_cell
    }

    /// Goes to the next tile.
    pub fn advance(&mut self, step: f64) {
        self.tile += step.signum();
        self.place_tile();
    }

    /// The map's cell, not wrapped, of a cell of the domain. Where the place decides, because the tile has no
    /// cells of its own, it is the place of the hit.
    pub fn cell(&self, domain_cell: i64, place: f64) -> i64 {
        let tile = self.tile as i64;
        let side = self.side as i64;
        match self.wrap {
            Wrap::Repeat => domain_cell + tile * side,
            Wrap::Clamp if self.tile == 0.0 => domain_cell - 1,
            Wrap::Clamp => place.floor() as i64,
            Wrap::Mirror if self.sign > 0.0 => domain_cell - 1 + tile * side,
            Wrap::Mirror => (tile + 1) * side - 1 - domain_cell,
        }
    }
}
