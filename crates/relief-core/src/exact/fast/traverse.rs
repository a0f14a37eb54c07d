//! From the hierarchy's window around a ray down to the first cell that it hits.

use glam::Vec4;

use super::hierarchy::{BLOCK, Hierarchy, Tile};
use super::ray::{TileRay, greater, lesser};
use crate::Cost;
use crate::exact::CELL_BYTES;
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
    pub cell: [u32; 2],
}

/// How far nodes are grown, as a share of the window's side. Smaller values lose hits, larger ones cost time.
///
/// Every place goes through at most 9 roundings of numbers that are no further from the ray's start than the
/// window's side: so it is wrong by less than `9 · 2⁻²⁴` of that side, at every level.
pub(super) const GROWTH: f32 = 1.0 / (1 << 18) as f32;

/// How far nodes are raised. Smaller values lose hits, larger ones cost time.
///
/// Every height goes through at most 8 roundings of numbers up to 2.
pub(super) const RAISE: f32 = 1.0 / (1 << 20) as f32;

/// Stands for the infinite reciprocal of the slope of a level ray.
pub(super) const MOST_PER_HEIGHT: f64 = (1u64 << 62) as f64;

/// Levels of 4, 16, 64 ... cells up to the longest side of a map, and some to spare.
pub(super) const MAX_LEVELS: usize = 16;

/// The numbers of the columns and rows of a block.
const COUNT: Vec4 = Vec4::new(0.0, 1.0, 2.0, 3.0);

/// Bytes of the maxima of a block of nodes.
pub(super) const BLOCK_BYTES: u32 = (BLOCK * BLOCK * size_of::<f32>()) as u32;

/// Bytes of the texels of a tile.
pub(super) const TILE_BYTES: u32 = size_of::<Tile>() as u32;

/// The cell at the corner of a node.
#[inline(always)]
pub(super) fn edge(node: [u32; 2], level: usize) -> [i32; 2] {
    [(node[0] << (2 * level + 2)) as i32, (node[1] << (2 * level + 2)) as i32]
}

/// Cells along the side of a node.
#[inline(always)]
pub(super) fn size(level: usize) -> f32 {
    (1i32 << (2 * level + 2)) as f32
}

/// What a search does otherwise for some rays: known to the compiler for one ray, and not for many.
pub(super) trait Kind: Copy {
    /// The height is not linear.
    fn is_bent(self) -> bool;
    /// The ray falls; else it rises or is level.
    fn falls(self) -> bool;
    /// The ray goes left and down, or right and up.
    fn is_crosswise(self) -> bool;
}

/// The kind of one ray.
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

/// Traces a ray that falls all the way, or rises, or is level.
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

/// Whether a ray goes left and down, or right and up.
#[inline(always)]
pub(super) fn is_crosswise(ray: &TileRay) -> bool {
    (ray.per_cell[0] < 0.0) != (ray.per_cell[1] < 0.0)
}

/// A ray in `f32`. Places are in cells from the cell where the ray begins.
#[derive(Clone, Copy)]
pub(super) struct Line<K> {
    kind: K,
    /// The cell where the ray begins.
    origin: [i32; 2],
    /// `s` a cell.
    per_cell: [f32; 2],
    /// `s` from that cell's edges to the ray's start.
    before: [f32; 2],
    /// `s` by which nodes are grown.
    slack: [f32; 2],
    /// The height, lowered by [`RAISE`], and the reciprocal of its slope.
    height: [f32; 3],
    per_height: f32,
    length: f32,
    /// The level of the window.
    pub start_level: usize,
    /// The first column and row of the window of 4 x 4 nodes that holds the ray.
    pub window: [u32; 2],
    /// The ray goes left.
    backward: bool,
}

/// The search for one ray.
struct Search<'a, K> {
    hierarchy: &'a Hierarchy,
    ray: &'a TileRay,
    line: Line<K>,
}

impl<K: Kind> Line<K> {
    #[inline(always)]
    pub fn new(hierarchy: &Hierarchy, ray: &TileRay, kind: K) -> Self {
        let travel = (ray.length * greater(ray.step[0].abs(), ray.step[1].abs())) as f32;
        let top = hierarchy.levels().len() - 1;
        // The finest level at which a window of 4 x 4 nodes holds the whole ray, wherever in its node it
        // begins.
        let mut start_level = 0;
        let mut node = BLOCK as f32;
        while start_level < top && travel > (BLOCK - 1) as f32 * node {
            start_level += 1;
            node *= BLOCK as f32;
        }
        let origin = [ray.start[0] as i32, ray.start[1] as i32];
        let within =
            [(ray.start[0] - f64::from(origin[0])) as f32, (ray.start[1] - f64::from(origin[1])) as f32];
        let per_cell = [ray.per_cell[0] as f32, ray.per_cell[1] as f32];
        let grow = node * (BLOCK as f32 * GROWTH);
        let per_height = (1.0 / (ray.height[1] + 0.0)).clamp(-MOST_PER_HEIGHT, MOST_PER_HEIGHT);
        let sides = hierarchy.levels()[start_level].sides;
        let corner = |k: usize| {
            let node = (origin[k].max(0) as u32) >> (2 * start_level + 2);
            let first = if per_cell[k] < 0.0 { node.saturating_sub(BLOCK as u32 - 1) } else { node };
            first.min(sides[k] - BLOCK as u32)
        };
        Self {
            kind,
            origin,
            per_cell,
            before: [within[0] * per_cell[0], within[1] * per_cell[1]],
            slack: [per_cell[0].abs() * grow, per_cell[1].abs() * grow],
            height: [ray.height[0] as f32 - RAISE, ray.height[1] as f32, ray.height[2] as f32],
            per_height: per_height as f32,
            length: ray.length as f32 * (1.0 + GROWTH),
            start_level,
            window: [corner(0), corner(1)],
            backward: per_cell[0] < 0.0,
        }
    }

    /// Which of 4 x 4 nodes, `size` cells wide and beginning at those edges, the ray touches. Column `c` of
    /// row `r` is bit `4 r + c`, or `4 (3 - r) + c` for a crosswise ray.
    ///
    /// Whether a node is touched is up to the ray and the node alone, so that packets of rays come to the
    /// same nodes.
    #[inline(always)]
    pub fn touched(&self, maxima: &[Vec4; BLOCK], edges: [i32; 2], size: f32) -> u32 {
        let enter_and_leave = |k: usize| {
            let across = size * self.per_cell[k];
            let (near, far) = (across.min(0.0) - self.slack[k], across.max(0.0) + self.slack[k]);
            let from_origin = Vec4::splat((edges[k] - self.origin[k]) as f32) + COUNT * Vec4::splat(size);
            let crossing = from_origin * Vec4::splat(self.per_cell[k]);
            (crossing + Vec4::splat(near - self.before[k]), crossing + Vec4::splat(far - self.before[k]))
        };
        let ((enter_x, leave_x), (enter_y, leave_y)) = (enter_and_leave(0), enter_and_leave(1));
        let enter_x = enter_x.max(Vec4::ZERO);
        let leave_x = leave_x.min(Vec4::splat(self.length));
        let [h0, h1, h2] = self.height;
        let row = |k: usize, enter_y: f32, leave_y: f32| {
            let enter = enter_x.max(Vec4::splat(enter_y));
            let leave = leave_x.min(Vec4::splat(leave_y));
            let touched = if self.kind.is_bent() {
                let s = if self.kind.falls() { leave } else { enter };
                let height = Vec4::splat(h0) + s * (Vec4::splat(h1) + s * Vec4::splat(h2));
                enter.cmple(leave) & height.cmple(maxima[k])
            } else {
                // Where the ray is as high as the node.
                let level = (maxima[k] - Vec4::splat(h0)) * Vec4::splat(self.per_height);
                if self.kind.falls() { level.max(enter).cmple(leave) } else { enter.cmple(level.min(leave)) }
            };
            touched.bitmask() << (4 * if self.kind.is_crosswise() { BLOCK - 1 - k } else { k })
        };
        row(0, enter_y.x, leave_y.x)
            | row(1, enter_y.y, leave_y.y)
            | row(2, enter_y.z, leave_y.z)
            | row(3, enter_y.w, leave_y.w)
    }

    /// Takes the node that the ray comes to first out of a mask: its column and row in the block.
    ///
    /// A ray that goes right and down comes to the nodes in the order of their bits, and one that goes left
    /// and up in the reverse order; for crosswise rays the rows of the mask are upside down, so that the same
    /// holds.
    #[inline(always)]
    pub fn take_first(&self, mask: &mut u32) -> [u32; 2] {
        let bit = if self.backward { 31 - mask.leading_zeros() } else { mask.trailing_zeros() };
        *mask ^= 1 << bit;
        [bit & 3, (bit >> 2) ^ if self.kind.is_crosswise() { 3 } else { 0 }]
    }
}

impl<'a, K: Kind> Search<'a, K> {
    #[inline(always)]
    fn new(hierarchy: &'a Hierarchy, ray: &'a TileRay, kind: K) -> Self {
        Self { hierarchy, ray, line: Line::new(hierarchy, ray, kind) }
    }

    fn run(&self, cost: &mut Cost) -> Option<CellHit> {
        let levels = self.hierarchy.levels();
        let (start, window) = (self.line.start_level, self.line.window);
        // What is left of the blocks above the one being searched.
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

    /// The first hit in a tile.
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

    /// The hit in one cell of a tile, in `f64`. Cells that share an edge compute the same `s` for it.
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
