//! Maximum and minimum pyramids over the dual cells of a height map.
//!
//! Tevs, Ihrke and Seidel 2008 ("Maximum mipmaps") and the pyramids of quadtree displacement
//! mapping take maxima over texels. These do not bound the bilinear surface between the texels.
//! Here level 0 holds the maxima over dual cells.

use std::convert::Infallible;
use std::sync::atomic::{AtomicUsize, Ordering};

use rayon::prelude::*;

use crate::{Cancelled, HeightMap, Watch, Wrap};

/// Upper bounds of the bilinear surface over squares of `2^k` by `2^k` dual cells.
///
/// * Level 0 has the size `W x H` of the map. Node `(i, j)` is the highest of the four texels
///   around dual cell `(i, j)`, wrapped as the map is. A bilinear patch never rises above its
///   corners, so this is a bound, and a tight one.
/// * Level `k + 1` has half the size of level `k`, rounded *up*. Node `(i, j)` is the highest of
///   the nodes `(2i, 2j)` to `(2i + 1, 2j + 1)` of level `k` that exist. So node `(i, j)` of level
///   `k` covers the cells `i 2^k .. (i + 1) 2^k` that are below `W`, and rows likewise. Nothing is
///   padded. (Texture mipmaps round down instead.)
/// * The last level is one node.
/// * Cells outside `0..W` are mapped to nodes by [`Self::column`]. The half cells before texel 0 of
///   a clamped or mirrored map (cell -1) are bounded by cell 0.
///
/// The pyramid takes 4/3 of the map's texels, as `f32`.
#[derive(Clone, Debug, PartialEq)]
pub struct MaxPyramid {
    wrap: Wrap,
    levels: Vec<PyramidLevel>,
}

/// Lower bounds of the bilinear surface over squares of `2^k` by `2^k` dual cells: like
/// [`MaxPyramid`], with the lowest texels. Levels, sizes and the cells of each node are equal.
#[derive(Clone, Debug, PartialEq)]
pub struct MinPyramid {
    wrap: Wrap,
    levels: Vec<PyramidLevel>,
}

#[derive(Clone, Debug, PartialEq)]
struct PyramidLevel {
    width: u32,
    height: u32,
    nodes: Vec<f32>,
}

impl MaxPyramid {
    /// Builds the pyramid of a map. Rows are built in parallel; the result does not depend on the
    /// number of threads.
    pub fn new(map: &HeightMap) -> Self {
        let Ok(levels) = levels(map, higher, |_| Ok::<(), Infallible>(()));
        Self { wrap: map.wrap(), levels }
    }

    /// Builds the pyramid as [`new`](Self::new), and reports progress to `watch`.
    ///
    /// # Errors
    ///
    /// When the work is cancelled.
    pub fn watched(map: &HeightMap, watch: &Watch) -> Result<Self, Cancelled> {
        Ok(Self { wrap: map.wrap(), levels: levels(map, higher, |part| watch.at(part))? })
    }

    /// Extends the nodes so that they also bound the coarser mip [levels](HeightMap::level) of the
    /// map.
    ///
    /// For the map's level `l`, node `(i, j)` of level `k > l` covers the cells from `i 2^(k - l)`
    /// up to `(i + 1) 2^(k - l)` that exist, counted in that level, and rows likewise. So the nodes
    /// from level `l + 1` on are a pyramid over the map's level `l`, and are traversed in the same
    /// way.
    ///
    /// A texel of a coarser level lies half a texel of that level beside the finest cells of the
    /// same numbers. So the bounds of the finest level are a little less tight. The pyramid's two
    /// finest levels do not change.
    #[must_use]
    pub fn over_levels(mut self, map: &HeightMap) -> Self {
        reach_over_levels(&mut self.levels, map, higher);
        self
    }

    /// The number of levels, at least 1.
    pub fn levels(&self) -> usize {
        self.levels.len()
    }

    /// Width and height of a level in nodes; `None` for a level that does not exist.
    pub fn size(&self, level: usize) -> Option<[u32; 2]> {
        self.levels.get(level).map(|level| [level.width, level.height])
    }

    /// The nodes of a level, row by row; empty for a level that does not exist.
    pub fn nodes(&self, level: usize) -> &[f32] {
        self.levels.get(level).map_or(&[], |level| &level.nodes)
    }

    /// Highest point of the surface.
    pub fn highest(&self) -> f32 {
        self.levels.last().map_or(0.0, |top| top.nodes[0])
    }

    /// Column of level 0 whose nodes bound column `cell` of dual cells, which may lie outside the
    /// map.
    pub fn column(&self, cell: i64) -> u32 {
        fold(self.wrap, cell, self.levels[0].width)
    }

    /// Row of level 0 whose nodes bound row `cell` of dual cells, which may lie outside the map.
    pub fn row(&self, cell: i64) -> u32 {
        fold(self.wrap, cell, self.levels[0].height)
    }

    /// Returns an upper bound of the surface over the dual cells from `first` to `last`, both
    /// included, and the number of nodes read. The cell numbers are not wrapped. `first` must not
    /// exceed `last` on either axis.
    ///
    /// It reads the finest level at which few nodes suffice: at most 3 by 3, or 6 by 6 across the
    /// edges of a repeated map. These nodes may cover more cells, so the bound need not be tight.
    /// Over a single cell of the map it is tight.
    pub fn bound(&self, first: [i64; 2], last: [i64; 2]) -> (f32, u32) {
        bound(&self.levels, self.wrap, first, last, higher)
    }
}

impl MinPyramid {
    /// Builds the pyramid of a map. Rows are built in parallel; the result does not depend on the
    /// number of threads.
    pub fn new(map: &HeightMap) -> Self {
        let Ok(levels) = levels(map, lower, |_| Ok::<(), Infallible>(()));
        Self { wrap: map.wrap(), levels }
    }

    /// Builds the pyramid as [`new`](Self::new), and reports progress to `watch`.
    ///
    /// # Errors
    ///
    /// When the work is cancelled.
    pub fn watched(map: &HeightMap, watch: &Watch) -> Result<Self, Cancelled> {
        Ok(Self { wrap: map.wrap(), levels: levels(map, lower, |part| watch.at(part))? })
    }

    /// Extends the nodes so that they also bound the coarser mip levels of the map: see
    /// [`MaxPyramid::over_levels`].
    #[must_use]
    pub fn over_levels(mut self, map: &HeightMap) -> Self {
        reach_over_levels(&mut self.levels, map, lower);
        self
    }

    /// The number of levels, at least 1.
    pub fn levels(&self) -> usize {
        self.levels.len()
    }

    /// Width and height of a level in nodes; `None` for a level that does not exist.
    pub fn size(&self, level: usize) -> Option<[u32; 2]> {
        self.levels.get(level).map(|level| [level.width, level.height])
    }

    /// The nodes of a level, row by row; empty for a level that does not exist.
    pub fn nodes(&self, level: usize) -> &[f32] {
        self.levels.get(level).map_or(&[], |level| &level.nodes)
    }

    /// Lowest point of the surface.
    pub fn lowest(&self) -> f32 {
        self.levels.last().map_or(0.0, |top| top.nodes[0])
    }

    /// Returns a lower bound of the surface over the dual cells from `first` to `last`, and the
    /// number of nodes read: see [`MaxPyramid::bound`].
    pub fn bound(&self, first: [i64; 2], last: [i64; 2]) -> (f32, u32) {
        bound(&self.levels, self.wrap, first, last, lower)
    }
}

/// Returns the `pick` of the nodes of the finest level at which few cover the cells from `first` to
/// `last`, and their number.
fn bound(
    levels: &[PyramidLevel],
    wrap: Wrap,
    first: [i64; 2],
    last: [i64; 2],
    pick: impl Fn(f32, f32) -> f32 + Copy,
) -> (f32, u32) {
    let columns = folded_ranges(wrap, first[0], last[0], levels[0].width);
    let rows = folded_ranges(wrap, first[1], last[1], levels[0].height);
    let longest = columns.iter().chain(&rows).flatten().map(|[a, b]| b - a).max().unwrap_or(0);
    let index = (u32::BITS - longest.leading_zeros()).saturating_sub(1).min(levels.len() as u32 - 1);
    let level = &levels[index as usize];
    let (mut bound, mut reads) = (None, 0);
    for [top, bottom] in rows.into_iter().flatten() {
        for [left, right] in columns.into_iter().flatten() {
            for row in top >> index..=bottom >> index {
                let start = row as usize * level.width as usize;
                let nodes =
                    &level.nodes[start + (left >> index) as usize..=start + (right >> index) as usize];
                bound = nodes.iter().copied().chain(bound).reduce(pick);
                reads += nodes.len() as u32;
            }
        }
    }
    (bound.unwrap_or(0.0), reads)
}

/// Higher of two heights that are not NaN. It is one instruction, while `f32::max` takes several.
fn higher(a: f32, b: f32) -> f32 {
    if a > b { a } else { b }
}

/// Lower of two heights that are not NaN.
fn lower(a: f32, b: f32) -> f32 {
    if a < b { a } else { b }
}

/// Nodes built between two calls of `at`: well below a millisecond of work.
const NODES_A_CALL: usize = 1 << 18;

/// Builds all levels. A node is the `pick` of the nodes or texels that it covers. The two finest
/// levels are built together, while their rows are cached.
fn levels<E: Send>(
    map: &HeightMap,
    pick: impl Fn(f32, f32) -> f32 + Copy + Sync,
    at: impl Fn(f32) -> Result<(), E> + Sync,
) -> Result<Vec<PyramidLevel>, E> {
    let mut finest = PyramidLevel::empty(map.width(), map.height());
    let mut next = finest.empty_half();
    let (width, half) = (finest.width as usize, next.width as usize);
    let pairs = (NODES_A_CALL / (2 * width)).max(1);
    let done = AtomicUsize::new(0);
    let texels = finest.nodes.len();
    finest
        .nodes
        .par_chunks_mut(2 * width * pairs)
        .zip(next.nodes.par_chunks_mut(half * pairs))
        .enumerate()
        .try_for_each(|(band, (nodes, above))| {
        for (pair, (nodes, above)) in nodes.chunks_mut(2 * width).zip(above.chunks_mut(half)).enumerate() {
            for (row, nodes) in nodes.chunks_mut(width).enumerate() {
                pick_cells(map, 2 * (band * pairs + pair) + row, nodes, pick);
            }
            pick_children(nodes, width, above, pick);
        }
        let done = done.fetch_add(nodes.len(), Ordering::Relaxed) + nodes.len();
        at(done as f32 / texels as f32)
    })?;
    let mut levels = if finest.nodes.len() > 1 { vec![finest, next] } else { vec![finest] };
    while let Some(top) = levels.last()
        && top.nodes.len() > 1
    {
        let above = top.halved(pick);
        levels.push(above);
    }
    Ok(levels)
}

/// Extends every node by the `pick` of the cells that it covers in the map's coarser levels. A node
/// includes its children. New at each level of nodes are two by two cells of the map's previous
/// level.
fn reach_over_levels(
    levels: &mut [PyramidLevel],
    map: &HeightMap,
    pick: impl Fn(f32, f32) -> f32 + Copy + Sync,
) {
    for k in 2..levels.len() {
        let cells = PyramidLevel::over_cells(&map.level(k as u32 - 1), pick).halved(pick);
        let (below, above) = levels.split_at_mut(k);
        let (children, nodes) = (&below[k - 1], &mut above[0]);
        let width = nodes.width as usize;
        nodes
            .nodes
            .par_chunks_mut(width)
            .zip(children.nodes.par_chunks(2 * children.width as usize))
            .for_each(|(nodes, rows)| pick_children(rows, children.width as usize, nodes, pick));
        // Sides of the map's levels are rounded down, sides of the pyramid's levels up. So the last
        // node may have no cells.
        let rows = nodes.nodes.par_chunks_mut(width).zip(cells.nodes.par_chunks(cells.width as usize));
        rows.for_each(|(nodes, cells)| {
            for (node, cell) in nodes.iter_mut().zip(cells) {
                *node = pick(*node, *cell);
            }
        });
    }
}

/// Builds one row of level 0.
fn pick_cells(map: &HeightMap, row: usize, nodes: &mut [f32], pick: impl Fn(f32, f32) -> f32) {
    let texels = |row: u32| {
        let start = row as usize * nodes.len();
        &map.texels()[start..start + nodes.len()]
    };
    let wrapped = |index: usize, size: u32| map.wrap().index(index as i64, size);
    let (top, bottom) = (texels(row as u32), texels(wrapped(row + 1, map.height())));
    let last = nodes.len() - 1;
    let beyond = wrapped(nodes.len(), map.width()) as usize;
    nodes[last] = pick(pick(top[last], top[beyond]), pick(bottom[last], bottom[beyond]));
    let lines = top.iter().zip(&top[1..]).zip(bottom.iter().zip(&bottom[1..]));
    for (node, ((h00, h10), (h01, h11))) in nodes.iter_mut().zip(lines) {
        *node = pick(pick(*h00, *h10), pick(*h01, *h11));
    }
}

/// Builds a row of nodes from the one or two rows below it.
fn pick_children(rows: &[f32], below: usize, nodes: &mut [f32], pick: impl Fn(f32, f32) -> f32) {
    let (top, bottom) = rows.split_at(below);
    let bottom = if bottom.is_empty() { top } else { bottom };
    for (node, (a, b)) in nodes.iter_mut().zip(top.chunks_exact(2).zip(bottom.chunks_exact(2))) {
        *node = pick(pick(a[0], a[1]), pick(b[0], b[1]));
    }
    if below % 2 == 1 {
        nodes[below / 2] = pick(top[below - 1], bottom[below - 1]);
    }
}

impl PyramidLevel {
    fn empty(width: u32, height: u32) -> Self {
        Self { width, height, nodes: vec![0.0; width as usize * height as usize] }
    }

    /// Level 0 of a map's pyramid.
    fn over_cells(map: &HeightMap, pick: impl Fn(f32, f32) -> f32 + Copy + Sync) -> Self {
        let mut level = Self::empty(map.width(), map.height());
        let rows = level.nodes.par_chunks_mut(map.width() as usize).enumerate();
        rows.for_each(|(row, nodes)| pick_cells(map, row, nodes, pick));
        level
    }

    fn empty_half(&self) -> Self {
        Self::empty(self.width.div_ceil(2), self.height.div_ceil(2))
    }

    fn halved(&self, pick: impl Fn(f32, f32) -> f32 + Copy + Sync) -> Self {
        let mut above = self.empty_half();
        let (below, width) = (self.width as usize, above.width as usize);
        above
            .nodes
            .par_chunks_mut(width)
            .zip(self.nodes.par_chunks(2 * below))
            .with_min_len((NODES_A_CALL / width).max(1) / 16 + 1)
            .for_each(|(nodes, rows)| pick_children(rows, below, nodes, pick));
        above
    }
}

/// Dual cell in `0..size` whose corners include the corners of `cell`, along one axis.
fn fold(wrap: Wrap, cell: i64, size: u32) -> u32 {
    let size = i64::from(size);
    let folded = match wrap {
        Wrap::Repeat => cell.rem_euclid(size),
        Wrap::Clamp => cell.clamp(0, size - 1),
        Wrap::Mirror => {
            let cell = cell.rem_euclid(2 * size);
            // Cell `size + k` lies between the texels `size - 1 - k` and `size - 2 - k`.
            if cell < size { cell } else { (2 * size - 2 - cell).max(0) }
        }
    };
    folded as u32
}

/// Ranges, both ends included, of the cells to which `fold` maps `first..=last`.
fn folded_ranges(wrap: Wrap, first: i64, last: i64, size: u32) -> [Option<[u32; 2]>; 2] {
    let all = [Some([0, size - 1]), None];
    let (a, b) = (fold(wrap, first, size), fold(wrap, last, size));
    let span = last.saturating_sub(first);
    let signed = i64::from(size);
    match wrap {
        Wrap::Clamp => [Some([a, b]), None],
        Wrap::Repeat if span >= signed => all,
        Wrap::Repeat if a <= b => [Some([a, b]), None],
        Wrap::Repeat => [Some([a, size - 1]), Some([0, b])],
        Wrap::Mirror if span >= 2 * signed => all,
        Wrap::Mirror => {
            // Folding reverses direction at the cells `size - 1` and `2 size - 1` of every period.
            let start = first.rem_euclid(2 * signed);
            let turns = |at: i64| (at - start).rem_euclid(2 * signed) <= span;
            let low = if turns(2 * signed - 1) { 0 } else { a.min(b) };
            let high = if turns(signed - 1) { size - 1 } else { a.max(b) };
            [Some([low, high]), None]
        }
    }
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::AtomicBool;

    use super::*;

    /// Uneven heights without a pattern that wrapping could hide.
    fn rough(width: u32, height: u32, wrap: Wrap) -> HeightMap {
        HeightMap::from_fn(width, height, wrap, |i, j| {
            let bits = (i.wrapping_mul(0x9e37_79b9) ^ j.wrapping_mul(0x85eb_ca6b)).wrapping_mul(0xc2b2_ae35);
            (bits >> 8) as f32 / (1u32 << 24) as f32
        })
        .expect("a valid map")
    }

    const SIZES: [(u32, u32); 9] =
        [(1, 1), (1, 7), (7, 1), (2, 2), (3, 5), (8, 8), (13, 9), (16, 5), (17, 33)];

    /// First dual cell, up to three tiles away, that is above the node meant to bound it.
    fn first_escape(map: &HeightMap, pyramid: &MaxPyramid) -> Option<[i64; 2]> {
        let (w, h) = (i64::from(map.width()), i64::from(map.height()));
        for j in -3 * h - 1..=4 * h {
            for i in -3 * w - 1..=4 * w {
                let highest = map.cell(i, j).into_iter().fold(0.0, f32::max);
                for level in 0..pyramid.levels() {
                    let [width, _] = pyramid.size(level)?;
                    let (column, row) = (pyramid.column(i) >> level, pyramid.row(j) >> level);
                    if pyramid.nodes(level)[(row * width + column) as usize] < highest {
                        return Some([i, j]);
                    }
                }
            }
        }
        None
    }

    #[test]
    fn every_node_bounds_the_surface_under_it() {
        for wrap in Wrap::ALL {
            for (width, height) in SIZES {
                let map = rough(width, height, wrap);
                let pyramid = MaxPyramid::new(&map);
                assert_eq!(first_escape(&map, &pyramid), None, "{wrap} {width}x{height}");
                let highest = map.texels().iter().copied().fold(0.0, f32::max);
                assert_eq!(pyramid.highest(), highest, "the top node is the maximum");
            }
        }
    }

    #[test]
    fn a_lowered_node_is_noticed() {
        for wrap in Wrap::ALL {
            let map = rough(13, 9, wrap);
            for level in 0..MaxPyramid::new(&map).levels() {
                let mut pyramid = MaxPyramid::new(&map);
                let node = &mut pyramid.levels[level].nodes[0];
                *node *= 0.5;
                assert!(first_escape(&map, &pyramid).is_some(), "{wrap}, level {level}");
            }
        }
    }

    #[test]
    fn minima_mirror_maxima() {
        for wrap in Wrap::ALL {
            for (width, height) in SIZES {
                // Multiples of 2⁻²⁴, so that 1 - h is exact.
                let map = rough(width, height, wrap);
                let upside_down: Vec<f32> = map.texels().iter().map(|texel| 1.0 - texel).collect();
                let upside_down = HeightMap::new(width, height, upside_down, wrap).expect("a valid map");
                let (min, max) = (MinPyramid::new(&map), MaxPyramid::new(&upside_down));
                assert_eq!(min.levels(), max.levels());
                for level in 0..min.levels() {
                    assert_eq!(min.size(level), max.size(level));
                    let mirrored: Vec<f32> = max.nodes(level).iter().map(|node| 1.0 - node).collect();
                    assert_eq!(min.nodes(level), mirrored, "{wrap} {width}x{height}, level {level}");
                }
                assert_eq!(min.lowest(), 1.0 - max.highest());
                for (first, last) in [([0, 0], [0, 0]), ([-2, 1], [4, 3]), ([-40, -9], [70, 2])] {
                    let (low, reads) = min.bound(first, last);
                    let (high, as_many) = max.bound(first, last);
                    assert_eq!((low, reads), (1.0 - high, as_many), "{wrap} {width}x{height}: {first:?}");
                }
            }
        }
    }

    #[test]
    fn a_cancelled_build_ends() {
        let map = rough(600, 700, Wrap::Repeat);
        let cancel = AtomicBool::new(false);
        let tell = |_: &str, part: f32| cancel.store(part > 0.5, Ordering::Relaxed);
        // One thread: of several, all may have asked for the last time before any reports its part.
        let one = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("a thread can be started");
        let built = one.install(|| MaxPyramid::watched(&map, &Watch::new(&tell, &cancel)));
        assert_eq!(built, Err(Cancelled));
        assert_eq!(MinPyramid::watched(&map, &Watch::none()), Ok(MinPyramid::new(&map)));
    }

    #[test]
    fn the_bound_of_a_range_is_that_of_its_cells_or_above() {
        for wrap in Wrap::ALL {
            for (width, height) in SIZES {
                let map = rough(width, height, wrap);
                let pyramid = MaxPyramid::new(&map);
                let (w, h) = (i64::from(width), i64::from(height));
                for first in -2 * w - 1..=2 * w + 1 {
                    for length in [0, 1, 2, w - 1, w, 2 * w - 1, 2 * w, 5 * w] {
                        let row = first.rem_euclid(2 * h + 3) - h;
                        let last_row = row + length % 3;
                        let (bound, reads) = pyramid.bound([first, row], [first + length, last_row]);
                        let highest = (row..=last_row)
                            .flat_map(|j| (first..=first + length).map(move |i| (i, j)))
                            .flat_map(|(i, j)| map.cell(i, j))
                            .fold(0.0, f32::max);
                        assert!(bound >= highest, "{wrap} {width}x{height}: {first}+{length}, row {row}");
                        assert!((1..=36).contains(&reads));
                    }
                }
                assert_eq!(pyramid.bound([0, 0], [0, 0]).0, map.cell(0, 0).into_iter().fold(0.0, f32::max));
            }
        }
    }
}
