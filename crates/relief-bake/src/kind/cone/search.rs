//! Every dual cell that may matter to a texel, and few others: a descent of the maximum pyramid.

use relief::{HeightMap, MaxPyramid, Wrap};

/// A bound is trusted to prune only when it is below by more than rounding, so that what is found does not depend on what
/// is looked at first.
pub(super) const MARGIN: f64 = 1.0 + 1e-9;

/// The map, its pyramid and the size of its texels.
pub(in crate::kind) struct Field<'a> {
    pub map: &'a HeightMap,
    pub texel_m: [f64; 2],
    pyramid: MaxPyramid,
    size: [i64; 2],
    /// How many tiles away, along either axis, a point may be nearer than the highest point of the nearest tiles.
    pub most_tiles: [i64; 2],
}

/// A dual cell as seen from a texel.
#[derive(Clone, Copy, Debug)]
pub(in crate::kind) struct Seen {
    /// Corner `h00` in texels from the texel's centre.
    pub offset: [i64; 2],
    /// The heights `h00 h10 h01 h11`.
    pub heights: [f64; 4],
}

/// The texel, its apexes' box and their lowest height.
#[derive(Clone, Copy, Debug)]
pub(in crate::kind) struct Viewer {
    /// Column and row.
    pub texel: [i64; 2],
    /// Half the side of the box of apexes, in texels.
    pub half: f64,
    /// Lowest apex.
    pub low: f64,
}

/// A node of the pyramid that is still to be looked into.
#[derive(Clone, Copy)]
pub(in crate::kind) struct Node {
    level: usize,
    at: [u32; 2],
    rise: f64,
    distance2: f64,
}

impl<'a> Field<'a> {
    pub fn new(map: &'a HeightMap, texel_m: [f64; 2]) -> Self {
        let size = [i64::from(map.width()), i64::from(map.height())];
        // Some image of the highest point is in the tile around an apex, and so not farther than a tile's diagonal.
        let tile_m = [0, 1].map(|axis| texel_m[axis] * size[axis] as f64);
        let diagonal = tile_m[0].hypot(tile_m[1]);
        let most_tiles = tile_m.map(|side| ((diagonal / side).ceil() + 1.0).min(1e6) as i64);
        Self { map, texel_m, pyramid: MaxPyramid::new(map), size, most_tiles }
    }

    /// How many images of the map may have to be looked at.
    pub fn most_images(&self) -> i64 {
        self.most_tiles.iter().map(|tiles| 2 * tiles + 1).product()
    }

    /// The cell at that offset from a texel, whether or not it is in the map.
    pub fn cell(&self, texel: [i64; 2], offset: [i64; 2]) -> Seen {
        let [i, j] = [texel[0] + offset[0], texel[1] + offset[1]];
        let heights = if i >= 0 && j >= 0 && i + 1 < self.size[0] && j + 1 < self.size[1] {
            // Inside nothing wraps, which is the costlier part of a read.
            let first = (j * self.size[0] + i) as usize;
            let texels = self.map.texels();
            let below = first + self.size[0] as usize;
            [texels[first], texels[first + 1], texels[below], texels[below + 1]].map(f64::from)
        } else {
            self.map.cell(i, j).map(f64::from)
        };
        Seen { offset, heights }
    }

    /// Calls `look` for every cell that may hold a point with a squared slope above `best` from an apex, which `look`
    /// raises, in the map and in its images at most so many tiles away. Returns the cell that raised it
    /// last; a cell returned for a texel nearby is a good seed.
    ///
    /// A map that does not repeat goes on for half a cell before its first texels, so that cell -1 comes with cell 0, which
    /// is as high. Images are looked at outward until their highest point is too far to matter.
    pub fn visit(
        &self,
        viewer: &Viewer,
        tiles: [i64; 2],
        best: &mut f64,
        seed: Option<[i64; 2]>,
        stack: &mut Vec<Node>,
        mut look: impl FnMut(&Seen, &mut f64),
    ) -> Option<[i64; 2]> {
        let mut raised_by = None;
        let mut leaf = |cell: [i64; 2], best: &mut f64| {
            let before = *best;
            let offset = [cell[0] - viewer.texel[0], cell[1] - viewer.texel[1]];
            look(&self.cell(viewer.texel, offset), best);
            if *best > before {
                raised_by = Some(cell);
            }
        };
        if let Some(cell) = seed {
            leaf(cell, best);
        }
        for y in 0..=tiles[1] {
            let mut is_row_open = false;
            for y in signs(y) {
                for x in 0..=tiles[0] {
                    let mut is_open = false;
                    for x in signs(x) {
                        is_open |= self.visit_tile(viewer, [x, y], best, stack, &mut leaf);
                    }
                    if !is_open {
                        break;
                    }
                    is_row_open = true;
                }
            }
            if !is_row_open {
                break;
            }
        }
        raised_by
    }

    /// Visits one image of the map; whether it is near enough to matter.
    fn visit_tile(
        &self,
        viewer: &Viewer,
        tile: [i64; 2],
        best: &mut f64,
        stack: &mut Vec<Node>,
        leaf: &mut impl FnMut([i64; 2], &mut f64),
    ) -> bool {
        let root = self.node(viewer, tile, self.pyramid.levels() - 1, [0, 0]);
        if is_pruned(root.rise, root.distance2, *best) {
            return false;
        }
        stack.clear();
        stack.push(root);
        while let Some(node) = stack.pop() {
            if is_pruned(node.rise, node.distance2, *best) {
                continue;
            }
            if node.level == 0 {
                let [columns, rows] = [0, 1].map(|axis| self.cells(tile, axis, node.at[axis], 0));
                for row in rows[0]..rows[1] {
                    for column in columns[0]..columns[1] {
                        leaf([column, row], best);
                    }
                }
                continue;
            }
            let level = node.level - 1;
            let [width, height] = self.pyramid.size(level).unwrap_or([0, 0]);
            let first = stack.len();
            for row in 2 * node.at[1]..(2 * node.at[1] + 2).min(height) {
                for column in 2 * node.at[0]..(2 * node.at[0] + 2).min(width) {
                    let child = self.node(viewer, tile, level, [column, row]);
                    if is_pruned(child.rise, child.distance2, *best) {
                        continue;
                    }
                    // The steepest is looked at first, so it comes last.
                    let is_steeper = |other: &Node| {
                        other.rise * other.rise * child.distance2 > child.rise * child.rise * other.distance2
                    };
                    let place = first + stack[first..].iter().take_while(|&other| !is_steeper(other)).count();
                    stack.insert(place, child);
                }
            }
        }
        true
    }

    /// The columns or rows of cells, from the first up to before the last, that a node bounds in an image of the map.
    #[inline]
    fn cells(&self, tile: [i64; 2], axis: usize, at: u32, level: usize) -> [i64; 2] {
        let size = self.size[axis];
        let from = i64::from(at) << level;
        let to = (from + (1 << level)).min(size);
        let wrap = self.map.wrap();
        let from = if from == 0 && wrap != Wrap::Repeat { -1 } else { from };
        if wrap == Wrap::Mirror && tile[axis] & 1 != 0 {
            // Mirrored, cell `i` lies between the texels `size - 1 - i` and `size - 2 - i`.
            let end = (tile[axis] + 1) * size - 1;
            [end - to, end - from]
        } else {
            [from + tile[axis] * size, to + tile[axis] * size]
        }
    }

    #[inline]
    fn node(&self, viewer: &Viewer, tile: [i64; 2], level: usize, at: [u32; 2]) -> Node {
        let width = self.pyramid.size(level).map_or(0, |size| size[0]) as usize;
        let highest = f64::from(self.pyramid.nodes(level)[at[1] as usize * width + at[0] as usize]);
        let distance = |axis: usize| {
            let [from, to] = self.cells(tile, axis, at[axis], level);
            let (from, to) = ((from - viewer.texel[axis]) as f64, (to - viewer.texel[axis]) as f64);
            (from - viewer.half).max(-viewer.half - to).max(0.0) * self.texel_m[axis]
        };
        let (x, y) = (distance(0), distance(1));
        Node { level, at, rise: (highest - viewer.low).max(0.0), distance2: x * x + y * y }
    }
}

/// A number and its opposite, zero once.
fn signs(n: i64) -> impl Iterator<Item = i64> {
    std::iter::once(n).chain((n != 0).then_some(-n))
}

/// Whether nothing that rises at most so much, at least so far away, is steeper than the squared slope `best`.
#[inline]
pub(in crate::kind) fn is_pruned(rise: f64, distance2: f64, best: f64) -> bool {
    rise <= 0.0 || rise * rise * MARGIN <= best * distance2
}
