//! Sorting of triangles into the tiles of an area.

use pulp::{Simd, WithSimd};

use super::view::{Planes, Projected, Side, View};
use super::{TILE, TileCaster};
use crate::raycast::RayCaster;

/// Most triangles per tile, on average, that an area may show, and half of the triangles tested for
/// it. With more, all rays of the area are cast one by one, because projecting the triangles takes
/// as long.
const MOST_IN_MEAN: usize = 128;

/// Most triangles of a tile, and average per tile of an area. With more, the tile's rays are cast
/// one by one, which is faster then.
const MOST_OF_TILE: usize = 512;

/// A range of a picture's pixels.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Area {
    /// Column and row of the upper left pixel.
    pub first: [u32; 2],
    /// Columns and rows.
    pub size: [u32; 2],
}

impl Area {
    /// Number of tiles along each side. The last ones may reach beyond the area.
    pub fn tiles(&self) -> [u32; 2] {
        self.size.map(|side| side.div_ceil(TILE as u32))
    }

    /// Upper left pixel of a tile, by its number along each side.
    pub fn pixel(&self, tile: [u32; 2]) -> [u32; 2] {
        [0, 1].map(|axis| self.first[axis] + tile[axis] * TILE as u32)
    }
}

/// Lists of the triangles that the tiles of an area may show. Their memory is reused for the next
/// area.
#[derive(Clone, Debug, Default)]
pub struct Bins {
    area: Area,
    /// Whether the lists are filled.
    is_binned: bool,
    /// Triangles within the area.
    covers: Vec<Cover>,
    /// Triangles that reach beside or behind the eye.
    through: Vec<u32>,
    /// End of the list of each tile. A list begins at the end of the previous one.
    ends: Vec<u32>,
    entries: Vec<Entry>,
    waiting: Vec<(u32, Side)>,
}

/// A triangle of an area.
#[derive(Clone, Copy, Debug)]
struct Cover {
    triangle: u32,
    /// First and last column, and first and last row, in the area of the rays that may hit it.
    columns: [u32; 2],
    rows: [u32; 2],
}

/// A triangle of a tile.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Entry {
    pub triangle: u32,
    /// First and last column, and first and last row, in the tile of the rays that may hit it.
    pub columns: [u8; 2],
    pub rows: [u8; 2],
}

impl Bins {
    /// Most memory for each tile of the largest area that the bins were filled for, in bytes. It
    /// counts the longest lists, in vectors of twice the length. If triangles are as fine as
    /// pixels, a tenth of it is used.
    pub const MOST_BYTES_PER_TILE: usize =
        2 * (2 * MOST_IN_MEAN * size_of::<Cover>() + MOST_OF_TILE * (size_of::<Entry>() + 16));

    /// Creates empty bins.
    pub fn new() -> Self {
        Self::default()
    }

    /// Area of the bins.
    pub fn area(&self) -> Area {
        self.area
    }

    /// List of a tile. `None` if its rays must be cast one by one.
    pub(super) fn entries(&self, tile: [u32; 2]) -> Option<&[Entry]> {
        if !self.is_binned {
            return None;
        }
        let number = tile[0] as usize + tile[1] as usize * self.area.tiles()[0] as usize;
        let start = number.checked_sub(1).map_or(Some(&0), |before| self.ends.get(before))?;
        let entries = self.entries.get(*start as usize..*self.ends.get(number)? as usize)?;
        (entries.len() <= MOST_OF_TILE).then_some(entries)
    }

    /// Memory of the bins, in bytes.
    pub fn bytes(&self) -> usize {
        self.covers.capacity() * size_of::<Cover>()
            + self.entries.capacity() * size_of::<Entry>()
            + self.waiting.capacity() * size_of::<(u32, Side)>()
            + (self.through.capacity() + self.ends.capacity()) * size_of::<u32>()
    }

    /// Removes a triangle from all lists, to test that this is noticed.
    #[cfg(test)]
    pub(super) fn forget(&mut self, triangle: u32) {
        for entry in &mut self.entries {
            if entry.triangle == triangle {
                entry.rows = [1, 0];
            }
        }
    }

    /// Limit for the whole area, from a limit per tile.
    fn most(&self, of_tile: usize) -> usize {
        let [across, down] = self.area.tiles().map(|side| side as usize);
        across.saturating_mul(down).saturating_mul(of_tile).min(u32::MAX as usize)
    }

    fn clear(&mut self, area: Area) {
        self.area = area;
        self.is_binned = false;
        self.covers.clear();
        self.through.clear();
        self.ends.clear();
        self.entries.clear();
        self.waiting.clear();
    }

    /// Adds a triangle of the mesh if a ray of the area may hit it.
    #[inline(always)]
    fn add(&mut self, triangle: u32, tiles: &TileCaster, view: &View, reach: &Reach) {
        let corners = &tiles.caster.corners[triangle as usize];
        match view.project(corners, tiles.sides) {
            Projected::Culled => {}
            Projected::Within(ranges) => {
                let [columns, rows] = [0, 1].map(|axis| reach.pixels(axis, ranges[axis], self.area));
                if let (Some(columns), Some(rows)) = (columns, rows) {
                    self.covers.push(Cover { triangle, columns, rows });
                }
            }
            Projected::Unbounded => self.through.push(triangle),
        }
    }

    /// Traverses the BVH. Returns false if there are too many triangles.
    #[inline(always)]
    fn collect(&mut self, tiles: &TileCaster, view: &View, reach: &Reach) -> bool {
        let most = self.most(MOST_IN_MEAN);
        let mut looked_at = 0;
        let RayCaster { bvh, .. } = tiles.caster;
        let planes = reach.planes(view, self.area.first, self.area.size);
        if !bvh.nodes.is_empty() {
            self.waiting.push((0, Side::Across));
        }
        while let Some((index, side)) = self.waiting.pop() {
            let node = &bvh.nodes[index as usize];
            let side = if side == Side::Inside { side } else { side_of_node(&planes, node.aabb()) };
            if side == Side::Outside {
                continue;
            }
            let first = node.first_index;
            if !node.is_leaf() {
                self.waiting.extend([(first, side), (first + 1, side)]);
                continue;
            }
            looked_at += node.prim_count as usize;
            for &triangle in &bvh.primitive_indices[first as usize..(first + node.prim_count) as usize] {
                self.add(triangle, tiles, view, reach);
            }
            if looked_at > 2 * most || self.covers.len() + self.through.len() > most {
                return false;
            }
        }
        true
    }

    /// Sorts the collected triangles into tiles. Returns false if there are too many.
    #[inline(always)]
    fn sort(&mut self, tiles: &TileCaster, view: &View, reach: &Reach) -> bool {
        let most = self.most(MOST_OF_TILE);
        let across = self.area.tiles()[0] as usize;
        let count = across * self.area.tiles()[1] as usize;
        self.ends.resize(count, 0);
        for cover in &self.covers {
            for row in cover.rows[0] / TILE as u32..=cover.rows[1] / TILE as u32 {
                let row = row as usize * across;
                let columns = cover.columns.map(|column| row + column as usize / TILE);
                for end in &mut self.ends[columns[0]..=columns[1]] {
                    *end += 1;
                }
            }
        }
        let mut around = Vec::new();
        for (number, end) in self.ends.iter_mut().enumerate() {
            let tile = [(number % across) as u32, (number / across) as u32];
            let planes = reach.planes(view, self.area.pixel(tile), [TILE as u32; 2]);
            let corners = |triangle: &u32| &tiles.caster.corners[*triangle as usize];
            if !self.through.is_empty() {
                let met = self.through.iter().filter(|triangle| !planes.leave_out(corners(triangle)));
                let before = around.len();
                around.extend(met.map(|triangle| (number, *triangle)));
                *end += (around.len() - before) as u32;
            }
            if around.len() > most {
                return false;
            }
        }
        let total = self.ends.iter().map(|count| *count as usize).sum::<usize>();
        if total > most {
            return false;
        }
        // Each end is the beginning of its list until the list is filled.
        let mut sum = 0;
        for end in &mut self.ends {
            (*end, sum) = (sum, sum + *end);
        }
        self.entries.resize(total, Entry { triangle: 0, columns: [0; 2], rows: [0; 2] });
        for Cover { triangle, columns, rows } in &self.covers {
            for row in rows[0] / TILE as u32..=rows[1] / TILE as u32 {
                let rows = within(*rows, row);
                for column in columns[0] / TILE as u32..=columns[1] / TILE as u32 {
                    let entry = Entry { triangle: *triangle, columns: within(*columns, column), rows };
                    let end = &mut self.ends[row as usize * across + column as usize];
                    self.entries[*end as usize] = entry;
                    *end += 1;
                }
            }
        }
        let whole = [0, TILE as u8 - 1];
        for (number, triangle) in around {
            let end = &mut self.ends[number];
            self.entries[*end as usize] = Entry { triangle, columns: whole, rows: whole };
            *end += 1;
        }
        true
    }
}

/// Part of a range of pixels inside a tile, counted from the tile's first pixel.
#[inline(always)]
fn within(range: [u32; 2], tile: u32) -> [u8; 2] {
    let first = tile * TILE as u32;
    [range[0].saturating_sub(first) as u8, (range[1] - first).min(TILE as u32 - 1) as u8]
}

#[inline(always)]
fn side_of_node(planes: &Planes, bounds: &obvhs::aabb::Aabb) -> Side {
    planes.side_of_box(bounds.min.as_dvec3(), bounds.max.as_dvec3())
}

/// Range of a pixel's rays, in pixels from the pixel's upper left corner.
struct Reach {
    low: [f64; 2],
    high: [f64; 2],
    /// Distance beside its projection at which something may still be hit.
    grown: [f64; 2],
}

impl Reach {
    fn new(view: &View, [low, high]: [[f32; 2]; 2]) -> Self {
        let from_corner = |offset: f32| 0.5 + f64::from(offset);
        Self { low: low.map(from_corner), high: high.map(from_corner), grown: view.grown() }
    }

    /// First and last pixel of an area, counted from its first, whose rays may hit something that
    /// is projected to `range` along an axis.
    #[inline(always)]
    fn pixels(&self, axis: usize, range: [f64; 2], area: Area) -> Option<[u32; 2]> {
        let from = f64::from(area.first[axis]);
        let last = f64::from(area.size[axis].checked_sub(1)?);
        let low = (range[0] - self.high[axis] - self.grown[axis] - from).ceil();
        let high = (range[1] - self.low[axis] + self.grown[axis] - from).floor();
        // NaN counts as everywhere.
        let is_beside = low > last || high < 0.0 || low > high;
        (!is_beside).then(|| [low.max(0.0) as u32, if high < last { high } else { last } as u32])
    }

    /// Planes around the rays of a range of pixels.
    #[inline(always)]
    fn planes(&self, view: &View, first: [u32; 2], size: [u32; 2]) -> Planes {
        view.planes([0, 1].map(|axis| {
            let (first, size) = (f64::from(first[axis]), f64::from(size[axis]));
            [first + self.low[axis], first + size - 1.0 + self.high[axis]]
        }))
    }
}

/// Work that fills bins.
pub struct Binning<'a, 'b> {
    pub tiles: &'a TileCaster<'b>,
    pub area: Area,
    pub offsets: [[f32; 2]; 2],
    pub bins: &'a mut Bins,
}

impl WithSimd for Binning<'_, '_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        let Self { tiles, area, offsets, bins } = self;
        bins.clear(area);
        let Some(view) = &tiles.view else { return };
        let reach = Reach::new(view, offsets);
        bins.is_binned = bins.collect(tiles, view, &reach) && bins.sort(tiles, view, &reach);
    }
}
