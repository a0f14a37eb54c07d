//! Greedy insertion: the point farthest from its triangle comes next, until none is too far.
//!
//! Source: Garland and Heckbert 1995, Fast Polygonal Approximation of Terrains and Height Fields.
//! Here the farthest point of the bilinear surface counts, not of the samples alone.

use std::collections::BinaryHeap;

use super::FillRequest;
use super::delaunay::{Delaunay, Location, NONE};
use super::ground::{Corner, Gap, Ground};
use crate::Judge;

/// Triangulated patch.
#[derive(Clone, Debug)]
pub struct Refined<'a, G> {
    pub ground: &'a G,
    pub mesh: Delaunay,
    /// Heights of the points, each representable in `f32`.
    pub heights: Vec<f64>,
    pub judge: Judge,
    /// Number of points on the border. They come first and do not move.
    border: usize,
    /// Greatest distance of each triangle, including its bend.
    worst: Vec<Gap>,
    /// Greatest distance of each half-edge and the points at its ends, where known.
    edges: Vec<([u32; 2], Gap)>,
    /// Triangles that are too far off: a number that grows with the distance, then the triangle's
    /// number.
    queue: BinaryHeap<u64>,
    changed: Vec<u32>,
    /// Number of calls of `update`, and the last one that measured each triangle.
    turn: u32,
    updated: Vec<u32>,
}

/// Distances of the surface from triangles, exact in `f64`.
#[derive(Clone, Copy, Debug)]
pub struct Distances {
    /// Greatest distance of the surface above them.
    pub above: Gap,
    /// Greatest distance of the surface below them, less than 0.
    pub below: Gap,
    /// Sum of the absolute distances at the corners of cells.
    pub sum: f64,
    /// Sum of the signed distances at the corners of cells.
    pub signed: f64,
    /// Number of these corners.
    pub count: u64,
}

impl Distances {
    /// No distances.
    pub const NOTHING: Self = Self { above: LEVEL, below: LEVEL, sum: 0.0, signed: 0.0, count: 0 };

    /// Returns the greatest absolute distance.
    pub fn greatest(&self) -> f64 {
        self.above.height.max(-self.below.height)
    }

    /// Adds a distance of a bent triangle.
    fn take_bent(&mut self, height: f64, bend: f64, place: impl Fn() -> [f64; 2]) {
        if height + bend > self.above.height {
            self.above = Gap { height: height + bend, place: place() };
        }
        if height - bend < self.below.height {
            self.below = Gap { height: height - bend, place: place() };
        }
    }

    /// Adds a distance.
    fn take(&mut self, gap: Gap) {
        if gap.height > self.above.height {
            self.above = gap;
        }
        if gap.height < self.below.height {
            self.below = gap;
        }
    }

    /// Returns the distances of both.
    pub fn with(mut self, other: &Self) -> Self {
        self.take(other.above);
        self.take(other.below);
        self.sum += other.sum;
        self.signed += other.signed;
        self.count += other.count;
        self
    }
}

/// Distance of 0.
const LEVEL: Gap = Gap { height: 0.0, place: [0.0; 2] };

impl<'a, G: Ground> Refined<'a, G> {
    /// Creates the first triangles of a patch, with the points of its border. `border` begins with
    /// the corners in the ground's order. Other points follow in any order, all with their heights.
    pub fn new(ground: &'a G, judge: Judge, border: &[([i32; 2], f32)]) -> Self {
        let mut mesh = ground.first_triangles();
        let corners = mesh.points().len();
        let mut near = 0;
        for (point, _) in &border[corners..] {
            let at = mesh.locate(*point, near);
            mesh.insert(*point, at);
            near = mesh.count() - 1;
        }
        let mut refined = Self {
            ground,
            mesh,
            heights: border.iter().map(|(_, height)| f64::from(*height)).collect(),
            judge,
            border: border.len(),
            worst: Vec::new(),
            edges: Vec::new(),
            queue: BinaryHeap::new(),
            changed: Vec::new(),
            turn: 0,
            updated: Vec::new(),
        };
        for point in ground.outline().into_iter().filter(|&point| ground.is_inside(point)) {
            let at = refined.mesh.locate(point, near);
            refined.insert_at(point, at);
            near = refined.mesh.count() - 1;
        }
        refined
    }

    /// Inserts a point at its location, if there is none. Returns whether it did.
    fn insert_at(&mut self, point: [i32; 2], at: Location) -> bool {
        let is_new = !matches!(at, Location::Point(_));
        if is_new {
            self.mesh.insert(point, at);
            self.heights.push(f64::from(self.ground.height(point) as f32));
        }
        is_new
    }

    pub fn border(&self) -> usize {
        self.border
    }

    pub fn corner(&self, point: u32) -> Corner {
        (self.mesh.points()[point as usize], self.heights[point as usize])
    }

    /// Returns the corners of a triangle.
    #[inline(always)]
    fn corners(&self, triangle: u32) -> [Corner; 3] {
        let [a, b, c] = self.mesh.triangle(triangle);
        [self.corner(a), self.corner(b), self.corner(c)]
    }

    /// Inserts points until no triangle is farther from the surface than `tolerance`, or the
    /// farther ones cannot be divided. Returns `None` if there are then more triangles than wanted,
    /// or if cancelled.
    pub fn refine(&mut self, tolerance: f64, request: &FillRequest<'_>) -> Option<()> {
        self.update(tolerance);
        while let Some(queued) = self.queue.pop() {
            let triangle = queued as u32;
            let gap = self.worst[triangle as usize];
            if queue_key(gap, triangle) != queued {
                continue;
            }
            if self.mesh.count() > request.most || request.watch.is_cancelled() {
                return None;
            }
            if self.insert(triangle, gap.place) {
                self.update(tolerance);
            }
        }
        Some(())
    }

    /// Marks all triangles to be measured again, after heights were moved.
    pub fn moved(&mut self) {
        self.queue.clear();
        self.edges.fill(([NONE; 2], LEVEL));
        self.changed.extend(0..self.mesh.count());
    }

    /// Measures the changed triangles, and queues those that are too far off.
    fn update(&mut self, tolerance: f64) {
        let mut changed = std::mem::take(&mut self.changed);
        self.mesh.take_changed(&mut changed);
        self.turn += 1;
        let count = self.mesh.count() as usize;
        self.worst.resize(count, LEVEL);
        self.updated.resize(count, 0);
        self.edges.resize(3 * count, ([NONE; 2], LEVEL));
        for &triangle in &changed {
            if std::mem::replace(&mut self.updated[triangle as usize], self.turn) == self.turn {
                continue;
            }
            let corners = self.corners(triangle);
            if self.ground.is_left_out(corners) {
                self.worst[triangle as usize] = LEVEL;
                continue;
            }
            let mut worst = self.ground.worst_within(corners).unwrap_or(LEVEL);
            if self.judge == Judge::Surface {
                for edge in 3 * triangle..3 * triangle + 3 {
                    let gap = self.edge(edge).unwrap_or(LEVEL);
                    if gap.height.abs() > worst.height.abs() {
                        worst = gap;
                    }
                }
            }
            let bend = self.ground.bend(corners);
            if bend > 0.0 {
                // The border is fixed. Where the surface itself is near, smaller triangles are bent
                // less.
                let border = self.at_border(triangle);
                let is_bent = bend.max(border) > worst.height.abs();
                let place = if is_bent { self.ground.bend_place(corners) } else { worst.place };
                worst = Gap { height: worst.height.abs().max(border) + bend, place };
            }
            self.worst[triangle as usize] = worst;
            if worst.height.abs() > tolerance {
                self.queue.push(queue_key(worst, triangle));
            }
        }
        changed.clear();
        self.changed = changed;
    }

    /// Returns the farthest distance along the edges of a triangle that lie on the border.
    fn at_border(&self, triangle: u32) -> f64 {
        if self.judge == Judge::Texels {
            return 0.0;
        }
        let edges = (3 * triangle..3 * triangle + 3).filter(|edge| self.mesh.opposite(*edge) == NONE);
        let along = edges.filter_map(|edge| {
            let ends = self.mesh.ends(edge).map(|point| self.corner(point));
            self.ground.along(ends).worst()
        });
        along.map(|gap| gap.height.abs()).fold(0.0, f64::max)
    }

    /// Returns the farthest distance along an edge that two triangles share.
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
            self.ground.along(ends).worst()?
        };
        self.edges[edge as usize] = ([a, b], gap);
        self.edges[far as usize] = ([b, a], gap);
        Some(gap)
    }

    /// Inserts the lattice point nearest to `place` whose insertion removes the triangle. Returns
    /// whether there is one.
    fn insert(&mut self, triangle: u32, place: [f64; 2]) -> bool {
        let step = self.ground.step(self.judge);
        let nearest = [0, 1].map(|axis| (place[axis] / f64::from(step)).round() as i32 * step);
        for [x, y] in AROUND {
            let point = [nearest[0] + x * step, nearest[1] + y * step];
            if !self.ground.is_inside(point) || !self.mesh.is_in_circle_of(triangle, point) {
                continue;
            }
            let at = self.mesh.locate(point, triangle);
            if self.insert_at(point, at) {
                return true;
            }
        }
        false
    }

    /// Returns the distances of all triangles, computed in `f64`.
    pub fn distances(&self) -> Distances {
        let ground = self.ground;
        let mut is_counted = vec![false; ground.centres()];
        let corner = self.mesh.points()[0];
        let level = Gap { height: 0.0, place: corner.map(f64::from) };
        let mut distances = Distances { above: level, below: level, ..Distances::NOTHING };
        for triangle in 0..self.mesh.count() {
            let corners = self.corners(triangle);
            if ground.is_left_out(corners) {
                continue;
            }
            let bend = ground.bend(corners);
            ground.each_centre(corners, |centre, gap, place| {
                // A centre on an edge belongs to both triangles.
                if !std::mem::replace(&mut is_counted[centre], true) {
                    distances.sum += gap.abs();
                    distances.signed += gap;
                    distances.count += 1;
                }
                distances.take_bent(gap, bend, place);
            });
            if self.judge == Judge::Texels {
                continue;
            }
            for edge in 3 * triangle..3 * triangle + 3 {
                let [a, b] = self.mesh.ends(edge);
                // An edge is the same for both of its triangles, unless they are bent or left out.
                if bend > 0.0 || ground.has_holes() || self.mesh.opposite(edge) == NONE || a < b {
                    let gaps = ground.along([a, b].map(|point| self.corner(point)));
                    for gap in [gaps.above, gaps.below] {
                        distances.take_bent(gap.height, bend, || gap.place);
                    }
                }
            }
        }
        distances
    }
}

/// Steps from a lattice point to its neighbours, the nearest first.
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

/// Returns a number that grows with the distance, and then with the triangle's number, which it
/// ends with.
fn queue_key(gap: Gap, triangle: u32) -> u64 {
    u64::from((gap.height.abs() as f32).to_bits()) << 32 | u64::from(triangle)
}
