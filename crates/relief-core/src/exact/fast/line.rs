//! A ray in `f32`, and the test for the nodes that it touches.

use glam::Vec4;

use super::hierarchy::{BLOCK, Hierarchy};
use super::ray::{TileRay, greater};

/// Growth of nodes, as a share of the window's side. Smaller values lose hits, larger ones cost
/// time.
///
/// Every position goes through at most 9 roundings of numbers that are no further from the ray's
/// start than the window's side. So its error is below `9 · 2⁻²⁴` of that side, at every level.
pub(super) const GROWTH: f32 = 1.0 / (1 << 18) as f32;

/// Raise of nodes, in heights. Smaller values lose hits, larger ones cost time.
///
/// Every height goes through at most 8 roundings of numbers up to 2.
pub(super) const RAISE: f32 = 1.0 / (1 << 20) as f32;

/// Finite substitute for the infinite reciprocal of the slope of a level ray.
pub(super) const MOST_PER_HEIGHT: f64 = (1u64 << 62) as f64;

/// Numbers of the columns and rows of a block.
const COUNT: Vec4 = Vec4::new(0.0, 1.0, 2.0, 3.0);

/// Properties of a ray on which the search depends. For a single ray they are compile-time
/// constants, so that they cost no time. For rays in turns they are looked up.
pub(super) trait Kind: Copy {
    /// Whether the height is not linear.
    fn is_bent(self) -> bool;
    /// Whether the ray falls; otherwise it rises or is level.
    fn falls(self) -> bool;
    /// Whether the ray goes left and down, or right and up.
    fn is_crosswise(self) -> bool;
}

/// Whether a ray goes left and down, or right and up.
#[inline(always)]
pub(super) fn is_crosswise(ray: &TileRay) -> bool {
    (ray.per_cell[0] < 0.0) != (ray.per_cell[1] < 0.0)
}

/// A ray in `f32`. Positions are in cells from the cell where the ray begins.
#[derive(Clone, Copy, Default)]
pub(super) struct Line<K> {
    kind: K,
    /// Cell where the ray begins.
    origin: [i32; 2],
    /// `s` per cell.
    per_cell: [f32; 2],
    /// `s` from that cell's edges to the ray's start.
    before: [f32; 2],
    /// Growth of nodes in `s`.
    slack: [f32; 2],
    /// Height, lowered by [`RAISE`], and the reciprocal of its slope.
    height: [f32; 3],
    per_height: f32,
    length: f32,
    /// Level of the window.
    pub start_level: usize,
    /// First column and row of the window of 4 x 4 nodes that holds the ray.
    pub window: [u32; 2],
    /// Whether the ray goes left.
    backward: bool,
}

impl<K: Kind> Line<K> {
    #[inline(always)]
    pub fn new(hierarchy: &Hierarchy, ray: &TileRay, kind: K) -> Self {
        let travel = (ray.length * greater(ray.step[0].abs(), ray.step[1].abs())) as f32;
        let top = hierarchy.levels().len() - 1;
        // The finest level at which a window of 4 x 4 nodes holds the whole ray, wherever in its
        // node it begins.
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

    /// Returns which of 4 x 4 nodes the ray touches. The nodes are `size` cells wide and begin at
    /// `edges`. Column `c` of row `r` is bit `4 r + c`, or `4 (3 - r) + c` for a crosswise ray.
    ///
    /// The result depends on the ray and the node alone, so that packets of rays visit the same
    /// nodes.
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
                // `s` at which the ray is as high as the node.
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

    /// Removes the node that the ray enters first from a mask. Returns its column and row in the
    /// block.
    ///
    /// A ray that goes right and down enters the nodes in the order of their bits. A ray that goes
    /// left and up enters them in reverse order. For crosswise rays the rows of the mask are upside
    /// down, so that the same holds.
    #[inline(always)]
    pub fn take_first(&self, mask: &mut u32) -> [u32; 2] {
        let bit = if self.backward { 31 - mask.leading_zeros() } else { mask.trailing_zeros() };
        *mask ^= 1 << bit;
        [bit & 3, (bit >> 2) ^ if self.kind.is_crosswise() { 3 } else { 0 }]
    }
}
