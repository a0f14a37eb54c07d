//! The near part of horizons: the ray of the texel itself, piece by piece, for every texel at once.

use std::ops::Range;

use relief_core::HeightMap;

use crate::azimuths::Direction;
use crate::sheared_lines::Run;

/// Steps read from the texel's own ray. The error falls as one over their number, and the time
/// grows.
pub const NEAR_STEPS: usize = 8;

/// Place where the ray crosses the line between two texels: `first + share * (second - first)`.
#[derive(Clone, Copy, Debug)]
struct Crossing {
    first: [i64; 2],
    second: [i64; 2],
    share: f32,
}

/// Part of the ray in one dual cell, the same for every texel. The surface over it is
/// `chord + bend (t - from) (t - to)`, with `t` in steps.
#[derive(Clone, Copy, Debug)]
struct Piece {
    from: f32,
    to: f32,
    /// The dual cell, relative to the texel.
    cell: [i64; 2],
    end: Crossing,
}

/// First steps of every texel's ray in a direction.
pub(super) struct Near {
    pieces: Vec<Piece>,
    /// Product of the ray's steps: the factor by which a cell's twist bends the surface over the
    /// ray.
    twist: f32,
}

/// Crossings nearer together than this, in steps, are one, through a corner.
const CORNER: f64 = 1e-9;

impl Near {
    /// Divides the ray into pieces, up to `steps` steps away.
    pub fn new(direction: &Direction, steps: usize) -> Self {
        let [x, y] = direction.step;
        let crossings = |speed: f64| {
            let count = (steps as f64 * speed.abs() + CORNER).floor() as u32;
            (1..=count).map(move |k| f64::from(k) / speed.abs())
        };
        let mut ends: Vec<f64> = crossings(x).chain(crossings(y)).map(|t| t.min(steps as f64)).collect();
        ends.sort_by(f64::total_cmp);
        ends.dedup_by(|a, b| *a - *b < CORNER);
        let mut from = 0.0;
        let pieces = ends.into_iter().map(|to| {
            let middle = 0.5 * (from + to);
            let cell = [x, y].map(|speed| (speed * middle).floor() as i64);
            let piece = Piece { from: from as f32, to: to as f32, cell, end: crossing([x * to, y * to]) };
            from = to;
            piece
        });
        Self { pieces: pieces.collect(), twist: (x * y) as f32 }
    }

    /// Writes the greatest slope, in heights a step, of the surface along each texel's ray to
    /// `slopes`. `start` is scratch for as many values.
    ///
    /// In a cell the surface over the ray is `a + b t + c t²` above the texel. Its slope
    /// `a/t + b + c t` is greatest at an end, or at `t = sqrt(a/c)` where `a` and `c` are negative.
    /// There it is `b - 2 sqrt(a c)`. In the first cell `a` is 0, and `b` is the slope at the texel
    /// itself. Beyond half of the way, only the ends of cells count; the kind `horizon` bounds the
    /// error.
    pub fn slopes(&self, band: &Padded, run: &Run, start: &mut [f32], slopes: &mut [f32]) {
        let own = band.row(run, [0, 0]);
        let start = &mut start[..slopes.len()];
        let inside = self.pieces.last().map_or(0.0, |last| 0.5 * last.to);
        for (number, piece) in self.pieces.iter().enumerate() {
            let Piece { from, to, cell: [i, j], end } = *piece;
            let (first, second) = (band.row(run, end.first), band.row(run, end.second));
            let height = |x: usize| first[x] + end.share * (second[x] - first[x]) - own[x];
            let (over_to, over_length) = (1.0 / to, 1.0 / (to - from));
            let corners =
                [[i, j], [i + 1, j], [i, j + 1], [i + 1, j + 1]].map(|corner| band.row(run, corner));
            let [h00, h10, h01, h11] = corners;
            let bend = |x: usize| self.twist * (h00[x] - h10[x] - h01[x] + h11[x]);
            if number == 0 {
                for x in 0..slopes.len() {
                    let height = height(x);
                    slopes[x] = (height * over_to).max(height * over_to - bend(x) * to);
                    start[x] = height;
                }
            } else if from < inside && self.twist != 0.0 {
                for x in 0..slopes.len() {
                    let (height, bend) = (height(x), bend(x));
                    let chord = (height - start[x]) * over_length;
                    let a = start[x] - chord * from + bend * (from * to);
                    let b = chord - bend * (from + to);
                    let peaks = (bend < 0.0) & (a <= bend * (from * from)) & (a >= bend * (to * to));
                    let peak = b - 2.0 * (a * bend).max(0.0).sqrt();
                    let end = height * over_to;
                    slopes[x] = slopes[x].max(end).max(if peaks { peak } else { end });
                    start[x] = height;
                }
            } else {
                for x in 0..slopes.len() {
                    let height = height(x);
                    slopes[x] = slopes[x].max(height * over_to);
                    start[x] = height;
                }
            }
        }
    }
}

/// Returns the crossing at a place relative to the texel. At least one of its coordinates is whole.
fn crossing(at: [f64; 2]) -> Crossing {
    let whole = |x: f64| (x - x.round()).abs() <= 2.0 * CORNER;
    if at.map(whole) == [true, true] {
        let first = at.map(|x| x.round() as i64);
        return Crossing { first, second: first, share: 0.0 };
    }
    let along = usize::from(whole(at[0]));
    let mut first = at.map(|x| x.round() as i64);
    first[along] = at[along].floor() as i64;
    let mut second = first;
    second[along] += 1;
    Crossing { first, second, share: (at[along] - at[along].floor()) as f32 }
}

/// Rectangle of a map with its surroundings, wrapped.
pub(super) struct Padded {
    texels: Vec<f32>,
    first_column: usize,
    stride: usize,
    margin: usize,
}

impl Padded {
    /// Copies rows and columns with a margin.
    pub fn new(map: &HeightMap, rows: Range<usize>, columns: Range<usize>, margin: usize) -> Self {
        let width = map.width() as usize;
        let stride = columns.len() + 2 * margin;
        let mut texels = Vec::with_capacity(stride * (rows.len() + 2 * margin));
        let side = margin as i64;
        let (left, right) = (columns.start as i64 - side, columns.end as i64 + side);
        for row in rows.start as i64 - side..rows.end as i64 + side {
            let start = map.wrap().index(row, map.height()) as usize * width;
            let line = &map.texels()[start..start + width];
            let at = |column: i64| line[map.wrap().index(column, map.width()) as usize];
            let (inner, outer) = (left.max(0), right.min(width as i64));
            texels.extend((left..inner).map(at));
            texels.extend_from_slice(&line[inner as usize..outer as usize]);
            texels.extend((outer..right).map(at));
        }
        Self { texels, first_column: columns.start, stride, margin }
    }

    /// Returns the texels `offset` away from a part of the rows.
    fn row(&self, run: &Run, offset: [i64; 2]) -> &[f32] {
        let at = |from: usize, by: i64| (from + self.margin).wrapping_add_signed(by as isize);
        let start =
            at(run.row, offset[1]) * self.stride + at(run.columns.start - self.first_column, offset[0]);
        &self.texels[start..start + run.columns.len()]
    }
}
