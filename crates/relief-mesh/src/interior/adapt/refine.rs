//! Greedy insertion: the point farthest from its triangle comes next, until none is too far.
//!
//! Source: Garland and Heckbert 1995, Fast Polygonal Approximation of Terrains and Height Fields; here the
//! farthest point of the bilinear surface, not of the samples alone.

use std::collections::BinaryHeap;

use super::Wanted;
use super::delaunay::{Delaunay, Location, NONE};
use super::ground::{Corner, Gap, Ground};
use crate::Judge;

/// A triangulated patch.
#[derive(Clone, Debug)]
pub struct Refined<'a, G> {
    pub ground: &'a G,
    pub mesh: Delaunay,
    /// Heights of the points; each is a number of `f32`.
    pub heights: Vec<f64>,
    pub judge: Judge,
    /// How many points lie on the border. They are the first ones, and stay.
    border: usize,
    /// The worst of each triangle, with what it is bent by.
    worst: Vec<Gap>,
    /// The worst of each half-edge, with the points at its ends, as far as they are known.
    edges: Vec<([u32; 2], Gap)>,
    /// Triangles that are too far off by their worst: a number that grows with it, then the triangle's.
    queue: BinaryHeap<u64>,
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

    /// Takes one more distance, of a triangle that is bent.
    fn take_bent(&mut self, height: f64, bend: f64, place: impl Fn() -> [f64; 2]) {
        if height + bend > self.above.height {
            self.above = Gap { height: height + bend, place: place() };
        }
        if height - bend < self.below.height {
            self.below = Gap { height: height - bend, place: place() };
        }
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

impl<'a, G: Ground> Refined<'a, G> {
    /// The triangles that a patch begins with, and what its border's points make of them: the corners as the
    /// ground counts them, then the others in any order, with their heights.
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
            looked: Vec::new(),
        };
        for point in ground.outline().into_iter().filter(|&point| ground.is_inside(point)) {
            let at = refined.mesh.locate(point, near);
            refined.insert_at(point, at);
            near = refined.mesh.count() - 1;
        }
        refined
    }

    /// Inserts a point at a place where there is none. Whether there was none.
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

    /// The corners of a triangle.
    #[inline(always)]
    fn corners(&self, triangle: u32) -> [Corner; 3] {
        let [a, b, c] = self.mesh.triangle(triangle);
        [self.corner(a), self.corner(b), self.corner(c)]
    }

    /// Inserts points until no triangle is farther from the surface than `tolerance`, or none of those that
    /// are can be cut. None where there are more triangles than wanted by then, or where it is cancelled.
    pub fn refine(&mut self, tolerance: f64, wanted: &Wanted<'_>) -> Option<()> {
        self.look(tolerance);
        while let Some(queued) = self.queue.pop() {
            let triangle = queued as u32;
            let gap = self.worst[triangle as usize];
            if queue_key(gap, triangle) != queued {
                continue;
            }
            if self.mesh.count() > wanted.most || wanted.watch.is_cancelled() {
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
                // The border stays as it is, and where the surface is near by itself, too, smaller triangles
                // are bent less.
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

    /// The farthest distance along the edges of a triangle that lie on the border.
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
            self.ground.along(ends).worst()?
        };
        self.edges[edge as usize] = ([a, b], gap);
        self.edges[far as usize] = ([b, a], gap);
        Some(gap)
    }

    /// Inserts the lattice point nearest to a place of a triangle, of those that do away with the triangle.
    /// Whether there is one.
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

    /// What all triangles together show, worked out in `f64`.
    pub fn seen(&self) -> Seen {
        let ground = self.ground;
        let mut is_counted = vec![false; ground.centres()];
        let corner = self.mesh.points()[0];
        let level = Gap { height: 0.0, place: corner.map(f64::from) };
        let mut seen = Seen { above: level, below: level, ..Seen::NOTHING };
        for triangle in 0..self.mesh.count() {
            let corners = self.corners(triangle);
            if ground.is_left_out(corners) {
                continue;
            }
            let bend = ground.bend(corners);
            ground.each_centre(corners, |centre, gap, place| {
                // A centre on an edge is one of both triangles.
                if !std::mem::replace(&mut is_counted[centre], true) {
                    seen.sum += gap.abs();
                    seen.signed += gap;
                    seen.count += 1;
                }
                seen.take_bent(gap, bend, place);
            });
            if self.judge == Judge::Texels {
                continue;
            }
            for edge in 3 * triangle..3 * triangle + 3 {
                let [a, b] = self.mesh.ends(edge);
                // An edge is the same to both of its triangles, unless these are bent or left out.
                if bend > 0.0 || ground.has_holes() || self.mesh.opposite(edge) == NONE || a < b {
                    let gaps = ground.along([a, b].map(|point| self.corner(point)));
                    for gap in [gaps.above, gaps.below] {
                        seen.take_bent(gap.height, bend, || gap.place);
                    }
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

/// A number that grows with a gap, and then with a triangle's number, which it ends with.
fn queue_key(gap: Gap, triangle: u32) -> u64 {
    u64::from((gap.height.abs() as f32).to_bits()) << 32 | u64::from(triangle)
}
