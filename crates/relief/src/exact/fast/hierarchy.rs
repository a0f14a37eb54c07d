//! The heights in tiles, and the maxima above them.

use glam::Vec4;
use rayon::prelude::*;

use crate::HeightMap;

/// Texels along the side of a tile: 4 cells and their far edge.
pub(super) const TILE_TEXELS: usize = 5;

/// Cells along the side of a tile, and nodes along the side of a block.
pub(super) const BLOCK: usize = 4;

/// One side of a map's period in dual cells, and which cell of the map is the first.
#[derive(Clone, Copy, Debug)]
pub(super) struct Domain {
    /// Number of cells on each axis.
    pub cells: [usize; 2],
    /// The map's cell at `(0, 0)` of the domain, on both axes.
    pub first: i64,
}

/// Tiles of texels, and level by level the maxima of 4 x 4 nodes of the level below; the nodes of level 0 are the tiles.
#[derive(Clone, Debug)]
pub(super) struct Hierarchy {
    tiles: Vec<[f32; TILE_TEXELS * TILE_TEXELS]>,
    columns: usize,
    levels: Vec<Level>,
}

/// The maxima of one level, row by row. Both sides are multiples of 4; nodes without a tile are minus infinity.
#[derive(Clone, Debug)]
pub(super) struct Level {
    pub columns: usize,
    pub rows: usize,
    pub maxima: Vec<f32>,
}

impl Hierarchy {
    /// Tiles stand on cells `first`, `first + 4` and so on. Where the last ones reach beyond the domain they hold the map's
    /// continuation, so that what is found there is true.
    pub fn new(map: &HeightMap, domain: Domain) -> Self {
        let [columns, rows] = domain.cells.map(|cells| cells.div_ceil(BLOCK));
        let mut tiles = vec![[0.0; TILE_TEXELS * TILE_TEXELS]; columns * rows];
        tiles.par_chunks_mut(columns).enumerate().for_each(|(row, tiles)| {
            for (column, tile) in tiles.iter_mut().enumerate() {
                let left = domain.first + (column * BLOCK) as i64;
                let top = domain.first + (row * BLOCK) as i64;
                for (at, texel) in tile.iter_mut().enumerate() {
                    *texel = map.texel(left + (at % TILE_TEXELS) as i64, top + (at / TILE_TEXELS) as i64);
                }
            }
        });
        let mut level = Level::padded(columns, rows);
        let stride = level.columns;
        level.maxima.par_chunks_mut(stride).zip(tiles.par_chunks(columns)).for_each(|(nodes, tiles)| {
            for (node, tile) in nodes.iter_mut().zip(tiles) {
                *node = tile.iter().copied().fold(0.0, f32::max);
            }
        });
        let mut levels = Vec::new();
        while level.columns > BLOCK || level.rows > BLOCK {
            let above = level.above();
            levels.push(level);
            level = above;
        }
        levels.push(level);
        Self { tiles, columns, levels }
    }

    /// All levels, the finest first.
    pub fn levels(&self) -> &[Level] {
        &self.levels
    }

    /// The texels of the tile at a column and row of tiles.
    #[inline]
    pub fn tile(&self, column: usize, row: usize) -> Option<&[f32; TILE_TEXELS * TILE_TEXELS]> {
        self.tiles.get(row * self.columns + column)
    }

    /// The corners of a cell of the domain.
    pub fn corners(&self, column: usize, row: usize) -> [f32; 4] {
        match self.tile(column / BLOCK, row / BLOCK) {
            Some(tile) => corners(tile, column % BLOCK, row % BLOCK),
            None => [0.0; 4],
        }
    }
}

/// The corners `[h00, h10, h01, h11]` of a cell of a tile.
#[inline]
pub(super) fn corners(tile: &[f32; TILE_TEXELS * TILE_TEXELS], column: usize, row: usize) -> [f32; 4] {
    // The remainders tell the compiler that no index leaves the tile.
    let at = (row % BLOCK) * TILE_TEXELS + column % BLOCK;
    [tile[at], tile[at + 1], tile[at + TILE_TEXELS], tile[at + TILE_TEXELS + 1]]
}

impl Level {
    fn padded(columns: usize, rows: usize) -> Self {
        let (columns, rows) = (columns.next_multiple_of(BLOCK), rows.next_multiple_of(BLOCK));
        Self { columns, rows, maxima: vec![f32::NEG_INFINITY; columns * rows] }
    }

    fn above(&self) -> Self {
        let mut above = Self::padded(self.columns / BLOCK, self.rows / BLOCK);
        let stride = above.columns;
        above.maxima.par_chunks_mut(stride).zip(self.maxima.par_chunks(BLOCK * self.columns)).for_each(
            |(nodes, rows)| {
                for row in rows.chunks(self.columns) {
                    for (node, children) in nodes.iter_mut().zip(row.chunks(BLOCK)) {
                        *node = children.iter().copied().fold(*node, f32::max);
                    }
                }
            },
        );
        above
    }

    /// Four rows of four nodes from a column and row on, the last row first if asked. The caller keeps the window inside.
    #[inline]
    pub fn window(&self, column: usize, row: usize, upside_down: bool) -> [Vec4; BLOCK] {
        let flip = if upside_down { BLOCK - 1 } else { 0 };
        std::array::from_fn(|k| {
            let at = (row + (k ^ flip)) * self.columns + column;
            Vec4::from_slice(&self.maxima[at..at + BLOCK])
        })
    }
}

/// The maxima of a tile's cells as four rows, the last row first if asked.
#[inline]
pub(super) fn cell_maxima(tile: &[f32; TILE_TEXELS * TILE_TEXELS], upside_down: bool) -> [Vec4; BLOCK] {
    let rows: [Vec4; TILE_TEXELS] = std::array::from_fn(|k| {
        let at = TILE_TEXELS * if upside_down { BLOCK - k } else { k };
        Vec4::from_slice(&tile[at..]).max(Vec4::from_slice(&tile[at + 1..]))
    });
    std::array::from_fn(|k| rows[k].max(rows[k + 1]))
}
