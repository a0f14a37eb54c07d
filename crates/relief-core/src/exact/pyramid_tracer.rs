//! A second exact tracer, which finds the same hits as the cell walk by other means.
//!
//! It does not step from cell to cell. The path is halved until a piece is above the
//! [`MaxPyramid`]'s bound of its cells, or crosses at most two columns and two rows. Inside one
//! cell the gap is quadratic. Its first root is isolated by the signs of Bernstein coefficients
//! (Lane and Riesenfeld 1981, "Bounds on a polynomial"). Bracketing then refines it: the Illinois
//! method (Dowell and Jarratt 1971), with bisection for safety.

use super::{CELL_BYTES, ExactHit, MAX_TRAVEL, is_traceable};
use crate::{Cost, HeightMap, MaxPyramid, Path};

/// An exact tracer in `f64` that shares neither traversal nor root finding with
/// [`cell_walk`](super::cell_walk).
///
/// The guarantee is the same. A read is a pyramid node or a cell; a step is a piece of the path or
/// a cell. The clearance is a lower bound that can be loose, because pieces above a bound count
/// with that bound.
#[derive(Clone, Debug)]
pub struct PyramidTracer<'a> {
    map: &'a HeightMap,
    pyramid: MaxPyramid,
}

/// Bytes of a node of the pyramid.
const NODE_BYTES: u32 = 4;

/// Limit of the halvings of a piece: no interval of `f64` can be halved more often before its ends
/// meet.
const MAX_HALVINGS: u32 = 2100;

/// Height above which pieces of a path are halved first.
const TALLEST: f64 = 1e300;

impl<'a> PyramidTracer<'a> {
    /// Builds the pyramid of a map.
    pub fn new(map: &'a HeightMap) -> Self {
        Self { map, pyramid: MaxPyramid::new(map) }
    }

    /// Returns the first hit of a path.
    pub fn trace(&self, path: &Path) -> ExactHit {
        if !is_traceable([self.map.width(), self.map.height()], path) {
            return ExactHit::miss(Cost::default(), 0.0);
        }
        let highest = f64::from(self.pyramid.highest());
        let mut trace = Trace { tracer: self, path, clearance: f64::INFINITY, cost: Cost::default() };
        let travel = trace.speed(0).max(trace.speed(1));
        let limit = MAX_TRAVEL / travel;
        // Pieces double in length, beginning with about one tile, so that an endless path is
        // searched from its start.
        let mut from = 0.0;
        let mut length = f64::from(self.map.width().max(self.map.height())) / travel;
        if !(length.is_finite() && length > 0.0) {
            length = 1.0;
        }
        loop {
            let to = path.exit.min(from + length).min(limit.max(from));
            if let Some(hit) = trace.search(from, to, MAX_HALVINGS) {
                return hit;
            }
            if to == path.exit {
                return ExactHit::miss(trace.cost, trace.clearance.max(0.0));
            }
            let [height, rising] = trace.height_and_rise(to);
            if height > highest && rising >= 0.0 && path.h[2] >= 0.0 {
                return ExactHit::miss(trace.cost, trace.clearance.min(height - highest).max(0.0));
            }
            let unchanging = travel == 0.0 && path.h[1] == 0.0 && path.h[2] == 0.0;
            if unchanging {
                return ExactHit::miss(trace.cost, trace.clearance.max(0.0));
            }
            if to >= limit {
                let rest = trace.least_height(to, path.exit) - highest;
                if rest <= 0.0 {
                    return ExactHit::given_up(self.map, path, to, trace.cost);
                }
                return ExactHit::miss(trace.cost, trace.clearance.min(rest).max(0.0));
            }
            from = to;
            length *= 2.0;
        }
    }
}

/// State of tracing one path.
struct Trace<'a> {
    tracer: &'a PyramidTracer<'a>,
    path: &'a Path,
    clearance: f64,
    cost: Cost,
}

impl Trace<'_> {
    fn side(&self, axis: usize) -> f64 {
        f64::from([self.tracer.map.width(), self.tracer.map.height()][axis])
    }

    /// Cells per unit of `t`, without sign.
    fn speed(&self, axis: usize) -> f64 {
        (self.path.duv[axis] * self.side(axis)).abs()
    }

    /// Position along one axis in cells.
    fn place(&self, axis: usize, t: f64) -> f64 {
        (self.path.uv[axis] + self.path.duv[axis] * t) * self.side(axis) - 0.5
    }

    fn height_and_rise(&self, t: f64) -> [f64; 2] {
        let [h0, h1, h2] = self.path.h;
        [h0 + t * (h1 + t * h2), h1 + 2.0 * t * h2]
    }

    /// Least height of the path over `[a, b]`; `b` may be infinite.
    fn least_height(&self, a: f64, b: f64) -> f64 {
        let [start, falling] = self.height_and_rise(a);
        if b.is_infinite() && (self.path.h[2] < 0.0 || (self.path.h[2] == 0.0 && falling < 0.0)) {
            return f64::NEG_INFINITY;
        }
        let [end, rising] = if b.is_infinite() { [start, 1.0] } else { self.height_and_rise(b) };
        if falling < 0.0 && rising > 0.0 {
            return self.height_and_rise(-self.path.h[1] / (2.0 * self.path.h[2]))[0].min(start).min(end);
        }
        start.min(end)
    }

    /// Returns the first hit with `t` in `[a, b]`.
    fn search(&mut self, a: f64, b: f64, halvings: u32) -> Option<ExactHit> {
        let far = (1i64 << 60) as f64;
        let cells = [0, 1].map(|axis| {
            let ends = [self.place(axis, a), self.place(axis, b)];
            ends.map(|place| place.floor().clamp(-far, far) as i64)
        });
        let first = cells.map(|[p, q]| p.min(q));
        let last = cells.map(|[p, q]| p.max(q));
        let (bound, reads) = self.tracer.pyramid.bound(first, last);
        self.cost.step(reads, NODE_BYTES * reads);
        let above = self.least_height(a, b) - f64::from(bound);
        if above > 0.0 {
            self.clearance = self.clearance.min(above);
            return None;
        }
        let middle = a + 0.5 * (b - a);
        // The solver of a patch adds and doubles heights. They must not overflow.
        let tame = self.height_and_rise(b)[0].abs() < TALLEST;
        let narrow = tame && (0..2).all(|axis| last[axis] - first[axis] <= 1);
        if narrow || halvings == 0 || !(a < middle && middle < b) {
            return self.search_cells(a, b, first, last);
        }
        self.search(a, middle, halvings - 1).or_else(|| self.search(middle, b, halvings - 1))
    }

    /// Returns the first hit with `t` in `[a, b]`, where the path crosses at most one line between
    /// columns and one between rows.
    fn search_cells(&mut self, a: f64, b: f64, first: [i64; 2], last: [i64; 2]) -> Option<ExactHit> {
        let mut cuts = [b, b];
        for (axis, cut) in cuts.iter_mut().enumerate() {
            if first[axis] != last[axis] {
                let line = (last[axis] as f64 + 0.5) / self.side(axis);
                *cut = ((line - self.path.uv[axis]) / self.path.duv[axis]).max(a).min(b);
            }
        }
        let [one, two] = [cuts[0].min(cuts[1]), cuts[0].max(cuts[1])];
        let mut from = a;
        for to in [one, two, b] {
            if to > from || (a == b && to == b) {
                let middle = from + 0.5 * (to - from);
                let cell = [0, 1]
                    .map(|axis| (self.place(axis, middle).floor() as i64).clamp(first[axis], last[axis]));
                if let Some(hit) = self.search_patch(from, to, cell) {
                    return Some(hit);
                }
            }
            from = to.max(from);
        }
        None
    }

    /// Returns the first hit with `t` in `[a, b]` inside one cell.
    fn search_patch(&mut self, a: f64, b: f64, cell: [i64; 2]) -> Option<ExactHit> {
        self.cost.step(1, CELL_BYTES);
        let corners = self.tracer.map.cell(cell[0], cell[1]).map(f64::from);
        let (tracer, path) = (self.tracer, self.path);
        let gap = |t: f64| Self { tracer, path, clearance: 0.0, cost: Cost::default() }.gap(corners, cell, t);
        let (start, middle, end) = (gap(a), gap(a + 0.5 * (b - a)), gap(b));
        let control = 2.0 * middle - 0.5 * (start + end);
        let mut least = f64::INFINITY;
        let root = first_bracket([start, control, end], a, b, &mut least).map(|[p, q]| close_in(gap, p, q));
        self.clearance = self.clearance.min(least);
        let t = root?;
        let depth = if t > 0.0 { 0.0 } else { gap(t).min(0.0) };
        let slope = self.slope_at(corners, cell, t);
        Some(ExactHit::at(self.path, t, cell, depth, slope, self.cost))
    }

    /// Height of the path above the patch, blended from the corners.
    fn gap(&self, [h00, h10, h01, h11]: [f64; 4], cell: [i64; 2], t: f64) -> f64 {
        let [u, v] = [0, 1].map(|axis| self.place(axis, t) - cell[axis] as f64);
        let [height, _] = self.height_and_rise(t);
        height - ((1.0 - v) * ((1.0 - u) * h00 + u * h10) + v * ((1.0 - u) * h01 + u * h11))
    }

    /// Derivative of the gap.
    fn slope_at(&self, [h00, h10, h01, h11]: [f64; 4], cell: [i64; 2], t: f64) -> f64 {
        let [u, v] = [0, 1].map(|axis| self.place(axis, t) - cell[axis] as f64);
        let along_u = (1.0 - v) * (h10 - h00) + v * (h11 - h01);
        let along_v = (1.0 - u) * (h01 - h00) + u * (h11 - h10);
        let [_, rise] = self.height_and_rise(t);
        let [du, dv] = [0, 1].map(|axis| self.path.duv[axis] * self.side(axis));
        rise - (along_u * du + along_v * dv)
    }
}

/// First piece of `[a, b]` over which a quadratic with these Bernstein coefficients falls from
/// above 0 to 0 or below. It is `[a, a]` if the quadratic is not above 0 at `a`. Without such a
/// piece, `least` is lowered to the least value known to be reached.
fn first_bracket([start, control, end]: [f64; 3], a: f64, b: f64, least: &mut f64) -> Option<[f64; 2]> {
    if start <= 0.0 {
        return Some([a, a]);
    }
    let middle = a + 0.5 * (b - a);
    let divisible = a < middle && middle < b;
    // If the values turn before the end they may rise above 0 again, and rounding at the end could
    // hide the dip.
    if end <= 0.0 && (control >= end || !divisible) {
        return Some([a, b]);
    }
    if (control > 0.0 && end > 0.0) || !divisible {
        // The values lie in the hull of the coefficients.
        *least = least.min(start).min(end).min(control.max(0.0));
        return None;
    }
    let (left, right) = (0.5 * (start + control), 0.5 * (control + end));
    let value = 0.5 * (left + right);
    first_bracket([start, left, value], a, middle, least)
        .or_else(|| first_bracket([value, right, end], middle, b, least))
}

/// Parameter in `[above, below]` at which the gap falls to 0. The gap is positive at `above` and
/// not at `below`.
fn close_in(gap: impl Fn(f64) -> f64, above: f64, below: f64) -> f64 {
    let (mut p, mut q) = (above, below);
    let (mut gap_p, mut gap_q) = (gap(p), gap(q));
    if gap_p <= 0.0 {
        return p;
    }
    if gap_q > 0.0 {
        // Rounding: the bracket follows from the coefficients, which show the root at its very end.
        return q;
    }
    let mut last_moved_p = None;
    for round in 0.. {
        let middle = p + 0.5 * (q - p);
        if !(p < middle && middle < q) {
            break;
        }
        let chord = p + (q - p) * (gap_p / (gap_p - gap_q));
        let t = if round % 3 == 2 || !(p < chord && chord < q) { middle } else { chord };
        let value = gap(t);
        if value > 0.0 {
            (p, gap_p) = (t, value);
            if last_moved_p == Some(true) {
                gap_q *= 0.5;
            }
            last_moved_p = Some(true);
        } else {
            (q, gap_q) = (t, value);
            if last_moved_p == Some(false) {
                gap_p *= 0.5;
            }
            last_moved_p = Some(false);
        }
    }
    q
}
