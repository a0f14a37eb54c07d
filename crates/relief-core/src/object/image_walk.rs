//! The exact tracer for objects. The images are asked in turn where the ray is next in their
//! solids, until none moves it.
//!
//! Each image is walked cell by cell (2-D DDA, Amanatides and Woo 1987, with crossings computed
//! from the cell's number). Cells are solved in closed form. Cells below the ray are skipped by the
//! object's pyramid of maxima, several at once.

use glam::DVec3;

use super::patch::{Patch, Solid};
use super::{EMPTY_HEIGHT, ImageObject, ViewRay};
use crate::raycast::Ray;

/// A hit of a ray with an object.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ObjectHit {
    /// Parameter, in units of the ray's direction.
    pub t: f64,
    /// Image whose solid the ray enters at the hit, counted from 0. If it enters several, one of
    /// them; 0 if it begins inside all.
    pub view: usize,
    /// Texture coordinates and height of the hit in that image. The height is the ray's. It is
    /// below the map on walls between cells of different heights, and if the ray begins inside.
    pub at: DVec3,
    /// Number of cells and pyramid nodes that were read.
    pub reads: u32,
}

impl ImageObject {
    /// Returns the first point of the object on a ray, from its parameter 0 on, in `f64`. The
    /// parameter is 0 if the ray begins inside.
    ///
    /// An image's solid is extended along the ray by [`AGREEMENT`](super::AGREEMENT) times the
    /// lengths that determine rounding. These are the distances from the world's origin to the
    /// ray's origin and to the image's centre, and the image's radius. So thin sheets that images
    /// show from both sides are hit.
    ///
    /// A ray misses if it is not finite, or if its direction is shorter than 1e-90 m or longer than
    /// 1e90 m. It also misses if it begins more than [`MAX_DISTANCE`](super::MAX_DISTANCE) radii
    /// away from an image's ball.
    ///
    /// The cost is at most a step for each cell on the ray in each image: no image is walked twice.
    pub fn first_hit(&self, ray: &Ray) -> Option<ObjectHit> {
        self.enter(ray, Solid::Depth, 0..self.views.len())
    }

    /// First point of a ray in the solids of all the given images. There must be at least one.
    pub(super) fn enter(
        &self,
        ray: &Ray,
        solid: Solid,
        numbers: impl Iterator<Item = usize>,
    ) -> Option<ObjectHit> {
        let mut walks = Vec::new();
        let (mut t, mut entered, mut end) = (0.0, 0, f64::INFINITY);
        for number in numbers {
            let walk = Walk::new(self, number, ray, solid)?;
            let [from, to] = walk.range.map(|s| walk.seen.on_ray(s));
            if from > t {
                (t, entered) = (from, walks.len());
            }
            end = end.min(to + walk.slack);
            walks.push(walk);
        }
        // An image moves the ray only to the beginning of a piece of its solid, and reaches each
        // piece once. So this ends.
        let (mut agreed, mut turn) = (0, 0);
        while agreed < walks.len() {
            if t > end {
                return None;
            }
            let entry = walks[turn].entry(t)?;
            // Smaller moves are rounding where the ray goes from cell to cell. The other images
            // need not be asked again.
            if entry > t + walks[turn].slack {
                (entered, agreed) = (turn, 0);
            }
            t = entry;
            agreed += 1;
            turn = if turn + 1 == walks.len() { 0 } else { turn + 1 };
        }
        let walk = walks.get(entered)?;
        let reads = walks.iter().map(|walk| walk.reads).sum();
        Some(ObjectHit { t, view: walk.number, at: walk.seen.at(walk.seen.of_ray(t)), reads })
    }
}

/// A forward walk through the cells of one image.
struct Walk<'a> {
    object: &'a ImageObject,
    number: usize,
    solid: Solid,
    seen: ViewRay,
    /// Position in cells at `s = 0`, and its change.
    start: [f64; 2],
    speed: [f64; 2],
    /// Height that is compared with the map, and its change.
    lift: [f64; 2],
    /// Range in which the ray is in the image's space.
    range: [f64; 2],
    size: [i64; 2],
    place: [i64; 2],
    /// Current cell, and the range in which the ray is in it.
    cell: [i64; 2],
    from: f64,
    to: f64,
    /// Last parameter to which the walk jumped. It jumps there once, as rounding may give the
    /// previous cell.
    sought: f64,
    /// Level of the pyramid that is read next.
    level: usize,
    /// Pieces of the ray in the cell's solid, in its own parameter, and the number of the first
    /// piece that is not yet passed.
    pieces: [[f64; 2]; 3],
    count: usize,
    next: usize,
    slack: f64,
    reads: u32,
}

impl<'a> Walk<'a> {
    /// Begins a walk. `None` if the ray does not enter the image's space.
    fn new(object: &'a ImageObject, number: usize, ray: &Ray, solid: Solid) -> Option<Self> {
        let slack = object.slack(number, ray)?;
        let view = &object.views[number];
        let seen = view.ray_in_view(ray, 0.0)?;
        let size = view.size().map(f64::from);
        let start = [seen.origin.x * size[0] - 0.5, seen.origin.y * size[1] - 0.5];
        let speed = [seen.change.x * size[0], seen.change.y * size[1]];
        let mut range = [0.0, seen.of_ray(seen.range[1])];
        if range[1].is_nan() {
            range[1] = f64::INFINITY;
        }
        for axis in 0..2 {
            clip(&mut range, start[axis], speed[axis], [-1.0, size[axis]])?;
        }
        let top = match solid {
            Solid::Depth => object.tops[number],
            Solid::Silhouette => 1.0,
        };
        if top <= EMPTY_HEIGHT {
            return None;
        }
        clip(&mut range, -seen.origin.z, -seen.change.z, [-top, -EMPTY_HEIGHT])?;
        let lift = match solid {
            Solid::Depth => [seen.origin.z, seen.change.z],
            Solid::Silhouette => [0.5, 0.0],
        };
        let mut walk = Self {
            object,
            number,
            solid,
            seen,
            start,
            speed,
            lift,
            range,
            size: view.size().map(i64::from),
            place: object.layout.places()[number].map(i64::from),
            cell: [0; 2],
            from: range[0],
            to: range[0],
            sought: range[0],
            level: object.pyramid.levels() / 2,
            pieces: [[0.0; 2]; 3],
            count: 0,
            next: 0,
            slack,
            reads: 0,
        };
        walk.cell = [0, 1].map(|axis| walk.cell_at(axis, range[0], [-1, i64::MAX]));
        Some(walk)
    }

    /// Column (axis 0) or row (axis 1) of cells at `s`, clamped to a range and to the image.
    fn cell_at(&self, axis: usize, s: f64, [first, last]: [i64; 2]) -> i64 {
        let cell = (self.start[axis] + self.speed[axis] * s).floor() as i64;
        cell.max(first).min(last).clamp(-1, self.size[axis] - 1)
    }

    /// First parameter from `t` on at which the ray is in the solid, if any.
    fn entry(&mut self, t: f64) -> Option<f64> {
        loop {
            while self.next < self.count {
                let [from, to] = self.pieces[self.next];
                if to + self.slack >= t {
                    return Some(from.max(t));
                }
                self.next += 1;
            }
            if !self.advance(t) {
                return None;
            }
        }
    }

    /// Goes to the next cell in which the ray may be in the solid at `t` or later. Returns false at
    /// the end.
    fn advance(&mut self, t: f64) -> bool {
        let wanted = self.seen.of_ray(t - self.slack).min(self.range[1]);
        if wanted > self.to && wanted > self.sought {
            self.sought = wanted;
            self.cell = [0, 1].map(|axis| self.cell_at(axis, wanted, [-1, i64::MAX]));
            // The range begins where the ray enters the cell, so that its roots do not depend on
            // `t`.
            let enters = [0, 1].map(|axis| self.crossing(axis, [self.cell[axis] + 1, self.cell[axis]]));
            self.from = enters.into_iter().filter(|s| *s < wanted).fold(self.range[0], f64::max);
        }
        while self.from < self.range[1] && (0..2).all(|axis| (-1..self.size[axis]).contains(&self.cell[axis]))
        {
            let node = [0, 1].map(|axis| (self.place[axis] + self.cell[axis]) >> self.level);
            let lines = [0, 1].map(|axis| {
                let first = (node[axis] << self.level) - self.place[axis];
                [first, first + (1 << self.level)]
            });
            let leaves = [0, 1].map(|axis| self.crossing(axis, lines[axis]));
            let leave = leaves[0].min(leaves[1]).min(self.range[1]).max(self.from);
            let lowest = self.lift_at(self.from).min(self.lift_at(leave));
            let above = self.is_above(node, lowest);
            if !above && self.level > 0 {
                self.level -= 1;
                continue;
            }
            let (cell, from) = (self.cell, self.from);
            let axis = usize::from(leaves[1] < leaves[0]);
            self.cell[axis] =
                lines[axis][usize::from(self.speed[axis] > 0.0)] - i64::from(self.speed[axis] <= 0.0);
            let other = 1 - axis;
            self.cell[other] = self.cell_at(other, leave, [lines[other][0], lines[other][1] - 1]);
            (self.from, self.to) = (leave, leave);
            if above {
                self.level = (self.level + 1).min(self.object.pyramid.levels() - 1);
            } else if self.solve(cell, from, leave) {
                return true;
            }
        }
        false
    }

    /// Parameter at which the ray leaves the space between two lines, the one with the lower number
    /// first. With the lines exchanged, it is the parameter of entry.
    fn crossing(&self, axis: usize, lines: [i64; 2]) -> f64 {
        let speed = self.speed[axis];
        if speed == 0.0 {
            return f64::INFINITY;
        }
        (lines[usize::from(speed > 0.0)] as f64 - self.start[axis]) / speed
    }

    fn lift_at(&self, s: f64) -> f64 {
        self.lift[0] + self.lift[1] * s
    }

    /// Whether a height of at least `lowest` is above the map in all cells of a node.
    fn is_above(&mut self, node: [i64; 2], lowest: f64) -> bool {
        self.reads += 1;
        let [width, _] = self.object.pyramid.size(self.level).unwrap_or_default();
        let at = node[1] as usize * width as usize + node[0] as usize;
        let highest = self.object.pyramid.nodes(self.level).get(at).copied().unwrap_or(1.0);
        match self.solid {
            Solid::Depth => lowest > f64::from(highest),
            Solid::Silhouette => f64::from(highest) <= EMPTY_HEIGHT,
        }
    }

    /// Finds the pieces of the ray in a cell's solid. Returns false if there are none.
    fn solve(&mut self, cell: [i64; 2], from: f64, to: f64) -> bool {
        (self.count, self.next) = (0, 0);
        let length = to - from;
        if length <= 0.0 {
            return false;
        }
        self.reads += 1;
        let place = [0, 1].map(|axis| self.start[axis] + self.speed[axis] * from - cell[axis] as f64);
        let lift = [self.lift_at(from), self.lift[1]];
        match self.object.patch(self.number, cell, self.solid) {
            Patch::Flat(height) => self.keep(from, 0.0, length, [lift[0] - height, lift[1], 0.0]),
            Patch::Bilinear([h00, h10, h01, h11]) => {
                let (bx, by, d) = (h10 - h00, h01 - h00, (h00 - h10) + (h11 - h01));
                let ([u, v], [du, dv]) = (place, self.speed);
                let c0 = lift[0] - (h00 + bx * u + (by + d * u) * v);
                let c1 = lift[1] - ((bx + d * v) * du + (by + d * u) * dv);
                self.keep(from, 0.0, length, [c0, c1, -d * du * dv]);
            }
            Patch::Quarters(corners) => {
                let mut cuts = [0, 1].map(|axis| {
                    let cut = (0.5 - place[axis]) / self.speed[axis];
                    if cut > 0.0 && cut < length { cut } else { length }
                });
                cuts.sort_by(f64::total_cmp);
                let mut begin = 0.0;
                for end in [cuts[0], cuts[1], length] {
                    if begin < end {
                        let middle = 0.5 * (begin + end);
                        let [x, y] = [0, 1].map(|axis| place[axis] + self.speed[axis] * middle >= 0.5);
                        let height = corners[usize::from(x) + 2 * usize::from(y)];
                        self.keep(from, begin, end, [lift[0] - height, lift[1], 0.0]);
                        begin = end;
                    }
                }
            }
        }
        self.count > 0
    }

    /// Stores the pieces of `[begin, end]`, counted from `from`, in which a quadratic is at most 0.
    fn keep(&mut self, from: f64, begin: f64, end: f64, c: [f64; 3]) {
        for [p, q] in not_above(c) {
            let piece = [p.max(begin), q.min(end)];
            if piece[0] <= piece[1] {
                self.pieces[self.count] = piece.map(|tau| self.seen.on_ray(from + tau));
                self.count += 1;
            }
        }
    }
}

/// Limits a range to the part in which `start + speed s` is in `[low, high)`. Returns `None` if
/// nothing remains.
fn clip(range: &mut [f64; 2], start: f64, speed: f64, [low, high]: [f64; 2]) -> Option<()> {
    if speed == 0.0 {
        return (low <= start && start < high).then_some(());
    }
    let [a, b] = [(low - start) / speed, (high - start) / speed];
    *range = [range[0].max(a.min(b)), range[1].min(a.max(b))];
    (range[0] <= range[1]).then_some(())
}

/// Intervals in which `c[0] + c[1] τ + c[2] τ²` is at most 0: up to two, in ascending order. A
/// missing interval ends before it begins.
fn not_above([c0, c1, c2]: [f64; 3]) -> [[f64; 2]; 2] {
    const ALL: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];
    const NONE: [f64; 2] = [f64::INFINITY, f64::NEG_INFINITY];
    if c2 == 0.0 {
        let root = -c0 / c1;
        let only = match c1 {
            _ if c1 > 0.0 => [ALL[0], root],
            _ if c1 < 0.0 => [root, ALL[1]],
            _ if c0 <= 0.0 => ALL,
            _ => NONE,
        };
        return [only, NONE];
    }
    let discriminant = c1 * c1 - 4.0 * c0 * c2;
    if discriminant < 0.0 {
        return [if c2 < 0.0 { ALL } else { NONE }, NONE];
    }
    // For each root, the form whose terms do not cancel.
    let q = -0.5 * (c1 + discriminant.sqrt().copysign(c1));
    let (a, b) = (q / c2, if q == 0.0 { 0.0 } else { c0 / q });
    let [first, last] = [a.min(b), a.max(b)];
    if c2 > 0.0 { [[first, last], NONE] } else { [[ALL[0], first], [last, ALL[1]]] }
}

#[cfg(test)]
mod tests {
    use super::not_above;

    #[test]
    fn quadratics_are_not_above_where_they_are_not() {
        let quadratics = [
            [2.0, -3.0, 1.0],
            [-2.0, 3.0, -1.0],
            [1.0, 0.0, 1.0],
            [-1.0, 0.0, -1.0],
            [1.0, 2.0, 0.0],
            [1.0, -2.0, 0.0],
            [0.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
            [1.0, -2.0, 1.0],
            [0.0, 0.0, 1.0],
            [0.5, -1.0, 1e-14],
        ];
        for c in quadratics {
            let pieces = not_above(c);
            for step in -400..400 {
                let tau = f64::from(step) / 100.0;
                let value = c[0] + tau * (c[1] + tau * c[2]);
                let inside = pieces.iter().any(|[from, to]| *from <= tau && tau <= *to);
                assert!(inside == (value <= 0.0) || value.abs() < 1e-12, "{c:?} at {tau}: {pieces:?}");
            }
        }
    }
}
