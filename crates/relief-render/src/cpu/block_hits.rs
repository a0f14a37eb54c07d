//! Nearest hits of a block's rays on a surface.

use relief_core::Lanes;
use relief_shaders::cpu::{BLOCK, EnteredBlock, HitBlock, PathBlock, Row};

use super::block::{Faces, places, places_where};
use super::prepared_surface::{PreparedSurface, ReliefHit};
use relief_core::raycast::tiles::{TileCaster, TileHit, TileHits};

/// Tile of a block, its hits of base triangles, and the numbers of the block's points in the tile.
#[derive(Clone, Copy)]
pub struct Cast<'a> {
    pub caster: &'a TileCaster<'a>,
    pub hits: &'a TileHits,
    pub numbers: &'a Row<usize>,
}

/// Nearest hits of a block's rays on a surface.
pub struct BlockHits {
    /// Points with a hit, a bit for each.
    pub which: u16,
    /// Keys of the hits: the greater, the nearer.
    pub keys: Row<f32>,
    /// Columns and rows of the points in the picture.
    pub points: [Row<f32>; 2],
    /// Triangles that are hit.
    pub faces: Faces,
    /// Entries into the relief, paths through it, and hits.
    pub at: EnteredBlock,
    pub paths: PathBlock,
    pub hits: HitBlock,
}

impl BlockHits {
    /// Creates a block without points and hits.
    pub fn new() -> Self {
        Self {
            which: 0,
            keys: [0.0; BLOCK],
            points: [[0.0; BLOCK]; 2],
            faces: Faces::new(),
            at: EnteredBlock::default(),
            paths: PathBlock::default(),
            hits: HitBlock::default(),
        }
    }

    /// Removes all hits and sets other points.
    pub fn begin(&mut self, points: [Row<f32>; 2]) {
        (self.which, self.points) = (0, points);
    }

    /// Stores a triangle's hit if it is the nearest so far. Ties go to the least rank.
    pub fn store(&mut self, place: usize, rank: (bool, u32), side: f32, met: &ReliefHit) {
        if self.is_nearest(place, rank, met.first.key) {
            self.set(place, rank, side, met.first.key);
            self.at.set(place, &met.at);
            self.paths.set(place, &met.path);
            self.hits.set(place, &met.first.hit);
        }
    }

    /// Stores a hit of another block, at the place `from` there, if it is the nearest so far.
    /// Returns whether it was stored.
    pub fn store_from(
        &mut self,
        place: usize,
        rank: (bool, u32),
        side: f32,
        key: f32,
        (from, at, paths, hits): (usize, &EnteredBlock, &PathBlock, &HitBlock),
    ) -> bool {
        let is_nearest = self.is_nearest(place, rank, key);
        if is_nearest {
            self.set(place, rank, side, key);
            self.at.set(place, &at.get(from));
            self.paths.set(place, &paths.get(from));
            self.hits.set(place, &hits.get(from));
        }
        is_nearest
    }

    fn is_nearest(&self, place: usize, rank: (bool, u32), key: f32) -> bool {
        let known = self.keys[place];
        self.which >> place & 1 == 0 || key > known || (key == known && rank < self.faces.rank[place])
    }

    fn set(&mut self, place: usize, rank: (bool, u32), side: f32, key: f32) {
        self.which |= 1 << place;
        self.keys[place] = key;
        (self.faces.rank[place], self.faces.side[place]) = (rank, side);
    }
}

/// Hits of a region's blocks on one surface among several.
pub struct RegionHits<'a> {
    /// Hits on all surfaces, block by block.
    pub seen: &'a mut [BlockHits],
    pub surfaces: usize,
    /// Number of the surface.
    pub number: usize,
}

impl RegionHits<'_> {
    /// Returns a block's hits on the surface.
    pub fn of(&mut self, block: u32) -> &mut BlockHits {
        &mut self.seen[block as usize * self.surfaces + self.number]
    }
}

impl PreparedSurface<'_> {
    /// Finds the nearest hits on the surface for the points of a block whose bits `which` has.
    /// `cast` holds the base triangles that the rays hit in the block's tile.
    pub fn trace_polygons(&self, which: u16, cast: Cast, lanes: Lanes, seen: &mut BlockHits) {
        let first = self.trace_first_segments(which, cast, lanes, seen);
        let Cast { caster, hits, numbers } = cast;
        for place in places(which).filter(|place| !hits.is_miss(numbers[*place])) {
            let aim = self.ray_through(seen.points.map(|row| row[place]));
            let mut is_first = first >> place & 1 == 1;
            self.propose_polygons(caster.hits(hits, numbers[place]), f64::INFINITY, |rank, side| {
                let met = match std::mem::take(&mut is_first) {
                    true => self.after_first_segment(seen, place),
                    false => self.trace_triangle(rank.1, side, aim),
                };
                if let Some(met) = met {
                    seen.store(place, rank, side, &met);
                }
                let has_hit = seen.which >> place & 1 == 1;
                if has_hit { self.reach(seen.keys[place]) } else { f64::INFINITY }
            });
        }
    }

    /// Traces the first segment in the first base triangle of each ray, if that is known. Returns
    /// the points that were traced.
    fn trace_first_segments(&self, which: u16, cast: Cast, lanes: Lanes, seen: &mut BlockHits) -> u16 {
        let mut first = 0;
        for place in places(which) {
            if let Some(TileHit { triangle, front, .. }) = cast.hits.first(cast.numbers[place]) {
                seen.faces.rank[place] = (false, triangle);
                seen.faces.side[place] = if front { 1.0 } else { -1.0 };
                first |= 1 << place;
            }
        }
        let BlockHits { keys, points, faces, at, paths, hits, .. } = seen;
        faces.each(self, points, first, lanes, |rays, which, lanes| {
            self.program.enter_block(rays, which, lanes, at, paths);
        });
        let traced = first & places_where(|place| at.segments[place] > 0 && paths.exit[place] > 0.0);
        for place in places(first & !traced) {
            hits.found[place] = 0;
            hits.cost.iter_mut().for_each(|row| row[place] = 0);
        }
        if traced != 0 {
            self.trace_block(paths, traced, lanes, hits);
            let found = traced & places_where(|place| hits.found[place] == 1);
            faces.each(self, points, found, lanes, |rays, which, lanes| {
                self.program.meet_block((rays, 0), which, lanes, (at, paths), hits, keys);
            });
        }
        seen.which |= first & places_where(|place| seen.hits.found[place] == 1);
        first
    }

    /// Returns the hit of a point's ray on the segments after the first, which is traced already. A
    /// hit on the first segment is the nearest: tiles cast base triangles, whose relief does not
    /// overlap itself.
    fn after_first_segment(&self, seen: &BlockHits, place: usize) -> Option<ReliefHit> {
        let is_hit = seen.hits.found[place] == 1;
        if is_hit || seen.at.segments[place] < 2 {
            return None;
        }
        let (triangle, side) = (seen.faces.rank[place].1, seen.faces.side[place]);
        let pixel = self.pixel(triangle, side, self.ray_through(seen.points.map(|row| row[place])));
        self.first_from(pixel, seen.at.get(place), 1, seen.hits.get(place).cost)
    }
}
