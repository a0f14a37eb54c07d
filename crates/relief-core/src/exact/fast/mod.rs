//! Exact first hits at rendering speed.
//!
//! The search through the hierarchy of maxima runs in `f32`, sixteen nodes at a time. Its nodes are
//! grown by more than the rounding error, so that rounding is harmless. The one or two remaining
//! cells of a path are solved in `f64`.
//!
//! The hierarchy follows Tevs, Ihrke and Seidel 2008, over dual cells, with sixteen branches
//! instead of four. A block is then four vectors, and all its nodes are tested against the ray
//! without a branch.

mod hierarchy;
mod line;
mod packet;
mod ray;
mod traverse;

use super::{ExactHit, MAX_TRAVEL, is_traceable, patch::Gap};
use crate::{Cost, HeightMap, Hit, Path, Wrap};
use hierarchy::{Domain, Hierarchy};
pub use packet::{HitPacket, PathPacket};
use ray::{Axis, TileRay, greater, lesser};
use traverse::CellHit;

/// A fast exact tracer for the view, bent and shadow rays of renderers.
///
/// # Guarantee
///
/// The answer is exact up to rounding in `f64`, as with [`cell_walk`](super::cell_walk). Let `e` be
/// [`Self::ERROR`]. For paths within 4096 cells of the texture's origin (in proportion beyond):
///
/// * at a hit `|H(t) - f(u, v)| <= e`, unless the path begins below the surface,
/// * no point before the hit, or on a path that misses, is deeper than `e` below the surface.
///
/// So the error of `t` is at most `e / |g'(t)|` to first order. A hit and a miss can be confused
/// only if the least gap of the path is within `e` of 0.
///
/// Proof: the search runs in `f32`, but its nodes are grown and raised by more than the rounding of
/// positions and heights. So it visits every node that the path touches; rounding can only cause
/// needless visits. The remaining cells are solved in `f64` by the formula of the cell walk,
/// between limits that neighbouring cells compute alike. What remains is the rounding of a position
/// in cells: `2⁻⁵³` times its distance from the origin. The surface rises by at most 1 per cell.
///
/// # Cost
///
/// [`Self::new`] is one parallel pass over the map. The tracer owns its data, 6.8 bytes per texel.
/// These are tiles of 5 x 5 heights for 4 x 4 cells, each read as one piece, and maxima of tiles
/// and of 4 x 4 such nodes, level by level. Tracing does not allocate. A step is one read: a block
/// of sixteen nodes (64 bytes), the texels of a tile (100 bytes) or a cell (16 bytes).
#[derive(Clone, Debug)]
pub struct FastTracer {
    hierarchy: Hierarchy,
    sides: [u32; 2],
    wrap: Wrap,
    /// Position where tile 0 begins, in cells.
    first_edge: f64,
    /// Cells of the domain before the map's cell 0.
    extra: f64,
    /// Least and greatest texel.
    lowest: f64,
    highest: f64,
}

impl FastTracer {
    /// Largest height residual of a hit, and largest depth of a missed point, in heights: see the
    /// guarantee.
    pub const ERROR: f64 = 2e-12;

    /// Heights by which the range of heights is widened, so that rounding at its ends loses
    /// nothing.
    const MARGIN: f64 = 1.0 / (1 << 20) as f64;

    /// Builds the hierarchy of a map.
    pub fn new(map: &HeightMap) -> Self {
        let sides = [map.width(), map.height()];
        let extra = usize::from(map.wrap() != Wrap::Repeat);
        let cells = sides.map(|side| side as usize + extra);
        let hierarchy = Hierarchy::new(map, Domain { cells, first: -(extra as i64) });
        let lowest = map.texels().iter().copied().fold(1.0, f32::min);
        let highest = map.texels().iter().copied().fold(0.0, f32::max);
        Self {
            hierarchy,
            sides,
            wrap: map.wrap(),
            first_edge: Axis::first_edge(map.wrap()),
            extra: extra as f64,
            lowest: f64::from(lowest),
            highest: f64::from(highest),
        }
    }

    /// Returns the first hit of a path. The clearance of a miss is always 0, as it is not computed.
    pub fn trace(&self, path: &Path) -> ExactHit {
        let mut cost = Cost::default();
        let outcome = self.search(path, &mut cost);
        self.answer(path, outcome, cost)
    }

    #[inline(always)]
    fn answer(&self, path: &Path, outcome: Outcome, cost: Cost) -> ExactHit {
        match outcome {
            Outcome::Hit { t, column, row, gap, slope } => {
                ExactHit::at(path, t, [column, row], gap, slope, cost)
            }
            Outcome::Miss => ExactHit::miss(cost, 0.0),
            Outcome::GivenUp { t } => self.given_up(path, t, cost),
        }
    }

    /// Whether [`Self::trace`] finds a hit, for shadow rays. Shadow rays must begin off the surface
    /// by more than [`Self::ERROR`], in heights of the map, so that they do not hit at their start. A
    /// path that is given up is not blocked.
    pub fn is_blocked(&self, path: &Path) -> bool {
        matches!(self.search(path, &mut Cost::default()), Outcome::Hit { .. })
    }

    #[inline(always)]
    fn search(&self, path: &Path, cost: &mut Cost) -> Outcome {
        if !is_traceable(self.sides, path) {
            return Outcome::Miss;
        }
        if path.h[2] != 0.0 {
            return self.search_bent(path, cost);
        }
        let [h0, h1, _] = path.h;
        if h0 > self.highest && h1 >= 0.0 {
            return Outcome::Miss;
        }
        // The part between the map's lowest and highest texel. For a level path both ends are
        // infinite, with opposite signs.
        let per_height = 1.0 / h1;
        let top = (self.highest + Self::MARGIN - h0) * per_height;
        let bottom = (self.lowest - Self::MARGIN - h0) * per_height;
        let mut from = greater(lesser(top, bottom), 0.0);
        let mut to = lesser(greater(top, bottom), path.exit);
        if h0 < self.lowest {
            (from, to) = (0.0, 0.0);
        }
        if from > to || from == f64::INFINITY {
            return Outcome::Miss;
        }
        self.search_piece(path, from, to, cost)
    }

    #[inline(never)]
    fn search_bent(&self, path: &Path, cost: &mut Cost) -> Outcome {
        if path.h[0] < self.lowest {
            return self.search_piece(path, 0.0, 0.0, cost);
        }
        let turn = -path.h[1] / (2.0 * path.h[2]);
        for (after, from, to) in [(false, 0.0, turn.min(path.exit)), (true, turn.max(0.0), path.exit)] {
            if from <= to
                && let Some([from, to]) = self.clip_bent(path.h, after, from, to)
            {
                match self.search_piece(path, from, to, cost) {
                    Outcome::Miss => {}
                    found => return found,
                }
            }
        }
        Outcome::Miss
    }

    /// Part between the map's lowest and highest texel of a bent path before or after its turning
    /// point.
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
        (from <= to && from.is_finite()).then_some([from, to])
    }

    /// Searches a piece of a path over which the height is monotone.
    #[inline(always)]
    fn search_piece(&self, path: &Path, t0: f64, t1: f64, cost: &mut Cost) -> Outcome {
        let [w, h] = [f64::from(self.sides[0]), f64::from(self.sides[1])];
        let place = [path.uv[0] * w - 0.5, path.uv[1] * h - 0.5];
        let speed = [path.duv[0] * w, path.duv[1] * h];
        let travel = greater(speed[0].abs(), speed[1].abs());
        let is_short = (t1 - t0) * travel <= MAX_TRAVEL && t1 < f64::INFINITY;
        if !is_short {
            return self.search_long(path, [place, speed], t0, t1, cost);
        }
        let (mut ray, unit) = TileRay::new(place, speed, path.h, t0, t1);
        // The rays of a renderer mostly stay in one tile.
        let begin = ray.start;
        let end = ray.place_at(ray.length);
        let tile_x = self.common_tile(begin[0], end[0], w);
        let tile_y = self.common_tile(begin[1], end[1], h);
        let (Some(tile_x), Some(tile_y)) = (tile_x, tile_y) else {
            return self.search_tiles(path, &ray, [t0, unit], cost);
        };
        let shift = [self.extra - tile_x * w, self.extra - tile_y * h];
        ray.start = [begin[0] + shift[0], begin[1] + shift[1]];
        self.search_tile(path, &ray, shift, [t0, unit], cost)
    }

    /// Searches the tile that holds the whole ray. `s` is `t - origin` in units of `unit`;
    /// positions are moved by `shift`.
    #[inline(always)]
    fn search_tile(
        &self,
        path: &Path,
        ray: &TileRay,
        shift: [f64; 2],
        [origin, unit]: [f64; 2],
        cost: &mut Cost,
    ) -> Outcome {
        match traverse::trace(&self.hierarchy, ray, cost) {
            None => Outcome::Miss,
            Some(CellHit { s, gap, slope, cell }) => {
                let [column, row] =
                    [i64::from(cell[0]) - shift[0] as i64, i64::from(cell[1]) - shift[1] as i64];
                let t = lesser(origin + s * unit, path.exit);
                Outcome::Hit { t, column, row, gap, slope: slope / unit }
            }
        }
    }

    /// Tile that holds two positions on an axis of `side` texels, if one does and its texels are
    /// not mirrored.
    #[inline(always)]
    fn common_tile(&self, a: f64, b: f64, side: f64) -> Option<f64> {
        let (low, high) = (lesser(a, b) - self.first_edge, greater(a, b) - self.first_edge);
        if low >= 0.0 && high <= side {
            return Some(0.0);
        }
        let tile = (low / side).floor();
        (self.wrap == Wrap::Repeat && high <= (tile + 1.0) * side).then_some(tile)
    }

    /// Searches a piece that is endless or longer than [`MAX_TRAVEL`].
    #[inline(never)]
    fn search_long(
        &self,
        path: &Path,
        [place, speed]: [[f64; 2]; 2],
        t0: f64,
        t1: f64,
        cost: &mut Cost,
    ) -> Outcome {
        let travel = speed[0].abs().max(speed[1].abs());
        // An endless path whose position does not change has nothing beyond its start.
        let end = if travel > 0.0 { t0 + MAX_TRAVEL / travel } else { t0 };
        let (ray, unit) = TileRay::new(place, speed, path.h, t0, end);
        match self.search_tiles(path, &ray, [t0, unit], cost) {
            Outcome::Miss if travel > 0.0 && path.at(end)[2].min(path.at(t1)[2]) <= self.highest => {
                Outcome::GivenUp { t: end }
            }
            found => found,
        }
    }

    /// Searches the tiles of the texture along a ray, one after the other. `s` is `t - origin` in
    /// units of `unit`.
    #[inline(never)]
    fn search_tiles(&self, path: &Path, ray: &TileRay, [origin, unit]: [f64; 2], cost: &mut Cost) -> Outcome {
        let mut axes = [0, 1].map(|k| Axis::at(self.wrap, self.sides[k], ray.start[k]));
        let mut from = 0.0;
        loop {
            let leave = [0, 1].map(|k| axes[k].leave(ray.start[k], ray.step[k], ray.per_cell[k]));
            let first = leave[0].min(leave[1]);
            let to = first.min(ray.length).max(from);
            let part = ray.inside(&axes, from, to);
            if let Some(CellHit { s, gap, slope, cell }) = traverse::trace(&self.hierarchy, &part, cost) {
                let place = ray.place_at(from + s);
                let [column, row] = [0, 1].map(|k| axes[k].cell(i64::from(cell[k]), place[k]));
                let t = (origin + (from + s) * unit).min(path.exit);
                return Outcome::Hit { t, column, row, gap, slope: slope / unit };
            }
            let goes_on = first < ray.length;
            if !goes_on {
                return Outcome::Miss;
            }
            let axis = usize::from(leave[1] < leave[0]);
            axes[axis].advance(ray.step[axis]);
            from = to;
        }
    }

    /// Last point of a path that was given up.
    #[cold]
    fn given_up(&self, path: &Path, t: f64, cost: Cost) -> ExactHit {
        let [u, v, h] = path.at(t);
        let place = [u * f64::from(self.sides[0]) - 0.5, v * f64::from(self.sides[1]) - 0.5];
        let (still, _) = TileRay::new(place, [0.0; 2], [h, 0.0, 0.0], 0.0, 0.0);
        let axes = [0, 1].map(|k| Axis::at(self.wrap, self.sides[k], place[k]));
        let local = still.inside(&axes, 0.0, 0.0).start;
        let cell = local.map(|place| place.max(0.0) as u32);
        let within = [local[0] - f64::from(cell[0]), local[1] - f64::from(cell[1])];
        let gap = Gap::in_cell(self.hierarchy.corners(cell), within, [0.0; 2], [h, 0.0, 0.0]);
        let clearance = gap.c[0];
        let hit = Hit { found: true, exhausted: true, uv: [u, v], height: h - clearance, t, cost };
        ExactHit { hit, cell: [0; 2], slope: 0.0, clearance }
    }
}

/// Result of a search.
enum Outcome {
    Hit { t: f64, column: i64, row: i64, gap: f64, slope: f64 },
    Miss,
    GivenUp { t: f64 },
}
