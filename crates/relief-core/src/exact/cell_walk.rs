//! The cell walk: visits every dual cell on the path, in order, and solves each in closed form.
//!
//! The walk is the 2-D DDA of Amanatides and Woo 1987. It computes crossings from the cell's number
//! instead of adding increments, so its error does not grow along the path.

use super::patch::Gap;
use super::{CELL_BYTES, ExactHit, MAX_TRAVEL, is_traceable};
use crate::{Cost, HeightMap, Path};

/// Returns the first hit of a path, in `f64`, by a walk through every dual cell on its way.
///
/// At a hit `|H(t) - f(u, v)|` is at most 1e-12, unless the path begins below the surface. This
/// holds for maps of up to 4096 cells a side and paths within a few tiles of the origin. Beyond
/// that the error grows with the number of cells between the path and the origin, times 2⁻⁵².
///
/// The walk costs a step and a read for each cell on the path. For endless paths see the
/// [module](super).
pub fn cell_walk(map: &HeightMap, path: &Path) -> ExactHit {
    if !is_traceable([map.width(), map.height()], path) {
        return ExactHit::miss(Cost::default(), 0.0);
    }
    let Some(span) = Span::of(map, path) else {
        return ExactHit::miss(Cost::default(), (least_height(path, 0.0, path.exit) - highest(map)).max(0.0));
    };
    let mut cost = Cost::default();
    let mut clearance = f64::INFINITY;
    let mut walk = Walk::new(map, path, span.from, span.to);
    while let Some(visit) = walk.next() {
        cost.step(1, CELL_BYTES);
        let gap = walk.gap(map, &visit);
        let length = visit.to - visit.from;
        if let Some(tau) = gap.first_root(length) {
            let depth = if tau > 0.0 { 0.0 } else { gap.c[0] };
            return ExactHit::at(path, visit.from + tau, visit.cell, depth, gap.slope(tau), cost);
        }
        clearance = clearance.min(gap.least(length));
    }
    if !span.given_up {
        return ExactHit::miss(cost, clearance);
    }
    let rest = least_height(path, span.to, path.exit) - highest(map);
    if rest > 0.0 {
        return ExactHit::miss(cost, clearance.min(rest));
    }
    ExactHit::given_up(map, path, span.to, cost)
}

/// Highest texel. It is computed only if a path is too long to be walked to its end.
fn highest(map: &HeightMap) -> f64 {
    f64::from(map.texels().iter().copied().fold(0.0, f32::max))
}

/// Returns the least gap `g` between path and surface for `t` in `[from, to]`, in `f64`. It is
/// negative where the path is below the surface. It shows how nearly a miss is a hit, and how small
/// an error turns a hit into a miss.
///
/// `from` and `to` must be finite, and are clamped to `[0, exit]`. The gap over an empty range is
/// infinite. At most [`MAX_TRAVEL`] cells are visited.
pub fn least_gap(map: &HeightMap, path: &Path, from: f64, to: f64) -> f64 {
    let (from, to) = (from.max(0.0), to.min(path.exit));
    let is_range = from <= to && to.is_finite();
    if !is_range || !is_traceable([map.width(), map.height()], path) {
        return f64::INFINITY;
    }
    let mut least = f64::INFINITY;
    let mut walk = Walk::new(map, path, from, to.min(from + walk_limit(map, path)));
    while let Some(visit) = walk.next() {
        least = least.min(walk.gap(map, &visit).least(visit.to - visit.from));
    }
    least
}

/// Distance that `t` may advance until the path has moved [`MAX_TRAVEL`] cells. Infinite for a path
/// whose position does not change.
fn walk_limit(map: &HeightMap, path: &Path) -> f64 {
    let speed_x = (path.duv[0] * f64::from(map.width())).abs();
    let speed_y = (path.duv[1] * f64::from(map.height())).abs();
    MAX_TRAVEL / speed_x.max(speed_y)
}

/// Least height of the path for `t` in `[from, to]`; `to` may be infinite.
fn least_height(path: &Path, from: f64, to: f64) -> f64 {
    let [_, h1, h2] = path.h;
    let height = |t: f64| path.at(t)[2];
    let end = if to.is_finite() {
        height(to)
    } else if h2 < 0.0 || (h2 == 0.0 && h1 < 0.0) {
        f64::NEG_INFINITY
    } else {
        f64::INFINITY
    };
    let turn = -h1 / (2.0 * h2);
    let turned = if h2 > 0.0 && turn > from && turn < to { height(turn) } else { f64::INFINITY };
    height(from).min(end).min(turned)
}

/// Part of a path that must be walked.
struct Span {
    from: f64,
    to: f64,
    /// Whether the path goes on after [`MAX_TRAVEL`] cells and may still come below the map.
    given_up: bool,
}

impl Span {
    /// Height above which a path need not be walked. Above 2 the gap is more than 1, and below 0
    /// there is a hit, so nothing outside that range matters.
    const TOP: f64 = 2.0;
    /// Height below which a path need not be walked. It is below 0, so that rounding does not end
    /// the walk before the hit.
    const BOTTOM: f64 = -1.0;

    /// Returns `None` if the path is above the map all the way, and too high or too long for the
    /// gap to matter.
    fn of(map: &HeightMap, path: &Path) -> Option<Self> {
        let [h0, h1, h2] = path.h;
        let top = crossings([h0 - Self::TOP, h1, h2]);
        let bottom = crossings([h0 - Self::BOTTOM, h1, h2]);
        let mut from = 0.0;
        if h0 > Self::TOP {
            from = top.into_iter().find(|t| *t >= 0.0)?;
        }
        let mut to = path.exit;
        if h0 > Self::BOTTOM {
            to = bottom.into_iter().filter(|t| *t >= from).fold(to, f64::min);
        }
        let ends_above = match to.is_finite() {
            true => path.at(to)[2] > Self::TOP,
            false => h2 > 0.0 || (h2 == 0.0 && h1 > 0.0),
        };
        if ends_above {
            to = top.into_iter().filter(|t| *t >= from && *t <= to).fold(from, f64::max);
        }
        if from > to {
            return None;
        }
        let limit = from + walk_limit(map, path);
        if to <= limit {
            return Some(Self { from, to, given_up: false });
        }
        if limit.is_infinite() {
            // Neither the position nor the height ever changes.
            return Some(Self { from, to: from, given_up: false });
        }
        (least_height(path, from, path.exit) <= highest(map)).then_some(Self {
            from,
            to: limit,
            given_up: true,
        })
    }
}

/// Roots of `c[0] + c[1] t + c[2] t²` in ascending order. NaN stands for a missing root.
fn crossings(c: [f64; 3]) -> [f64; 2] {
    let [c0, c1, c2] = c;
    if c2 == 0.0 {
        return if c1 == 0.0 { [f64::NAN; 2] } else { [-c0 / c1, f64::NAN] };
    }
    let disc = c1 * c1 - 4.0 * c0 * c2;
    if disc < 0.0 {
        return [f64::NAN; 2];
    }
    let q = -0.5 * (c1 + disc.sqrt().copysign(c1));
    let (a, b) = (q / c2, if q == 0.0 { 0.0 } else { c0 / q });
    [a.min(b), a.max(b)]
}

/// A cell on the path, and the parameters between which the path is in it.
struct Visit {
    cell: [i64; 2],
    from: f64,
    to: f64,
}

/// Dual cells on a path, in order. One parameter is both the end in a cell and the beginning in the
/// next.
struct Walk {
    /// Position at `t = 0` and change per unit of `t`, in cells.
    start: [f64; 2],
    speed: [f64; 2],
    h: [f64; 3],
    cell: [i64; 2],
    t: f64,
    end: f64,
    done: bool,
}

impl Walk {
    fn new(map: &HeightMap, path: &Path, from: f64, to: f64) -> Self {
        let size = [f64::from(map.width()), f64::from(map.height())];
        let start = [path.uv[0] * size[0] - 0.5, path.uv[1] * size[1] - 0.5];
        let speed = [path.duv[0] * size[0], path.duv[1] * size[1]];
        // This is far enough from the ends of `i64` that no step of the walk reaches them.
        let far = (1i64 << 60) as f64;
        let cell = [0, 1].map(|axis| (start[axis] + speed[axis] * from).floor().clamp(-far, far) as i64);
        Self { start, speed, h: path.h, cell, t: from, end: to, done: false }
    }

    /// Parameter at which the path leaves the current column (axis 0) or row (axis 1) of cells.
    fn crossing(&self, axis: usize) -> f64 {
        let line = if self.speed[axis] > 0.0 { self.cell[axis] + 1 } else { self.cell[axis] };
        if self.speed[axis] == 0.0 {
            return f64::INFINITY;
        }
        (line as f64 - self.start[axis]) / self.speed[axis]
    }

    /// Returns the next cell. The last one ends at the end of the path.
    fn next(&mut self) -> Option<Visit> {
        if self.done {
            return None;
        }
        let (x, y) = (self.crossing(0), self.crossing(1));
        let leave = x.min(y);
        let (cell, from) = (self.cell, self.t);
        if leave < self.end {
            let axis = usize::from(y < x);
            self.cell[axis] += if self.speed[axis] > 0.0 { 1 } else { -1 };
            self.t = leave.max(from);
        } else {
            self.t = self.end.max(from);
            self.done = true;
        }
        Some(Visit { cell, from, to: self.t })
    }

    /// Gap in a visited cell, counted from the path's entry into it.
    fn gap(&self, map: &HeightMap, visit: &Visit) -> Gap {
        let t = visit.from;
        let from = [0, 1].map(|axis| self.start[axis] + self.speed[axis] * t - visit.cell[axis] as f64);
        let [h0, h1, h2] = self.h;
        let h = [h0 + t * (h1 + t * h2), h1 + 2.0 * t * h2, h2];
        Gap::in_cell(map.cell(visit.cell[0], visit.cell[1]), from, self.speed, h)
    }
}
