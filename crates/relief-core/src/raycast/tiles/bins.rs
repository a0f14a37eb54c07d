//! The triangles that the tiles of an area may show.

use pulp::{Simd, WithSimd};

use super::view::{Place, Planes, Side, View};
use super::{TILE, TileCaster};
use crate::raycast::RayCaster;

/// The most triangles that an area may show, and half of those that are looked at for it, a tile in the mean;
/// with more all of its rays are cast one by one: to project them takes as long as that does.
const MOST_IN_MEAN: usize = 128;

/// The most triangles of a tile, and of an area's tiles in the mean; with more the tile's rays are cast one by
/// one, which is quicker then.
const MOST_OF_TILE: usize = 512;

/// A range of a picture's pixels.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Area {
    /// The column and the row of the upper left one.
    pub first: [u32; 2],
    /// Columns and rows.
    pub size: [u32; 2],
}

impl Area {
    /// How many tiles there are along each side; the last ones may reach beyond it.
    pub fn tiles(&self) -> [u32; 2] {
        self.size.map(|side| side.div_ceil(TILE as u32))
    }

    /// The upper left pixel of a tile, by its number along each side.
    pub fn pixel(&self, tile: [u32; 2]) -> [u32; 2] {
        [0, 1].map(|axis| self.first[axis] + tile[axis] * TILE as u32)
    }
}

/// The triangles that the tiles of an area may show. They keep their memory from one area to the next.
#[derive(Clone, Debug, Default)]
pub struct Bins {
    area: Area,
    /// Whether there are lists.
    is_binned: bool,
    /// Triangles within the area.
    covers: Vec<Cover>,
    /// Triangles that reach beside or behind the eye.
    through: Vec<u32>,
    /// Where the list of each tile ends; it begins where that of the one before ends.
    ends: Vec<u32>,
    entries: Vec<Entry>,
    waiting: Vec<(u32, Side)>,
}

/// A triangle of an area.
#[derive(Clone, Copy, Debug)]
struct Cover {
    triangle: u32,
    /// The first and the last column in the area of a ray that may meet it, and the rows.
    columns: [u32; 2],
    rows: [u32; 2],
}

/// A triangle of a tile.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Entry {
    pub triangle: u32,
    /// The first and the last column in the tile of a ray that may meet it, and the rows.
    pub columns: [u8; 2],
    pub rows: [u8; 2],
}

impl Bins {
    /// The most memory that they take for each tile of the largest area that they were filled for, in bytes:
    /// lists as long as they may be, in vectors that are twice as long. Where triangles are as fine as pixels
    /// it is a tenth of that.
    pub const MOST_BYTES_PER_TILE: usize =
        2 * (2 * MOST_IN_MEAN * size_of::<Cover>() + MOST_OF_TILE * (size_of::<Entry>() + 16));

    /// Bins of nothing.
    pub fn new() -> Self {
        Self::default()
    }

    /// The area that they are of.
    pub fn area(&self) -> Area {
        self.area
    }

    /// The list of a tile; none where its rays are to be cast one by one.
    pub(super) fn entries(&self, tile: [u32; 2]) -> Option<&[Entry]> {
        if !self.is_binned {
            return None;
        }
        let number = tile[0] as usize + tile[1] as usize * self.area.tiles()[0] as usize;
        let start = number.checked_sub(1).map_or(Some(&0), |before| self.ends.get(before))?;
        let entries = self.entries.get(*start as usize..*self.ends.get(number)? as usize)?;
        (entries.len() <= MOST_OF_TILE).then_some(entries)
    }

    /// The memory that they take, in bytes.
    pub fn bytes(&self) -> usize {
        self.covers.capacity() * size_of::<Cover>()
            + self.entries.capacity() * size_of::<Entry>()
            + self.waiting.capacity() * size_of::<(u32, Side)>()
            + (self.through.capacity() + self.ends.capacity()) * size_of::<u32>()
    }

    /// Leaves a triangle out of all lists, as no caster may.
    #[cfg(test)]
    pub(super) fn forget(&mut self, triangle: u32) {
        for entry in &mut self.entries {
            if entry.triangle == triangle {
                entry.rows = [1, 0];
            }
        }
    }

    /// So many for each tile.
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

    /// Adds a triangle of the mesh where a ray of the area may meet it.
    #[inline(always)]
    fn add(&mut self, triangle: u32, tiles: &TileCaster, view: &View, reach: &Reach) {
        let corners = &tiles.caster.corners[triangle as usize];
        match view.place(corners, tiles.sides) {
            Place::Unseen => {}
            Place::Within(ranges) => {
                let [columns, rows] = [0, 1].map(|axis| reach.pixels(axis, ranges[axis], self.area));
                if let (Some(columns), Some(rows)) = (columns, rows) {
                    self.covers.push(Cover { triangle, columns, rows });
                }
            }
            Place::Through => self.through.push(triangle),
        }
    }

    /// Goes through the hierarchy; whether there was room for all.
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

    /// Sorts what was collected into tiles; whether there was room for all.
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
        // Each end is where its list begins, until that is filled.
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

/// A range of pixels, from the first of a tile's and within it.
#[inline(always)]
fn within(range: [u32; 2], tile: u32) -> [u8; 2] {
    let first = tile * TILE as u32;
    [range[0].saturating_sub(first) as u8, (range[1] - first).min(TILE as u32 - 1) as u8]
}

#[inline(always)]
fn side_of_node(planes: &Planes, bounds: &obvhs::aabb::Aabb) -> Side {
    planes.side_of_box(bounds.min.as_dvec3(), bounds.max.as_dvec3())
}

/// How far from a pixel's upper left corner its rays may be, in pixels.
struct Reach {
    low: [f64; 2],
    high: [f64; 2],
    /// How far beside its projection something may be met.
    grown: [f64; 2],
}

impl Reach {
    fn new(view: &View, [low, high]: [[f32; 2]; 2]) -> Self {
        let from_corner = |offset: f32| 0.5 + f64::from(offset);
        Self { low: low.map(from_corner), high: high.map(from_corner), grown: view.grown() }
    }

    /// The first and the last pixel of an area, from its first, with rays that may meet what is projected to
    /// a range along an axis.
    #[inline(always)]
    fn pixels(&self, axis: usize, range: [f64; 2], area: Area) -> Option<[u32; 2]> {
        let from = f64::from(area.first[axis]);
        let last = f64::from(area.size[axis].checked_sub(1)?);
        let low = (range[0] - self.high[axis] - self.grown[axis] - from).ceil();
        let high = (range[1] - self.low[axis] + self.grown[axis] - from).floor();
        // What is no number is everywhere.
        let is_beside = low > last || high < 0.0 || low > high;
        (!is_beside).then(|| [low.max(0.0) as u32, if high < last { high } else { last } as u32])
    }

    /// The planes around the rays of so many pixels.
    #[inline(always)]
    fn planes(&self, view: &View, first: [u32; 2], size: [u32; 2]) -> Planes {
        view.planes([0, 1].map(|axis| {
            let (first, size) = (f64::from(first[axis]), f64::from(size[axis]));
            [first + self.low[axis], first + size - 1.0 + self.high[axis]]
        }))
    }
}

/// Fills bins.
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
