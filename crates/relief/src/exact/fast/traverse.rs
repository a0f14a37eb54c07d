//! From the hierarchy's window around a ray down to the first cell that it hits.

use glam::Vec4;

use super::hierarchy::{BLOCK, Hierarchy, Level, TILE_TEXELS, cell_maxima, corners};
use super::ray::Ray;
use crate::exact::patch::Gap;

/// A hit in the domain of the hierarchy.
#[derive(Clone, Copy, Debug)]
pub(super) struct CellHit {
    /// Where on the ray.
    pub s: f64,
    /// The gap there: 0, or negative where the ray begins below the surface.
    pub gap: f64,
    /// Derivative of the gap by `s`.
    pub slope: f64,
    /// The cell.
    pub cell: [i64; 2],
}

/// How far nodes are grown, as a share of the window's side, and raised: see the guarantee of the tracer. Smaller values
/// lose hits, larger ones cost time.
const SLACK: f32 = 1.0 / (1 << 20) as f32;

/// No reciprocal in the `f32` search is larger. A smaller bound would move shallow rays by more than the slack.
const MOST_PER_CELL: f64 = (1u64 << 40) as f64;

/// Levels 4, 16, 64 ... up to the longest side of a map, and one to spare.
const MAX_LEVELS: usize = 12;

/// Traces a ray that falls (or is level) or rises all the way.
#[inline]
pub(super) fn trace(hierarchy: &Hierarchy, ray: &Ray, reads: &mut u32) -> Option<CellHit> {
    let falls = ray.height[1] + ray.length * ray.height[2] < 0.0;
    match (falls, ray.height[2] != 0.0) {
        (true, false) => Search::<true, false>::new(hierarchy, ray).run(reads),
        (false, false) => Search::<false, false>::new(hierarchy, ray).run(reads),
        (true, true) => Search::<true, true>::new(hierarchy, ray).run(reads),
        (false, true) => Search::<false, true>::new(hierarchy, ray).run(reads),
    }
}

/// The search for one ray. All places are in cells from the cell where the ray begins.
struct Search<'a, const FALLS: bool, const BENT: bool> {
    hierarchy: &'a Hierarchy,
    ray: &'a Ray,
    /// The cell where the ray begins, and where in it.
    origin: [i32; 2],
    within: [f32; 2],
    /// `s` a cell.
    per_cell: [f32; 2],
    /// `s` by which nodes are grown.
    slack: [f32; 2],
    /// `s` from a block's first edge to the near and the far edge of each of its four nodes, for nodes of one cell. Rows are
    /// in the order in which they are loaded.
    near: [Vec4; 2],
    far: [Vec4; 2],
    height: [f32; 3],
    length: f32,
    start_level: usize,
    /// Rows are loaded last first, and bits are visited from the highest: see [`Self::next_node`].
    upside_down: bool,
    backward: bool,
}

impl<'a, const FALLS: bool, const BENT: bool> Search<'a, FALLS, BENT> {
    #[inline]
    fn new(hierarchy: &'a Hierarchy, ray: &'a Ray) -> Self {
        let travel = (ray.length * ray.step[0].abs().max(ray.step[1].abs())) as f32;
        let top = hierarchy.levels().len() - 1;
        // The finest level at which a window of 4 x 4 nodes holds the whole ray, wherever in its node it begins.
        let mut start_level = 0;
        let mut node = BLOCK as f32;
        while start_level < top && travel > (BLOCK - 1) as f32 * node {
            start_level += 1;
            node *= BLOCK as f32;
        }
        let origin = ray.start.map(|start| start as i32);
        let within = [0, 1].map(|k| (ray.start[k] - f64::from(origin[k])) as f32);
        let per_cell = ray.per_cell.map(|inverse| inverse.clamp(-MOST_PER_CELL, MOST_PER_CELL) as f32);
        let slack = per_cell.map(|inverse| inverse.abs() * node * BLOCK as f32 * SLACK);
        let backward = per_cell[0] < 0.0;
        let upside_down = backward != (per_cell[1] < 0.0);
        let lanes = [
            Vec4::new(0.0, 1.0, 2.0, 3.0),
            if upside_down { Vec4::new(3.0, 2.0, 1.0, 0.0) } else { Vec4::new(0.0, 1.0, 2.0, 3.0) },
        ];
        let edge = |k: usize, far: bool| {
            let offset = if (per_cell[k] < 0.0) != far { 1.0 } else { 0.0 };
            (lanes[k] + Vec4::splat(offset)) * per_cell[k]
        };
        let height = ray.height.map(|h| h as f32);
        Self {
            hierarchy,
            ray,
            origin,
            within,
            per_cell,
            slack,
            near: [edge(0, false), edge(1, false)],
            far: [edge(0, true), edge(1, true)],
            height: [height[0] - SLACK, height[1], height[2]],
            length: ray.length as f32 * (1.0 + SLACK),
            start_level,
            upside_down,
            backward,
        }
    }

    fn run(&self, reads: &mut u32) -> Option<CellHit> {
        let levels = self.hierarchy.levels();
        let mut masks = [0u32; MAX_LEVELS];
        let mut corners = [[0usize; 2]; MAX_LEVELS];
        let mut level = self.start_level.min(MAX_LEVELS - 1);
        let mut corner = self.window_corner(&levels[level], level);
        let mut mask = self.block(&levels[level], level, corner);
        *reads += 1;
        loop {
            while mask == 0 {
                if level == self.start_level {
                    return None;
                }
                level += 1;
                (mask, corner) = (masks[level], corners[level]);
            }
            let node = self.next_node(&mut mask);
            let [column, row] = [corner[0] + node[0], corner[1] + node[1]];
            if level == 0 {
                if let Some(hit) = self.tile(column, row, reads) {
                    return Some(hit);
                }
                continue;
            }
            (masks[level], corners[level]) = (mask, corner);
            level -= 1;
            corner = [column * BLOCK, row * BLOCK];
            mask = self.block(&levels[level], level, corner);
            *reads += 1;
        }
    }

    /// The first node of the window of 4 x 4 nodes that reaches from the ray's start along its direction.
    #[inline]
    fn window_corner(&self, level: &Level, index: usize) -> [usize; 2] {
        let most = [level.columns - BLOCK, level.rows - BLOCK];
        [0, 1].map(|k| {
            let node = (self.origin[k].max(0) as usize) >> (2 * index + 2);
            let first = if self.per_cell[k] < 0.0 { node.saturating_sub(BLOCK - 1) } else { node };
            first.min(most[k])
        })
    }

    /// Which nodes of a block the ray touches: bit `4 r + c` for column `c` of the `r`-th row loaded.
    #[inline]
    fn block(&self, level: &Level, index: usize, corner: [usize; 2]) -> u32 {
        let shift = 2 * index + 2;
        let edge = corner.map(|node| (node << shift) as i32);
        self.touched(level.window(corner[0], corner[1], self.upside_down), edge, (1u32 << shift) as f32)
    }

    /// Which of 4 x 4 nodes, `size` cells wide and with the first one's corner at `edge`, the ray touches.
    #[inline]
    fn touched(&self, maxima: [Vec4; BLOCK], edge: [i32; 2], size: f32) -> u32 {
        let base = [0, 1].map(|k| ((edge[k] - self.origin[k]) as f32 - self.within[k]) * self.per_cell[k]);
        let enter_x = (self.near[0] * size + Vec4::splat(base[0] - self.slack[0])).max(Vec4::ZERO);
        let leave_x =
            (self.far[0] * size + Vec4::splat(base[0] + self.slack[0])).min(Vec4::splat(self.length));
        let enter_y = (self.near[1] * size + Vec4::splat(base[1] - self.slack[1])).to_array();
        let leave_y = (self.far[1] * size + Vec4::splat(base[1] + self.slack[1])).to_array();
        let [h0, h1, h2] = self.height.map(Vec4::splat);
        let mut mask = 0;
        for k in 0..BLOCK {
            let enter = enter_x.max(Vec4::splat(enter_y[k]));
            let leave = leave_x.min(Vec4::splat(leave_y[k]));
            let s = if FALLS { leave } else { enter };
            let height = if BENT { h0 + s * (h1 + s * h2) } else { h0 + s * h1 };
            let touched = enter.cmple(leave) & height.cmple(maxima[k]);
            mask |= touched.bitmask() << (4 * k);
        }
        mask
    }

    /// Takes the node that the ray comes to first out of a mask: its column and row in the block.
    ///
    /// A ray that goes right and down comes to the nodes in the order of their bits. One that goes left and up comes
    /// to them in the reverse order, and the two other directions do so when the rows are loaded upside down.
    #[inline]
    fn next_node(&self, mask: &mut u32) -> [usize; 2] {
        let bit = if self.backward { 31 - mask.leading_zeros() } else { mask.trailing_zeros() };
        *mask ^= 1 << bit;
        let row = (bit >> 2) ^ if self.upside_down { 3 } else { 0 };
        [(bit & 3) as usize, row as usize]
    }

    /// The first hit in a tile.
    #[inline]
    fn tile(&self, column: usize, row: usize, reads: &mut u32) -> Option<CellHit> {
        let tile = self.hierarchy.tile(column, row)?;
        let [left, top] = [column * BLOCK, row * BLOCK];
        let mut mask = self.touched(cell_maxima(tile, self.upside_down), [left as i32, top as i32], 1.0);
        *reads += 1;
        while mask != 0 {
            let [c, r] = self.next_node(&mut mask);
            *reads += 1;
            if let Some(hit) = self.cell(tile, [c, r], [left + c, top + r]) {
                return Some(hit);
            }
        }
        None
    }

    /// The hit in one cell, in `f64`.
    #[inline]
    fn cell(
        &self,
        tile: &[f32; TILE_TEXELS * TILE_TEXELS],
        in_tile: [usize; 2],
        cell: [usize; 2],
    ) -> Option<CellHit> {
        let ray = self.ray;
        let (mut enter, mut leave) = (0.0f64, ray.length);
        let corner = cell.map(|cell| cell as f64);
        for (k, corner) in corner.into_iter().enumerate() {
            let [low, high] = [corner, corner + 1.0].map(|edge| (edge - ray.start[k]) * ray.per_cell[k]);
            let [near, far] = if ray.per_cell[k] < 0.0 { [high, low] } else { [low, high] };
            enter = enter.max(near);
            leave = leave.min(far);
        }
        if enter > leave {
            return None;
        }
        let from = [0, 1].map(|k| ray.start[k] + ray.step[k] * enter - corner[k]);
        let gap = Gap::in_cell(corners(tile, in_tile[0], in_tile[1]), from, ray.step, ray.height_at(enter));
        let tau = gap.first_root(leave - enter)?;
        let s = enter + tau;
        let depth = if tau > 0.0 { 0.0 } else { gap.c[0] };
        Some(CellHit { s, gap: depth, slope: gap.slope(tau), cell: cell.map(|cell| cell as i64) })
    }
}
