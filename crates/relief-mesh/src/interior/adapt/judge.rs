//! Exact distances of the bilinear surface from a triangle, above and below.
//!
//! In a cell the surface minus a plane is harmonic. So its greatest and least values over a part of
//! the cell lie on the part's border. It is linear along lines between cells, and quadratic along
//! an edge of a triangle. So three sorts of points are enough: corners of cells within the
//! triangle, crossings of its edges with lines between cells, and vertices of the quadratics along
//! its edges.

use glam::{BVec4A, Vec4};

use super::delaunay::Delaunay;
use super::ground::{Corner, Gap, Gaps, Ground, middle, vertex_between};
use super::window::{STEPS, Window, bilinear};
use crate::Judge;

impl Ground for Window {
    fn first_triangles(&self) -> Delaunay {
        Delaunay::of_rectangle(self.from, self.to)
    }

    fn is_inside(&self, point: [i32; 2]) -> bool {
        (0..2).all(|axis| point[axis] > self.from[axis] && point[axis] < self.to[axis])
    }

    fn step(&self, judge: Judge) -> i32 {
        if judge == Judge::Texels { STEPS } else { 1 }
    }

    fn height(&self, point: [i32; 2]) -> f64 {
        self.height_at(point)
    }

    fn centres(&self) -> usize {
        self.columns() * (self.to[1] / STEPS + 1) as usize
    }

    fn each_centre(&self, corners: [Corner; 3], mut each: impl FnMut(usize, f64, &dyn Fn() -> [f64; 2])) {
        each_row(corners, |row, count| {
            let first = row.first(self) as usize;
            for (k, &height) in self.heights()[first..first + count as usize].iter().enumerate() {
                let place = || [row.from + k as i32, row.j].map(|at| f64::from(at * STEPS));
                each(first + k, row.gap(k, height), &place);
            }
        });
    }

    fn worst_within(&self, corners: [Corner; 3]) -> Option<Gap> {
        worst_within(self, corners)
    }

    fn within(&self, corners: [Corner; 3]) -> Gaps {
        within(self, corners)
    }

    fn along(&self, ends: [Corner; 2]) -> Gaps {
        along(self, ends)
    }

    fn outline(&self) -> Vec<[i32; 2]> {
        Window::outline(self).map(|corner| corner.map(|at| at * STEPS)).collect()
    }

    fn has_holes(&self) -> bool {
        Window::has_holes(self)
    }

    fn is_left_out(&self, corners: [Corner; 3]) -> bool {
        Window::has_holes(self)
            && self.is_hole(middle(corners.map(|(at, _)| at.map(f64::from))).map(|at| at / f64::from(STEPS)))
    }
}

/// Returns the greatest and the least distance at the corners of cells within a triangle and on its
/// edges, in `f32`.
fn within(window: &Window, corners: [Corner; 3]) -> Gaps {
    let [mut above, mut below] = [Greatest::NONE; 2];
    fours(window, corners, |gap, at, is_within| {
        above.take(gap, at, is_within);
        below.take(-gap, at, is_within);
    });
    let none = Gaps::none();
    let below = below.gap(window).map(|gap| Gap { height: -gap.height, ..gap });
    Gaps { above: above.gap(window).unwrap_or(none.above), below: below.unwrap_or(none.below) }
}

/// Returns the farthest distance at the corners of cells within a triangle and on its edges,
/// without its sign. This is the fast path, in `f32`.
fn worst_within(window: &Window, corners: [Corner; 3]) -> Option<Gap> {
    let mut worst = Greatest::NONE;
    fours(window, corners, |gap, at, is_within| worst.take(gap.abs(), at, is_within));
    worst.gap(window)
}

/// Measures distances at the corners of cells within a triangle and on its edges, four along a row
/// at a time. Calls `each` with the distances, the numbers of the corners, and which of them are
/// within. Rows are short: four corners on average.
#[inline(always)]
fn fours(window: &Window, corners: [Corner; 3], mut each: impl FnMut(Vec4, Vec4, BVec4A)) {
    each_row(corners, |row, count| {
        let (start, slope) = (Vec4::splat(row.start as f32), Vec4::splat(row.slope as f32));
        let first = row.first(window);
        let numbers = Vec4::splat(first as f32);
        let mut done = 0;
        while done < count {
            let k = Vec4::splat(done as f32) + Vec4::new(0.0, 1.0, 2.0, 3.0);
            let heights = Vec4::from_array(*window.four(first + done));
            each(heights - (start + slope * k), numbers + k, k.cmplt(Vec4::splat(count as f32)));
            done += 4;
        }
    });
}

/// Greatest of some numbers in four SIMD lanes, and the corner at which each lane has it. `f32`
/// holds the numbers of corners, as a tile has far fewer than 2²⁴.
#[derive(Clone, Copy, Debug)]
struct Greatest {
    most: Vec4,
    at: Vec4,
}

impl Greatest {
    const NONE: Self = Self { most: Vec4::NEG_INFINITY, at: Vec4::NEG_ONE };

    /// Adds four more numbers, where `is_there` is set.
    #[inline(always)]
    fn take(&mut self, numbers: Vec4, at: Vec4, is_there: BVec4A) {
        let is_greater = numbers.cmpgt(self.most) & is_there;
        self.most = Vec4::select(is_greater, numbers, self.most);
        self.at = Vec4::select(is_greater, at, self.at);
    }

    /// Returns the first of the greatest numbers, and its place.
    fn gap(self, window: &Window) -> Option<Gap> {
        let (most, at) = (self.most.to_array(), self.at.to_array());
        let mut best = 0;
        for k in 1..4 {
            if most[k] > most[best] || (most[k] == most[best] && at[k] < at[best]) {
                best = k;
            }
        }
        (at[best] >= 0.0).then(|| {
            let (columns, at) = (window.columns() as i32, at[best] as i32);
            let place = [at % columns, at / columns].map(|at| f64::from(at * STEPS));
            Gap { height: f64::from(most[best]), place }
        })
    }
}

/// Calls `each` with the rows of cell corners within a triangle and on its edges, and the number of
/// corners of each.
#[inline(always)]
fn each_row(corners: [Corner; 3], mut each: impl FnMut(Row, i32)) {
    let sorted = by_row(corners);
    let [a, b, c] = [sorted[0].0, sorted[1].0, sorted[2].0];
    let first = (a[1] + STEPS - 1) / STEPS;
    let last = c[1] / STEPS;
    if first > last {
        return;
    }
    let [slope, down] = slopes(sorted);
    let origin = {
        let [x, y] = a.map(|at| f64::from(at) / f64::from(STEPS));
        sorted[0].1 - slope * x - down * y
    };
    // The corner in the middle lies on one side of the long edge.
    let across = |run: i32, fall: i32| i64::from(run) * i64::from(fall);
    let is_left = across(b[0] - a[0], c[1] - a[1]) < across(c[0] - a[0], b[1] - a[1]);
    let [long, upper, lower] = [Edge::new(a, c), Edge::new(a, b), Edge::new(b, c)];
    // The last row along the upper edge, if it has any.
    let middle = if b[1] > a[1] { b[1] / STEPS } else { first - 1 };
    for j in first..=last {
        let ends = [long.at(j), if j <= middle { upper.at(j) } else { lower.at(j) }];
        let [left, right] = if is_left { [ends[1], ends[0]] } else { ends };
        let from = ((left + (CELL - 1 - ROUNDING)) >> CELL_BITS) as i32;
        let to = ((right + ROUNDING) >> CELL_BITS) as i32;
        if from <= to {
            let start = origin + slope * f64::from(from) + down * f64::from(j);
            each(Row { j, from, start, slope }, to - from + 1);
        }
    }
}

/// Returns the corners from the first row to the last. It has no branches, as none could be
/// predicted.
#[inline(always)]
fn by_row(corners: [Corner; 3]) -> [Corner; 3] {
    let [a, b, c] = [corners[0].0[1], corners[1].0[1], corners[2].0[1]];
    let [first, second, third] =
        SORTED[usize::from(a > b) | usize::from(b > c) << 1 | usize::from(a > c) << 2];
    [corners[first], corners[second], corners[third]]
}

/// Order of three numbers, by three bits: first above second, second above third, first above
/// third.
const SORTED: [[usize; 3]; 8] =
    [[0, 1, 2], [1, 0, 2], [0, 2, 1], [0, 1, 2], [0, 1, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];

/// Binary places of a step of the lattice after the point.
const STEP_BITS: u32 = 32;

/// Binary places of a cell after the point.
const CELL_BITS: u32 = STEP_BITS + STEPS.ilog2();

/// A cell.
const CELL: i64 = 1 << CELL_BITS;

/// Greatest rounding error of an edge. A corner of a cell that is not on an edge is farther from
/// it, as the edge's ends are lattice points fewer than 2¹³ steps apart.
const ROUNDING: i64 = 1 << 16;

/// Crossings of an edge with rows, with [`STEP_BITS`] binary places after the point.
#[derive(Clone, Copy, Debug)]
struct Edge {
    x: i64,
    y: i64,
    lean: i64,
}

impl Edge {
    /// Creates an edge between lattice points, the upper one first.
    fn new([x, y]: [i32; 2], [to_x, to_y]: [i32; 2]) -> Self {
        let run = i64::from(to_x - x) << STEP_BITS;
        Self { x: i64::from(x) << STEP_BITS, y: i64::from(y), lean: run / i64::from(to_y - y).max(1) }
    }

    fn at(&self, row: i32) -> i64 {
        self.x + (i64::from(row * STEPS) - self.y) * self.lean
    }
}

/// Returns the slopes of a triangle along both axes, in heights per cell.
#[inline(always)]
fn slopes([(a, za), (b, zb), (c, zc)]: [Corner; 3]) -> [f64; 2] {
    let cells = |from: i32, to: i32| f64::from(to - from) / f64::from(STEPS);
    let [b, c] = [b, c].map(|to| [cells(a[0], to[0]), cells(a[1], to[1])]);
    let scale = 1.0 / (b[0] * c[1] - b[1] * c[0]);
    let [rise_b, rise_c] = [zb - za, zc - za];
    [(rise_b * c[1] - rise_c * b[1]) * scale, (rise_c * b[0] - rise_b * c[0]) * scale]
}

/// Row of cell corners within a triangle.
#[derive(Clone, Copy, Debug)]
struct Row {
    /// Number of the row.
    j: i32,
    /// First corner.
    from: i32,
    /// Height of the triangle at the first corner.
    start: f64,
    /// Rise of the triangle per corner.
    slope: f64,
}

impl Row {
    /// Returns the distance of a height above the triangle, `k` corners from the first.
    fn gap(&self, k: usize, height: f32) -> f64 {
        f64::from(height) - (self.start + self.slope * k as f64)
    }

    /// Returns the number of the first corner in the window.
    fn first(&self, window: &Window) -> i32 {
        self.j * window.columns() as i32 + self.from
    }
}

/// Returns the greatest and the least distance along an edge, ends included.
fn along(window: &Window, [a, b]: [Corner; 2]) -> Gaps {
    let mut gaps = Gaps::none();
    let ((from, start), (to, end)) = (a, b);
    let run = [to[0] - from[0], to[1] - from[1]];
    let length = run.map(i32::abs);
    let steps = run.map(|run| f64::from(run) / f64::from(STEPS));
    let scale = 1.0 / (f64::from(length[0].max(1)) * f64::from(length[1].max(1)));
    let place = |t: f64| [0, 1].map(|axis| f64::from(from[axis]) + t * f64::from(run[axis]));
    // The first cell, and the distance to the next line across each axis. Distances are multiplied
    // by the other axis's run, so that they compare as integers.
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
        let until = if is_last { 1.0 } else { nearest as f64 * scale };
        let next = gap_at(heights, cell, until);
        gaps.take(next, || place(until));
        let share = until - t;
        let twist = heights[0] - heights[1] - heights[2] + heights[3];
        if let Some((gap, s)) = vertex_between(gap, next, twist * steps[0] * steps[1] * share * share) {
            gaps.take(gap, || place(t + s * share));
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
