//! Rendering by tiles of pixels. The base triangles are cast for all of a tile's rays together.

use rayon::prelude::*;
use relief_core::{Cancelled, Lanes};
use relief_shaders::cpu::{BLOCK, Row};

use super::Progress;
use super::block::{BLOCK_SIDE, places, places_where};
use super::block_hits::{BlockHits, Cast, RegionHits};
use super::prepared_surface::PreparedSurface;
use super::shells::Shells;
use crate::samples::Sample;
use relief_core::raycast::tiles::{Area, Bins, PictureRays, TILE, TileCaster, TileHits};

/// Most columns that are sorted into tiles at once. More need more memory on every thread; fewer
/// need more traversals of the BVHs.
const MOST_COLUMNS: u32 = 1024;

/// Most rows of a thread's piece of work. Fewer need more traversals of the BVHs.
const MOST_ROWS: u32 = 4 * TILE as u32;

/// Tiles along a side of a region, whose rays are traced in shells together. With more tiles more
/// rays share a shell, and every thread needs more memory.
const REGION_TILES: usize = 4;

/// The first points of a tile's blocks.
const BLOCKS: [[usize; 2]; 4] = [[0, 0], [BLOCK_SIDE, 0], [0, BLOCK_SIDE], [BLOCK_SIDE, BLOCK_SIDE]];

/// Least number of pieces of work for each thread, so that all are busy until the end.
const LEAST_PIECES: u32 = 4;

/// The surfaces of a picture.
pub struct Tiled<'a> {
    size: [u32; 2],
    samples: &'a [Sample],
    surfaces: Vec<(&'a PreparedSurface<'a>, Option<TileCaster<'a>>)>,
    lanes: Lanes,
}

/// Scratch memory of a thread.
struct Scratch {
    bins: Vec<Bins>,
    hits: Vec<TileHits>,
    /// Points of a region's blocks, tile by tile, and their hits on each surface.
    points: Vec<Points>,
    seen: Vec<BlockHits>,
    shells: Shells,
}

/// The points of a block of a tile.
pub struct Points {
    /// Points that lie in the area, a bit for each.
    pub which: u16,
    /// Numbers of the points in the tile.
    numbers: Row<usize>,
    /// Columns and rows of the points' pixels, and of the points themselves.
    pixels: Row<[u32; 2]>,
    pub points: [Row<f32>; 2],
}

/// Hits of a block's points on all surfaces, with the nearest surface of each point.
pub struct VisibleBlock<'a> {
    /// The block's points.
    pub points: &'a Points,
    /// Hits on each surface.
    pub surfaces: &'a [BlockHits],
    /// Number of the nearest surface, for points that hit any.
    pub nearest: Row<Option<usize>>,
}

impl<'a> Tiled<'a> {
    /// Creates the casters by tiles of all surfaces, for a picture of the given columns and rows.
    pub fn new(
        surfaces: &'a [PreparedSurface<'a>],
        samples: &'a [Sample],
        size: [u32; 2],
        lanes: Lanes,
    ) -> Self {
        let surfaces = surfaces.iter().map(|surface| (surface, surface.tiles(size, lanes)));
        Self { size, samples, surfaces: surfaces.collect(), lanes }
    }

    /// Renders whole rows of the picture, from the row `first` on, one sample of each pixel after
    /// the other. `look` turns a block's hits into values, point by point. `show` writes a value
    /// into a pixel. `done` counts rows.
    pub(super) fn each<P: Send, V>(
        &self,
        pixels: &mut [P],
        first: u32,
        done: &Progress,
        look: impl Fn(&VisibleBlock, &mut dyn FnMut(usize, V)) + Sync,
        show: impl Fn(&mut P, usize, V) + Sync,
    ) -> Result<(), Cancelled> {
        // A picture without columns has no rows to go through either.
        let width = self.size[0].max(1) as usize;
        let rows = rows_of_piece((pixels.len() / width) as u32);
        pixels.par_chunks_mut(width * rows as usize).enumerate().try_for_each_init(
            || self.scratch(),
            |scratch, (number, pixels)| {
                let first = first + number as u32 * rows;
                let rows = (pixels.len() / width) as u32;
                for column in (0..self.size[0]).step_by(MOST_COLUMNS as usize) {
                    let columns = MOST_COLUMNS.min(self.size[0] - column);
                    let area = Area { first: [column, first], size: [columns, rows] };
                    self.area(area, scratch, done, |points, number, seen| {
                        look(seen, &mut |place, value| {
                            if points.which >> place & 1 == 1 {
                                let [x, y] = points.pixels[place];
                                let pixel = (y - first) as usize * width + x as usize;
                                show(&mut pixels[pixel], number, value);
                            }
                        });
                    })?;
                }
                done.add(rows)
            },
        )
    }

    fn scratch(&self) -> Scratch {
        let count = self.surfaces.len();
        Scratch {
            bins: vec![Bins::new(); count],
            hits: vec![TileHits::new(); count],
            points: Vec::new(),
            seen: Vec::new(),
            shells: Shells::default(),
        }
    }

    fn area(
        &self,
        area: Area,
        scratch: &mut Scratch,
        done: &Progress,
        mut show: impl FnMut(&Points, usize, &VisibleBlock),
    ) -> Result<(), Cancelled> {
        let Scratch { bins, hits, points, seen, shells } = scratch;
        let offsets = reach_of(self.samples);
        for ((_, caster), bins) in self.surfaces.iter().zip(&mut *bins) {
            if let Some(caster) = caster {
                caster.bin(area, offsets, bins);
            }
        }
        let [across, down] = area.tiles();
        let side = self.region_side();
        let regions =
            (0..down).step_by(side).flat_map(|row| (0..across).step_by(side).map(move |at| [at, row]));
        for [column, row] in regions {
            let (columns, rows) =
                (column..across.min(column + side as u32), row..down.min(row + side as u32));
            let tiles = || rows.clone().flat_map(|row| columns.clone().map(move |column| [column, row]));
            for (number, sample) in self.samples.iter().enumerate() {
                done.check()?;
                points.clear();
                points.extend(tiles().flat_map(|tile| BLOCKS.map(|at| Points::new(area, tile, at, sample))));
                self.trace_shells(points, seen, shells);
                for (tile, of_tile) in tiles().zip(0..) {
                    for (((_, caster), bins), hits) in self.surfaces.iter().zip(&*bins).zip(&mut *hits) {
                        if let Some(caster) = caster {
                            caster.cast(bins, tile, sample.offset, hits);
                        }
                    }
                    for block in BLOCKS.len() * of_tile..BLOCKS.len() * (of_tile + 1) {
                        let count = self.surfaces.len();
                        let (points, seen) = (&points[block], &mut seen[count * block..count * (block + 1)]);
                        let nearest = self.block(points, hits, seen);
                        show(points, number, &VisibleBlock { points, surfaces: seen, nearest });
                    }
                }
            }
        }
        Ok(())
    }

    /// Returns the number of tiles along a side of a region: 1 where no surface has shells.
    fn region_side(&self) -> usize {
        if self.surfaces.iter().any(|(_, caster)| caster.is_none()) { REGION_TILES } else { 1 }
    }

    /// Finds the hits of a region's blocks in shells. Other surfaces have no hits yet.
    fn trace_shells(&self, points: &[Points], seen: &mut Vec<BlockHits>, shells: &mut Shells) {
        let surfaces = self.surfaces.len();
        seen.resize_with(points.len() * surfaces, BlockHits::new);
        for (number, seen) in seen.iter_mut().enumerate() {
            seen.begin(points[number / surfaces].points);
        }
        for (number, (surface, _)) in self.surfaces.iter().enumerate() {
            let mut seen = RegionHits { seen, surfaces, number };
            surface.trace_shells(points, self.lanes, shells, &mut seen);
        }
    }

    /// Finds the hits of a block on the other surfaces, and returns the nearest surface for each
    /// point. Ties go to the first surface. Hits in shells are known already.
    fn block(&self, of: &Points, hits: &[TileHits], seen: &mut [BlockHits]) -> Row<Option<usize>> {
        let mut nearest: Row<Option<usize>> = [None; BLOCK];
        let mut keys = [0.0; BLOCK];
        for (at, ((surface, caster), hits)) in self.surfaces.iter().zip(hits).enumerate() {
            if let Some(caster) = caster {
                let cast = Cast { caster, hits, numbers: &of.numbers };
                surface.trace_polygons(of.which, cast, self.lanes, &mut seen[at]);
            }
            for number in places(seen[at].which) {
                let key = seen[at].keys[number];
                if nearest[number].is_none() || key > keys[number] {
                    (nearest[number], keys[number]) = (Some(at), key);
                }
            }
        }
        nearest
    }
}

impl Points {
    /// Returns a sample's points in the block that begins at the given point of a tile.
    fn new(area: Area, tile: [u32; 2], first: [usize; 2], sample: &Sample) -> Self {
        let [column, row] = area.pixel(tile);
        let end = [0, 1].map(|axis| area.first[axis] + area.size[axis]);
        let place = |at: usize| [first[0] + at % BLOCK_SIDE, first[1] + at / BLOCK_SIDE];
        let pixels: Row<[u32; 2]> = std::array::from_fn(|at| {
            let [x, y] = place(at);
            [column + x as u32, row + y as u32]
        });
        let points = pixels.map(|pixel| PictureRays::point(pixel, sample.offset));
        Self {
            which: places_where(|at| pixels[at][0] < end[0] && pixels[at][1] < end[1]),
            numbers: std::array::from_fn(|at| place(at)[1] * TILE + place(at)[0]),
            pixels,
            points: [0, 1].map(|axis| points.map(|point| point[axis])),
        }
    }
}

/// Returns the least and the greatest offset of samples.
fn reach_of(samples: &[Sample]) -> [[f32; 2]; 2] {
    let nothing = [[f32::INFINITY; 2], [f32::NEG_INFINITY; 2]];
    samples.iter().fold(nothing, |[low, high], Sample { offset, .. }| {
        [[0, 1].map(|axis| low[axis].min(offset[axis])), [0, 1].map(|axis| high[axis].max(offset[axis]))]
    })
}

/// Returns the number of rows that a thread renders at a time, out of `rows`.
fn rows_of_piece(rows: u32) -> u32 {
    let pieces = LEAST_PIECES.saturating_mul(rayon::current_num_threads() as u32);
    let whole_tiles = rows / pieces / TILE as u32 * TILE as u32;
    whole_tiles.clamp(TILE as u32, MOST_ROWS)
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use relief_core::{HeightMap, Wrap};
    use relief_shaders::cpu::{Frame, SurfaceSettings};
    use relief_shaders::{Selection, SlotMaps};

    use super::super::prepared_surface::picture_rays;
    use super::*;
    use crate::job::JobSurface;

    fn surface() -> JobSurface {
        let map = Arc::new(HeightMap::from_fn(4, 4, Wrap::Repeat, |_, _| 0.5).expect("a valid map"));
        let selection = Selection::method("relief").expect("a method");
        JobSurface {
            settings: SurfaceSettings::tracing(&map, &selection, &SlotMaps::default()),
            selection,
            triangles: Arc::default(),
            height_map: map,
            color: None,
            normal_map: None,
            material_maps: None,
            maps: Vec::new(),
            two_sided: false,
        }
    }

    #[test]
    fn rays_of_tiles_are_those_of_the_shaders() {
        let surface = surface();
        let four = |x: f32| [x * 0.731, x * -1.377, x * 2.093, 0.0].into();
        let frame = Frame {
            eye: four(1.1),
            eye_right: four(0.000_73),
            eye_down: four(-0.000_41),
            corner: four(-0.77),
            right: four(0.001_3),
            down: four(0.000_917),
            ..Frame::none()
        };
        let (program, rays) = (surface.program(frame, None), picture_rays(&frame));
        for number in 0..20_000u32 {
            let pixel = [number * 7 % 4099, number * 13 % 2503];
            let point = PictureRays::point(pixel, [0.1237 - (number % 10) as f32 / 31.0, 0.25]);
            let (eye, direction) = (program.pixel_eye(point), program.pixel_direction(point));
            let ray = rays.ray(point);
            assert_eq!(ray.origin.to_array(), [eye.x, eye.y, eye.z].map(f64::from));
            assert_eq!(ray.direction.to_array(), [direction.x, direction.y, direction.z].map(f64::from));
        }
    }

    #[test]
    fn work_is_whole_tiles_until_the_last_rows() {
        let threads = rayon::current_num_threads() as u32;
        assert_eq!([0, 1, 8, 9].map(rows_of_piece), [8; 4]);
        assert_eq!(rows_of_piece(10_000 * threads), MOST_ROWS);
        assert_eq!(rows_of_piece(4 * 17 * threads), 16);
        assert_eq!(reach_of(&[Sample::CENTRE]), [[0.0; 2]; 2]);
    }
}
