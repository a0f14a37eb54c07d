//! Free ways of all paths in a cell.

use rayon::prelude::*;
use relief_core::{Cancelled, HeightMap, Watch, Wrap};

use super::axes::PathRanges;

/// Pieces into which the longest way is divided. More bound paths more closely, and take as much longer.
const PIECES: u32 = 48;

/// Halvings of the piece in which a cell's paths may meet the relief.
const HALVINGS: u32 = 6;

/// The part of a free way that is stored. Greater, and what shaders make of it by `f32` may be past a hit.
const STORED: f64 = 0.998;

/// Texels by which the boxes of paths are widened: far more than the rounding of their places here.
const SLACK_TEXELS: f64 = 1e-3;

/// Returns for each texel's square the way on which no path of `ranges` that comes in there meets the
/// relief, as a part of their [longest](PathRanges::longest), less a slack of two thousandths for the
/// rounding of shaders, rounded down.
///
/// Piece by piece the least height of all these paths is held against the greatest height of the
/// texels around the box in which they are then. These are the corners of the dual cells that the box
/// touches: a patch is nowhere above its corners.
///
/// # Errors
///
/// When it is cancelled.
pub fn free_ways(map: &HeightMap, ranges: &PathRanges, watch: &Watch) -> Result<Vec<f32>, Cancelled> {
    let [width, height] = [map.width(), map.height()];
    let tops = map.texels();
    let mut free = vec![f32::NAN; tops.len()];
    let mut open = tops.len();
    let longest = ranges.longest;
    let mut windows = Windows::new(map.wrap(), [width, height]);
    for piece in 0..PIECES {
        if open == 0 {
            break;
        }
        watch.check()?;
        let way = [piece, piece + 1].map(|side| longest * f64::from(side) / f64::from(PIECES));
        let [u, v] = ranges.places(way);
        let highest = windows.greatest(tops, [texels(u, width), texels(v, height)]);
        let least = ranges.least_height(way);
        for (free, top) in free.iter_mut().zip(highest) {
            if free.is_nan() && least <= f64::from(*top) {
                *free = rounded_down(STORED * clear_until(ranges, way, f64::from(*top)) / longest);
                open -= 1;
            }
        }
    }
    for free in &mut free {
        *free = if free.is_nan() { rounded_down(STORED) } else { *free };
    }
    Ok(free)
}

/// Returns the greatest `f32` that is not above a part of a way.
fn rounded_down(part: f64) -> f32 {
    let nearest = part as f32;
    if f64::from(nearest) > part { nearest.next_down() } else { nearest }
}

/// Returns the way up to which the paths are higher than `top`, in a piece that
/// not all of them pass so.
fn clear_until(ranges: &PathRanges, [begin, end]: [f64; 2], top: f64) -> f64 {
    let [mut clear, mut blocked] = [begin, end];
    for _ in 0..HALVINGS {
        let middle = 0.5 * (clear + blocked);
        if ranges.least_height([begin, middle]) > top { clear = middle } else { blocked = middle }
    }
    clear
}

/// Returns the first and the last texel, counted from the one whose square a path comes in at, that
/// bounds the relief where the path may be.
fn texels([low, high]: [f64; 2], side: u32) -> [f64; 2] {
    let side = f64::from(side);
    [(low * side - 0.5 - SLACK_TEXELS).floor(), (high * side + 0.5 + SLACK_TEXELS).floor() + 1.0]
}

/// Greatest heights of boxes of texels, with scratch memory.
struct Windows {
    wrap: Wrap,
    size: [usize; 2],
    along_rows: Vec<f32>,
    greatest: Vec<f32>,
    line: Line,
}

impl Windows {
    fn new(wrap: Wrap, size: [u32; 2]) -> Self {
        let size = size.map(|side| side as usize);
        let texels = size[0] * size[1];
        let (along_rows, greatest) = (vec![0.0; texels], vec![0.0; texels]);
        Self { wrap, size, along_rows, greatest, line: Line::default() }
    }

    /// Returns for each texel the greatest value of the box from it, given by the numbers of its
    /// first and its last texel along both axes.
    fn greatest(&mut self, values: &[f32], [across, down]: [[f64; 2]; 2]) -> &[f32] {
        let [width, height] = self.size;
        for (from, to) in values.chunks_exact(width).zip(self.along_rows.chunks_exact_mut(width)) {
            self.line.greatest(self.wrap, across, from.iter().copied(), to.iter_mut());
        }
        for column in 0..width {
            let from = (0..height).map(|row| self.along_rows[row * width + column]);
            let to = self.greatest[column..].iter_mut().step_by(width);
            self.line.greatest(self.wrap, down, from, to);
        }
        &self.greatest
    }
}

/// Sliding maximum over a line of values and what continues it.
#[derive(Default)]
struct Line {
    values: Vec<f32>,
    continued: Vec<f32>,
    /// Greatest values from the beginning of a block, and up to its end.
    since: Vec<f32>,
    until: Vec<f32>,
}

impl Line {
    /// Sets each value of `to` to the greatest of `from` between the first and the last of a window
    /// from there (van Herk 1992).
    fn greatest<'a>(
        &mut self,
        wrap: Wrap,
        [first, last]: [f64; 2],
        from: impl Iterator<Item = f32>,
        to: impl Iterator<Item = &'a mut f32>,
    ) {
        let Self { values, continued, since, until } = self;
        values.clear();
        values.extend(from);
        let count = values.len() as i64;
        let period = match wrap {
            Wrap::Repeat => count,
            Wrap::Mirror => 2 * count,
            // Beyond the whole line all values are the outermost ones.
            Wrap::Clamp => i64::MAX,
        };
        let limit = count as f64;
        let [first, last] = match wrap {
            Wrap::Clamp => [first, last].map(|at| at.clamp(-limit, limit) as i64),
            _ if last - first + 1.0 >= period as f64 => [0, period - 1],
            // Whole periods are no change. They are taken off first, since `i64` is not endless.
            _ => {
                let periods = (first / period as f64).floor() * period as f64;
                [first - periods, last - periods].map(|at| at as i64)
            }
        };
        let window = (last - first + 1) as usize;
        continued.clear();
        continued.extend((first..count + last).map(|at| values[wrap.index(at, count as u32) as usize]));
        since.clear();
        since.extend_from_slice(continued);
        until.clear();
        until.extend_from_slice(continued);
        for block in since.chunks_mut(window) {
            for at in 1..block.len() {
                block[at] = block[at].max(block[at - 1]);
            }
        }
        for block in until.chunks_mut(window) {
            for at in (1..block.len()).rev() {
                block[at - 1] = block[at - 1].max(block[at]);
            }
        }
        for (at, to) in to.enumerate() {
            *to = until[at].max(since[at + window - 1]);
        }
    }
}

/// Returns [`free_ways`] of several cells, in order, by all threads.
pub(crate) fn all_free_ways(
    map: &HeightMap,
    cells: &[PathRanges],
    watch: &Watch,
) -> Result<Vec<Vec<f32>>, Cancelled> {
    cells.par_iter().map(|ranges| free_ways(map, ranges, watch)).collect()
}
