//! A piece of a path as the search wants it: monotone in height, inside one tile of the texture, in cells.

use crate::Wrap;

/// A piece of a path on which the height only falls or only rises.
///
/// The parameter `s` is `t` from the piece's start times a rate at which neither the place, in cells, nor the height
/// changes by more than 1 a unit. So no number here is larger than the way is long, however steep or shallow the path.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ray {
    /// Cells from the domain's corner at `s = 0`.
    pub start: [f64; 2],
    /// Cells a unit of `s`, at most 1.
    pub step: [f64; 2],
    /// Units of `s` a cell; finite also where the step is 0.
    pub per_cell: [f64; 2],
    /// The height as a polynomial in `s`.
    pub height: [f64; 3],
    /// The last `s`.
    pub length: f64,
}

/// Stands for the infinite reciprocal of a step of 0, without making `0 * inf`.
const MOST_PER_CELL: f64 = 1e30;

impl Ray {
    /// The piece of a path from `t0` on, at `place` there, and the rate: units of `s` a unit of `t`.
    pub fn new(place: [f64; 2], speed: [f64; 2], h: [f64; 3], t0: f64, t1: f64) -> (Self, f64) {
        let rise = (h[1] + 2.0 * h[2] * t0).abs().max((h[1] + 2.0 * h[2] * t1).abs());
        let fastest = speed[0].abs().max(speed[1].abs()).max(rise);
        let rate = if fastest > 0.0 { fastest } else { 1.0 };
        let unit = 1.0 / rate;
        let start = [place[0] + speed[0] * t0, place[1] + speed[1] * t0];
        let step = [speed[0] * unit, speed[1] * unit];
        let per_cell = step.map(|step| (1.0 / step).clamp(-MOST_PER_CELL, MOST_PER_CELL));
        let height = [h[0] + t0 * (h[1] + t0 * h[2]), (h[1] + 2.0 * h[2] * t0) * unit, h[2] * unit * unit];
        (Self { start, step, per_cell, height, length: (t1 - t0) * rate }, rate)
    }

    /// The height at `s`, and its first two Taylor coefficients there.
    #[inline]
    pub fn height_at(&self, s: f64) -> [f64; 3] {
        let [h0, h1, h2] = self.height;
        [h0 + s * (h1 + s * h2), h1 + 2.0 * s * h2, h2]
    }

    /// The part of the ray from `from` to `to` inside a tile, from that tile's corner.
    pub fn inside(&self, axes: &[Axis; 2], from: f64, to: f64) -> Self {
        let mut part = Self { height: self.height_at(from), length: to - from, ..*self };
        for (k, axis) in axes.iter().enumerate() {
            part.start[k] = axis.sign * (self.start[k] + self.step[k] * from) + axis.shift;
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
    /// The tile around a place, along an axis with that many texels.
    #[inline]
    pub fn at(wrap: Wrap, side: u32, place: f64) -> Self {
        let side = f64::from(side);
        let tile = match wrap {
            Wrap::Repeat if place >= 0.0 && place < side => 0.0,
            Wrap::Repeat => (place / side).floor(),
            Wrap::Clamp | Wrap::Mirror => ((place + 0.5) / side).floor(),
        };
        let mut axis = Self { wrap, side, tile, sign: 1.0, shift: 0.0 };
        axis.place_tile();
        axis
    }

    /// The domain's place of the tile. For clamp and mirror the domain's first cell is the half cell before texel 0, and
    /// their tiles run from edge to edge of the texels, half a cell before their centres.
    #[inline]
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

    /// Where a ray that is at `start` and moves by `step` leaves the tile.
    #[inline]
    pub fn leave(&self, start: f64, step: f64, per_cell: f64) -> f64 {
        let forward = step > 0.0;
        if step == 0.0 || (self.wrap == Wrap::Clamp && self.tile == if forward { 1.0 } else { -1.0 }) {
            return f64::INFINITY;
        }
        let edge = (self.tile + f64::from(u8::from(forward))) * self.side;
        let offset = if self.wrap == Wrap::Repeat { 0.0 } else { 0.5 };
        (edge - offset - start) * per_cell
    }

    /// Goes to the next tile.
    pub fn advance(&mut self, step: f64) {
        self.tile += step.signum();
        self.place_tile();
    }

    /// The map's cell, not wrapped, of a cell of the domain; `place` is where the hit is, for tiles without cells.
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
