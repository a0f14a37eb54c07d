//! Sheared lines: a family of parallel lines that visits every texel once (Timonen and Westerholm 2010).

use rayon::prelude::*;
use relief::{HeightMap, Wrap};

/// A direction along the base plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Direction {
    /// One step in texels; the component along the major axis is 1 or -1, the other at most as large.
    pub step: [f64; 2],
    /// Length of the step in metres.
    pub step_m: f64,
}

impl Direction {
    /// Azimuth number `index` of `azimuths`, at the angle `2π index / azimuths` in metres from `+u` towards `+v`.
    pub fn azimuth(index: u32, azimuths: u32, texel_m: [f64; 2]) -> Self {
        let [cos, sin] = unit_vector(index, azimuths);
        let along = [cos / texel_m[0], sin / texel_m[1]];
        let major = along[0].abs().max(along[1].abs());
        Self { step: along.map(|x| snap(x / major)), step_m: 1.0 / major }
    }

    /// Whether the major axis is `v`.
    pub fn is_steep(&self) -> bool {
        self.step[1].abs() > self.step[0].abs()
    }
}

/// Cosine and sine of azimuth number `index` of `azimuths`, with exact quarters.
pub(crate) fn unit_vector(index: u32, azimuths: u32) -> [f64; 2] {
    let angle = std::f64::consts::TAU * f64::from(index) / f64::from(azimuths);
    [snap(angle.cos()), snap(angle.sin())]
}

/// Zero and one where rounding has spoilt them: a line a hair off an axis would read a second row for nothing.
fn snap(x: f64) -> f64 {
    const ROUNDING: f64 = 1e-12;
    if x.abs() < ROUNDING {
        0.0
    } else if (x.abs() - 1.0).abs() < ROUNDING {
        x.signum()
    } else {
        x
    }
}

/// A map and its transpose, so that lines run along rows of one of them.
pub(crate) struct Rows<'a> {
    map: &'a HeightMap,
    transposed: Vec<f32>,
}

impl<'a> Rows<'a> {
    /// Takes as much memory as the map.
    pub fn new(map: &'a HeightMap) -> Self {
        let (width, height) = (map.width() as usize, map.height() as usize);
        let mut transposed = vec![0.0; width * height];
        /// Columns of the map that one task reads together, so that a cache line is read once.
        const BLOCK: usize = 16;
        transposed.par_chunks_mut(BLOCK * height).enumerate().for_each(|(block, columns)| {
            for (j, row) in map.texels().chunks_exact(width).enumerate() {
                for (i, column) in columns.chunks_exact_mut(height).enumerate() {
                    column[j] = row[block * BLOCK + i];
                }
            }
        });
        Self { map, transposed }
    }

    /// How many steps of a direction reach so many tiles; at least [`MIN_REACH`].
    pub fn reach(&self, direction: &Direction, tiles: u32) -> usize {
        let length = if direction.is_steep() { self.map.height() } else { self.map.width() };
        (length as usize * tiles as usize).max(MIN_REACH)
    }

    /// The lines along a direction, which go on for `reach` steps beyond the map.
    pub fn lines(&self, direction: &Direction, reach: usize) -> Lines<'_> {
        let (width, height) = (self.map.width() as usize, self.map.height() as usize);
        let [x, y] = direction.step;
        let steep = direction.is_steep();
        let (texels, length, count) = if steep {
            (self.transposed.as_slice(), height, width)
        } else {
            (self.map.texels(), width, height)
        };
        let (major, slope) = if steep { (y, x) } else { (x, y) };
        // Along a single row every line is the same one.
        let slope = if count == 1 { 0.0 } else { slope };
        let reversed = major < 0.0;
        let wrap = self.map.wrap();
        let columns = (0..(length + reach) as i64)
            .map(|p| wrap.index(if reversed { length as i64 - 1 - p } else { p }, length as u32));
        let rise = |p: usize| slope * p as f64;
        let shifts: Vec<i64> = (0..length).map(|p| (rise(p) + 0.5).floor() as i64).collect();
        let period = match wrap {
            Wrap::Repeat => count as i64,
            Wrap::Mirror => 2 * count as i64,
            Wrap::Clamp => i64::MAX,
        };
        let modulo = |divisor: i64| shifts.iter().map(|shift| shift.rem_euclid(divisor)).collect();
        let turns = if wrap == Wrap::Clamp { shifts.clone() } else { modulo(period) };
        let slots = modulo(count as i64);
        let places: Vec<(i64, f32)> = (0..length + reach)
            .map(|p| {
                let floor = rise(p).floor();
                (floor as i64, (rise(p) - floor) as f32)
            })
            .collect();
        let (first, last) = places.iter().fold((0, 0), |(a, b), place| (a.min(place.0), b.max(place.0)));
        // Clamped lines begin up to as far outside of the map as they are sheared within it.
        let most = places[length - 1].0.abs() + MARGIN;
        let lowest = first - most;
        let highest = last + most + 2 * count as i64;
        let starts = (lowest..=highest).map(|row| wrap.index(row, count as u32) as usize * length).collect();
        let columns = columns.map(|column| column as usize).collect();
        Lines {
            texels,
            length,
            count,
            reach,
            wrap,
            reversed,
            slope,
            lowest,
            columns,
            shifts,
            turns,
            slots,
            period,
            places,
            starts,
        }
    }
}

/// Rows around a line that are read: a ray strays half a row from its line and moves at most a row a step.
const MARGIN: i64 = 3;

/// The least reach in texels: small tiles are there to be repeated many times.
pub(crate) const MIN_REACH: usize = 64;

/// The lines of one direction. Positions `p` count texels along the major axis in the direction of the lines; line
/// `b` is at row `b + slope p`, rows counting texels along the other axis.
///
/// The texel at position `p` and row `y` belongs to the line `y - shift(p)`, `shift(p) = floor(slope p + ½)`, which
/// passes it at most half a row away.
pub(crate) struct Lines<'a> {
    texels: &'a [f32],
    /// Texels along the lines.
    pub length: usize,
    /// Texels across them.
    pub count: usize,
    /// How many texels beyond the map lines go on.
    pub reach: usize,
    wrap: Wrap,
    /// Whether position 0 is the last column.
    pub reversed: bool,
    /// Rows a position.
    pub slope: f64,
    lowest: i64,
    columns: Vec<usize>,
    /// `shift(p)`; the same modulo the period after which lines come back to the same texels; and modulo `count`.
    shifts: Vec<i64>,
    turns: Vec<i64>,
    slots: Vec<i64>,
    /// After so many rows a line runs over the same texels again.
    period: i64,
    /// Whole rows and the rest by which a line is displaced at a position.
    places: Vec<(i64, f32)>,
    starts: Vec<usize>,
}

/// A part of a line whose texels lie in the map.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Stretch {
    /// The line.
    pub line: i64,
    /// Its first position with such a texel and the one after its last.
    pub from: usize,
    pub to: usize,
}

impl Lines<'_> {
    /// The stretches that make up slot `slot` of a sheared map. The texel at `(p, y)` belongs to the slot `(y -
    /// shift(p)) mod count`, so that every slot has exactly one texel at every position.
    ///
    /// Under repeat a slot is one line. Under mirror the texels of a slot are those of two lines, which fold back
    /// into the map in turn; a line with all its copies is again a single one. A clamped line that leaves the map
    /// never comes back, and the slot goes on with the next.
    pub fn stretches(&self, slot: usize) -> Vec<Stretch> {
        let (count, line) = (self.count as i64, slot as i64);
        let whole = |line| Stretch { line, from: 0, to: self.length };
        match self.wrap {
            Wrap::Repeat => vec![whole(line)],
            Wrap::Mirror => vec![whole(line), whole(line + count)],
            Wrap::Clamp => {
                let tile = |p: usize| (line + self.shifts[p]).div_euclid(count);
                let mut stretches: Vec<Stretch> = Vec::new();
                for p in 0..self.length {
                    let line = line - tile(p) * count;
                    match stretches.last_mut() {
                        Some(last) if last.line == line => last.to = p + 1,
                        _ => stretches.push(Stretch { line, from: p, to: p + 1 }),
                    }
                }
                stretches
            }
        }
    }

    /// By how many rows lines are displaced at a position of the map, to the nearest.
    pub fn shift(&self, p: usize) -> i64 {
        self.shifts[p]
    }

    /// The slot of the texel at a position and row.
    pub fn slot(&self, p: usize, row: usize) -> usize {
        let slot = row as i64 - self.slots[p];
        (if slot < 0 { slot + self.count as i64 } else { slot }) as usize
    }

    /// The row of the texel at a position of a stretch, if it is in the map.
    pub fn row(&self, stretch: &Stretch, p: usize) -> Option<usize> {
        let row = stretch.line + self.turns[p];
        let row = if row >= self.period { row - self.period } else { row };
        (row < self.count as i64).then_some(row as usize)
    }

    /// The texel at a position and row of the map.
    pub fn texel(&self, p: usize, row: usize) -> f32 {
        self.texels[row * self.length + self.columns[p]]
    }

    /// The cell between the positions `p` and `p + 1`, both below `length + reach`, and the rows `row` and `row + 1`,
    /// at most [`MARGIN`] off a line there: the texels at `(p, row)`, `(p + 1, row)`, `(p, row + 1)` and `(p + 1, row
    /// + 1)`.
    #[inline]
    pub fn cell(&self, p: usize, row: i64) -> [f32; 4] {
        let at = (row - self.lowest) as usize;
        let (top, bottom) = (self.starts[at], self.starts[at + 1]);
        let (near, far) = (self.columns[p], self.columns[p + 1]);
        [
            self.texels[top + near],
            self.texels[top + far],
            self.texels[bottom + near],
            self.texels[bottom + far],
        ]
    }

    /// The highest point of the surface at position `p`, below `length + reach`, at most `aside` rows, below 2, off a
    /// line.
    #[inline]
    pub fn highest(&self, line: i64, p: usize, aside: f64) -> f32 {
        let (floor, share) = self.places[p];
        let (low, high) = (f64::from(share) - aside, f64::from(share) + aside);
        let (first, last) = (low.floor(), high.floor());
        let at = |row: f64| {
            self.texels[self.starts[(line + floor + row as i64 - self.lowest) as usize] + self.columns[p]]
        };
        let end = |row: f64, share: f64| at(row) + share as f32 * (at(row + 1.0) - at(row));
        let mut highest = end(first, low - first).max(end(last, high - last));
        let mut row = first + 1.0;
        while row <= last {
            highest = highest.max(at(row));
            row += 1.0;
        }
        highest
    }

    /// The heights of the surface on a line at the positions `from..to`, below `length + reach`.
    pub fn samples(&self, line: i64, from: usize, to: usize, heights: &mut Vec<f32>) {
        let places = self.places[from..to].iter().zip(&self.columns[from..to]);
        heights.clear();
        heights.extend(places.map(|(&(floor, share), &column)| {
            let row = (line + floor - self.lowest) as usize;
            let (near, far) =
                (self.texels[self.starts[row] + column], self.texels[self.starts[row + 1] + column]);
            near + share * (far - near)
        }));
    }
}
