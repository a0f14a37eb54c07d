//! Heights in tiles, and the hierarchy of maxima above them.

use glam::Vec4;
use rayon::prelude::*;

use crate::HeightMap;

/// Cells along the side of a tile, and nodes along the side of a block.
pub(super) const BLOCK: usize = 4;

/// Texels along the side of a tile: its cells and their far edge.
const TILE_TEXELS: usize = BLOCK + 1;

/// One period of the map in dual cells, and the map's cell at its beginning.
#[derive(Clone, Copy, Debug)]
pub(super) struct Domain {
    /// Number of cells on each axis.
    pub cells: [usize; 2],
    /// Number of the map's cell at `(0, 0)` of the domain, on both axes.
    pub first: i64,
}

/// Texels of 4 x 4 cells, row by row.
#[derive(Clone, Copy, Debug)]
pub(super) struct Tile {
    texels: [f32; TILE_TEXELS * TILE_TEXELS],
}

/// Tiles of texels, and levels of maxima over 4 x 4 nodes of the level below. The nodes of level 0
/// are the tiles.
#[derive(Clone, Debug)]
pub(super) struct Hierarchy {
    tiles: Vec<Tile>,
    columns: usize,
    levels: Vec<MaximaLevel>,
}

/// Maxima of one level. Both sides are multiples of 4; nodes without a tile are minus infinity.
///
/// They are stored twice: block by block for the descent, and row by row for windows that do not
/// begin at a block.
#[derive(Clone, Debug)]
pub(super) struct MaximaLevel {
    /// Columns and rows of nodes.
    pub sides: [u32; 2],
    rows: Vec<f32>,
    blocks: Vec<[Vec4; BLOCK]>,
}

impl Tile {
    /// Corners `[h00, h10, h01, h11]` of the cell in a column and row of the tile.
    #[inline(always)]
    pub fn corners(&self, [column, row]: [u32; 2]) -> [f32; 4] {
        // The remainders show the compiler that no index leaves the tile.
        let at = (row as usize % BLOCK) * TILE_TEXELS + column as usize % BLOCK;
        let t = &self.texels;
        [t[at], t[at + 1], t[at + TILE_TEXELS], t[at + TILE_TEXELS + 1]]
    }

    /// Maxima of the cells, row by row.
    #[inline(always)]
    pub fn cell_maxima(&self) -> [Vec4; BLOCK] {
        let pairs = |row: usize| {
            let at = row * TILE_TEXELS;
            Vec4::from_slice(&self.texels[at..]).max(Vec4::from_slice(&self.texels[at + 1..]))
        };
        let (a, b, c, d, e) = (pairs(0), pairs(1), pairs(2), pairs(3), pairs(4));
        [a.max(b), b.max(c), c.max(d), d.max(e)]
    }
}

impl Hierarchy {
    /// Builds the hierarchy. Tiles begin at the cells `first`, `first + 4` and so on. The last
    /// tiles may reach beyond the domain; there they hold the map's continuation, so that hits in
    /// them are correct.
    pub fn new(map: &HeightMap, domain: Domain) -> Self {
        let [columns, rows] = domain.cells.map(|cells| cells.div_ceil(BLOCK));
        let mut tiles = vec![Tile { texels: [0.0; TILE_TEXELS * TILE_TEXELS] }; columns * rows];
        tiles.par_chunks_mut(columns).enumerate().for_each(|(row, tiles)| {
            for (column, tile) in tiles.iter_mut().enumerate() {
                let left = domain.first + (column * BLOCK) as i64;
                let top = domain.first + (row * BLOCK) as i64;
                for (at, texel) in tile.texels.iter_mut().enumerate() {
                    *texel = map.texel(left + (at % TILE_TEXELS) as i64, top + (at / TILE_TEXELS) as i64);
                }
            }
        });
        let maxima = tiles.par_iter().map(|tile| tile.texels.iter().copied().fold(0.0, f32::max)).collect();
        let mut levels = vec![MaximaLevel::new(columns, rows, maxima)];
        while let Some(above) = levels.last().and_then(MaximaLevel::above) {
            levels.push(above);
        }
        Self { tiles, columns, levels }
    }

    /// All levels, the finest first. There is at least one.
    #[inline(always)]
    pub fn levels(&self) -> &[MaximaLevel] {
        &self.levels
    }

    /// Tile at a column and row of tiles.
    #[inline(always)]
    pub fn tile(&self, [column, row]: [u32; 2]) -> Option<&Tile> {
        self.tiles.get(row as usize * self.columns + column as usize)
    }

    /// Corners of a cell of the domain.
    pub fn corners(&self, [column, row]: [u32; 2]) -> [f32; 4] {
        let side = BLOCK as u32;
        self.tile([column / side, row / side])
            .map_or([0.0; 4], |tile| tile.corners([column % side, row % side]))
    }
}

impl MaximaLevel {
    /// Creates a level from nodes given row by row.
    fn new(columns: usize, rows: usize, maxima: Vec<f32>) -> Self {
        let sides = [columns.next_multiple_of(BLOCK), rows.next_multiple_of(BLOCK)];
        let mut padded = vec![f32::NEG_INFINITY; sides[0] * sides[1]];
        for (to, from) in padded.chunks_mut(sides[0]).zip(maxima.chunks(columns)) {
            to[..columns].copy_from_slice(from);
        }
        let across = sides[0] / BLOCK;
        let block = |at: usize| {
            let first = at / across * BLOCK * sides[0] + at % across * BLOCK;
            std::array::from_fn(|row| Vec4::from_slice(&padded[first + row * sides[0]..]))
        };
        let blocks = (0..across * (sides[1] / BLOCK)).map(block).collect();
        Self { sides: sides.map(|side| side as u32), rows: padded, blocks }
    }

    /// Level above this one; `None` above a single block.
    fn above(&self) -> Option<Self> {
        let [columns, rows] = self.sides.map(|side| side as usize / BLOCK);
        let maxima = self.blocks.iter().map(|[a, b, c, d]| a.max(*b).max(c.max(*d)).max_element()).collect();
        (columns * rows > 1).then(|| Self::new(columns, rows, maxima))
    }

    /// Block at a column and row of blocks.
    #[inline(always)]
    pub fn block(&self, [column, row]: [u32; 2]) -> Option<&[Vec4; BLOCK]> {
        self.blocks.get(row as usize * (self.sides[0] as usize / BLOCK) + column as usize)
    }

    /// Maximum at a column and row, which must be inside. Only packets call it.
    #[cfg(target_arch = "x86_64")]
    #[inline(always)]
    pub fn node(&self, [column, row]: [u32; 2]) -> f32 {
        self.rows[row as usize * self.sides[0] as usize + column as usize]
    }

    /// Four rows of four nodes, from a column and row on. All of them must be inside.
    #[inline(always)]
    pub fn window(&self, [column, row]: [u32; 2]) -> [Vec4; BLOCK] {
        let stride = self.sides[0] as usize;
        let nodes = &self.rows[row as usize * stride + column as usize..];
        let row = |k: usize| Vec4::from_slice(&nodes[k * stride..]);
        [row(0), row(1), row(2), row(3)]
    }
}
