//! Descent from the hierarchy's window around the rays of a packet to the first cell that each ray
//! hits.

use super::cell::{CellHits, Rays};
use super::setup::HalfRays;
use super::vector::{Double, Single, Vector};
use crate::exact::CELL_BYTES;
use crate::exact::fast::hierarchy::{BLOCK, Hierarchy, MaximaLevel};
use crate::exact::fast::line::{GROWTH, MOST_PER_HEIGHT, RAISE};
use crate::exact::fast::traverse::{BLOCK_BYTES, MAX_LEVELS, TILE_BYTES, edge, size};

/// Nodes of a block or cells of a tile.
const NODES: usize = BLOCK * BLOCK;

/// Columns and rows of the largest window from which rays descend together.
pub(super) const MOST_NODES: usize = 8;

/// Rays in `f32`: see `Line`.
pub(super) struct Singles<V: Vector> {
    pub origin: [Single<V>; 2],
    pub per_cell: [Single<V>; 2],
    pub before: [Single<V>; 2],
    pub height: Single<V>,
    pub per_height: Single<V>,
    pub length: Single<V>,
    /// Distance in cells along the longer axis.
    pub travel: Single<V>,
}

/// Rays that descend together. They go in similar directions, all fall or all rise, and begin at
/// the same level.
pub(super) struct Group<V: Vector> {
    /// Lanes as bits.
    pub lanes: u32,
    pub level: usize,
    /// Direction of travel: the `i`-th column, or row, that the rays enter in a block has number
    /// `i ^ flip`.
    pub flip: [usize; 2],
    /// First and last column and row of nodes that the rays visit.
    pub window: [[u32; 2]; 2],
    /// First column and row of each ray's own window.
    pub corner: [Single<V>; 2],
}

/// State of the search of one group.
pub(super) struct Search<'a, V: Vector, const FALLS: bool> {
    v: V,
    hierarchy: &'a Hierarchy,
    rays: &'a Rays<V>,
    singles: &'a Singles<V>,
    group: &'a Group<V>,
    /// Growth of nodes in `s`.
    slack: [Single<V>; 2],
    /// Rays without a hit yet.
    alive: u32,
    hits: &'a mut CellHits<V>,
}

/// The 4 x 4 nodes of a block, and the lanes that test them.
struct Nodes<'a> {
    maxima: &'a [f32; NODES],
    /// Exclusive-or mask that turns the order of travel into node numbers.
    flip: usize,
    lanes: u32,
}

/// Touched nodes of a block: a bit for each, in the order in which rays enter them, and the lanes
/// that touch them.
#[derive(Clone, Copy)]
struct Touched {
    nodes: u32,
    by: [u16; NODES],
}

/// A block and its remaining nodes.
#[derive(Clone, Copy)]
struct Remaining {
    corner: [u32; 2],
    touched: Touched,
}

/// Remaining nodes of the blocks above the current one, level by level. It is created once for many
/// packets. Clearing it for each search would take some hundredths of the time.
pub(super) struct Stack([Remaining; MAX_LEVELS]);

impl Stack {
    pub fn new() -> Self {
        Self([Remaining { corner: [0; 2], touched: Touched { nodes: 0, by: [0; NODES] } }; MAX_LEVELS])
    }
}

impl<V: Vector> Singles<V> {
    #[inline(always)]
    pub fn new(v: V, rays: &Rays<V>) -> Self {
        let [low, high] = rays;
        let (origin_x, within_x) = cell_and_rest(low.start[0], high.start[0]);
        let (origin_y, within_y) = cell_and_rest(low.start[1], high.start[1]);
        let per_cell_x = Single::narrow([low.per_cell[0], high.per_cell[0]]);
        let per_cell_y = Single::narrow([low.per_cell[1], high.per_cell[1]]);
        Self {
            origin: [origin_x, origin_y],
            per_cell: [per_cell_x, per_cell_y],
            before: [within_x * per_cell_x, within_y * per_cell_y],
            height: Single::narrow([low.height[0], high.height[0]]) - Single::splat(v, RAISE),
            per_height: Single::narrow([per_height(low.height[1]), per_height(high.height[1])]),
            length: Single::narrow([low.length, high.length]) * Single::splat(v, 1.0 + GROWTH),
            travel: Single::narrow([travel(low), travel(high)]),
        }
    }
}

/// Cell of a position, and the position in it.
#[inline(always)]
fn cell_and_rest<V: Vector>(low: Double<V>, high: Double<V>) -> (Single<V>, Single<V>) {
    let cells = [low.truncate(), high.truncate()];
    (Single::narrow(cells), Single::narrow([low - cells[0], high - cells[1]]))
}

#[inline(always)]
fn per_height<V: Vector>(slope: Double<V>) -> Double<V> {
    let v = slope.token();
    let (least, most) = (Double::splat(v, -MOST_PER_HEIGHT), Double::splat(v, MOST_PER_HEIGHT));
    (Double::splat(v, 1.0) / (slope + Double::splat(v, 0.0))).greater(least).lesser(most)
}

#[inline(always)]
fn travel<V: Vector>(rays: &HalfRays<V>) -> Double<V> {
    rays.length * rays.step[0].abs().greater(rays.step[1].abs())
}

/// The `at`-th of some columns or rows in the order of travel.
#[inline(always)]
fn turn(flip: usize, at: u32, [first, last]: [u32; 2]) -> u32 {
    if flip == 0 { first + at } else { last - at }
}

impl<'a, V: Vector, const FALLS: bool> Search<'a, V, FALLS> {
    #[inline(always)]
    pub fn new(
        v: V,
        hierarchy: &'a Hierarchy,
        rays: &'a Rays<V>,
        singles: &'a Singles<V>,
        group: &'a Group<V>,
        hits: &'a mut CellHits<V>,
    ) -> Self {
        let grow = Single::splat(v, size(group.level) * (BLOCK as f32 * GROWTH));
        let slack = [singles.per_cell[0].abs() * grow, singles.per_cell[1].abs() * grow];
        Self { v, hierarchy, rays, singles, group, slack, alive: group.lanes, hits }
    }

    /// Finds the first hits of the group.
    #[inline(always)]
    pub fn run(&mut self, stack: &mut Stack) {
        let Some(level) = self.hierarchy.levels().get(self.group.level) else { return };
        let [wide, high] = self.group.window;
        let (columns, rows) = (wide[1] - wide[0] + 1, high[1] - high[0] + 1);
        let side = size(self.group.level);
        let [near_x, far_x] = self.near_and_far(0, side);
        let [near_y, far_y] = self.near_and_far(1, side);
        let mut across = [[Single::splat(self.v, 0.0); 2]; MOST_NODES];
        for (at, across) in (0..columns).zip(&mut across) {
            let column = turn(self.group.flip[0], at, wide) as f32 * side;
            *across = self.column(column, 0, side, near_x, far_x);
        }
        self.hits.count(self.alive, BLOCK_BYTES);
        for at in 0..rows {
            let row = turn(self.group.flip[1], at, high);
            let [enter_y, leave_y] = self.row(row as f32 * side, 0, side, near_y, far_y);
            for (at, [enter, leave]) in (0..columns).zip(&across) {
                let node = [turn(self.group.flip[0], at, wide), row];
                let maximum = Single::splat(self.v, level.node(node));
                let by = self.touches(maximum, enter.max(enter_y), leave.min(leave_y)) & self.alive;
                if by != 0 {
                    let by = by & self.windows_with(node);
                    if by != 0 {
                        self.below(node, by, stack);
                        if self.alive == 0 {
                            return;
                        }
                    }
                }
            }
        }
    }

    /// Lanes whose own windows contain a node of the first level.
    #[inline(always)]
    fn windows_with(&self, node: [u32; 2]) -> u32 {
        let middle = Single::splat(self.v, (BLOCK - 1) as f32 / 2.0);
        let from_x = Single::splat(self.v, node[0] as f32) - self.group.corner[0];
        let from_y = Single::splat(self.v, node[1] as f32) - self.group.corner[1];
        (from_x - middle).abs().le(middle) & (from_y - middle).abs().le(middle)
    }

    /// Descends from a node of the first level.
    #[inline(always)]
    fn below(&mut self, node: [u32; 2], by: u32, stack: &mut Stack) {
        let levels = self.hierarchy.levels();
        let (mut level, mut node, mut by) = (self.group.level, node, by);
        loop {
            if level == 0 {
                self.tile(node, by);
                if self.alive == 0 {
                    return;
                }
            } else {
                level -= 1;
                let Some(block) = levels.get(level).and_then(|level: &MaximaLevel| level.block(node)) else {
                    return;
                };
                let corner = [node[0] * BLOCK as u32, node[1] * BLOCK as u32];
                let maxima = pulp::bytemuck::cast_ref(block);
                self.hits.count(by, BLOCK_BYTES);
                let touched = self.touched(maxima, edge(corner, level), size(level), by);
                stack.0[level % MAX_LEVELS] = Remaining { corner, touched };
            }
            // Goes to the next node.
            loop {
                if level == self.group.level {
                    return;
                }
                let left = &mut stack.0[level % MAX_LEVELS];
                if left.touched.nodes == 0 {
                    level += 1;
                    continue;
                }
                let at = left.touched.nodes.trailing_zeros() as usize % NODES;
                left.touched.nodes &= left.touched.nodes - 1;
                by = u32::from(left.touched.by[at]) & self.alive;
                if by != 0 {
                    let [x, y] = self.place(at);
                    node = [left.corner[0] + x as u32, left.corner[1] + y as u32];
                    break;
                }
            }
        }
    }

    /// Column and row of a block's node, from its number in the order of travel.
    #[inline(always)]
    fn place(&self, at: usize) -> [usize; 2] {
        let [x, y] = self.group.flip;
        [(at % BLOCK) ^ x, (at / BLOCK) ^ y]
    }

    /// Finds the first hits in a tile.
    #[inline(always)]
    fn tile(&mut self, node: [u32; 2], by: u32) {
        let Some(tile) = self.hierarchy.tile(node) else { return };
        let corner = [node[0] * BLOCK as u32, node[1] * BLOCK as u32];
        let maxima = tile.cell_maxima();
        self.hits.count(by, TILE_BYTES);
        let edges = [corner[0] as i32, corner[1] as i32];
        let mut touched = self.touched(pulp::bytemuck::cast_ref(&maxima), edges, 1.0, by);
        while touched.nodes != 0 {
            let at = touched.nodes.trailing_zeros() as usize % NODES;
            touched.nodes &= touched.nodes - 1;
            let by = u32::from(touched.by[at]) & self.alive;
            if by != 0 {
                let [x, y] = self.place(at);
                let in_tile = [x as u32, y as u32];
                self.hits.count(by, CELL_BYTES);
                let cell = [corner[0] + in_tile[0], corner[1] + in_tile[1]];
                self.alive &= !self.hits.cell(self.v, self.rays, tile.corners(in_tile), cell, by);
            }
        }
    }

    /// Offsets from the crossing of a node's first edge to the ray's entry and exit.
    #[inline(always)]
    fn near_and_far(&self, axis: usize, size: f32) -> [Single<V>; 2] {
        let zero = Single::splat(self.v, 0.0);
        let across = Single::splat(self.v, size) * self.singles.per_cell[axis];
        let near = across.min(zero) - self.slack[axis] - self.singles.before[axis];
        let far = across.max(zero) + self.slack[axis] - self.singles.before[axis];
        [near, far]
    }

    /// `s` from the edge of the cell where the ray begins to another edge.
    #[inline(always)]
    fn crossing(&self, axis: usize, edge: f32) -> Single<V> {
        (Single::splat(self.v, edge) - self.singles.origin[axis]) * self.singles.per_cell[axis]
    }

    /// Lanes that touch a node, which they enter and leave at these `s`.
    #[inline(always)]
    fn touches(&self, maximum: Single<V>, enter: Single<V>, leave: Single<V>) -> u32 {
        let level = (maximum - self.singles.height) * self.singles.per_height;
        if FALLS { level.max(enter).le(leave) } else { enter.le(level.min(leave)) }
    }

    /// Returns which of 4 x 4 nodes the rays touch: `Line::touched` in lanes, with the same bits.
    #[inline(always)]
    fn touched(&self, maxima: &[f32; NODES], edges: [i32; 2], size: f32, lanes: u32) -> Touched {
        let [flip_x, flip_y] = self.group.flip;
        let (x, y) = (edges[0] as f32, edges[1] as f32);
        let [near, far] = self.near_and_far(0, size);
        let columns = [
            self.column(x, flip_x, size, near, far),
            self.column(x, 1 ^ flip_x, size, near, far),
            self.column(x, 2 ^ flip_x, size, near, far),
            self.column(x, 3 ^ flip_x, size, near, far),
        ];
        let [near, far] = self.near_and_far(1, size);
        let nodes = Nodes { maxima, flip: BLOCK * flip_y + flip_x, lanes };
        let mut touched = Touched { nodes: 0, by: [0; NODES] };
        let row = |at: usize| self.row(y, at ^ flip_y, size, near, far);
        self.touched_row(row(0), &columns, &nodes, 0, &mut touched);
        self.touched_row(row(1), &columns, &nodes, BLOCK, &mut touched);
        self.touched_row(row(2), &columns, &nodes, 2 * BLOCK, &mut touched);
        self.touched_row(row(3), &columns, &nodes, 3 * BLOCK, &mut touched);
        touched
    }

    /// `s` at which rays enter and leave a column of nodes, limited to the rays' length.
    #[inline(always)]
    fn column(&self, edge: f32, at: usize, size: f32, near: Single<V>, far: Single<V>) -> [Single<V>; 2] {
        let crossing = self.crossing(0, edge + at as f32 * size);
        [(crossing + near).max(Single::splat(self.v, 0.0)), (crossing + far).min(self.singles.length)]
    }

    /// `s` at which rays enter and leave a row of nodes.
    #[inline(always)]
    fn row(&self, edge: f32, at: usize, size: f32, near: Single<V>, far: Single<V>) -> [Single<V>; 2] {
        let crossing = self.crossing(1, edge + at as f32 * size);
        [crossing + near, crossing + far]
    }

    /// Tests the nodes of a row, from number `first` on in the order of travel.
    #[inline(always)]
    fn touched_row(
        &self,
        row: [Single<V>; 2],
        columns: &[[Single<V>; 2]; BLOCK],
        nodes: &Nodes,
        first: usize,
        touched: &mut Touched,
    ) {
        self.touched_node(row, columns[0], nodes, first, touched);
        self.touched_node(row, columns[1], nodes, first + 1, touched);
        self.touched_node(row, columns[2], nodes, first + 2, touched);
        self.touched_node(row, columns[3], nodes, first + 3, touched);
    }

    #[inline(always)]
    fn touched_node(
        &self,
        row: [Single<V>; 2],
        column: [Single<V>; 2],
        Nodes { maxima, flip, lanes }: &Nodes,
        at: usize,
        touched: &mut Touched,
    ) {
        let maximum = Single::splat(self.v, maxima[(at ^ flip) % NODES]);
        let by = self.touches(maximum, column[0].max(row[0]), column[1].min(row[1])) & lanes;
        touched.by[at] = by as u16;
        touched.nodes |= u32::from(by != 0) << at;
    }
}
