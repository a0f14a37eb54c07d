//! Greedy insertion: the point farthest from its triangle comes next, until none is too far.
//!
//! Source: Garland and Heckbert 1995, Fast Polygonal Approximation of Terrains and Height Fields; here the
//! farthest point of the bilinear surface, not of the samples alone.

use std::collections::BinaryHeap;

use super::delaunay::{Delaunay, Location, NONE};
use super::judge::{Corner, Gap, along, rows, worst_within};
use super::window::{STEPS, Window};
use crate::Judge;

/// A triangulated tile.
#[derive(Clone, Debug)]
pub struct Refined<'a> {
    pub window: &'a Window,
    pub mesh: Delaunay,
    /// Heights of the points; each is a number of `f32`.
    pub heights: Vec<f64>,
    pub judge: Judge,
    /// How many points lie on the border. They are the first ones, and stay.
    border: usize,
    /// The worst of each triangle.
    worst: Vec<Gap>,
    /// The worst of each half-edge, with the points at its ends, as far as they are known.
    edges: Vec<([u32; 2], Gap)>,
    /// Triangles that are too far off by their worst, as a number that grows with it.
    queue: BinaryHeap<(u32, u32)>,
    changed: Vec<u32>,
    /// How often changed triangles were looked at, and the last time that each was.
    turn: u32,
    looked: Vec<u32>,
}

/// What triangles show, exact in `f64`.
#[derive(Clone, Copy, Debug)]
pub struct Seen {
    /// The farthest that the surface is above them.
    pub above: Gap,
    /// The farthest that it is below them, less than 0.
    pub below: Gap,
    /// The sum of the distances at the corners of cells.
    pub sum: f64,
    /// The sum of what the surface is above there, less what it is below.
    pub signed: f64,
    /// How many corners there are.
    pub count: u64,
}

impl Seen {
    /// Of nothing.
    pub const NOTHING: Self = Self { above: LEVEL, below: LEVEL, sum: 0.0, signed: 0.0, count: 0 };

    /// The farthest that the surface is from them.
    pub fn greatest(&self) -> f64 {
        self.above.height.max(-self.below.height)
    }

    /// Takes one more distance.
    fn take(&mut self, gap: Gap) {
        if gap.height > self.above.height {
            self.above = gap;
        }
        if gap.height < self.below.height {
            self.below = gap;
        }
    }

    /// What both show.
    pub fn with(mut self, other: &Self) -> Self {
        self.take(other.above);
        self.take(other.below);
        self.sum += other.sum;
        self.signed += other.signed;
        self.count += other.count;
        self
    }
}

/// No gap.
const LEVEL: Gap = Gap { height: 0.0, place: [0.0; 2] };

impl<'a> Refined<'a> {
    /// The two triangles of a tile, and what its border's points make of them: points in any order, with
    /// their heights, the four corners first, by rows.
    pub fn new(window: &'a Window, judge: Judge, border: &[([i32; 2], f32)]) -> Self {
        let mut mesh = Delaunay::new(window.from, window.to);
        let mut near = 0;
        for (point, _) in &border[4..] {
            let at = mesh.locate(*point, near);
            mesh.insert(*point, at);
            near = mesh.count() - 1;
        }
        Self {
            window,
            mesh,
            heights: border.iter().map(|(_, height)| f64::from(*height)).collect(),
            judge,
            border: border.len(),
            worst: Vec::new(),
            edges: Vec::new(),
            queue: BinaryHeap::new(),
            changed: Vec::new(),
            turn: 0,
            looked: Vec::new(),
        }
    }

    pub fn border(&self) -> usize {
        self.border
    }

    pub fn corner(&self, point: u32) -> Corner {
        (self.mesh.points()[point as usize], self.heights[point as usize])
    }

    /// Inserts points until no triangle is farther from the surface than `tolerance`, or none of those that
    /// are can be cut. None where there are more triangles than `most` by then.
    pub fn refine(&mut self, tolerance: f64, most: u32) -> Option<()> {
        self.look(tolerance);
        while let Some((key, triangle)) = self.queue.pop() {
            let gap = self.worst[triangle as usize];
            if key_of(gap) != key {
                continue;
            }
            if self.mesh.count() > most {
                return None;
            }
            if self.insert(triangle, gap.place) {
                self.look(tolerance);
            }
        }
        Some(())
    }

    /// Looks at all triangles anew, after heights were moved.
    pub fn moved(&mut self) {
        self.queue.clear();
        self.edges.fill(([NONE; 2], LEVEL));
        self.changed.extend(0..self.mesh.count());
    }

    /// Looks at the triangles that are new, and queues those that are too far off.
    fn look(&mut self, tolerance: f64) {
        let mut changed = std::mem::take(&mut self.changed);
        self.mesh.take_changed(&mut changed);
        self.turn += 1;
        let count = self.mesh.count() as usize;
        self.worst.resize(count, LEVEL);
        self.looked.resize(count, 0);
        self.edges.resize(3 * count, ([NONE; 2], LEVEL));
        for &triangle in &changed {
            if std::mem::replace(&mut self.looked[triangle as usize], self.turn) == self.turn {
                continue;
            }
            let corners = self.mesh.triangle(triangle).map(|point| self.corner(point));
            let mut worst = worst_within(self.window, corners).unwrap_or(LEVEL);
            if self.judge == Judge::Surface {
                for edge in 3 * triangle..3 * triangle + 3 {
                    let gap = self.edge(edge).unwrap_or(LEVEL);
                    if gap.height.abs() > worst.height.abs() {
                        worst = gap;
                    }
                }
            }
            self.worst[triangle as usize] = worst;
            if worst.height.abs() > tolerance {
                self.queue.push((key_of(worst), triangle));
            }
        }
        changed.clear();
        self.changed = changed;
    }

    /// The worst along an edge that two triangles share.
    fn edge(&mut self, edge: u32) -> Option<Gap> {
        let far = self.mesh.opposite(edge);
        if far == NONE {
            return None;
        }
        let [a, b] = self.mesh.ends(edge);
        let (known, there) = (self.edges[edge as usize], self.edges[far as usize]);
        let gap = if known.0 == [a, b] {
            known.1
        } else if there.0 == [b, a] {
            there.1
        } else {
            // From the same end for both sides.
            let ends = [a.min(b), a.max(b)].map(|point| self.corner(point));
            along(self.window, ends).worst()?
        };
        self.edges[edge as usize] = ([a, b], gap);
        self.edges[far as usize] = ([b, a], gap);
        Some(gap)
    }

    /// Inserts the lattice point nearest to a place of a triangle, of those that do away with the triangle.
    /// Whether there is one.
    fn insert(&mut self, triangle: u32, place: [f64; 2]) -> bool {
        let step = if self.judge == Judge::Texels { STEPS } else { 1 };
        let nearest = [0, 1].map(|axis| (place[axis] / f64::from(step)).round() as i32 * step);
        for [x, y] in AROUND {
            let point = [nearest[0] + x * step, nearest[1] + y * step];
            let is_inside =
                (0..2).all(|axis| point[axis] > self.window.from[axis] && point[axis] < self.window.to[axis]);
            if !is_inside || !self.mesh.is_in_circle_of(triangle, point) {
                continue;
            }
            let at = self.mesh.locate(point, triangle);
            if !matches!(at, Location::Point(_)) {
                self.mesh.insert(point, at);
                self.heights.push(f64::from(self.window.height(point) as f32));
                return true;
            }
        }
        false
    }

    /// What all triangles together show, worked out in `f64`.
    pub fn seen(&self) -> Seen {
        let to = self.window.to;
        let columns = (to[0] / STEPS + 1) as usize;
        let mut is_counted = vec![false; columns * (to[1] / STEPS + 1) as usize];
        let level = Gap { height: 0.0, place: self.window.from.map(f64::from) };
        let mut seen = Seen { above: level, below: level, ..Seen::NOTHING };
        for triangle in 0..self.mesh.count() {
            let corners = self.mesh.triangle(triangle).map(|point| self.corner(point));
            rows(self.window, corners, |row, heights| {
                let first = row.j as usize * columns + row.from as usize;
                for (k, (&height, is_counted)) in heights.iter().zip(&mut is_counted[first..]).enumerate() {
                    let gap = row.gap(k, height);
                    // A corner on an edge is one of both triangles.
                    if !std::mem::replace(is_counted, true) {
                        seen.sum += gap.abs();
                        seen.signed += gap;
                        seen.count += 1;
                    }
                    if gap > seen.above.height || gap < seen.below.height {
                        let place = [row.from + k as i32, row.j].map(|at| f64::from(at * STEPS));
                        seen.take(Gap { height: gap, place });
                    }
                }
            });
            if self.judge == Judge::Texels {
                continue;
            }
            for edge in 3 * triangle..3 * triangle + 3 {
                let [a, b] = self.mesh.ends(edge);
                if self.mesh.opposite(edge) == NONE || a < b {
                    let gaps = along(self.window, [a, b].map(|point| self.corner(point)));
                    seen.take(gaps.above);
                    seen.take(gaps.below);
                }
            }
        }
        seen
    }
}

/// Steps from a lattice point to those around it, the nearest first.
const AROUND: [[i32; 2]; 25] = {
    let mut all = [[0; 2]; 25];
    let (mut count, mut square) = (0, 0);
    while square <= 8 {
        let mut at = 0;
        while at < 25 {
            let [x, y] = [at % 5 - 2, at / 5 - 2];
            if x * x + y * y == square {
                all[count] = [x, y];
                count += 1;
            }
            at += 1;
        }
        square += 1;
    }
    all
};

/// A number that grows with a gap.
fn key_of(gap: Gap) -> u32 {
    (gap.height.abs() as f32).to_bits()
}
