//! A piece of a path in the form that the search requires: in cells, monotone in height, inside one
//! tile.

use crate::Wrap;

/// A piece of a path whose height only falls or only rises.
///
/// Its parameter `s` is the path's, counted from the piece's start and divided by the power of two
/// at or below its length. So no number overflows in `f32`, whatever the unit of `t` is.
#[derive(Clone, Copy, Debug)]
pub(super) struct TileRay {
    /// Position at `s = 0`, in cells from the domain's corner.
    pub start: [f64; 2],
    /// Cells per unit of `s`.
    pub step: [f64; 2],
    /// Units of `s` per cell; finite even if the step is 0.
    pub per_cell: [f64; 2],
    /// Height as a polynomial in `s`.
    pub height: [f64; 3],
    /// End of the piece in `s`, below 2.
    pub length: f64,
}

/// Finite substitute for the infinite reciprocal of a step of 0, to avoid `0 * inf`. A ray is
/// shorter than 2, so such a slow move is as good as none.
pub(super) const MOST_PER_CELL: f64 = (1u64 << 62) as f64;

/// Lesser of two numbers, the second if one is NaN. It is a single instruction; `f64::min` is not.
#[inline(always)]
pub(super) fn lesser(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

/// Greater of two numbers, the second if one is NaN.
#[inline(always)]
pub(super) fn greater(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

/// Units of `s` per cell. Adding 0 makes -0 positive. The division can start before the unit is
/// known.
#[inline(always)]
fn units_per_cell(speed: f64, per_unit: f64) -> f64 {
    greater(-MOST_PER_CELL, lesser(1.0 / (speed + 0.0) * per_unit, MOST_PER_CELL))
}

impl TileRay {
    /// Creates the piece from `t0` to `t1` of a path with this position and speed, in cells. Also
    /// returns the unit of `s` in `t`.
    #[inline(always)]
    pub fn new(place: [f64; 2], speed: [f64; 2], h: [f64; 3], t0: f64, t1: f64) -> (Self, f64) {
        const EXPONENT: u64 = 0x7ff << 52;
        // Exponents of the least and greatest powers of two whose reciprocals are normal numbers,
        // too.
        let exponent = ((t1 - t0).to_bits() & EXPONENT).clamp(1 << 52, 2045 << 52);
        let (unit, per_unit) = (f64::from_bits(exponent), f64::from_bits((2046 << 52) - exponent));
        let start = [place[0] + speed[0] * t0, place[1] + speed[1] * t0];
        let step = [speed[0] * unit, speed[1] * unit];
        let per_cell = [units_per_cell(speed[0], per_unit), units_per_cell(speed[1], per_unit)];
        let height = [h[0] + t0 * (h[1] + t0 * h[2]), (h[1] + 2.0 * h[2] * t0) * unit, h[2] * unit * unit];
        (Self { start, step, per_cell, height, length: (t1 - t0) * per_unit }, unit)
    }

    /// Height at `s`, and its first two Taylor coefficients there.
    #[inline(always)]
    pub fn height_at(&self, s: f64) -> [f64; 3] {
        let [h0, h1, h2] = self.height;
        [h0 + s * (h1 + s * h2), h1 + 2.0 * s * h2, h2]
    }

    /// Position at `s`.
    #[inline(always)]
    pub fn place_at(&self, s: f64) -> [f64; 2] {
        [self.start[0] + self.step[0] * s, self.start[1] + self.step[1] * s]
    }

    /// Part of the ray from `from` to `to` inside a tile, counted from that tile's corner.
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

/// Position of the ray among the tiles along one axis, and the map from positions to the domain:
/// `sign * place + shift`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Axis {
    wrap: Wrap,
    side: f64,
    /// Number of the tile. Under clamp, -1 and 1 stand for everything outside.
    tile: f64,
    sign: f64,
    shift: f64,
}

impl Axis {
    /// Position where tile 0 begins, in cells. It is as many cells long as there are texels. Tiles
    /// of clamp and mirror run from edge to edge of the texels, half a cell before their centres.
    /// There the domain's first cell is the half cell at the edge.
    pub fn first_edge(wrap: Wrap) -> f64 {
        if wrap == Wrap::Repeat { 0.0 } else { -0.5 }
    }

    /// Tile around a position, along an axis of `side` texels.
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

    /// `s` at which a ray that is at `start` and moves by `step` leaves the tile.
    pub fn leave(&self, start: f64, step: f64, per_cell: f64) -> f64 {
        let forward = step > 0.0;
        if step == 0.0 || (self.wrap == Wrap::Clamp && self.tile == if forward { 1.0 } else { -1.0 }) {
            return f64::INFINITY;
        }
        let edge = (self.tile + f64::from(u8::from(forward))) * self.side + Self::first_edge(self.wrap);
        (edge - start) * per_cell
    }

    /// Moves to the next tile.
    pub fn advance(&mut self, step: f64) {
        self.tile += step.signum();
        self.place_tile();
    }

    /// The map's cell, not wrapped, of a cell of the domain. Tiles outside a clamped map have no
    /// cells of their own; there the hit's position `place` decides.
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
