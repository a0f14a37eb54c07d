//! The exact first hit of a path with a volume: the judge of methods that trace volumes.

use super::Volume;
use crate::Path;
use crate::exact::{MAX_RATE, MAX_START, MAX_TRAVEL};

/// Halvings until a root is known to the last bits of `f64`.
const HALVINGS: u32 = 60;

/// The first place on a path where the field reaches the surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VolumeHit {
    /// Parameter of the hit along the path.
    pub t: f64,
    /// Texture coordinates, not wrapped, and height.
    pub at: [f64; 3],
}

impl Volume {
    /// The first hit of a path: the least `t` in `[0, exit]` at which the field is [`SURFACE`](Self::SURFACE)
    /// or more. A path that begins in the solid hits at 0.
    ///
    /// The parameters at which the path crosses a plane between cells are sorted. Between two of them the
    /// field is a polynomial of degree 4, whose first root is isolated by halving its control polygon.
    ///
    /// A path is a miss if it does not end, or if it is longer than the exact tracers of height maps follow.
    pub fn first_hit(&self, path: &Path) -> Option<VolumeHit> {
        let way = Way::of(self, path)?;
        let mut last = 0.0;
        for t in way.crossings() {
            if let Some(root) = self.root_between(&way, last, t, HALVINGS) {
                return Some(VolumeHit { t: root, at: path.at(root) });
            }
            last = t;
        }
        None
    }

    /// The first hit of a path that stays in one cell, as a parameter of the path, to a part of
    /// `2^-halvings` of its way. For walks that know their cells; [`first_hit`](Self::first_hit) needs
    /// none.
    pub fn first_hit_in_cell(&self, path: &Path, halvings: u32) -> Option<f64> {
        let way = Way::of(self, path)?;
        self.root_between(&way, 0.0, path.exit, halvings)
    }

    /// The least gap of the field to the surface along a path, at equal steps: how clearly it misses.
    /// Negative where the path enters the solid.
    pub fn least_gap(&self, path: &Path, steps: u32) -> f64 {
        let gap =
            |k: u32| Self::SURFACE - self.value_at(path.at(path.exit * f64::from(k) / f64::from(steps)));
        (0..=steps).map(gap).fold(f64::INFINITY, f64::min)
    }

    /// The first root of the gap between two parameters in one cell.
    fn root_between(&self, way: &Way, begin: f64, end: f64, halvings: u32) -> Option<f64> {
        let cell = way.at(0.5 * (begin + end)).map(f64::floor);
        let span = end - begin;
        let at = way.at(begin);
        let [x, y] = [0, 1].map(|axis| [at[axis] - cell[axis], way.step[axis] * span]);
        let slope = way.step[2] + 2.0 * way.bend * begin;
        let z = [at[2] - cell[2], slope * span, way.bend * span * span];
        let corners = self.cell(cell.map(|cell| cell as i64));
        let low = along(&corners.low, x, y);
        let high = along(&corners.high, x, y);
        let mut gap = [0.0; 5];
        gap[0] = Self::SURFACE;
        for (degree, (low, high)) in low.into_iter().zip(high).enumerate() {
            gap[degree] -= low;
            for (bend, z) in z.into_iter().enumerate() {
                gap[degree + bend] -= (high - low) * z;
            }
        }
        let root = first_root(control_points(gap), halvings)?;
        Some(begin + root * span)
    }
}

/// A path in voxels: centres are at whole numbers.
struct Way {
    origin: [f64; 3],
    step: [f64; 3],
    bend: f64,
    exit: f64,
}

impl Way {
    fn of(volume: &Volume, path: &Path) -> Option<Self> {
        let size = volume.size().map(f64::from);
        let [u, v] = path.uv;
        let [du, dv] = path.duv;
        let [h, dh, bend] = path.h;
        let origin = [u * size[0] - 0.5, v * size[1] - 0.5, h * size[2] - 0.5];
        let step = [du * size[0], dv * size[1], dh * size[2]];
        let way = Self { origin, step, bend: bend * size[2], exit: path.exit };
        let is_near = origin.iter().all(|at| at.abs() < MAX_START);
        let is_slow = step.iter().chain([&way.bend]).all(|rate| rate.abs() < MAX_RATE);
        let travel = |axis: usize| (step[axis].abs() + way.bend.abs() * path.exit) * path.exit;
        let ends = path.exit >= 0.0 && (0..3).all(|axis| travel(axis) < MAX_TRAVEL);
        (is_near && is_slow && ends).then_some(way)
    }

    fn at(&self, t: f64) -> [f64; 3] {
        let [x, y, z] = [0, 1, 2].map(|axis| self.origin[axis] + self.step[axis] * t);
        [x, y, z + self.bend * t * t]
    }

    /// The parameters at which the way goes from cell to cell, in order, and its end.
    fn crossings(&self) -> Vec<f64> {
        let mut crossings = vec![self.exit];
        let ends = [self.at(0.0), self.at(self.exit)];
        let planes =
            |low: f64, high: f64| (low.ceil() as i64..=high.floor() as i64).map(|plane| plane as f64);
        for axis in 0..2 {
            let [first, last] = ends.map(|at| at[axis]);
            let crossed = planes(first.min(last), first.max(last)).filter(|_| self.step[axis] != 0.0);
            crossings.extend(crossed.map(|plane| (plane - self.origin[axis]) / self.step[axis]));
        }
        let turn =
            if self.bend == 0.0 { 0.0 } else { (-0.5 * self.step[2] / self.bend).clamp(0.0, self.exit) };
        let heights = [ends[0][2], ends[1][2], self.at(turn)[2]];
        let [low, high] = [f64::min, f64::max].map(|of| heights.into_iter().fold(heights[0], of));
        for plane in planes(low, high) {
            crossings.extend(self.heights_at(plane));
        }
        crossings.retain(|t| (0.0..=self.exit).contains(t));
        crossings.sort_by(f64::total_cmp);
        crossings
    }

    /// The parameters at which the way is at a height.
    fn heights_at(&self, plane: f64) -> Vec<f64> {
        let gap = self.origin[2] - plane;
        if self.bend == 0.0 {
            return if self.step[2] == 0.0 { Vec::new() } else { vec![-gap / self.step[2]] };
        }
        let discriminant = self.step[2] * self.step[2] - 4.0 * self.bend * gap;
        if discriminant < 0.0 {
            return Vec::new();
        }
        let q = -0.5 * (self.step[2] + discriminant.sqrt().copysign(self.step[2]));
        let roots = [q / self.bend, gap / q];
        roots.into_iter().filter(|root| root.is_finite()).collect()
    }
}

/// The bilinear mean of four corners along a straight way, as a polynomial of degree 2.
fn along(h: &[f64; 4], [x, dx]: [f64; 2], [y, dy]: [f64; 2]) -> [f64; 3] {
    let (bx, by, twist) = (h[1] - h[0], h[2] - h[0], h[0] - h[1] - h[2] + h[3]);
    [h[0] + bx * x + by * y + twist * x * y, bx * dx + by * dy + twist * (x * dy + y * dx), twist * dx * dy]
}

/// The control points from 0 to 1 of a polynomial of degree 4.
fn control_points([a, b, c, d, e]: [f64; 5]) -> [f64; 5] {
    [a, a + b / 4.0, a + b / 2.0 + c / 6.0, a + 0.75 * b + c / 2.0 + d / 4.0, a + b + c + d + e]
}

/// The first place from 0 to 1 at which a polynomial with these control points is not above 0.
fn first_root(points: [f64; 5], halvings: u32) -> Option<f64> {
    if points[0] <= 0.0 {
        return Some(0.0);
    }
    if points.iter().all(|point| *point > 0.0) {
        return None;
    }
    if halvings == 0 {
        return (points[4] <= 0.0).then_some(1.0);
    }
    let (mut left, mut right, mut row) = ([0.0; 5], [0.0; 5], points);
    for k in 0..5 {
        (left[k], right[4 - k]) = (row[0], row[4 - k]);
        for i in 0..4 - k {
            row[i] = 0.5 * (row[i] + row[i + 1]);
        }
    }
    let of_left = first_root(left, halvings - 1).map(|root| 0.5 * root);
    of_left.or_else(|| first_root(right, halvings - 1).map(|root| 0.5 + 0.5 * root))
}
