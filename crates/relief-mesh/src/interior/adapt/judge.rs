//! How far the bilinear surface lies above and below a triangle, exactly.
//!
//! In a cell the surface less a plane is harmonic, so what is greatest and least of it over a part of the
//! cell lies on the part's border. Along lines between cells it is linear, along an edge of a triangle
//! quadratic. So it is enough to look at the corners of cells within the triangle, at the places where its
//! edges cross lines between cells, and at the vertices of the quadratics along the edges.

use std::fmt::Debug;
use std::ops::{Add, Mul, Sub};

use super::window::{STEPS, Window, bilinear};

/// A distance of the surface from a triangle, along the direction of displacement: greater than 0 where the
/// surface is above.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gap {
    pub height: f64,
    /// Where, in steps of the lattice.
    pub place: [f64; 2],
}

/// The greatest and the least distance of the surface from something.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gaps {
    pub above: Gap,
    pub below: Gap,
}

impl Gaps {
    /// Of nothing.
    pub const NONE: Self = Self {
        above: Gap { height: f64::NEG_INFINITY, place: [0.0; 2] },
        below: Gap { height: f64::INFINITY, place: [0.0; 2] },
    };

    /// Takes one more distance.
    fn take(&mut self, height: f64, place: impl Fn() -> [f64; 2]) {
        if height > self.above.height {
            self.above = Gap { height, place: place() };
        }
        if height < self.below.height {
            self.below = Gap { height, place: place() };
        }
    }

    /// Takes one more distance.
    pub fn take_gap(&mut self, gap: Gap) {
        self.take(gap.height, || gap.place);
    }

    /// Those of both.
    pub fn with(self, other: Self) -> Self {
        Self {
            above: if other.above.height > self.above.height { other.above } else { self.above },
            below: if other.below.height < self.below.height { other.below } else { self.below },
        }
    }

    /// The farther one, if there is any.
    pub fn worst(&self) -> Option<Gap> {
        let gap = if self.above.height >= -self.below.height { self.above } else { self.below };
        gap.height.is_finite().then_some(gap)
    }
}

/// A corner of a triangle: where, and how high.
pub type Corner = ([i32; 2], f64);

/// What a corner of a cell may lie outside of a triangle by rounding, in cells. Corners that lie outside are
/// farther away: edges have lattice points for ends.
const ROUNDING: f64 = 1e-7;

/// Numbers that distances are worked out in.
pub trait Number:
    Copy + PartialOrd + Debug + From<f32> + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self>
{
    const INFINITY: Self;
    const NEG_INFINITY: Self;
    fn of(value: f64) -> Self;
    fn value(self) -> f64;
}

impl Number for f32 {
    const INFINITY: Self = f32::INFINITY;
    const NEG_INFINITY: Self = f32::NEG_INFINITY;
    fn of(value: f64) -> Self {
        value as f32
    }
    fn value(self) -> f64 {
        f64::from(self)
    }
}

impl Number for f64 {
    const INFINITY: Self = f64::INFINITY;
    const NEG_INFINITY: Self = f64::NEG_INFINITY;
    fn of(value: f64) -> Self {
        value
    }
    fn value(self) -> f64 {
        self
    }
}

/// Distances at the corners of cells within a triangle, and on its edges: in `f32` they are found twice as
/// fast, in `f64` exactly.
pub fn within<N: Number>(window: &Window, corners: [Corner; 3]) -> Gaps {
    let mut best = [Best::<N>::NONE; 2];
    rows(window, corners, |row, heights| {
        let Row { j, from, start, slope } = row;
        let row = Row { j, from, start: N::of(start), slope: N::of(slope) };
        let [above, below] = row.extremes(heights);
        if best[0].row.is_none() || above > best[0].height {
            best[0] = Best { height: above, row: Some(row) };
        }
        if best[1].row.is_none() || below < best[1].height {
            best[1] = Best { height: below, row: Some(row) };
        }
    });
    let [above, below] = best.map(|best| best.gap(window));
    Gaps { above: above.unwrap_or(Gaps::NONE.above), below: below.unwrap_or(Gaps::NONE.below) }
}

/// The rows of cells' corners within a triangle, and on its edges, with their heights.
pub fn rows(window: &Window, corners: [Corner; 3], mut each: impl FnMut(Row<f64>, &[f32])) {
    let mut sorted = corners;
    sorted.sort_unstable_by_key(|(at, _)| at[1]);
    let first = (sorted[0].0[1] + STEPS - 1) / STEPS;
    let last = sorted[2].0[1] / STEPS;
    if first > last {
        return;
    }
    let at = sorted.map(|(at, _)| at.map(|at| f64::from(at) / f64::from(STEPS)));
    let [slope, down] = slopes(at, sorted.map(|(_, height)| height));
    let lean = |a: [f64; 2], b: [f64; 2]| if b[1] > a[1] { (b[0] - a[0]) / (b[1] - a[1]) } else { 0.0 };
    let leans = [lean(at[0], at[1]), lean(at[1], at[2]), lean(at[0], at[2])];
    for j in first..=last {
        let y = f64::from(j);
        let short = usize::from(y > at[1][1] || at[0][1] == at[1][1]);
        let ends = [at[short][0] + (y - at[short][1]) * leans[short], at[0][0] + (y - at[0][1]) * leans[2]];
        let (left, right) = if ends[0] < ends[1] { (ends[0], ends[1]) } else { (ends[1], ends[0]) };
        // Conversion rounds towards 0.
        let from = (left + (1.0 - ROUNDING)) as i32;
        let to = (right + ROUNDING) as i32;
        if from <= to {
            let start = sorted[0].1 + (y - at[0][1]) * down + (f64::from(from) - at[0][0]) * slope;
            each(Row { j, from, start, slope }, &window.row(j as usize)[from as usize..=to as usize]);
        }
    }
}

/// The slopes of a triangle along both axes.
pub fn slopes(at: [[f64; 2]; 3], heights: [f64; 3]) -> [f64; 2] {
    let [b, c] = [1, 2].map(|k| [at[k][0] - at[0][0], at[k][1] - at[0][1]]);
    let [rise_b, rise_c] = [heights[1] - heights[0], heights[2] - heights[0]];
    let area = b[0] * c[1] - b[1] * c[0];
    [(rise_b * c[1] - rise_c * b[1]) / area, (rise_c * b[0] - rise_b * c[0]) / area]
}

/// A row of cells' corners within a triangle.
#[derive(Clone, Copy, Debug)]
pub struct Row<N> {
    /// Which row.
    pub j: i32,
    /// The first corner.
    pub from: i32,
    /// The triangle's height at the first corner.
    pub start: N,
    /// How much it rises at each.
    pub slope: N,
}

/// Corners that are looked at together.
const LANES: usize = 8;

impl<N: Number> Row<N> {
    /// The greatest and the least distance of these heights.
    fn extremes(&self, heights: &[f32]) -> [N; 2] {
        let (mut above, mut below) = (N::NEG_INFINITY, N::INFINITY);
        let mut done = 0.0_f32;
        let (lanes, rest) = heights.as_chunks::<LANES>();
        if !lanes.is_empty() {
            let (mut most, mut least) = ([N::NEG_INFINITY; LANES], [N::INFINITY; LANES]);
            for chunk in lanes {
                for k in 0..LANES {
                    let gap = self.gap(done + k as f32, chunk[k]);
                    most[k] = if gap > most[k] { gap } else { most[k] };
                    least[k] = if gap < least[k] { gap } else { least[k] };
                }
                done += LANES as f32;
            }
            for k in 0..LANES {
                above = if most[k] > above { most[k] } else { above };
                below = if least[k] < below { least[k] } else { below };
            }
        }
        for (k, &height) in rest.iter().enumerate() {
            let gap = self.gap(done + k as f32, height);
            above = if gap > above { gap } else { above };
            below = if gap < below { gap } else { below };
        }
        [above, below]
    }

    fn gap(&self, k: f32, height: f32) -> N {
        N::from(height) - (self.start + self.slope * N::from(k))
    }
}

/// The greatest distance so far, and its row.
#[derive(Clone, Copy, Debug)]
struct Best<N> {
    height: N,
    row: Option<Row<N>>,
}

impl<N: Number> Best<N> {
    const NONE: Self = Self { height: N::INFINITY, row: None };

    /// With the place in its row.
    fn gap(&self, window: &Window) -> Option<Gap> {
        let row = self.row?;
        let heights = &window.row(row.j as usize)[row.from as usize..];
        let is_there = |(k, &height): (usize, &f32)| row.gap(k as f32, height) == self.height;
        let k = heights.iter().enumerate().position(is_there)?;
        let place = [row.from + k as i32, row.j].map(|at| f64::from(at * STEPS));
        Some(Gap { height: self.height.value(), place })
    }
}

/// Distances along an edge, its ends among them.
pub fn along(window: &Window, [a, b]: [Corner; 2]) -> Gaps {
    let mut gaps = Gaps::NONE;
    let ((from, start), (to, end)) = (a, b);
    let run = [to[0] - from[0], to[1] - from[1]];
    let length = run.map(i32::abs);
    let steps = run.map(|run| f64::from(run) / f64::from(STEPS));
    let scale = f64::from(length[0].max(1)) * f64::from(length[1].max(1));
    let place = |t: f64| [0, 1].map(|axis| f64::from(from[axis]) + t * f64::from(run[axis]));
    // The first cell, and how far it is to the next line across each axis; times the other axis's run, so
    // that both are compared as whole numbers.
    let mut cell = [0; 2];
    let mut ahead = [i64::MAX; 2];
    for axis in 0..2 {
        let at = from[axis];
        cell[axis] = if run[axis] < 0 || (run[axis] == 0 && at > 0) { (at - 1) / STEPS } else { at / STEPS };
        let line = if run[axis] > 0 { STEPS * (cell[axis] + 1) - at } else { at - STEPS * cell[axis] };
        if run[axis] != 0 {
            ahead[axis] = i64::from(line) * i64::from(length[1 - axis].max(1));
        }
    }
    let stride = [0, 1].map(|axis| i64::from(STEPS) * i64::from(length[1 - axis].max(1)));
    let full = i64::from(length[0].max(1)) * i64::from(length[1].max(1));
    let base = [0, 1].map(|axis| f64::from(from[axis]) / f64::from(STEPS));
    let gap_at = |heights: [f64; 4], cell: [i32; 2], t: f64| {
        let part = [0, 1].map(|axis| base[axis] + t * steps[axis] - f64::from(cell[axis]));
        bilinear(heights, part) - (start + (end - start) * t)
    };
    let mut heights = window.cell(cell);
    let (mut t, mut gap) = (0.0, gap_at(heights, cell, 0.0));
    gaps.take(gap, || place(0.0));
    loop {
        let nearest = ahead[0].min(ahead[1]);
        let is_last = nearest >= full;
        let until = if is_last { 1.0 } else { nearest as f64 / scale };
        let next = gap_at(heights, cell, until);
        gaps.take(next, || place(until));
        // Over the segment the distance is `gap + b s + a s²`, `s` from 0 to 1.
        let share = until - t;
        let twist = heights[0] - heights[1] - heights[2] + heights[3];
        let a = twist * steps[0] * steps[1] * share * share;
        let b = next - gap - a;
        if b * a < 0.0 && b.abs() < 2.0 * a.abs() {
            let s = -0.5 * b / a;
            gaps.take(gap + 0.5 * b * s, || place(t + s * share));
        }
        if is_last {
            return gaps;
        }
        for axis in 0..2 {
            if ahead[axis] == nearest {
                ahead[axis] += stride[axis];
                cell[axis] += run[axis].signum();
            }
        }
        heights = window.cell(cell);
        (t, gap) = (until, next);
    }
}
