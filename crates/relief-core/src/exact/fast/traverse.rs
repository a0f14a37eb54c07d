//! Descent from the hierarchy's window around a ray to the first cell that it hits.

use super::hierarchy::{BLOCK, Hierarchy, Tile};
use super::line::{Kind, Line, is_crosswise};
use super::ray::{TileRay, greater, lesser};
use crate::Cost;
use crate::exact::CELL_BYTES;
use crate::exact::patch::Gap;

/// A hit in the domain of the hierarchy.
#[derive(Clone, Copy, Debug)]
pub(super) struct CellHit {
    /// Parameter along the ray.
    pub s: f64,
    /// Gap at the hit: 0, or negative if the ray begins below the surface.
    pub gap: f64,
    /// Derivative of the gap by `s`.
    pub slope: f64,
    /// Cell of the hit.
    pub cell: [u32; 2],
}

/// Number of levels: enough for 4, 16, 64 ... cells up to the longest side of a map, with some to
/// spare.
pub(super) const MAX_LEVELS: usize = 16;

/// Bytes of a block of maxima.
pub(super) const BLOCK_BYTES: u32 = (BLOCK * BLOCK * size_of::<f32>()) as u32;

/// Bytes of a tile's texels.
pub(super) const TILE_BYTES: u32 = size_of::<Tile>() as u32;

/// Cell at the corner of a node.
#[inline(always)]
pub(super) fn edge(node: [u32; 2], level: usize) -> [i32; 2] {
    [(node[0] << (2 * level + 2)) as i32, (node[1] << (2 * level + 2)) as i32]
}

/// Cells along the side of a node.
#[inline(always)]
pub(super) fn size(level: usize) -> f32 {
    (1i32 << (2 * level + 2)) as f32
}

/// Kind of a single ray, in constants.
#[derive(Clone, Copy)]
struct Always<const BENT: bool, const FALLS: bool, const CROSSWISE: bool>;

impl<const BENT: bool, const FALLS: bool, const CROSSWISE: bool> Kind for Always<BENT, FALLS, CROSSWISE> {
    #[inline(always)]
    fn is_bent(self) -> bool {
        BENT
    }

    #[inline(always)]
    fn falls(self) -> bool {
        FALLS
    }

    #[inline(always)]
    fn is_crosswise(self) -> bool {
        CROSSWISE
    }
}

/// Traces a ray that falls, rises or is level all the way.
#[inline(always)]
pub(super) fn trace(hierarchy: &Hierarchy, ray: &TileRay, cost: &mut Cost) -> Option<CellHit> {
    let bent = ray.height[2] != 0.0;
    let falls = ray.height[1] + ray.length * ray.height[2] < 0.0;
    match (bent, falls, is_crosswise(ray)) {
        (false, true, false) => Search::new(hierarchy, ray, Always::<false, true, false>).run(cost),
        (false, true, true) => Search::new(hierarchy, ray, Always::<false, true, true>).run(cost),
        (false, false, false) => Search::new(hierarchy, ray, Always::<false, false, false>).run(cost),
        (false, false, true) => Search::new(hierarchy, ray, Always::<false, false, true>).run(cost),
        (true, true, false) => Search::new(hierarchy, ray, Always::<true, true, false>).run(cost),
        (true, true, true) => Search::new(hierarchy, ray, Always::<true, true, true>).run(cost),
        (true, false, false) => Search::new(hierarchy, ray, Always::<true, false, false>).run(cost),
        (true, false, true) => Search::new(hierarchy, ray, Always::<true, false, true>).run(cost),
    }
}

/// Search for one ray.
struct Search<'a, K> {
    hierarchy: &'a Hierarchy,
    ray: &'a TileRay,
    line: Line<K>,
}

impl<'a, K: Kind> Search<'a, K> {
    #[inline(always)]
    fn new(hierarchy: &'a Hierarchy, ray: &'a TileRay, kind: K) -> Self {
        Self { hierarchy, ray, line: Line::new(hierarchy, ray, kind) }
    }

    fn run(&self, cost: &mut Cost) -> Option<CellHit> {
        let levels = self.hierarchy.levels();
        let (start, window) = (self.line.start_level, self.line.window);
        // Remaining nodes of the blocks above the current one, by level.
        let mut masks = [0u16; MAX_LEVELS];
        let mut level = start;
        let mut corner = window;
        let mut mask = self.line.touched(&levels[level].window(window), edge(window, level), size(level));
        cost.step(1, BLOCK_BYTES);
        loop {
            while mask == 0 {
                if level >= start {
                    return None;
                }
                level += 1;
                mask = u32::from(masks[level % MAX_LEVELS]);
                let parent = [corner[0] >> 2, corner[1] >> 2];
                corner = if level == start { window } else { [parent[0] & !3, parent[1] & !3] };
            }
            let [column, row] = self.line.take_first(&mut mask);
            let node = [corner[0] + column, corner[1] + row];
            if level == 0 {
                let hit = self.tile(node, cost);
                if hit.is_some() {
                    return hit;
                }
                continue;
            }
            masks[level % MAX_LEVELS] = mask as u16;
            level -= 1;
            corner = [node[0] * BLOCK as u32, node[1] * BLOCK as u32];
            mask = self.line.touched(levels[level].block(node)?, edge(corner, level), size(level));
            cost.step(1, BLOCK_BYTES);
        }
    }

    /// First hit in a tile.
    #[inline(always)]
    fn tile(&self, node: [u32; 2], cost: &mut Cost) -> Option<CellHit> {
        let tile = self.hierarchy.tile(node)?;
        let corner = [node[0] * BLOCK as u32, node[1] * BLOCK as u32];
        let mut mask = self.line.touched(&tile.cell_maxima(), [corner[0] as i32, corner[1] as i32], 1.0);
        cost.step(1, TILE_BYTES);
        while mask != 0 {
            let cell = self.line.take_first(&mut mask);
            cost.step(1, CELL_BYTES);
            let hit = self.cell(tile, corner, cell);
            if hit.is_some() {
                return hit;
            }
        }
        None
    }

    /// Hit in one cell of a tile, in `f64`. Cells that share an edge compute the same `s` for it.
    #[inline(always)]
    fn cell(&self, tile: &Tile, corner: [u32; 2], in_tile: [u32; 2]) -> Option<CellHit> {
        let ray = self.ray;
        let cell = [corner[0] + in_tile[0], corner[1] + in_tile[1]];
        let (x, y) = (f64::from(cell[0]), f64::from(cell[1]));
        let crossings = |k: usize, edge: f64| {
            let (low, high) =
                ((edge - ray.start[k]) * ray.per_cell[k], (edge + 1.0 - ray.start[k]) * ray.per_cell[k]);
            (lesser(low, high), greater(low, high))
        };
        let ((near_x, far_x), (near_y, far_y)) = (crossings(0, x), crossings(1, y));
        let enter = greater(greater(near_x, near_y), 0.0);
        let leave = lesser(lesser(far_x, far_y), ray.length);
        if enter > leave {
            return None;
        }
        let [place_x, place_y] = ray.place_at(enter);
        let gap =
            Gap::in_cell(tile.corners(in_tile), [place_x - x, place_y - y], ray.step, ray.height_at(enter));
        let tau = gap.first_root(leave - enter)?;
        let depth = if tau > 0.0 { 0.0 } else { gap.c[0] };
        Some(CellHit { s: enter + tau, gap: depth, slope: gap.slope(tau), cell })
    }
}
