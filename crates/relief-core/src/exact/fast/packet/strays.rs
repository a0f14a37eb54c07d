//! Rays with no neighbours. Each goes down the hierarchy by itself, and all take turns, a step at a time.
//!
//! Each step of a ray waits for the ray's last one, but not for those of other rays: so the processor works
//! on several at once. A ray that has come to a cell waits until all have; then the cells are solved in lanes.

use glam::Vec4;

use super::PathPacket;
use super::cell::{CellHits, Patch, Patches, Rays};
use super::vector::{Vector, lanes_of};
use crate::exact::CELL_BYTES;
use crate::exact::fast::hierarchy::{BLOCK, Hierarchy};
use crate::exact::fast::line::{Kind, Line, is_crosswise};
use crate::exact::fast::ray::TileRay;
use crate::exact::fast::traverse::{BLOCK_BYTES, MAX_LEVELS, TILE_BYTES};

/// The kind of a ray whose height is linear.
#[derive(Clone, Copy, Default)]
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

/// What is left of a block, or of a window.
#[derive(Clone, Copy, Default)]
struct Left {
    /// The first column and row.
    corner: [u32; 2],
    /// The nodes that the ray touches and has not been to.
    nodes: u32,
}

/// A ray on its way down. The nodes of depth 0 are cells, those of depth 1 tiles.
#[derive(Clone, Copy, Default)]
struct Stray {
    line: Line<Straight>,
    /// The nodes left, depth by depth.
    left: [Left; MAX_LEVELS],
    /// The depths that have nodes left, as bits.
    depths: u32,
    /// The node that it has come to, and its depth.
    node: [u32; 2],
    depth: usize,
}

/// What a ray has come to.
#[derive(Clone, Copy)]
enum Node {
    Cell,
    Tile,
    /// A node above tiles.
    Block,
    /// There is no node left.
    End,
}

/// The lanes whose rays have come to each kind of node. All are in one number, so that no lane waits until the
/// one before is stored.
#[derive(Clone, Copy, Default)]
struct Turns(u64);

impl Turns {
    #[inline(always)]
    fn add(&mut self, node: Node, lane: usize) {
        self.0 |= 1 << (PathPacket::LEN * node as usize + lane);
    }

    #[inline(always)]
    fn of(self, node: Node) -> u32 {
        u32::from((self.0 >> (PathPacket::LEN * node as usize)) as u16)
    }
}

impl Stray {
    /// Begins with a ray: looks at its window.
    #[inline(always)]
    fn begin(&mut self, hierarchy: &Hierarchy, ray: &TileRay) {
        let kind = Straight { falls: ray.height[1] < 0.0, crosswise: is_crosswise(ray) };
        self.line = Line::new(hierarchy, ray, kind);
        self.depths = 0;
        let Line { start_level, window, .. } = self.line;
        self.look(&hierarchy.levels()[start_level].window(window), start_level + 1, window);
    }

    /// Finds which of 4 x 4 nodes it touches.
    #[inline(always)]
    fn look(&mut self, maxima: &[Vec4; BLOCK], depth: usize, corner: [u32; 2]) {
        let edges = corner.map(|at| (at << (2 * depth)) as i32);
        let nodes = self.line.touched(maxima, edges, (1u32 << (2 * depth)) as f32);
        self.left[depth % MAX_LEVELS] = Left { corner, nodes };
        self.depths |= u32::from(nodes != 0) << depth;
    }

    /// Goes to the next node. There is no branch on its kind, which the processor could not foresee.
    #[inline(always)]
    fn advance(&mut self) -> Node {
        if self.depths == 0 {
            return Node::End;
        }
        self.depth = self.depths.trailing_zeros() as usize;
        let left = &mut self.left[self.depth % MAX_LEVELS];
        let [column, row] = self.line.take_first(&mut left.nodes);
        self.depths ^= u32::from(left.nodes == 0) << self.depth;
        self.node = [left.corner[0] + column, left.corner[1] + row];
        match self.depth {
            0 => Node::Cell,
            1 => Node::Tile,
            _ => Node::Block,
        }
    }

    /// Looks at the nodes of the block that it has come to.
    #[inline(always)]
    fn block(&mut self, hierarchy: &Hierarchy) {
        let depth = self.depth - 1;
        if let Some(block) = hierarchy.levels()[depth - 1].block(self.node) {
            self.look(block, depth, self.corner());
        }
    }

    /// Looks at the cells of the tile that it has come to.
    #[inline(always)]
    fn tile(&mut self, hierarchy: &Hierarchy) {
        if let Some(tile) = hierarchy.tile(self.node) {
            self.look(&tile.cell_maxima(), 0, self.corner());
        }
    }

    /// The first column and row inside its node.
    #[inline(always)]
    fn corner(&self) -> [u32; 2] {
        self.node.map(|at| at * BLOCK as u32)
    }
}

/// The rays, by lanes, and the cells that they have come to.
pub(super) struct Strays {
    strays: [Stray; PathPacket::LEN],
    patches: Patches,
}

impl Strays {
    // Inlined, so that it is made in its place: to copy it takes a twentieth of a packet's time.
    #[inline(always)]
    pub fn new() -> Self {
        Self { strays: [Stray::default(); PathPacket::LEN], patches: Patches::default() }
    }

    /// Finds the first hits of some lanes, whose rays have nothing to do with each other.
    #[inline(always)]
    pub fn run<V: Vector>(
        &mut self,
        v: V,
        hierarchy: &Hierarchy,
        rays: &Rays<V>,
        lanes: u32,
        hits: &mut CellHits<V>,
    ) {
        let Self { strays, patches } = self;
        for lane in lanes_of(lanes) {
            let ray = rays[lane / V::F64_LANES].lane(lane % V::F64_LANES);
            strays[lane].begin(hierarchy, &ray);
        }
        hits.count(lanes, BLOCK_BYTES);
        let mut left = lanes;
        while left != 0 {
            let (mut going, mut cells) = (left, 0);
            while going != 0 {
                let mut turns = Turns::default();
                for lane in lanes_of(going) {
                    turns.add(strays[lane].advance(), lane);
                }
                let (blocks, tiles) = (turns.of(Node::Block), turns.of(Node::Tile));
                for lane in lanes_of(blocks) {
                    strays[lane].block(hierarchy);
                }
                for lane in lanes_of(tiles) {
                    strays[lane].tile(hierarchy);
                }
                hits.count(blocks, BLOCK_BYTES);
                hits.count(tiles, TILE_BYTES);
                going = blocks | tiles;
                cells |= turns.of(Node::Cell);
            }
            for lane in lanes_of(cells) {
                let cell = strays[lane].node;
                patches.set(lane, Patch::new(cell, hierarchy.corners(cell)));
            }
            hits.count(cells, CELL_BYTES);
            left = cells & !hits.cells(v, rays, patches, cells);
        }
    }
}
