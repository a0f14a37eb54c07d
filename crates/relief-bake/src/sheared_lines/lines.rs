//! Sheared lines: a family of parallel lines that visits every texel once (Timonen and Westerholm
//! 2010).

use std::ops::Range;

use relief_core::{HeightMap, Wrap};

use crate::azimuths::Direction;
use crate::transpose::transpose;

/// Map from which lines are taken.
pub(crate) struct Rows<'a> {
    map: &'a HeightMap,
    /// Transpose of the map, whose rows steep lines follow.
    transposed: Option<Vec<f32>>,
}

impl<'a> Rows<'a> {
    /// Creates it without a transpose. Steep lines run across the rows of the map, and are best
    /// read several at a time.
    pub fn new(map: &'a HeightMap) -> Self {
        Self { map, transposed: None }
    }

    /// Creates it with a transpose, for lines that are read at random. Takes as much memory as the
    /// map.
    pub fn with_transpose(map: &'a HeightMap) -> Self {
        let (width, height) = (map.width() as usize, map.height() as usize);
        let mut transposed = vec![0.0; width * height];
        transpose(map.texels(), width, &mut transposed);
        Self { map, transposed: Some(transposed) }
    }

    /// Returns the steps of a direction that cover `tiles` tiles; at least [`MIN_REACH`].
    pub fn reach(&self, direction: &Direction, tiles: u32) -> usize {
        let length = if direction.is_steep() { self.map.height() } else { self.map.width() };
        (length as usize * tiles as usize).max(MIN_REACH)
    }

    /// Returns the lines along a direction. They continue for `reach` steps beyond the map.
    pub fn lines(&self, direction: &Direction, reach: usize) -> Lines<'_> {
        let (width, height) = (self.map.width() as usize, self.map.height() as usize);
        let [x, y] = direction.step;
        let steep = direction.is_steep();
        let (length, count) = if steep { (height, width) } else { (width, height) };
        // Distances in memory between texels, along lines and across them.
        let (texels, along, across) = match (&self.transposed, steep) {
            (Some(transposed), true) => (transposed.as_slice(), 1, height),
            (None, true) => (self.map.texels(), width, 1),
            (_, false) => (self.map.texels(), 1, width),
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
        let starts = (lowest..=highest).map(|row| wrap.index(row, count as u32) as usize * across).collect();
        let columns = columns.map(|column| column as usize * along).collect();
        Lines {
            texels,
            along,
            across,
            length,
            count,
            reach,
            wrap,
            steep,
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

/// Rows around a line that are read: a ray strays half a row from its line and moves at most a row
/// a step.
const MARGIN: i64 = 3;

/// Least reach in texels: small tiles are repeated many times.
pub(crate) const MIN_REACH: usize = 64;

/// Lines of one direction. Positions `p` count texels along the major axis in the direction of the
/// lines. Line `b` is at row `b + slope p`, where rows count texels along the other axis.
///
/// The texel at position `p` and row `y` belongs to the line `y - shift(p)`,
/// `shift(p) = floor(slope p + ½)`, which passes it at most half a row away.
pub(crate) struct Lines<'a> {
    texels: &'a [f32],
    /// Distances in memory between texels, along the lines and across them.
    along: usize,
    across: usize,
    /// Texels along the lines.
    pub length: usize,
    /// Texels across them.
    pub count: usize,
    /// Texels by which lines continue beyond the map.
    pub reach: usize,
    wrap: Wrap,
    /// Whether the lines run along `v`; positions are then rows of the map.
    pub steep: bool,
    /// Whether position 0 is the last column.
    pub reversed: bool,
    /// Rows a position.
    pub slope: f64,
    lowest: i64,
    /// Index of a position's texel in the first row; `starts` has the index of each row's begin.
    columns: Vec<usize>,
    /// `shift(p)` by itself, modulo `period`, and modulo `count`.
    shifts: Vec<i64>,
    turns: Vec<i64>,
    slots: Vec<i64>,
    /// Rows after which a line runs over the same texels again.
    period: i64,
    /// Displacement of a line at a position, in whole rows and the rest.
    places: Vec<(i64, f32)>,
    starts: Vec<usize>,
}

/// Part of a line whose texels lie in the map.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Stretch {
    /// The line.
    pub line: i64,
    /// First position with such a texel, and the one after the last.
    pub from: usize,
    pub to: usize,
}

impl Lines<'_> {
    /// Returns the stretches that make up slot `slot` of a sheared map. The texel at `(p, y)`
    /// belongs to the slot `(y - shift(p)) mod count`, so that every slot has exactly one texel at
    /// every position.
    ///
    /// Under repeat, a slot is one line. Under mirror, the texels of a slot belong to two lines,
    /// which fold back into the map in turn; a line with all its copies is again a single one. A
    /// clamped line that leaves the map never returns, and the slot continues with the next line.
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

    /// Returns the rows by which lines are displaced at a position of the map, to the nearest.
    pub fn shift(&self, p: usize) -> i64 {
        self.shifts[p]
    }

    /// Returns the slot of the texel at a position and row.
    pub fn slot(&self, p: usize, row: usize) -> usize {
        let slot = row as i64 - self.slots[p];
        (if slot < 0 { slot + self.count as i64 } else { slot }) as usize
    }

    /// Returns the row of the texel at a position of a stretch, if it is in the map.
    pub fn row(&self, stretch: &Stretch, p: usize) -> Option<usize> {
        let row = stretch.line + self.turns[p];
        let row = if row >= self.period { row - self.period } else { row };
        (row < self.count as i64).then_some(row as usize)
    }

    /// Returns the texel at a position and row of the map.
    pub fn texel(&self, p: usize, row: usize) -> f32 {
        self.texels[row * self.across + self.columns[p]]
    }

    /// Returns the cell between the positions `p` and `p + 1`, both below `length + reach`, and the
    /// rows `row` and `row + 1`, at most [`MARGIN`] off a line there. Its texels are at `(p, row)`,
    /// `(p + 1, row)`, `(p, row + 1)` and `(p + 1, row + 1)`.
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

    /// Returns the highest point of the surface at position `p`, at most `aside` rows off a line.
    /// `p` is below `length + reach`, `aside` below 2.
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

    /// Samples the surface at the positions `from..to`, below `length + reach`. It follows
    /// neighbouring lines from `line` on, until `heights` is full. Each line's heights take
    /// `stride` values.
    pub fn samples(&self, line: i64, from: usize, to: usize, stride: usize, heights: &mut [f32]) {
        let sample = |line: i64, p: usize| {
            let (floor, share) = self.places[p];
            let (row, column) = ((line + floor - self.lowest) as usize, self.columns[p]);
            let (near, far) =
                (self.texels[self.starts[row] + column], self.texels[self.starts[row + 1] + column]);
            near + share * (far - near)
        };
        self.each(from..to, heights, stride, |lane, p| sample(line + lane as i64, p));
    }

    /// Computes the heights from which texels look along their lines, position by position. It
    /// takes neighbouring slots from `slot` on; each slot's heights take `stride` values.
    ///
    /// Each is the texel's own height, corrected for the line that passes beside it. The correction
    /// is the line's distance in rows times the slope across. The slope is the lesser of the
    /// differences to the rows on both sides, or 0 where one rises and the other falls. On the edge
    /// of a clamped map it is the difference to the row inside, if the lines go there.
    pub fn origins(&self, slot: usize, stride: usize, heights: &mut [f32]) {
        let last = self.count - 1;
        let goes_inside = |row: usize| match self.wrap {
            Wrap::Clamp => [row == 0 && self.slope > 0.0, row == last && self.slope < 0.0],
            Wrap::Repeat | Wrap::Mirror => [false; 2],
        };
        self.each(0..self.length, heights, stride, |lane, p| {
            let row = slot + lane + self.slots[p] as usize;
            let row = if row < self.count { row } else { row - self.count };
            let start = (row as i64 - self.lowest) as usize;
            let texel = |start: usize| self.texels[start + self.columns[p]];
            let [above, own, below] = [start - 1, start, start + 1].map(|at| texel(self.starts[at]));
            let (before, behind) = (own - above, below - own);
            let rise = match goes_inside(row) {
                [true, _] => behind,
                [_, true] => before,
                _ if before * behind <= 0.0 => 0.0,
                _ if before.abs() < behind.abs() => before,
                _ => behind,
            };
            let share = self.places[p].1;
            own + (if share < 0.5 { share } else { share - 1.0 }) * rise
        });
    }

    /// Fills lanes of `stride` values from their positions, in the order of the map's texels in
    /// memory.
    #[inline(always)]
    fn each(
        &self,
        positions: Range<usize>,
        heights: &mut [f32],
        stride: usize,
        value: impl Fn(usize, usize) -> f32,
    ) {
        let first = positions.start;
        if self.along == 1 {
            for (lane, heights) in heights.chunks_mut(stride).enumerate() {
                for (p, height) in positions.clone().zip(heights) {
                    *height = value(lane, p);
                }
            }
        } else {
            let lanes = heights.len().div_ceil(stride);
            for p in positions {
                for lane in 0..lanes {
                    heights[lane * stride + p - first] = value(lane, p);
                }
            }
        }
    }

    /// Finds the columns of a row of the map whose texels lie in some slots, as runs.
    pub fn runs(&self, row: usize, slots: &Range<usize>, runs: &mut Vec<Range<usize>>) {
        runs.clear();
        if self.steep {
            let p = if self.reversed { self.length - 1 - row } else { row };
            let first = (slots.start + self.slots[p] as usize) % self.count;
            let end = first + slots.len();
            runs.push(first..end.min(self.count));
            if end > self.count {
                runs.push(0..end - self.count);
            }
            return;
        }
        // The slot of the texel at `p` is `row - shift(p)` modulo `count`, and shifts are monotone.
        let count = self.count as i64;
        let (first, last) = (self.shifts[0], self.shifts[self.length - 1]);
        let (least, most) = (row as i64 + 1 - slots.end as i64, row as i64 - slots.start as i64);
        let turns = (first.min(last) - most).div_euclid(count)..=(first.max(last) - least).div_euclid(count);
        for turn in turns {
            let (least, most) = (least + turn * count, most + turn * count);
            let (from, to) = if first <= last {
                (self.shifts.partition_point(|&x| x < least), self.shifts.partition_point(|&x| x <= most))
            } else {
                (self.shifts.partition_point(|&x| x > most), self.shifts.partition_point(|&x| x >= least))
            };
            if from < to {
                runs.push(if self.reversed { self.length - to..self.length - from } else { from..to });
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn runs_are_the_columns_of_the_slots() {
        for (wrap, [width, height]) in Wrap::ALL
            .into_iter()
            .flat_map(|wrap| [[13, 7], [5, 31], [8, 8], [1, 9], [9, 1]].map(|size| (wrap, size)))
        {
            let map = HeightMap::from_fn(width, height, wrap, |i, j| (i * 7 + j) as f32 / 300.0);
            let map = map.expect("a valid map");
            let rows = Rows::new(&map);
            for azimuth in 0..24 {
                let lines = rows.lines(&Direction::azimuth(azimuth, 24, [1.0, 0.7]), 9);
                for slots in [0..lines.count, 0..1, lines.count / 2..lines.count] {
                    for row in 0..height as usize {
                        let mut found = Vec::new();
                        lines.runs(row, &slots, &mut found);
                        let mut columns: Vec<usize> = found.into_iter().flatten().collect();
                        columns.sort_unstable();
                        let expected = (0..width as usize).filter(|&column| {
                            let (along, across) = if lines.steep { (row, column) } else { (column, row) };
                            let p = if lines.reversed { lines.length - 1 - along } else { along };
                            slots.contains(&lines.slot(p, across))
                        });
                        assert_eq!(
                            columns,
                            expected.collect::<Vec<_>>(),
                            "{wrap} {width}x{height} {azimuth}"
                        );
                    }
                }
            }
        }
    }
}
