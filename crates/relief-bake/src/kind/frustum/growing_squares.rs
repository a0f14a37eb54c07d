//! Least slopes of most cells, by squares of texels that grow ahead of all cells at once.
//!
//! Let `z` be a cell's top, and `B(k)` the greatest height in the square of texels up to `k` ahead
//! along both axes. A texel of height `h` that is `k` ahead requires the slope `(h - z) / (k - 1)`.
//! The highest texel of a square may be nearer than the square's end, and then requires more. So
//! `(B(k) - z) / (k - 1)` is never too much, and at some `k` it equals the slope that all texels
//! require. The cell on the diagonal that ends at `k` requires less than `(B(k) - z) / (k - 3/2)`,
//! or less than its corners do.
//!
//! Squares of `2^m` texels, one at every texel, are built from squares of half the side. Four of
//! them, which may overlap, make any square of up to twice the side. So `k` goes from one power of
//! two to the next, a ring, for all cells at once, and only two planes of squares are held. A ring
//! is cut into spans. In a first pass, the ends of the spans estimate all slopes. In a second pass,
//! they show which spans may require more. Only there is `k` tested one by one, from far to near;
//! the skipped values are too low to require more.
//!
//! On inclined ground every `k` is as steep as the next. A cell that took many steps in vain is
//! left to the search of `least_slopes.rs`, which begins with the slope found here.

mod squares;

use std::ops::Range;

use pulp::{Simd, WithSimd};
use rayon::prelude::*;
use relief_core::{Cancelled, HeightMap, Watch, Wrap};

use self::squares::{Squares, greater};
use super::diagonal;
use super::rounding::{CAUTION, round_up};

/// Steps that a cell may take without a rise; natural ground takes about ten.
const PATIENCE: u8 = 64;

/// Spans of a ring that are tested one by one.
const SPANS: usize = 16;

/// Spans of a ring for estimates.
const SPANS_OF_ESTIMATE: usize = 8;

/// Cells side by side that skip a ring together.
const SEGMENT: usize = 64;

/// Factor that raises the reach of a height by more than its rounding has lowered it.
const REACH: f64 = 1.0 + 1.0 / (1u64 << 40) as f64;

/// Share of two heights above a top by which rounding may have lowered their mean, and more.
const ROUNDED: f32 = 1.0 / (1u32 << 22) as f32;

/// Cells that are compared together.
const BLOCK: usize = 8;

/// Slopes of a quadrant, as far as squares determine them.
pub struct SquareSlopes {
    /// Slopes, none of them more than the least slope, rounded up.
    pub slopes: Vec<f32>,
    /// Steps that each cell has left. A cell without steps may need a greater slope.
    pub patience: Vec<u8>,
}

/// Computes the slopes of all cells by squares. `tops` are the cells' tops. Each quadrant goes
/// forward or not along both axes.
pub fn slopes_by_squares<const N: usize>(
    map: &HeightMap,
    tops: &[f32],
    quadrants: [[bool; 2]; N],
    watch: &Watch,
) -> Result<[SquareSlopes; N], Cancelled> {
    let width = map.width() as usize;
    let highest_of_all = map.texels().iter().fold(0.0, |highest, &texel| greater(highest, texel));
    let planes = &mut [const { Vec::new() }; 2];
    let mut each = [const { SquareSlopes { slopes: Vec::new(), patience: Vec::new() } }; N];
    for (place, (found, forward)) in each.iter_mut().zip(quadrants).enumerate() {
        let watch = watch.piece(place as f32 / N as f32, (place + 1) as f32 / N as f32);
        let ground = Ground { map, tops, highest_of_all, forward };
        found.slopes.resize(tops.len(), 0.0);
        found.patience.resize(tops.len(), PATIENCE);
        grow(ground, Pass::Estimate, planes, found, &watch.piece(0.0, 0.3))?;
        grow(ground, Pass::Settle, planes, found, &watch.piece(0.3, 1.0))?;
        turn(&mut found.slopes, width, forward);
        if found.patience.contains(&0) {
            turn(&mut found.patience, width, forward);
        } else {
            found.patience = Vec::new();
        }
    }
    Ok(each)
}

/// Work of a pass while squares grow.
#[derive(Clone, Copy, PartialEq)]
enum Pass {
    /// Raises slopes to a little less than the squares up to the end of each span require.
    Estimate,
    /// Tests the spans that may require more.
    Settle,
}

/// Map and the tops of its cells, for a quadrant.
#[derive(Clone, Copy)]
struct Ground<'a> {
    map: &'a HeightMap,
    tops: &'a [f32],
    highest_of_all: f32,
    forward: [bool; 2],
}

/// Lets squares grow until they can require nothing more. They are held in two planes.
fn grow(
    ground: Ground,
    pass: Pass,
    planes: &mut [Vec<f32>; 2],
    found: &mut SquareSlopes,
    watch: &Watch,
) -> Result<(), Cancelled> {
    let Ground { map, tops, forward, .. } = ground;
    let size = [map.width(), map.height()].map(|side| side as usize);
    let width = size[0] + 1;
    let farthest = if map.wrap() == Wrap::Mirror { 2 } else { 1 } * size[0].max(size[1]);
    let levels = farthest.ilog2() as f32 + 1.0;
    let [held, next] = planes;
    let mut squares = Squares::of_texels(map, forward, std::mem::take(held));
    next.resize(squares.highest.len(), 0.0);
    while squares.side <= farthest {
        watch.at(squares.side.ilog2() as f32 / levels)?;
        let (inner, last) = next.split_at_mut(size[1] * width);
        squares.highest_of_row(size[1], squares.side, 0, last);
        let squares_of = &squares;
        let may_rise = inner
            .par_chunks_mut(width)
            .zip(found.slopes.par_chunks_mut(size[0]))
            .zip(found.patience.par_chunks_mut(size[0]))
            .enumerate()
            .with_min_len(8)
            .map_init(
                || Scratch::new(size[0]),
                |scratch, (row, ((larger, slopes), patience))| {
                    let from = if forward[1] { row } else { size[1] - 1 - row };
                    let tops = &tops[from * size[0]..][..size[0]];
                    scratch.tops.copy_from_slice(tops);
                    if !forward[0] {
                        scratch.tops.reverse();
                    }
                    let squares = squares_of;
                    let row = Row { ground, pass, squares, row, larger, scratch, slopes, patience };
                    relief_core::Lanes::Eight.run_up_to_eight(row)
                },
            )
            .reduce(|| false, |one, other| one | other);
        std::mem::swap(&mut squares.highest, next);
        squares.side *= 2;
        if !may_rise {
            break;
        }
    }
    *held = squares.highest;
    Ok(())
}

/// Turns rows around that were counted ahead, where ahead is backward in the map.
fn turn<T>(cells: &mut [T], width: usize, forward: [bool; 2]) {
    match forward {
        [true, true] => {}
        [false, false] => cells.reverse(),
        [false, true] => cells.chunks_mut(width).for_each(<[T]>::reverse),
        [true, false] => {
            cells.reverse();
            cells.chunks_mut(width).for_each(<[T]>::reverse);
        }
    }
}

/// Row of cells and the squares of twice the side that begin at them, processed with the vectors of
/// the machine.
struct Row<'a> {
    ground: Ground<'a>,
    pass: Pass,
    squares: &'a Squares<'a>,
    row: usize,
    larger: &'a mut [f32],
    scratch: &'a mut Scratch,
    slopes: &'a mut [f32],
    patience: &'a mut [u8],
}

/// Buffers of a task, one row each.
struct Scratch {
    tops: Vec<f32>,
    /// Greatest heights up to the end of a span.
    highest: Vec<f32>,
    /// Texels on both sides of the diagonal.
    beside: [Vec<f32>; 2],
    /// Excess of a possible demand over a cell's slope, in heights: positive where the cell may
    /// require more.
    excess: Vec<f32>,
}

impl Scratch {
    /// Creates buffers for rows of `width` cells.
    fn new(width: usize) -> Self {
        let row = || vec![0.0; width];
        Self { tops: row(), highest: row(), beside: [row(), row()], excess: row() }
    }
}

impl WithSimd for Row<'_> {
    /// Whether squares of a larger side may require more.
    type Output = bool;

    #[inline(always)]
    fn with_simd<S: Simd>(mut self, _: S) -> bool {
        let side = self.squares.side;
        self.squares.highest_of_row(self.row, side, 0, self.larger);
        if side < 2 {
            return true;
        }
        let width = self.slopes.len();
        let mut begin = 0;
        while begin < width {
            let segment = |begin: usize| begin..(begin + SEGMENT).min(width);
            if !self.may_rise(segment(begin)) {
                begin += SEGMENT;
                continue;
            }
            let mut end = segment(begin).end;
            while end < width && self.may_rise(segment(end)) {
                end = segment(end).end;
            }
            self.test_spans(begin..end);
            begin = end;
        }
        let beyond = 2.0 * side as f32 - 1.5;
        let mut may_rise = false;
        for ((top, slope), patience) in self.scratch.tops.iter().zip(&*self.slopes).zip(&*self.patience) {
            may_rise |= (self.ground.highest_of_all - top > slope * CAUTION * beyond) & (*patience > 0);
        }
        may_rise
    }
}

impl Row<'_> {
    /// Returns whether the ring may require more in any of those cells.
    #[inline(always)]
    fn may_rise(&self, cells: Range<usize>) -> bool {
        let distance = CAUTION * (self.squares.side as f32 - 1.5);
        let slopes = self.slopes[cells.clone()].iter().zip(&self.patience[cells.clone()]);
        let heights = self.scratch.tops[cells.clone()].iter().zip(&self.larger[cells]);
        let mut may_rise = false;
        for ((slope, patience), (top, highest)) in slopes.zip(heights) {
            may_rise |= (highest - top > slope * distance) & (*patience > 0);
        }
        may_rise
    }

    /// Tests the ring's spans for those cells.
    #[inline(always)]
    fn test_spans(&mut self, cells: Range<usize>) {
        let (squares, side) = (self.squares, self.squares.side);
        let spans = if self.pass == Pass::Estimate { SPANS_OF_ESTIMATE } else { SPANS };
        let span = side.div_ceil(spans);
        for by in (span..=side).step_by(span) {
            let (first, last) = (side + by - span, side + by - 1);
            squares.highest_of_row(self.row, by, cells.start, &mut self.scratch.highest[cells.clone()]);
            if self.pass == Pass::Estimate {
                self.estimate(last, cells.clone());
            } else {
                if first == last {
                    self.compare_square(last, cells.clone());
                } else {
                    self.compare(first, cells.clone());
                }
                self.raise([first, last], cells.clone());
            }
        }
    }

    /// Raises slopes to a little less than the squares up to `last` texels ahead require.
    #[inline(always)]
    fn estimate(&mut self, last: usize, cells: Range<usize>) {
        let share = CAUTION / (last as f32 - 1.0);
        let heights = self.scratch.tops[cells.clone()].iter().zip(&self.scratch.highest[cells.clone()]);
        for (slope, (top, highest)) in self.slopes[cells].iter_mut().zip(heights) {
            *slope = greater((highest - top) * share, *slope);
        }
    }

    /// Computes the excess of squares that end `first` texels ahead or farther.
    #[inline(always)]
    fn compare(&mut self, first: usize, cells: Range<usize>) {
        let Scratch { tops, highest, excess, .. } = &mut *self.scratch;
        let distance = CAUTION * (first as f32 - 1.5);
        let heights = tops[cells.clone()].iter().zip(&highest[cells.clone()]);
        let slopes = &self.slopes[cells.clone()];
        for (excess, (slope, (top, highest))) in excess[cells].iter_mut().zip(slopes.iter().zip(heights)) {
            *excess = highest - top - slope * distance;
        }
    }

    /// Computes the excess of the square that ends `ahead` texels ahead, and of the cell on its
    /// diagonal.
    #[inline(always)]
    fn compare_square(&mut self, ahead: usize, cells: Range<usize>) {
        let Scratch { tops, highest, beside, excess } = &mut *self.scratch;
        let [below, right] = beside.each_mut().map(|texels| &mut texels[cells.clone()]);
        self.squares.texels_of_row(self.row + ahead, cells.start + ahead - 1, below);
        self.squares.texels_of_row(self.row + ahead - 1, cells.start + ahead, right);
        let (whole, half) = (CAUTION * (ahead as f32 - 1.0), CAUTION * (ahead as f32 - 1.5));
        let heights = tops[cells.clone()].iter().zip(&highest[cells.clone()]);
        let given = self.slopes[cells.clone()].iter().zip(heights).zip(below).zip(right);
        for (excess, (((slope, (top, highest)), below), right)) in excess[cells].iter_mut().zip(given) {
            let (below, right) = (*below - top, *right - top);
            let mean = 0.5 * (below + right) + ROUNDED * (below.abs() + right.abs());
            *excess = greater(highest - top - slope * whole, mean - slope * half);
        }
    }

    /// Raises the slopes of the cells that may require more.
    #[inline(always)]
    fn raise(&mut self, span: [usize; 2], cells: Range<usize>) {
        let mut begin = cells.start;
        while begin < cells.end {
            let end = (begin + BLOCK).min(cells.end);
            // The length is known, so that this compiles to one comparison.
            let is_none = end - begin == BLOCK
                && !self.scratch.excess[begin..begin + BLOCK].iter().fold(false, |any, by| any | (*by > 0.0));
            if !is_none {
                for column in begin..end {
                    if self.scratch.excess[column] > 0.0 {
                        self.raise_cell(column, span);
                    }
                }
            }
            begin = end;
        }
    }

    #[inline(always)]
    fn raise_cell(&mut self, column: usize, span: [usize; 2]) {
        let patience = &mut self.patience[column];
        if *patience > 0 {
            let (top, outermost) = (self.scratch.tops[column], self.scratch.highest[column]);
            let slope = &mut self.slopes[column];
            self.squares.raise([column, self.row], top, span, outermost, slope, patience);
        }
    }
}

impl Squares<'_> {
    /// Raises a cell's slope to the demand of the squares from `first` to `last` texels ahead.
    /// `outermost` is the greatest height of the outermost square.
    #[inline(never)]
    fn raise(
        &self,
        places: [usize; 2],
        top: f32,
        [first, last]: [usize; 2],
        outermost: f32,
        stored: &mut f32,
        patience: &mut u8,
    ) {
        let top = f64::from(top);
        let begun = f64::from(*stored);
        let mut slope = begun;
        // Reach of a height, raised by more than rounding has lowered it.
        let mut reach = REACH / slope;
        let (mut ahead, mut height) = (last, f64::from(outermost) - top);
        while height > 0.0 {
            let asked = slope;
            if height > slope * (ahead as f64 - 1.0) {
                slope = slope.max(height / (ahead as f64 - 1.0));
            }
            if height > slope * (ahead as f64 - 1.5) {
                slope = slope.max(self.diagonal(places, top, ahead - 1, slope));
            }
            if slope > asked {
                reach = REACH / slope;
            } else {
                *patience -= 1;
                if *patience == 0 {
                    break;
                }
            }
            ahead = ((height * reach + 1.5) as usize).min(ahead - 1);
            if ahead < first {
                break;
            }
            height = f64::from(self.highest_up_to(places, ahead)) - top;
        }
        if slope > begun {
            *stored = round_up(slope);
        }
    }

    /// Returns the slope that the `k`-th cell on the diagonal requires, if it is more than `slope`;
    /// otherwise 0.
    #[inline(always)]
    fn diagonal(&self, [column, row]: [usize; 2], top: f64, k: usize, slope: f64) -> f64 {
        let rise = |u: usize, v: usize| f64::from(self.texel([column + u, row + v])) - top;
        let mean = 0.5 * (rise(k + 1, k) + rise(k, k + 1));
        if mean <= slope * (k as f64 - 0.5) {
            return 0.0;
        }
        diagonal::slope(k as i64, rise(k, k), mean, rise(k + 1, k + 1))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use relief_core::MaxPyramid;
    use relief_testing::brute::frustum as brute;
    use relief_testing::maps;

    const QUADRANTS: [[bool; 2]; 4] = [[true, true], [false, true], [true, false], [false, false]];

    fn found(map: &HeightMap) -> [SquareSlopes; 4] {
        let tops = MaxPyramid::new(map).nodes(0).to_vec();
        slopes_by_squares(map, &tops, QUADRANTS, &Watch::none()).expect("nobody cancels")
    }

    #[test]
    fn slopes_are_the_brute_forces_where_steps_are_left_and_nowhere_more() {
        let (mut settled, mut left) = (0, 0);
        for named in maps::ALL {
            for wrap in Wrap::ALL {
                let map = named.build(wrap);
                let most = 2 * i64::from(map.width().max(map.height())) + 4;
                let highest = brute::highest(&map);
                for (found, forward) in found(&map).iter().zip(QUADRANTS) {
                    for (at, &slope) in found.slopes.iter().enumerate().step_by(7) {
                        let cell = [at as u32 % map.width(), at as u32 / map.width()].map(i64::from);
                        let slow = brute::least_slope(&map, highest, cell, forward, most).slope;
                        let close = f64::from((slow as f32).next_up().next_up()) + 4e-15;
                        let name = named.name;
                        assert!(f64::from(slope) <= close, "{name} {wrap} {cell:?} {forward:?} {slope:e}");
                        let is_settled = found.patience.is_empty() || found.patience[at] > 0;
                        assert!(
                            !is_settled || f64::from(slope) >= slow,
                            "{name} {wrap} {cell:?} {forward:?}: {slope:e} and {slow:e}"
                        );
                        *if is_settled { &mut settled } else { &mut left } += 1;
                    }
                }
            }
        }
        assert!(settled > 20 * left, "{left} cells are left of {}", settled + left);
    }

    #[test]
    fn inclined_ground_is_left_to_the_search_and_flat_ground_is_not() {
        let of = |height: fn(u32, u32) -> f32| {
            found(&HeightMap::from_fn(256, 256, Wrap::Clamp, height).expect("heights from 0 to 1"))
        };
        let left = |found: &SquareSlopes| found.patience.iter().filter(|patience| **patience == 0).count();
        let inclined = of(|i, j| (2 * i + j) as f32 / 1024.0);
        assert!(left(&inclined[0]) > 256 * 256 / 4, "{} are left uphill", left(&inclined[0]));
        assert!(inclined[3].patience.is_empty() && inclined[3].slopes.iter().all(|slope| *slope == 0.0));
        for found in of(|_, _| 0.5) {
            assert!(found.patience.is_empty() && found.slopes.iter().all(|slope| *slope == 0.0));
        }
    }
}
