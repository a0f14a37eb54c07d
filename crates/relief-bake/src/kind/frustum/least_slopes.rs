//! Least slopes of one quadrant, for the cells that growing squares have left.
//!
//! The search is a branch and bound over a maximum pyramid of texels, for a few cells side by side
//! at once. A node is skipped when its greatest height, at its least distance, is for none of them
//! steeper than the best so far. The texel that was steepest for the previous row is visited first;
//! it is mostly steepest again, or nearly.
//!
//! Aside of the diagonal the distance goes along one axis. The hull of a node's profile along it
//! then gives the steepest point of the node at once. Hulls and planes above nodes also show that a
//! node requires no more. On inclined ground everything ahead is equally steep, and heights alone
//! show nothing.

mod bounds;

use std::sync::atomic::{AtomicUsize, Ordering};

use pulp::{Simd, WithSimd};
use rayon::prelude::*;
use relief_core::{Cancelled, HeightMap, Watch};

use super::ahead::{self, Run};
use super::diagonal;
use super::growing_squares::SquareSlopes;
use super::rounding::{CAUTION, round_up};
use crate::fixed_point::floor;
use crate::texel_pyramid::TexelPyramid;
use crate::upper_hulls::UpperHulls;
use crate::upper_planes::UpperPlanes;

/// Cells that are searched at once. They share the walk through the pyramid and are compared
/// together. More of them would have fewer nodes in common.
const LANES: usize = 8;

/// Rows of a tile of cells that one thread processes: about a millisecond of work.
const ROWS: usize = 64;

/// Tiles that are computed before they are copied into place; at most this many are held twice.
const TILES: usize = 2048;

/// Factor that raises a slope where another point is as steep to within this factor. Otherwise, the
/// rounding of heights would decide which of many equally steep points is steepest, and all of them
/// would be visited.
const TIE: f64 = 1.0 + 1.0 / (1u64 << 16) as f64;

/// Nodes that a search visits before it tests hulls and planes; natural ground mostly takes fewer.
const PATIENCE: u32 = 64;

/// Returns the least slope of every cell in the quadrant that goes `forward` or not along each
/// axis. `tops` are the cells' tops, and `found` is the result of the squares.
pub fn least_slopes(
    map: &HeightMap,
    tops: &[f32],
    nodes: &Nodes,
    forward: [bool; 2],
    found: SquareSlopes,
    watch: &Watch,
) -> Result<Vec<f32>, Cancelled> {
    let (width, height) = (map.width() as usize, map.height() as usize);
    let SquareSlopes { mut slopes, patience } = found;
    let done = AtomicUsize::new(0);
    let across = width.div_ceil(LANES);
    let tiles = across * height.div_ceil(ROWS);
    for first in (0..tiles).step_by(TILES) {
        let tile = |tile: usize| {
            let (column, row) = (tile % across * LANES, tile / across * ROWS);
            let columns = [column, (column + LANES).min(width) - 1].map(|column| column as u32);
            let rows = [row, (row + ROWS).min(height) - 1].map(|row| row as u32);
            let mut search = Search::new(map, tops, nodes, (&slopes, &patience), forward, columns);
            // Wider vectors are of no use: eight cells are searched together.
            let found = relief_core::Lanes::Eight.run_up_to_eight(Rows { search: &mut search, rows });
            let done = done.fetch_add(1, Ordering::Relaxed) + 1;
            watch.at(done as f32 / tiles as f32).map(|()| (columns, rows, found))
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

/// Data of the squares of texels that a search visits.
pub struct Nodes<'a> {
    levels: TexelPyramid<'a>,
    planes: UpperPlanes,
    hulls: UpperHulls,
}

impl<'a> Nodes<'a> {
    /// Builds the nodes of a map.
    pub fn new(map: &'a HeightMap) -> Self {
        let (levels, planes, hulls) = (TexelPyramid::new(map), UpperPlanes::new(map), UpperHulls::new(map));
        Self { levels, planes, hulls }
    }
}

/// Rows of a tile, to be searched with the vectors of the machine.
struct Rows<'a, 'b> {
    search: &'b mut Search<'a>,
    rows: [u32; 2],
}

impl WithSimd for Rows<'_, '_> {
    type Output = Vec<[f32; LANES]>;

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) -> Self::Output {
        self.search.rows(self.rows)
    }
}

/// Node of the pyramid.
#[derive(Clone, Copy)]
struct Node {
    level: u32,
    at: [u32; 2],
    /// Lanes that may visit it.
    lanes: [bool; LANES],
}

/// Begin and end of a node along both axes, in texels ahead of the first lane, and its height.
#[derive(Clone, Copy)]
struct NodeExtent {
    near: [i64; 2],
    far: [i64; 2],
    highest: f32,
}

struct Search<'a> {
    map: &'a HeightMap,
    tops: &'a [f32],
    /// Slopes of all cells at the start. Cells without patience are searched.
    begun: &'a [f32],
    patience: &'a [u8],
    levels: &'a TexelPyramid<'a>,
    planes: &'a UpperPlanes,
    hulls: &'a UpperHulls,
    forward: [bool; 2],
    columns: [u32; 2],
    row: u32,
    /// Tops of the lanes' cells; infinite for lanes without a cell.
    top: [f32; LANES],
    /// Texels by which everything is farther ahead for a lane than for the first.
    shift: [f32; LANES],
    /// Steepest slope so far, and the same lowered for comparisons in `f32`.
    slope: [f64; LANES],
    cautious: [f32; LANES],
    /// Tops and slopes rounded down to multiples of one over [`GRID`](crate::fixed_point::GRID).
    fine_top: [f64; LANES],
    fine_slope: [f64; LANES],
    /// Whether a skipped point may be steeper, by no more than a [`TIE`].
    is_tied: [bool; LANES],
    /// Texels ahead to the steepest point.
    ahead: [[i64; 2]; LANES],
    /// Nodes yet to be visited.
    pending: Vec<Node>,
}

impl<'a> Search<'a> {
    fn new(
        map: &'a HeightMap,
        tops: &'a [f32],
        nodes: &'a Nodes<'a>,
        (begun, patience): (&'a [f32], &'a [u8]),
        forward: [bool; 2],
        columns: [u32; 2],
    ) -> Self {
        let shift = std::array::from_fn(|lane| if forward[0] { -(lane as f32) } else { lane as f32 });
        Self {
            map,
            tops,
            begun,
            patience,
            levels: &nodes.levels,
            planes: &nodes.planes,
            hulls: &nodes.hulls,
            forward,
            columns,
            row: 0,
            top: [0.0; LANES],
            shift,
            slope: [0.0; LANES],
            cautious: [0.0; LANES],
            fine_top: [0.0; LANES],
            fine_slope: [0.0; LANES],
            is_tied: [false; LANES],
            ahead: [[0; 2]; LANES],
            pending: Vec::new(),
        }
    }

    /// Returns the least slopes of all lanes in those rows.
    #[inline(always)]
    fn rows(&mut self, [first, last]: [u32; 2]) -> Vec<[f32; LANES]> {
        let mut found = vec![[0.0; LANES]; (last - first) as usize + 1];
        // Rows go from far to near, so that the steepest point of one row is ahead of the next.
        for at in 0..found.len() {
            let row = if self.forward[1] { found.len() - 1 - at } else { at };
            self.row = first + row as u32;
            found[row] = self.least_slopes();
        }
        found
    }

    #[inline(always)]
    fn least_slopes(&mut self) -> [f32; LANES] {
        let start = self.row as usize * self.map.width() as usize;
        let cells = start + self.columns[0] as usize..=start + self.columns[1] as usize;
        let (tops, patience) = (&self.tops[cells.clone()], &self.patience[cells.clone()]);
        let mut found = [0.0; LANES];
        found[..tops.len()].copy_from_slice(&self.begun[cells]);
        if !patience.contains(&0) {
            return found;
        }
        self.top = [f32::INFINITY; LANES];
        self.slope = [0.0; LANES];
        self.cautious = [0.0; LANES];
        self.fine_slope = [0.0; LANES];
        self.is_tied = [false; LANES];
        for lane in (0..tops.len()).filter(|lane| patience[*lane] == 0) {
            self.top[lane] = tops[lane];
            let [u, v] = self.ahead[lane];
            self.offer(lane, f64::from(found[lane]), [u, v + 1]);
            self.visit(lane, [u, v + 1]);
        }
        self.fine_top = self.top.map(|top| floor(f64::from(top)));
        let (size, wrap) = ([self.map.width(), self.map.height()], self.map.wrap());
        let columns = ahead::runs(wrap, size[0], self.columns, self.forward[0]);
        let rows = ahead::runs(wrap, size[1], [self.row; 2], self.forward[1]);
        for along_v in rows.into_iter().flatten() {
            for along_u in columns.into_iter().flatten() {
                self.search(&[along_u, along_v]);
            }
        }
        for (lane, found) in found.iter_mut().enumerate().take(tops.len()) {
            if self.is_tied[lane] {
                *found = round_up(self.slope[lane] * TIE);
            } else if self.slope[lane] > f64::from(*found) {
                *found = round_up(self.slope[lane]);
            }
        }
        found
    }

    /// Returns the height of a texel `u` and `v` texels ahead of a lane's cell, above its top.
    #[inline(always)]
    fn rise(&self, lane: usize, [u, v]: [i64; 2]) -> f64 {
        let column = ahead::texel(self.columns[0] + lane as u32, self.forward[0], u);
        let row = ahead::texel(self.row, self.forward[1], v);
        f64::from(self.map.texel(column, row)) - f64::from(self.top[lane])
    }

    /// Offers a lane the slopes that a texel ahead requires, and the diagonal cell with the texel
    /// as a corner.
    #[inline(never)]
    fn visit(&mut self, lane: usize, ahead: [i64; 2]) {
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

    #[inline(always)]
    fn offer(&mut self, lane: usize, slope: f64, ahead: [i64; 2]) {
        if slope > self.slope[lane] {
            self.slope[lane] = slope;
            self.cautious[lane] = slope as f32 * CAUTION;
            self.fine_slope[lane] = floor(slope);
            self.ahead[lane] = ahead;
        }
    }

    /// Visits the texels of a product of runs.
    #[inline(always)]
    fn search(&mut self, runs: &[Run; 2]) {
        let mut pending = std::mem::take(&mut self.pending);
        pending.push(Node { level: self.levels.top(), at: [0, 0], lanes: [true; LANES] });
        let mut visited = 0;
        while let Some(node) = pending.pop() {
            let Some(extent) = self.extent_if_steeper(runs, node) else { continue };
            let mut lanes = node.lanes;
            visited += 1;
            if visited > PATIENCE && !self.may_be_steeper(runs, node, &extent, &mut lanes) {
                continue;
            }
            if node.level == 0 {
                self.visit_texel(&extent, &lanes);
                continue;
            }
            let level = node.level - 1;
            let [columns, rows] = self.levels.level(level).size();
            let order = |axis: usize, is_near_first: bool| {
                let first = 2 * node.at[axis];
                if runs[axis].rising == is_near_first { [first, first + 1] } else { [first + 1, first] }
            };
            if level == 0 {
                for row in order(1, true) {
                    for column in order(0, true) {
                        let child = Node { level, at: [column, row], lanes };
                        if let Some(extent) = self.extent(runs, child) {
                            self.visit_texel(&extent, &lanes);
                        }
                    }
                }
                continue;
            }
            // The last one pushed is visited first: it should be the nearest.
            for row in order(1, false) {
                for column in order(0, false) {
                    let child = Node { level, at: [column, row], lanes };
                    if column < columns && row < rows && self.extent_if_steeper(runs, child).is_some() {
                        pending.push(child);
                    }
                }
            }
        }
        self.pending = pending;
    }

    /// Returns the extent of a node's texels that are in the runs; `None` without any.
    #[inline(always)]
    fn extent(&self, runs: &[Run; 2], node: Node) -> Option<NodeExtent> {
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
        Some(NodeExtent { near, far, highest: level.highest(node.at) })
    }

    /// Returns a node's extent, if any lane must visit it.
    #[inline(always)]
    fn extent_if_steeper(&self, runs: &[Run; 2], node: Node) -> Option<NodeExtent> {
        let extent = self.extent(runs, node)?;
        let is_steeper = self.excess(&extent).iter().fold(false, |any, excess| any | (*excess > 0.0));
        is_steeper.then_some(extent)
    }

    /// Visits a texel for the lanes for which it may be steeper than their best.
    #[inline(always)]
    fn visit_texel(&mut self, extent: &NodeExtent, lanes: &[bool; LANES]) {
        let excess = self.excess(extent);
        for lane in (0..LANES).filter(|lane| lanes[*lane] && excess[*lane] > 0.0) {
            self.visit(lane, [extent.near[0] + self.shift[lane] as i64, extent.near[1]]);
        }
    }
}
