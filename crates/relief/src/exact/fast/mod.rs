//! The exact hit at rendering speed.
//!
//! The idea is to be fast where rounding can be made harmless, and exact where it cannot: the search through the
//! hierarchy runs in `f32`, sixteen nodes at a time, on nodes that are grown by more than the rounding error; the few
//! cells that are left are solved in `f64`, between the same limits that the cell walk would use.

mod hierarchy;
mod ray;
mod traverse;

use super::{ExactHit, MAX_TRAVEL, is_traceable, patch::Gap};
use crate::{HeightMap, Hit, Path, Wrap};
use hierarchy::{Domain, Hierarchy};
use ray::{Axis, Ray};
use traverse::CellHit;

/// An exact tracer that is fast: for view, bent and shadow rays of renderers.
///
/// # Guarantee
///
/// The answer is exact up to rounding in `f64`, like that of [`cell_walk`](super::cell_walk): at a hit the height
/// residual `|H(t) - f(u, v)|` is at most [`Self::ERROR`], no earlier point of the path is deeper than that below the
/// surface, and neither is any point of a path that is said to miss, for paths that stay within 4096 cells of the origin
/// (in proportion beyond). So the hit's `t` is off by at most `ERROR / |g'(t)|` to first order, and hit and miss can only be taken
/// for each other where the path's clearance or depth is below `ERROR`.
///
/// Where that comes from: every quantity of the `f32` search is a position relative to the cell where the ray
/// begins, or a height. Each position goes through at most six roundings of numbers no larger than twice the search
/// window of `m` cells, so it is wrong by less than `6 · 2m · 2⁻²⁴ < m 2⁻²⁰` cells; nodes are grown by that much on each side. Each height
/// goes through at most eight roundings of numbers no larger than 2, and nodes are raised by `2⁻²⁰`. So no node is passed
/// over that the path touches; a needless visit is all that rounding can cause. Cells are then solved in `f64` by the
/// formula of the cell walk, whose residual is a few units of `2⁻⁵³` times the number of cells from the origin.
///
/// # Cost
///
/// [`Self::new`] is one parallel pass over the map. The hierarchy owns its copy of the heights: 6.25 bytes a texel for tiles of 5 x 5 texels
/// (4 x 4 cells and their far edge) and 0.28 for the maxima of tiles and of 4 x 4 such nodes, level by level. Tracing does not allocate.
/// One read is one block of sixteen nodes or one cell.
#[derive(Clone, Debug)]
pub struct FastTracer {
    hierarchy: Hierarchy,
    size: [u32; 2],
    wrap: Wrap,
    /// The least and the greatest texel.
    lowest: f64,
    highest: f64,
}

impl FastTracer {
    /// The largest height residual of a hit, and depth of a point passed over, in heights: see the guarantee.
    pub const ERROR: f64 = 2e-12;

    /// Heights by which the range of heights is widened, so that rounding at its ends loses nothing.
    const MARGIN: f64 = 1.0 / (1 << 20) as f64;

    /// Builds the hierarchy of a map.
    pub fn new(map: &HeightMap) -> Self {
        let size = [map.width(), map.height()];
        let domain = match map.wrap() {
            Wrap::Repeat => Domain { cells: size.map(|side| side as usize), first: 0 },
            Wrap::Clamp | Wrap::Mirror => Domain { cells: size.map(|side| side as usize + 1), first: -1 },
        };
        let hierarchy = Hierarchy::new(map, domain);
        let lowest = map.texels().iter().copied().fold(1.0, f32::min);
        let highest = map.texels().iter().copied().fold(0.0, f32::max);
        Self { hierarchy, size, wrap: map.wrap(), lowest: f64::from(lowest), highest: f64::from(highest) }
    }

    /// The first hit of a path. Its clearance is 0 for every miss: it is not looked for.
    pub fn trace(&self, path: &Path) -> ExactHit {
        let mut reads = 0;
        match self.search(path, &mut reads) {
            Outcome::Hit { t, cell, gap, slope } => ExactHit::at(path, t, cell, gap, slope, reads),
            Outcome::Miss => ExactHit::miss(reads, 0.0),
            Outcome::GivenUp { t } => self.given_up(path, t, reads),
        }
    }

    /// Whether anything is in the way: whether [`Self::trace`] finds a hit. For shadow rays, which must begin off the
    /// surface by more than [`Self::ERROR`] so as not to hit where they begin. A path that is given up is not blocked.
    pub fn is_blocked(&self, path: &Path) -> bool {
        matches!(self.search(path, &mut 0), Outcome::Hit { .. })
    }

    fn search(&self, path: &Path, reads: &mut u32) -> Outcome {
        if !is_traceable(self.size, path) {
            return Outcome::Miss;
        }
        if path.h[0] < self.lowest {
            return self.search_piece(path, 0.0, 0.0, reads);
        }
        if path.h[2] == 0.0 {
            return match self.clip(path) {
                Some([t0, t1]) => self.search_piece(path, t0, t1, reads),
                None => Outcome::Miss,
            };
        }
        let turn = -path.h[1] / (2.0 * path.h[2]);
        for (after, from, to) in [(false, 0.0, turn.min(path.exit)), (true, turn.max(0.0), path.exit)] {
            if from <= to
                && let Some([t0, t1]) = self.clip_bent(path.h, after, from, to)
            {
                match self.search_piece(path, t0, t1, reads) {
                    Outcome::Miss => {}
                    found => return found,
                }
            }
        }
        Outcome::Miss
    }

    /// The part of a straight path between the map's lowest and highest texel.
    fn clip(&self, path: &Path) -> Option<[f64; 2]> {
        let [h0, h1, _] = path.h;
        if h0 > self.highest && h1 >= 0.0 {
            return None;
        }
        // For a level path these are infinite, with the sign that says on which side it is.
        let top = (self.highest + Self::MARGIN - h0) / h1;
        let bottom = (self.lowest - Self::MARGIN - h0) / h1;
        let from = top.min(bottom).max(0.0);
        let to = top.max(bottom).min(path.exit);
        (from <= to).then_some([from, to])
    }

    /// The part between the map's lowest and highest texel of a bent path before or after its turning point.
    fn clip_bent(&self, [h0, h1, h2]: [f64; 3], after: bool, from: f64, to: f64) -> Option<[f64; 2]> {
        let crossing = |level: f64| {
            let c0 = h0 - level;
            let disc = h1 * h1 - 4.0 * c0 * h2;
            if disc < 0.0 {
                return None;
            }
            let q = -0.5 * (h1 + disc.sqrt().copysign(h1));
            let (a, b) = (q / h2, if q == 0.0 { 0.0 } else { c0 / q });
            Some(if after { a.max(b) } else { a.min(b) })
        };
        let (top, bottom) = (crossing(self.highest + Self::MARGIN), crossing(self.lowest - Self::MARGIN));
        if top.is_none() && h2 > 0.0 {
            return None;
        }
        let falls = (h2 > 0.0) != after;
        let (first, last) = if falls { (top, bottom) } else { (None, top) };
        let from = first.map_or(from, |t| t.max(from));
        let to = last.map_or(to, |t| t.min(to));
        (from <= to).then_some([from, to])
    }

    /// Searches the tiles of the texture that a piece of a path goes through. Its height must be monotone.
    fn search_piece(&self, path: &Path, t0: f64, t1: f64, reads: &mut u32) -> Outcome {
        let size = self.size.map(f64::from);
        let place = [path.uv[0] * size[0] - 0.5, path.uv[1] * size[1] - 0.5];
        let speed = [path.duv[0] * size[0], path.duv[1] * size[1]];
        let travel = speed[0].abs().max(speed[1].abs());
        let mut end = t1;
        let mut given_up = false;
        if (t1 - t0) * travel > MAX_TRAVEL {
            end = t0 + MAX_TRAVEL / travel;
            given_up = true;
        } else if t1.is_infinite() {
            // Neither the place nor the height changes.
            end = t0;
        }
        let (ray, rate) = Ray::new(place, speed, path.h, t0, end);
        let mut axes = [0, 1].map(|k| Axis::at(self.wrap, self.size[k], ray.start[k]));
        let mut from = 0.0;
        loop {
            let leave = [0, 1].map(|k| axes[k].leave(ray.start[k], ray.step[k], ray.per_cell[k]));
            let first = leave[0].min(leave[1]);
            let to = first.min(ray.length).max(from);
            let part = ray.inside(&axes, from, to);
            if let Some(CellHit { s, gap, slope, cell }) = traverse::trace(&self.hierarchy, &part, reads) {
                let s = from + s;
                let cell = [0, 1].map(|k| axes[k].cell(cell[k], ray.start[k] + ray.step[k] * s));
                return Outcome::Hit { t: (t0 + s / rate).min(path.exit), cell, gap, slope: slope * rate };
            }
            if first >= ray.length {
                break;
            }
            let axis = usize::from(leave[1] < leave[0]);
            axes[axis].advance(ray.step[axis]);
            from = to;
        }
        if given_up { Outcome::GivenUp { t: end } } else { Outcome::Miss }
    }

    /// The last point of a path that was given up.
    fn given_up(&self, path: &Path, t: f64, reads: u32) -> ExactHit {
        let [u, v, h] = path.at(t);
        let place = [u * f64::from(self.size[0]) - 0.5, v * f64::from(self.size[1]) - 0.5];
        let still = Ray::new(place, [0.0; 2], [h, 0.0, 0.0], 0.0, 0.0).0;
        let axes = [0, 1].map(|k| Axis::at(self.wrap, self.size[k], place[k]));
        let local = still.inside(&axes, 0.0, 0.0).start;
        let cell = local.map(|place| place.max(0.0) as usize);
        let within = [local[0] - cell[0] as f64, local[1] - cell[1] as f64];
        let corners = self.hierarchy.corners(cell[0], cell[1]);
        let clearance = Gap::in_cell(corners, within, [0.0; 2], [h, 0.0, 0.0]).c[0];
        let hit = Hit { found: true, exhausted: true, uv: [u, v], height: h - clearance, t, reads };
        ExactHit { hit, cell: [0; 2], slope: 0.0, clearance }
    }
}

/// What a search ends with.
enum Outcome {
    Hit { t: f64, cell: [i64; 2], gap: f64, slope: f64 },
    Miss,
    GivenUp { t: f64 },
}
