//! Rays with no neighbours. Each goes down the hierarchy by itself, and all take turns, a step at a time.
//!
//! Each step of a ray waits for the ray's last one, but not for those of other rays: so the processor works
//! on several at once. The cells that the rays come to are solved in lanes.

use glam::Vec4;

use super::PathPacket;
use super::cell::{CellHits, Patch, Patches, Rays};
use super::together::lanes_of;
use super::vector::Vector;
use crate::exact::CELL_BYTES;
use crate::exact::fast::hierarchy::{BLOCK, Hierarchy};
use crate::exact::fast::line::{Kind, Line, is_crosswise};
use crate::exact::fast::ray::TileRay;
use crate::exact::fast::traverse::{BLOCK_BYTES, MAX_LEVELS, TILE_BYTES};

/// The kind of a ray whose height is linear.
#[derive(Clone, Copy)]
struct Straight {
    falls: bool,
    crosswise: bool,
}

impl Kind for Straight {
    #[inline(always)]
    fn is_bent(self) -> bool {
        false
    }

    #[inline(always)]
    fn falls(self) -> bool {
        self.falls
    }

    #[inline(always)]
    fn is_crosswise(self) -> bool {
        self.crosswise
    }
}

/// A ray on its way down. The nodes of depth 0 are cells, those of depth 1 tiles.
struct Stray {
    line: Line<Straight>,
    /// The depth of the block or window that it is in, the first column and row there, and the nodes left.
    depth: usize,
    corner: [u32; 2],
    mask: u32,
    /// The nodes left of those above, depth by depth.
    masks: [u16; MAX_LEVELS],
}

/// What a step looked at.
enum Step {
    /// The nodes of a block.
    Block,
    /// The cells of a tile.
    Tile,
    /// A cell, and its corners.
    Cell([u32; 2], [f32; 4]),
    /// Nothing: there is no node left.
    End,
}

impl Stray {
    /// A ray that has looked at its window.
    #[inline(always)]
    fn new(hierarchy: &Hierarchy, ray: &TileRay) -> Self {
        let kind = Straight { falls: ray.height[1] < 0.0, crosswise: is_crosswise(ray) };
        let line = Line::new(hierarchy, ray, kind);
        let (depth, corner) = (line.start_level + 1, line.window);
        let mut stray = Self { line, depth, corner, mask: 0, masks: [0; MAX_LEVELS] };
        stray.look(&hierarchy.levels()[line.start_level].window(corner));
        stray
    }

    /// Finds the nodes that it touches of a block.
    #[inline(always)]
    fn look(&mut self, maxima: &[Vec4; BLOCK]) {
        let edges = self.corner.map(|at| (at << (2 * self.depth)) as i32);
        self.mask = self.line.touched(maxima, edges, (1u32 << (2 * self.depth)) as f32);
    }

    /// Goes to the next node.
    #[inline(always)]
    fn step(&mut self, hierarchy: &Hierarchy) -> Step {
        let start = self.line.start_level + 1;
        while self.mask == 0 {
            if self.depth >= start {
                return Step::End;
            }
            self.depth += 1;
            self.mask = u32::from(self.masks[self.depth % MAX_LEVELS]);
            let block = self.corner.map(|at| (at >> 2) & !3);
            self.corner = if self.depth == start { self.line.window } else { block };
        }
        let [column, row] = self.line.take_first(&mut self.mask);
        let node = [self.corner[0] + column, self.corner[1] + row];
        if self.depth == 0 {
            let tile = self.corner.map(|at| at / BLOCK as u32);
            return match hierarchy.tile(tile) {
                Some(tile) => Step::Cell(node, tile.corners([column, row])),
                None => Step::End,
            };
        }
        self.masks[self.depth % MAX_LEVELS] = self.mask as u16;
        self.depth -= 1;
        self.corner = node.map(|at| at * BLOCK as u32);
        if self.depth == 0 {
            match hierarchy.tile(node) {
                Some(tile) => self.look(&tile.cell_maxima()),
                None => return Step::End,
            }
            return Step::Tile;
        }
        match hierarchy.levels()[self.depth - 1].block(node) {
            Some(block) => self.look(block),
            None => return Step::End,
        }
        Step::Block
    }
}

/// Finds the first hits of some lanes, whose rays have nothing to do with each other.
#[inline(always)]
pub(super) fn search<V: Vector>(
    v: V,
    hierarchy: &Hierarchy,
    rays: &Rays<V>,
    lanes: u32,
    hits: &mut CellHits<V>,
) {
    let mut strays = [const { None }; PathPacket::LEN];
    for lane in lanes_of(lanes) {
        let ray = rays[lane / V::F64_LANES].lane(lane % V::F64_LANES);
        strays[lane] = Some(Stray::new(hierarchy, &ray));
    }
    hits.count(lanes, BLOCK_BYTES);
    let mut patches = Patches::default();
    let mut left = lanes;
    while left != 0 {
        let (mut blocks, mut tiles, mut cells) = (0, 0, 0);
        for lane in lanes_of(left) {
            let Some(stray) = &mut strays[lane] else { continue };
            match stray.step(hierarchy) {
                Step::Block => blocks |= 1 << lane,
                Step::Tile => tiles |= 1 << lane,
                Step::Cell(cell, corners) => {
                    cells |= 1 << lane;
                    patches.set(lane, Patch::new(cell, corners));
                }
                Step::End => left &= !(1 << lane),
            }
        }
        if blocks != 0 {
            hits.count(blocks, BLOCK_BYTES);
        }
        if tiles != 0 {
            hits.count(tiles, TILE_BYTES);
        }
        if cells != 0 {
            hits.count(cells, CELL_BYTES);
            left &= !hits.cells(v, rays, &patches, cells);
        }
    }
}
