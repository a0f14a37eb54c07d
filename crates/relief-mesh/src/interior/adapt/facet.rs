//! Base triangle as ground for triangulation: a lattice of its barycentric coordinates, with texels
//! at arbitrary places.
//!
//! Within the triangle the place in the map is linear. Let `h` be the height of the map, and `g`
//! the interpolated heights of the corners of a piece. The relief and the piece differ at a base
//! point by `(h - g) N`, with `N` the direction of displacement. They also differ by the *bend* of
//! the piece, because `N` varies over it, or because the base is smooth. The first part is measured
//! exactly, as `h - g` is harmonic in a cell. The second is bounded: see [`Turning`].

use super::delaunay::{Delaunay, MOST_BENT, MOST_METRIC, Metric};
use super::ground::{Corner, Gap, Gaps, Ground, middle, vertex_between};
use super::turning::Turning;
use super::window::{STEPS, Window, bilinear};
use crate::Judge;

/// Least area of a triangle in the map, in cells, whose inside is tested. In smaller ones the edges
/// show all.
const LEAST_AREA: f64 = 1e-9;

/// Rounding of places, in cells.
const ROUNDING: f64 = 1e-9;

/// Base triangle as a [`Ground`].
#[derive(Clone, Debug)]
pub struct Facet {
    /// Heights around it, at centres of texels.
    window: Window,
    /// First corner of the window in the map.
    first: [i64; 2],
    /// Steps of the lattice along a side.
    size: i32,
    /// Places of its corners in the window, in cells.
    places: [[f64; 2]; 3],
    turning: Turning,
    metric: Metric,
}

impl Facet {
    /// Creates a triangle from the places of its corners in a map. The centre of texel `i` is at
    /// `i`.
    pub fn new(size: u32, places: [[f64; 2]; 3], turning: Turning, texel: impl Fn([i64; 2]) -> f32) -> Self {
        let size = (size as i32).min(MOST_BENT);
        let least = [0, 1].map(|axis| places.iter().map(|at| at[axis]).fold(f64::INFINITY, f64::min).floor());
        let places = places.map(|at| [at[0] - least[0], at[1] - least[1]]);
        let most = [0, 1].map(|axis| places.iter().map(|at| at[axis]).fold(1.0, f64::max).ceil() as i32);
        let first = least.map(|at| at as i64);
        let window = Window::new([0, 0], most.map(|cells| cells * STEPS), |[i, j]| {
            texel([first[0] + i as i64, first[1] + j as i64])
        });
        Self { window, first, size, places, turning, metric: metric(places) }
    }

    /// Adds holes: `is_hole` says which cells of the map are holes.
    #[must_use]
    pub fn with_holes(mut self, is_hole: impl Fn([i64; 2]) -> bool) -> Self {
        let [i0, j0] = self.first;
        self.window = self.window.with_holes(|[i, j]| is_hole([i0 + i as i64, j0 + j as i64]));
        self
    }

    /// Returns the barycentric weights of a place of the lattice.
    pub fn weights(&self, place: [f64; 2]) -> [f64; 3] {
        let [of_b, of_c] = place.map(|at| at / f64::from(self.size));
        [1.0 - of_b - of_c, of_b, of_c]
    }

    /// Returns the place in the window of a lattice point.
    fn place(&self, at: [i32; 2]) -> [f64; 2] {
        let size = f64::from(self.size);
        let [of_b, of_c] = at.map(f64::from);
        let of_a = size - of_b - of_c;
        [0, 1].map(|axis| {
            let [a, b, c] = self.places.map(|place| place[axis]);
            (a * of_a + b * of_b + c * of_c) / size
        })
    }

    /// Returns the place of the lattice at a place in the window. It exists if the triangle has an
    /// area in the map.
    fn over(&self, place: [f64; 2]) -> [f64; 2] {
        let [a, b, c] = self.places;
        let [b, c, at] = [b, c, place].map(|to| [to[0] - a[0], to[1] - a[1]]);
        let scale = f64::from(self.size) / (b[0] * c[1] - b[1] * c[0]);
        [(at[0] * c[1] - at[1] * c[0]) * scale, (b[0] * at[1] - b[1] * at[0]) * scale]
    }

    /// Calls `each` for each row of cell corners within a triangle. The arguments are the first
    /// corner and its row, the triangle's height there and its rise per corner, and the heights of
    /// the map.
    fn rows(&self, corners: [Corner; 3], mut each: impl FnMut([i32; 2], [f64; 2], &[f32])) {
        let mut sorted = corners.map(|(at, height)| (self.place(at), height));
        for [a, b] in [[0, 1], [1, 2], [0, 1]] {
            if sorted[a].0[1] > sorted[b].0[1] {
                sorted.swap(a, b);
            }
        }
        let [(a, za), (b, zb), (c, zc)] = sorted;
        let [ab, ac] = [b, c].map(|to| [to[0] - a[0], to[1] - a[1]]);
        let area = ab[0] * ac[1] - ab[1] * ac[0];
        if area.abs() < LEAST_AREA {
            return;
        }
        let [rise_b, rise_c] = [zb - za, zc - za];
        let slope = (rise_b * ac[1] - rise_c * ab[1]) / area;
        let down = (rise_c * ab[0] - rise_b * ac[0]) / area;
        let across = |from: [f64; 2], to: [f64; 2], y: f64| {
            let run = to[1] - from[1];
            if run > 0.0 {
                from[0] + (to[0] - from[0]) * ((y - from[1]) / run).clamp(0.0, 1.0)
            } else {
                to[0]
            }
        };
        let [first, last] = [(a[1] - ROUNDING).ceil() as i32, (c[1] + ROUNDING).floor() as i32];
        for j in first..=last {
            let y = f64::from(j);
            let long = across(a, c, y);
            let short = if y < b[1] { across(a, b, y) } else { across(b, c, y) };
            let from = (long.min(short) - ROUNDING).ceil() as i32;
            let to = (long.max(short) + ROUNDING).floor() as i32;
            if from <= to {
                let start = za + slope * (f64::from(from) - a[0]) + down * (y - a[1]);
                each([from, j], [start, slope], &self.window.row(j as usize)[from as usize..=to as usize]);
            }
        }
    }
}

impl Ground for Facet {
    fn first_triangles(&self) -> Delaunay {
        Delaunay::of_triangle(self.size, self.metric)
    }

    fn is_inside(&self, [x, y]: [i32; 2]) -> bool {
        x > 0 && y > 0 && x + y < self.size
    }

    fn step(&self, _: Judge) -> i32 {
        1
    }

    fn height(&self, point: [i32; 2]) -> f64 {
        let place = self.place(point);
        let cell = self.window.cell_at(place);
        bilinear(self.window.cell(cell), [0, 1].map(|axis| place[axis] - f64::from(cell[axis])))
    }

    fn centres(&self) -> usize {
        self.window.columns() * self.window.rows()
    }

    fn each_centre(&self, corners: [Corner; 3], mut each: impl FnMut(usize, f64, &dyn Fn() -> [f64; 2])) {
        self.rows(corners, |[from, j], [start, slope], heights| {
            let first = j as usize * self.window.columns() + from as usize;
            for (k, &height) in heights.iter().enumerate() {
                let place = || self.over([f64::from(from) + k as f64, f64::from(j)]);
                each(first + k, f64::from(height) - (start + slope * k as f64), &place);
            }
        });
    }

    fn worst_within(&self, corners: [Corner; 3]) -> Option<Gap> {
        self.within(corners).worst()
    }

    fn within(&self, corners: [Corner; 3]) -> Gaps {
        let mut gaps = Gaps::none();
        self.each_centre(corners, |_, gap, place| gaps.take(gap, place));
        gaps
    }

    fn along(&self, [(from, start), (to, end)]: [Corner; 2]) -> Gaps {
        let places = [from, to].map(|at| self.place(at));
        let [from, to] = [from, to].map(|at| at.map(f64::from));
        let place = |t: f64| [0, 1].map(|axis| from[axis] + t * (to[axis] - from[axis]));
        let Gaps { above, below } = along(places, [start, end], |place| {
            let cell = self.window.cell_at(place);
            (cell.map(i64::from), self.window.cell(cell))
        });
        let [above, below] = [above, below].map(|gap| Gap { height: gap.height, place: place(gap.place) });
        Gaps { above, below }
    }

    fn outline(&self) -> Vec<[i32; 2]> {
        let over = |corner: [i32; 2]| self.over(corner.map(f64::from)).map(|at| at.round() as i32);
        self.window.outline().map(over).collect()
    }

    fn has_holes(&self) -> bool {
        self.window.has_holes()
    }

    fn is_left_out(&self, corners: [Corner; 3]) -> bool {
        self.window.has_holes() && self.window.is_hole(middle(corners.map(|(at, _)| self.place(at))))
    }

    fn bend(&self, corners: [Corner; 3]) -> f64 {
        self.turning.bend(corners.map(|(at, height)| (self.weights(at.map(f64::from)), height)))
    }
}

/// Returns the metric of the lattice that measures squares of lengths in the map. If the triangle
/// has hardly any area in the map, returns a metric of the lattice itself.
fn metric([a, b, c]: [[f64; 2]; 3]) -> Metric {
    let [b, c] = [b, c].map(|to| [to[0] - a[0], to[1] - a[1]]);
    let dot = |p: [f64; 2], q: [f64; 2]| p[0] * q[0] + p[1] * q[1];
    let all = [dot(b, b), 2.0 * dot(b, c), dot(c, c)];
    let scale = MOST_METRIC as f64 / all[0].max(all[2]);
    let metric = all.map(|square| (square * scale).round() as i64);
    let [xx, xy, yy] = metric;
    let is_definite = scale.is_finite() && xx > 0 && yy > 0 && 4 * xx * yy > xy * xy;
    if is_definite { metric } else { [1, 1, 1] }
}

/// Returns the greatest and the least distance of a bilinear surface from a straight line, positive
/// above it, and their positions along the line from 0 to 1. Places are counted in cells. `cell_at`
/// returns the cell at a place, and the heights at its corners.
pub fn along(
    [from, to]: [[f64; 2]; 2],
    [start, end]: [f64; 2],
    cell_at: impl Fn([f64; 2]) -> ([i64; 2], [f64; 4]),
) -> Gaps<f64> {
    let run = [to[0] - from[0], to[1] - from[1]];
    let place = |t: f64| [from[0] + t * run[0], from[1] + t * run[1]];
    let mut gaps = Gaps::none();
    // The next line between cells across each axis.
    let mut line =
        [0, 1].map(|axis| if run[axis] > 0.0 { from[axis].floor() + 1.0 } else { from[axis].ceil() - 1.0 });
    let reached = |line: f64, axis: usize| {
        if run[axis] == 0.0 { f64::INFINITY } else { (line - from[axis]) / run[axis] }
    };
    let mut t = 0.0_f64;
    loop {
        let next = [0, 1].map(|axis| reached(line[axis], axis));
        let nearest = next[0].min(next[1]);
        let is_last = nearest.is_nan() || nearest >= 1.0;
        let until = if is_last { 1.0 } else { nearest.max(t) };
        let (cell, heights) = cell_at(place(0.5 * (t + until)));
        let gap_at = |t: f64| {
            let at = place(t);
            bilinear(heights, [0, 1].map(|axis| at[axis] - cell[axis] as f64)) - (start + (end - start) * t)
        };
        let (gap, next_gap) = (gap_at(t), gap_at(until));
        gaps.take(gap, || t);
        gaps.take(next_gap, || until);
        let share = until - t;
        let twist = heights[0] - heights[1] - heights[2] + heights[3];
        if let Some((gap, s)) = vertex_between(gap, next_gap, twist * run[0] * run[1] * share * share) {
            gaps.take(gap, || t + s * share);
        }
        if is_last {
            return gaps;
        }
        for axis in 0..2 {
            if next[axis] == nearest {
                line[axis] += run[axis].signum();
            }
        }
        t = until;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    /// Returns heights without any pattern.
    fn texel([i, j]: [i64; 2]) -> f32 {
        let mixed = (i.wrapping_mul(73_856_093) ^ j.wrapping_mul(19_349_663)).rem_euclid(1009);
        mixed as f32 / 1008.0
    }

    fn height([x, y]: [f64; 2]) -> f64 {
        let [i, j] = [x.floor(), y.floor()];
        let corner = |di: i64, dj: i64| f64::from(texel([i as i64 + di, j as i64 + dj]));
        bilinear([corner(0, 0), corner(1, 0), corner(0, 1), corner(1, 1)], [x - i, y - j])
    }

    #[test]
    fn no_sample_lies_farther_than_the_edges_and_centres_say() {
        let all = [
            [[0.3, 0.2], [9.7, 1.1], [4.0, 8.9]],
            [[-3.0, 5.0], [7.0, 5.0], [-3.0, -4.0]],
            [[100.5, -20.25], [101.0, -20.0], [100.0, -3.0]],
            [[0.5, 0.5], [0.5, 7.5], [0.5, 3.0]],
            [[2.0, 2.0], [2.0, 2.0], [2.0, 2.0]],
        ];
        for places in all {
            let facet = Facet::new(64, places, Turning::flat([DVec3::Y; 3]), texel);
            let corners: [Corner; 3] = [([3, 5], 0.2), ([50, 2], 0.9), ([10, 40], 0.4)];
            let mut most = facet.within(corners);
            for [a, b] in [[0, 1], [1, 2], [2, 0]] {
                let gaps = facet.along([corners[a], corners[b]]);
                most.take(gaps.above.height, || gaps.above.place);
                most.take(gaps.below.height, || gaps.below.place);
            }
            let mut found = Gaps::none();
            let gap = |at: [f64; 2], of: [f64; 3]| {
                let [wa, wb, wc] = facet.weights(at);
                let place = [0, 1].map(|k| wa * places[0][k] + wb * places[1][k] + wc * places[2][k]);
                height(place) - (0..3).map(|k| of[k] * corners[k].1).sum::<f64>()
            };
            let n = 300;
            for i in 0..=n {
                for j in 0..=n - i {
                    let of = [i, j, n - i - j].map(|part| f64::from(part) / f64::from(n));
                    let at = [0, 1].map(|k| (0..3).map(|c| of[c] * f64::from(corners[c].0[k])).sum());
                    found.take(gap(at, of), || at);
                }
            }
            // Nothing is missed, and the bounds are reached nearly everywhere.
            assert!(found.above.height <= most.above.height + 1e-9, "{places:?}: {found:?}, {most:?}");
            assert!(found.below.height >= most.below.height - 1e-9, "{places:?}: {found:?}, {most:?}");
            assert!(found.above.height >= most.above.height - 0.05, "{places:?}: {found:?}, {most:?}");
            assert!(found.below.height <= most.below.height + 0.05, "{places:?}: {found:?}, {most:?}");
        }
    }
}
