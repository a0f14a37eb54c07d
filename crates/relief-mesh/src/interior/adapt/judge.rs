//! How far the bilinear surface lies above and below a triangle, exactly.
//!
//! In a cell the surface less a plane is harmonic, so what is greatest and least of it over a part of the
//! cell lies on the part's border. Along lines between cells it is linear, along an edge of a triangle
//! quadratic. So it is enough to look at the corners of cells within the triangle, at the places where its
//! edges cross lines between cells, and at the vertices of the quadratics along the edges.

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
        rows(self, corners, |row, heights| {
            let first = row.j as usize * self.columns() + row.from as usize;
            for (k, &height) in heights.iter().enumerate() {
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

/// The greatest and the least distance at the corners of cells within a triangle, and on its edges, in `f32`.
fn within(window: &Window, corners: [Corner; 3]) -> Gaps {
    let mut best = [None::<Best>; 2];
    rows(window, corners, |row, heights| {
        let line = row.line();
        let [above, below] = line.extremes(heights);
        if best[0].is_none_or(|best| above > best.height) {
            best[0] = Some(Best { height: above, row });
        }
        if best[1].is_none_or(|best| below < best.height) {
            best[1] = Some(Best { height: below, row });
        }
    });
    let [above, below] = best.map(|best| best.and_then(|best| best.gap(window)));
    let none = Gaps::none();
    Gaps { above: above.unwrap_or(none.above), below: below.unwrap_or(none.below) }
}

/// The farthest distance at the corners of cells within a triangle, and on its edges: as fast as can be, in
/// `f32`.
fn worst_within(window: &Window, corners: [Corner; 3]) -> Option<Gap> {
    let mut worst = -1.0_f32;
    let mut found = (0.0, [0; 2]);
    rows(window, corners, |row, heights| {
        let line = row.line();
        // Most rows are short. In long ones the place is looked for only where there is one.
        if heights.len() >= 2 * LANES {
            let [above, below] = line.extremes(heights);
            if above.max(-below) <= worst {
                return;
            }
        }
        for (k, &height) in heights.iter().enumerate() {
            let gap = line.gap(k as f32, height);
            if gap.abs() > worst {
                worst = gap.abs();
                found = (gap, [row.from + k as i32, row.j]);
            }
        }
    });
    let (height, at) = found;
    (worst >= 0.0).then(|| Gap { height: f64::from(height), place: at.map(|at| f64::from(at * STEPS)) })
}

/// The rows of cells' corners within a triangle, and on its edges, with their heights.
fn rows(window: &Window, corners: [Corner; 3], mut each: impl FnMut(Row, &[f32])) {
    let mut sorted = corners;
    for [a, b] in [[0, 1], [1, 2], [0, 1]] {
        if sorted[a].0[1] > sorted[b].0[1] {
            sorted.swap(a, b);
        }
    }
    let first = (sorted[0].0[1] + STEPS - 1) / STEPS;
    let last = sorted[2].0[1] / STEPS;
    if first > last {
        return;
    }
    let at = sorted.map(|(at, _)| at);
    let [slope, down] = slopes(sorted);
    let origin = {
        let [x, y] = at[0].map(|at| f64::from(at) / f64::from(STEPS));
        sorted[0].1 - slope * x - down * y
    };
    // The corner in the middle lies on one side of the long edge.
    let [ab, ac] = [1, 2].map(|k| [0, 1].map(|axis| i64::from(at[k][axis] - at[0][axis])));
    let is_left = ab[0] * ac[1] < ab[1] * ac[0];
    let long = Edge::new(at[0], at[2]);
    let middle = if at[1][1] > at[0][1] { at[1][1] / STEPS } else { first - 1 };
    for (short, rows) in [([0, 1], first..=middle.min(last)), ([1, 2], middle + 1..=last)] {
        if rows.is_empty() {
            continue;
        }
        let short = Edge::new(at[short[0]], at[short[1]]);
        let (left, right) = if is_left { (&short, &long) } else { (&long, &short) };
        for j in rows {
            let from = ((left.at(j) + (CELL - 1 - ROUNDING)) >> CELL_BITS) as i32;
            let to = ((right.at(j) + ROUNDING) >> CELL_BITS) as i32;
            if from <= to {
                let start = origin + slope * f64::from(from) + down * f64::from(j);
                each(Row { j, from, start, slope }, &window.row(j as usize)[from as usize..=to as usize]);
            }
        }
    }
}

/// Bits of a step of the lattice behind the point.
const STEP_BITS: u32 = 32;

/// Bits of a cell behind the point.
const CELL_BITS: u32 = STEP_BITS + STEPS.ilog2();

/// A cell.
const CELL: i64 = 1 << CELL_BITS;

/// What an edge is wrong by at most. A corner of a cell that is not on an edge is farther from it: the edge's
/// ends are lattice points, fewer than 2¹³ steps apart.
const ROUNDING: i64 = 1 << 16;

/// Where an edge crosses rows, with [`STEP_BITS`] bits behind the point.
#[derive(Clone, Copy, Debug)]
struct Edge {
    x: i64,
    y: i64,
    lean: i64,
}

impl Edge {
    /// An edge between lattice points, the upper one first.
    fn new([x, y]: [i32; 2], [to_x, to_y]: [i32; 2]) -> Self {
        let run = i64::from(to_x - x) << STEP_BITS;
        Self { x: i64::from(x) << STEP_BITS, y: i64::from(y), lean: run / i64::from(to_y - y).max(1) }
    }

    fn at(&self, row: i32) -> i64 {
        self.x + (i64::from(row * STEPS) - self.y) * self.lean
    }
}

/// The slopes of a triangle along both axes, in heights a cell.
fn slopes([(a, za), (b, zb), (c, zc)]: [Corner; 3]) -> [f64; 2] {
    let cells = |from: i32, to: i32| f64::from(to - from) / f64::from(STEPS);
    let [b, c] = [b, c].map(|to| [cells(a[0], to[0]), cells(a[1], to[1])]);
    let scale = 1.0 / (b[0] * c[1] - b[1] * c[0]);
    let [rise_b, rise_c] = [zb - za, zc - za];
    [(rise_b * c[1] - rise_c * b[1]) * scale, (rise_c * b[0] - rise_b * c[0]) * scale]
}

/// A row of cells' corners within a triangle.
#[derive(Clone, Copy, Debug)]
struct Row {
    /// Which row.
    j: i32,
    /// The first corner.
    from: i32,
    /// The triangle's height at the first corner.
    start: f64,
    /// How much it rises at each.
    slope: f64,
}

impl Row {
    /// How far a height lies above the triangle, so many corners from the first.
    fn gap(&self, k: usize, height: f32) -> f64 {
        f64::from(height) - (self.start + self.slope * k as f64)
    }

    fn line(&self) -> Line {
        Line { start: self.start as f32, slope: self.slope as f32 }
    }
}

/// A triangle along a row, in `f32`: half as exact, and twice as fast.
#[derive(Clone, Copy, Debug)]
struct Line {
    start: f32,
    slope: f32,
}

/// Corners that are looked at together.
const LANES: usize = 8;

impl Line {
    fn gap(&self, k: f32, height: f32) -> f32 {
        height - (self.start + self.slope * k)
    }

    /// The greatest and the least distance of these heights.
    fn extremes(&self, heights: &[f32]) -> [f32; 2] {
        let (mut above, mut below) = (f32::NEG_INFINITY, f32::INFINITY);
        let mut done = 0.0_f32;
        let (lanes, rest) = heights.as_chunks::<LANES>();
        if !lanes.is_empty() {
            let (mut most, mut least) = ([above; LANES], [below; LANES]);
            for chunk in lanes {
                for k in 0..LANES {
                    let gap = self.gap(done + k as f32, chunk[k]);
                    most[k] = if gap > most[k] { gap } else { most[k] };
                    least[k] = if gap < least[k] { gap } else { least[k] };
                }
                done += LANES as f32;
            }
            above = most.into_iter().fold(above, f32::max);
            below = least.into_iter().fold(below, f32::min);
        }
        for (k, &height) in rest.iter().enumerate() {
            let gap = self.gap(done + k as f32, height);
            above = if gap > above { gap } else { above };
            below = if gap < below { gap } else { below };
        }
        [above, below]
    }
}

/// The greatest distance so far, and its row.
#[derive(Clone, Copy, Debug)]
struct Best {
    height: f32,
    row: Row,
}

impl Best {
    /// With the place in its row.
    fn gap(&self, window: &Window) -> Option<Gap> {
        let (row, line) = (self.row, self.row.line());
        let heights = &window.row(row.j as usize)[row.from as usize..];
        let is_there = |(k, &height): (usize, &f32)| line.gap(k as f32, height) == self.height;
        let k = heights.iter().enumerate().position(is_there)?;
        let place = [row.from + k as i32, row.j].map(|at| f64::from(at * STEPS));
        Some(Gap { height: f64::from(self.height), place })
    }
}

/// Distances along an edge, its ends among them.
fn along(window: &Window, [a, b]: [Corner; 2]) -> Gaps {
    let mut gaps = Gaps::none();
    let ((from, start), (to, end)) = (a, b);
    let run = [to[0] - from[0], to[1] - from[1]];
    let length = run.map(i32::abs);
    let steps = run.map(|run| f64::from(run) / f64::from(STEPS));
    let scale = 1.0 / (f64::from(length[0].max(1)) * f64::from(length[1].max(1)));
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
