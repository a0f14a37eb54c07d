//! The least slopes of one quadrant.
//!
//! A branch and bound over a maximum pyramid of texels, for a few cells side by side at once. A node is
//! passed over when its greatest height, at its least distance, is for none of them steeper than the best so
//! far. What was steepest for the row before is looked at first; it is mostly steepest again, or nearly.
//!
//! On inclined ground all that is ahead is equally steep, and no node is passed over so. There a plane above
//! the node tells that nothing of it asks for more.

use std::sync::atomic::{AtomicUsize, Ordering};

use rayon::prelude::*;
use relief_core::HeightMap;

use super::ahead::{self, Run};
use super::diagonal;
use crate::texel_pyramid::TexelPyramid;
use crate::upper_planes::{EXACT, UpperPlane, UpperPlanes, floor};
use crate::{Cancelled, Progress};

/// How many cells are searched for at once. They share the walk through the pyramid and are compared
/// together; more of them would have fewer nodes in common.
const LANES: usize = 8;

/// Rows of a tile of cells that one thread works through: about a millisecond of work.
const ROWS: usize = 64;

/// Tiles that are worked on before they are put in place; at most so many values are held twice.
const TILES: usize = 2048;

/// What raises a slope in `f64` by more than the roundings of a difference and a quotient have lowered it.
const RAISE: f64 = 1.0 + 1.0 / (1u64 << 50) as f64;

/// Lowers slopes, so that in `f32`, with three roundings of 2⁻²⁴, no node that matters is passed over.
const CAUTION: f32 = 1.0 - 1.0 / (1u32 << 20) as f32;

/// Nodes that a search looks into before it asks for planes: natural ground mostly takes fewer.
const PATIENCE: u32 = 256;

/// No slope is steeper: heights differ by 1 at most, and the nearest that counts is half a texel away.
const STEEPEST: f32 = 2.0;

/// The least slope of every cell, with those tops, in the quadrant that goes `forward` or not along each
/// axis.
pub fn least_slopes(
    map: &HeightMap,
    tops: &[f32],
    levels: &TexelPyramid,
    planes: &UpperPlanes,
    forward: [bool; 2],
    progress: &Progress,
) -> Result<Vec<f32>, Cancelled> {
    let (width, height) = (map.width() as usize, map.height() as usize);
    let mut slopes = vec![0.0; width * height];
    let done = AtomicUsize::new(0);
    let across = width.div_ceil(LANES);
    let tiles = across * height.div_ceil(ROWS);
    for first in (0..tiles).step_by(TILES) {
        let tile = |tile: usize| {
            let (column, row) = (tile % across * LANES, tile / across * ROWS);
            let columns = [column, (column + LANES).min(width) - 1].map(|column| column as u32);
            let rows = [row, (row + ROWS).min(height) - 1].map(|row| row as u32);
            let mut search = Search::new(map, tops, (levels, planes), forward, columns);
            let found = search.rows(rows);
            let done = done.fetch_add(1, Ordering::Relaxed) + 1;
            progress.at(done as f32 / tiles as f32).map(|()| (columns, rows, found))
        };
        let found: Vec<_> =
            (first..(first + TILES).min(tiles)).into_par_iter().map(tile).collect::<Result<_, _>>()?;
        for ([left, right], [top, _], found) in found {
            for (row, lanes) in found.iter().enumerate() {
                let start = (top as usize + row) * width;
                let lanes = &lanes[..(right - left) as usize + 1];
                slopes[start + left as usize..=start + right as usize].copy_from_slice(lanes);
            }
        }
    }
    Ok(slopes)
}

/// A node of the pyramid.
#[derive(Clone, Copy)]
struct Node {
    level: u32,
    at: [u32; 2],
    /// The lanes that may look into it.
    lanes: [bool; LANES],
}

/// How many texels ahead of the first lane a node begins and ends, along both axes, and its height.
#[derive(Clone, Copy)]
struct Sight {
    near: [i64; 2],
    far: [i64; 2],
    highest: f32,
}

struct Search<'a> {
    map: &'a HeightMap,
    tops: &'a [f32],
    levels: &'a TexelPyramid<'a>,
    planes: &'a UpperPlanes,
    forward: [bool; 2],
    columns: [u32; 2],
    row: u32,
    /// The tops of the lanes' cells; infinite for lanes without a cell.
    top: [f32; LANES],
    /// How much farther ahead everything is for a lane than for the first.
    shift: [f32; LANES],
    /// The steepest so far, and lowered for comparisons in `f32`.
    slope: [f64; LANES],
    cautious: [f32; LANES],
    /// Tops and slopes rounded down to multiples of one over [`GRID`](crate::upper_planes::GRID).
    fine_top: [f64; LANES],
    fine_slope: [f64; LANES],
    /// How many texels ahead it is.
    ahead: [[i64; 2]; LANES],
    /// Nodes still to be looked at.
    pending: Vec<Node>,
}

impl<'a> Search<'a> {
    fn new(
        map: &'a HeightMap,
        tops: &'a [f32],
        (levels, planes): (&'a TexelPyramid<'a>, &'a UpperPlanes),
        forward: [bool; 2],
        columns: [u32; 2],
    ) -> Self {
        let shift = std::array::from_fn(|lane| if forward[0] { -(lane as f32) } else { lane as f32 });
        Self {
            map,
            tops,
            levels,
            planes,
            forward,
            columns,
            row: 0,
            top: [0.0; LANES],
            shift,
            slope: [0.0; LANES],
            cautious: [0.0; LANES],
            fine_top: [0.0; LANES],
            fine_slope: [0.0; LANES],
            ahead: [[0; 2]; LANES],
            pending: Vec::new(),
        }
    }

    /// The least slopes of all lanes in those rows.
    fn rows(&mut self, [first, last]: [u32; 2]) -> Vec<[f32; LANES]> {
        let mut found = vec![[0.0; LANES]; (last - first) as usize + 1];
        // From far to near, so that what is steepest for one row is ahead of the next.
        for at in 0..found.len() {
            let row = if self.forward[1] { found.len() - 1 - at } else { at };
            self.row = first + row as u32;
            found[row] = self.least_slopes();
        }
        found
    }

    fn least_slopes(&mut self) -> [f32; LANES] {
        let start = self.row as usize * self.map.width() as usize;
        let tops = &self.tops[start + self.columns[0] as usize..=start + self.columns[1] as usize];
        self.top = [f32::INFINITY; LANES];
        self.top[..tops.len()].copy_from_slice(tops);
        self.slope = [0.0; LANES];
        self.cautious = [0.0; LANES];
        self.fine_top = self.top.map(|top| floor(f64::from(top)));
        self.fine_slope = [0.0; LANES];
        for lane in 0..tops.len() {
            let [u, v] = self.ahead[lane];
            self.look(lane, [u, v + 1]);
        }
        let (size, wrap) = ([self.map.width(), self.map.height()], self.map.wrap());
        let columns = ahead::runs(wrap, size[0], self.columns, self.forward[0]);
        let rows = ahead::runs(wrap, size[1], [self.row; 2], self.forward[1]);
        for along_v in rows.into_iter().flatten() {
            for along_u in columns.into_iter().flatten() {
                self.search(&[along_u, along_v]);
            }
        }
        self.slope.map(round_up)
    }

    /// The height of a texel so many ahead of a lane's cell, above its top.
    fn rise(&self, lane: usize, [u, v]: [i64; 2]) -> f64 {
        let column = ahead::texel(self.columns[0] + lane as u32, self.forward[0], u);
        let row = ahead::texel(self.row, self.forward[1], v);
        f64::from(self.map.texel(column, row)) - f64::from(self.top[lane])
    }

    /// Offers a lane what a texel ahead asks for, and the diagonal cell that it is a corner of.
    fn look(&mut self, lane: usize, ahead: [i64; 2]) {
        let [u, v] = ahead;
        let distance = u.max(v) - 1;
        if u < 0 || distance < 1 {
            return;
        }
        self.offer(lane, self.rise(lane, ahead) / distance as f64, ahead);
        let k = u.min(v);
        if (u - v).abs() == 1 && k >= 1 {
            let mean = 0.5 * (self.rise(lane, [k + 1, k]) + self.rise(lane, [k, k + 1]));
            if mean > self.slope[lane] * (k as f64 - 0.5) {
                let (near, far) = (self.rise(lane, [k, k]), self.rise(lane, [k + 1, k + 1]));
                self.offer(lane, diagonal::slope(k, near, mean, far), ahead);
            }
        }
    }

    #[inline]
    fn offer(&mut self, lane: usize, slope: f64, ahead: [i64; 2]) {
        if slope > self.slope[lane] {
            self.slope[lane] = slope;
            self.cautious[lane] = slope as f32 * CAUTION;
            self.fine_slope[lane] = floor(slope);
            self.ahead[lane] = ahead;
        }
    }

    /// Looks at the texels of a product of runs.
    fn search(&mut self, runs: &[Run; 2]) {
        let mut pending = std::mem::take(&mut self.pending);
        pending.push(Node { level: self.levels.top(), at: [0, 0], lanes: [true; LANES] });
        let mut looked_into = 0;
        while let Some(node) = pending.pop() {
            let Some(sight) = self.worth(runs, node) else { continue };
            let mut lanes = node.lanes;
            looked_into += 1;
            if looked_into > PATIENCE
                && let Some(plane) = self.planes.plane(node.level, node.at)
            {
                let above = self.above_plane(runs, node, plane, &sight);
                lanes = std::array::from_fn(|lane| lanes[lane] & above[lane]);
                if lanes == [false; LANES] {
                    continue;
                }
            }
            if node.level == 0 {
                let excess = self.excess(&sight);
                for lane in (0..LANES).filter(|lane| lanes[*lane] && excess[*lane] > 0.0) {
                    self.look(lane, [sight.near[0] + self.shift[lane] as i64, sight.near[1]]);
                }
                continue;
            }
            let level = node.level - 1;
            let [columns, rows] = self.levels.level(level).size();
            // The last one pushed is looked at first: that is to be the nearest.
            let order = |axis: usize| {
                let first = 2 * node.at[axis];
                if runs[axis].rising { [first + 1, first] } else { [first, first + 1] }
            };
            for row in order(1) {
                for column in order(0) {
                    let child = Node { level, at: [column, row], lanes };
                    if column < columns && row < rows && self.worth(runs, child).is_some() {
                        pending.push(child);
                    }
                }
            }
        }
        self.pending = pending;
    }

    /// Where the texels of a node that are in the runs are; `None` without any.
    #[inline]
    fn sight(&self, runs: &[Run; 2], node: Node) -> Option<Sight> {
        let (mut near, mut far) = ([0; 2], [0; 2]);
        for axis in 0..2 {
            let first = (node.at[axis] << node.level).max(runs[axis].first);
            let last = (((node.at[axis] + 1) << node.level) - 1).min(runs[axis].last);
            if first > last {
                return None;
            }
            let (a, b) = (runs[axis].ahead(first), runs[axis].ahead(last));
            (near[axis], far[axis]) = (a.min(b), a.max(b));
        }
        let level = self.levels.level(node.level);
        Some(Sight { near, far, highest: level.highest(node.at) })
    }

    /// How much higher a node is than it must be to be steeper than each lane's best: positive where it may
    /// be.
    #[inline]
    fn excess(&self, sight: &Sight) -> [f32; LANES] {
        let [near_u, near_v] = sight.near.map(|ahead| ahead as i32 as f32);
        let [far_u, far_v] = sight.far.map(|ahead| ahead as i32 as f32);
        let mut excess = [0.0; LANES];
        let lanes = self.shift.iter().zip(&self.top).zip(&self.cautious);
        for (excess, ((shift, top), cautious)) in excess.iter_mut().zip(lanes) {
            let (near, far) = (near_u + shift, far_u + shift);
            // What is beside the diagonal counts in a diagonal cell too, from half a texel nearer.
            let beside = (near <= far_v + 1.0) & (near_v <= far + 1.0);
            let farther = if near > near_v { near } else { near_v };
            let distance = farther - if beside { 1.5 } else { 1.0 };
            let distance = if distance > 0.0 { distance } else { 0.0 };
            *excess = (sight.highest - top) - cautious * distance;
        }
        excess
    }

    /// The lanes in which a node may ask for more than the best by the plane above it.
    ///
    /// Over the cells around the node's texels the surface is below the plane, and so below the frustum where
    /// the plane is. The plane less the slope times `max(u, v)` is linear on either side of the diagonal, so
    /// it is greatest at a corner of the box of these cells or where the diagonal crosses the box's rim. All
    /// numbers are multiples of one over [`GRID`](crate::upper_planes::GRID), with top and slope rounded down
    /// to such, and nothing is rounded: a tie is told from a rise by a last bit.
    #[inline]
    fn above_plane(&self, runs: &[Run; 2], node: Node, plane: &UpperPlane, sight: &Sight) -> [bool; LANES] {
        let mut along = plane.along.map(f64::from);
        let mut zero = plane.height;
        let mut most = plane.height.abs() + 2.0;
        let (mut from, mut to) = ([0.0; 2], [0.0; 2]);
        for axis in 0..2 {
            along[axis] = if runs[axis].rising { along[axis] } else { -along[axis] };
            let first = runs[axis].ahead(node.at[axis] << node.level) as f64;
            (from[axis], to[axis]) = (sight.near[axis] as f64 - 1.0, sight.far[axis] as f64 + 1.0);
            zero -= along[axis] * first;
            most += along[axis].abs() * (first.abs() + from[axis].abs().max(to[axis].abs()) + LANES as f64);
        }
        let mut above = [true; LANES];
        let lanes = self.shift.iter().zip(&self.fine_slope).zip(&self.fine_top);
        for (above, ((shift, &slope), &top)) in above.iter_mut().zip(lanes) {
            let shift = f64::from(*shift);
            let (left, right) = (from[0] + shift, to[0] + shift);
            let over = |u: f64, v: f64| along[0] * (u - shift) + along[1] * v - slope * greater(u, v);
            let near = greater(over(left, from[1]), over(right, from[1]));
            let far = greater(over(left, to[1]), over(right, to[1]));
            let (enter, leave) = (greater(left, from[1]), -greater(-right, -to[1]));
            let diagonal = greater(over(enter, enter), over(leave, leave));
            let diagonal = if enter <= leave { diagonal } else { f64::NEG_INFINITY };
            let highest = greater(greater(near, far), diagonal);
            let is_exact = most + slope * greater(right.abs(), to[1].abs()) < EXACT;
            *above = !(is_exact & (zero + highest + slope <= top));
        }
        above
    }

    /// Where a node is, if any lane must look into it.
    #[inline]
    fn worth(&self, runs: &[Run; 2], node: Node) -> Option<Sight> {
        let sight = self.sight(runs, node)?;
        let worth = self.excess(&sight).iter().fold(false, |worth, excess| worth | (*excess > 0.0));
        worth.then_some(sight)
    }
}

/// The greater one, in the form that compiles to one instruction.
#[inline(always)]
fn greater(x: f64, y: f64) -> f64 {
    if x > y { x } else { y }
}

/// The least `f32` that is surely not below the slope whose rounded value is given.
fn round_up(slope: f64) -> f32 {
    let raised = slope * RAISE;
    let nearest = raised as f32;
    if f64::from(nearest) < raised { nearest.next_up().min(STEEPEST) } else { nearest }
}
