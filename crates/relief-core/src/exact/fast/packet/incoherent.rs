//! Search of incoherent rays. Each descends the hierarchy by itself, and all take turns, a step at
//! a time.
//!
//! Each step of a ray depends on its previous step, but not on other rays. So the processor works
//! on several rays at once. A ray that has reached a cell waits until all have; then the cells are
//! solved in lanes.

use glam::Vec4;

use super::PathPacket;
use super::cell::{CellHits, Patch, Patches, Rays};
use super::vector::{Vector, lanes_of};
use crate::exact::CELL_BYTES;
use crate::exact::fast::hierarchy::{BLOCK, Hierarchy};
use crate::exact::fast::line::{Kind, Line, is_crosswise};
use crate::exact::fast::ray::TileRay;
use crate::exact::fast::traverse::{BLOCK_BYTES, MAX_LEVELS, TILE_BYTES};

/// Kind of a ray whose height is linear.
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

/// Remaining nodes of a block or a window.
#[derive(Clone, Copy, Default)]
struct Remaining {
    /// First column and row.
    corner: [u32; 2],
    /// Nodes that the ray touches and has not visited.
    nodes: u32,
}

/// A ray on its descent. Nodes of depth 0 are cells, nodes of depth 1 are tiles.
#[derive(Clone, Copy, Default)]
struct RayState {
    line: Line<Straight>,
    /// Remaining nodes by depth.
    left: [Remaining; MAX_LEVELS],
    /// Depths with remaining nodes, as bits.
    depths: u32,
    /// Current node and its depth.
    node: [u32; 2],
    depth: usize,
}

/// Kind of the current node of a ray.
#[derive(Clone, Copy)]
enum Node {
    Cell,
    Tile,
    /// A node above tiles.
    Block,
    /// No node remains.
    End,
}

/// Lanes whose rays have reached each kind of node. All are in one number, so that no lane waits
/// for the store of the previous one.
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

impl RayState {
    /// Begins the search of a ray by testing its window.
    #[inline(always)]
    fn begin(&mut self, hierarchy: &Hierarchy, ray: &TileRay) {
        let kind = Straight { falls: ray.height[1] < 0.0, crosswise: is_crosswise(ray) };
        self.line = Line::new(hierarchy, ray, kind);
        self.depths = 0;
        let Line { start_level, window, .. } = self.line;
        self.look(&hierarchy.levels()[start_level].window(window), start_level + 1, window);
    }

    /// Tests which of 4 x 4 nodes the ray touches.
    #[inline(always)]
    fn look(&mut self, maxima: &[Vec4; BLOCK], depth: usize, corner: [u32; 2]) {
        let edges = corner.map(|at| (at << (2 * depth)) as i32);
        let nodes = self.line.touched(maxima, edges, (1u32 << (2 * depth)) as f32);
        self.left[depth % MAX_LEVELS] = Remaining { corner, nodes };
        self.depths |= u32::from(nodes != 0) << depth;
    }

    /// Goes to the next node. There is no branch on the kind of the node, because the processor
    /// could not predict it.
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

    /// Tests the nodes of the current block.
    #[inline(always)]
    fn block(&mut self, hierarchy: &Hierarchy) {
        let depth = self.depth - 1;
        if let Some(block) = hierarchy.levels()[depth - 1].block(self.node) {
            self.look(block, depth, self.corner());
        }
    }

    /// Tests the cells of the current tile.
    #[inline(always)]
    fn tile(&mut self, hierarchy: &Hierarchy) {
        if let Some(tile) = hierarchy.tile(self.node) {
            self.look(&tile.cell_maxima(), 0, self.corner());
        }
    }

    /// First column and row inside the current node.
    #[inline(always)]
    fn corner(&self) -> [u32; 2] {
        self.node.map(|at| at * BLOCK as u32)
    }
}

/// Incoherent rays by lane, and the cells that they have reached.
pub(super) struct IncoherentRays {
    states: [RayState; PathPacket::LEN],
    patches: Patches,
}

impl IncoherentRays {
    // This is inlined, so that it is built in place. A copy takes a twentieth of a packet's time.
    #[inline(always)]
    pub fn new() -> Self {
        Self { states: [RayState::default(); PathPacket::LEN], patches: Patches::default() }
    }

    /// Finds the first hits of some lanes whose rays are incoherent.
    #[inline(always)]
    pub fn run<V: Vector>(
        &mut self,
        v: V,
        hierarchy: &Hierarchy,
        rays: &Rays<V>,
        lanes: u32,
        hits: &mut CellHits<V>,
    ) {
        let Self { states, patches } = self;
        for lane in lanes_of(lanes) {
            let ray = rays[lane / V::F64_LANES].lane(lane % V::F64_LANES);
            states[lane].begin(hierarchy, &ray);
        }
        hits.count(lanes, BLOCK_BYTES);
        let mut left = lanes;
        while left != 0 {
            let (mut going, mut cells) = (left, 0);
            while going != 0 {
                let mut turns = Turns::default();
                for lane in lanes_of(going) {
                    turns.add(states[lane].advance(), lane);
                }
                let (blocks, tiles) = (turns.of(Node::Block), turns.of(Node::Tile));
                for lane in lanes_of(blocks) {
                    states[lane].block(hierarchy);
                }
                for lane in lanes_of(tiles) {
                    states[lane].tile(hierarchy);
                }
                hits.count(blocks, BLOCK_BYTES);
                hits.count(tiles, TILE_BYTES);
                going = blocks | tiles;
                cells |= turns.of(Node::Cell);
            }
            for lane in lanes_of(cells) {
                let cell = states[lane].node;
                patches.set(lane, Patch::new(cell, hierarchy.corners(cell)));
            }
            hits.count(cells, CELL_BYTES);
            left = cells & !hits.cells(v, rays, patches, cells);
        }
    }
}
