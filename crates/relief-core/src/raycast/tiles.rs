//! Casting of a picture's rays against a mesh of flat triangles, one tile of 8 x 8 pixels at a
//! time.
//!
//! [`TileCaster`] finds in the BVH of a [`RayCaster`] which triangles an area of the picture may
//! show. It projects them and sorts them into tiles ([`Bins`]). The triangles of a tile are then
//! tested against its rays by the very formula of [`RayCaster`], for several rays at once. The
//! operations, numbers and order are the same, so that hits are the same to the last bit, and so is
//! their order by `(t, triangle)`. The projection only has to guarantee that no triangle is left
//! out that a ray hits.
//!
//! Some tiles cast their rays one by one instead. The rays of the tile may differ in the axis along
//! which they are longest. The view may be so narrow that rays in `f32` are wrong by pixels. Or the
//! triangles may be so numerous that the BVH is faster.

use glam::{DVec3, Vec3};

pub use self::bins::{Area, Bins};
use self::view::View;
use super::{Ray, RayCaster, Sides, SurfaceHit};
use crate::Lanes;

mod bins;
mod lanes;
mod view;

/// Pixels along a side of a tile.
pub const TILE: usize = 8;

/// Pixels of a tile.
pub const TILE_POINTS: usize = TILE * TILE;

/// Rays of a picture in single precision, computed with the arithmetic of shaders. The first vector
/// of each triple belongs to the upper left corner. The other two are the steps for a column to the
/// right and a row down.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PictureRays {
    /// Origin of the ray through the picture's upper left corner, and the steps.
    pub origin: [Vec3; 3],
    /// Direction of that ray, and the steps.
    pub direction: [Vec3; 3],
}

impl PictureRays {
    /// Ray through a point of the picture, in pixels from its upper left corner.
    #[inline]
    pub fn ray(&self, point: [f32; 2]) -> Ray {
        let along = |[first, right, down]: [Vec3; 3]| (first + right * point[0]) + down * point[1];
        Ray { origin: along(self.origin).as_dvec3(), direction: along(self.direction).as_dvec3() }
    }

    /// Position of a point in a pixel at an `offset` from the pixel's centre, in pixels.
    #[inline(always)]
    pub fn point(pixel: [u32; 2], offset: [f32; 2]) -> [f32; 2] {
        [pixel[0] as f32 + 0.5 + offset[0], pixel[1] as f32 + 0.5 + offset[1]]
    }
}

/// A triangle that a ray of a tile hits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TileHit {
    /// Parameter along the ray, as in [`SurfaceHit`].
    pub t: f64,
    /// Number of the triangle in the mesh.
    pub triangle: u32,
    /// Whether the ray hits the front.
    pub front: bool,
}

impl From<SurfaceHit> for TileHit {
    fn from(SurfaceHit { t, triangle, front, .. }: SurfaceHit) -> Self {
        Self { t, triangle, front }
    }
}

/// A mesh and a picture's rays, prepared for casting by tiles.
#[derive(Clone, Debug)]
pub struct TileCaster<'a> {
    caster: &'a RayCaster,
    rays: PictureRays,
    sides: Sides,
    lanes: Lanes,
    /// `None` if all rays are cast one by one.
    view: Option<View>,
}

impl<'a> TileCaster<'a> {
    /// Prepares the rays of a picture of `size` columns and rows.
    ///
    /// With [`Lanes::One`] all rays are cast one by one.
    pub fn new(caster: &'a RayCaster, rays: PictureRays, size: [u32; 2], sides: Sides, lanes: Lanes) -> Self {
        let view = if lanes == Lanes::One { None } else { View::new(&rays, size) };
        // Wider vectors do not divide faster, and division is most of the work. Later steps are
        // slower in them.
        Self { caster, rays, sides, lanes: lanes.min(Lanes::Eight), view }
    }

    /// Sorts the triangles that an area of the picture may show into its tiles. Earlier contents of
    /// the bins are dropped. `offsets` are the least and the greatest offset that the rays will
    /// have.
    pub fn bin(&self, area: Area, offsets: [[f32; 2]; 2], bins: &mut Bins) {
        self.lanes.run_up_to_eight(bins::Binning { tiles: self, area, offsets, bins });
    }

    /// Casts the rays of a tile at an offset from the centres of its pixels. `tile` counts along
    /// the columns and the rows of the area that was binned.
    ///
    /// A tile that reaches beyond the picture has rays there as well.
    pub fn cast(&self, bins: &Bins, tile: [u32; 2], offset: [f32; 2], hits: &mut TileHits) {
        hits.one_by_one = true;
        (hits.first, hits.offset) = (bins.area().pixel(tile), offset);
        let (Some(view), Some(entries)) = (&self.view, bins.entries(tile)) else { return };
        if entries.is_empty() {
            // Nothing is there, whether the rays are valid or not.
            hits.one_by_one = false;
            hits.count = [0.0; TILE_POINTS];
            return;
        }
        self.lanes.run_up_to_eight(lanes::Casting { tiles: self, view, entries, hits });
    }

    /// Returns the hits of a ray of a tile after [`Self::cast`], in the order of `(t, triangle)`.
    /// `point` is its number in the tile, row by row.
    pub fn hits<'b>(&'b self, hits: &'b TileHits, point: usize) -> impl Iterator<Item = TileHit> + 'b {
        let known = if hits.one_by_one { 0 } else { (hits.count[point] as usize).min(STORED) };
        let are_all = !hits.one_by_one && hits.count[point] <= STORED as f64;
        let mut number = 0;
        let mut last = None;
        let mut others = None;
        std::iter::from_fn(move || {
            if number < known {
                last = hits.stored(point, number);
                number += 1;
                return last;
            }
            if are_all {
                return None;
            }
            others.get_or_insert_with(|| self.others(hits, point, last)).next().map(TileHit::from)
        })
    }

    /// Hits of a ray behind `last`, or all of them.
    fn others(
        &self,
        hits: &TileHits,
        point: usize,
        last: Option<TileHit>,
    ) -> impl Iterator<Item = SurfaceHit> + use<'_, 'a> {
        let pixel = [hits.first[0] + (point % TILE) as u32, hits.first[1] + (point / TILE) as u32];
        let ray = self.rays.ray(PictureRays::point(pixel, hits.offset));
        self.caster.hits_after(ray, self.sides, last.map(|hit| (hit.t, hit.triangle)))
    }
}

/// Number of hits stored per ray. Further hits, which are seldom needed, are found by the BVH.
const STORED: usize = 2;

/// First hits of a tile's rays.
#[derive(Clone, Debug)]
pub struct TileHits {
    /// Whether the rays must be cast one by one. Then the other fields are invalid.
    one_by_one: bool,
    /// Upper left pixel of the tile, and the offset of the rays from the pixels' centres.
    first: [u32; 2],
    offset: [f32; 2],
    /// Number of hits of each ray.
    count: [f64; TILE_POINTS],
    /// Parameters of the stored hits.
    t: [[f64; TILE_POINTS]; STORED],
    /// Twice the number of the triangle, plus one for a front.
    key: [[f64; TILE_POINTS]; STORED],
}

impl TileHits {
    /// Creates an empty set of hits for one tile.
    pub fn new() -> Self {
        Self {
            one_by_one: true,
            first: [0; 2],
            offset: [0.0; 2],
            count: [0.0; TILE_POINTS],
            t: [[0.0; TILE_POINTS]; STORED],
            key: [[0.0; TILE_POINTS]; STORED],
        }
    }

    /// Whether a ray is known to hit nothing.
    pub fn is_miss(&self, point: usize) -> bool {
        !self.one_by_one && self.count[point] == 0.0
    }

    /// First hit of a ray, if it is known and exists.
    pub fn first(&self, point: usize) -> Option<TileHit> {
        if self.one_by_one { None } else { self.stored(point, 0) }
    }

    /// Stored hit of a ray, by its number.
    #[inline]
    fn stored(&self, point: usize, number: usize) -> Option<TileHit> {
        (number < STORED && (number as f64) < self.count[point]).then(|| {
            let key = self.key[number][point] as u64;
            TileHit { t: self.t[number][point], triangle: (key >> 1) as u32, front: key & 1 == 1 }
        })
    }
}

impl Default for TileHits {
    fn default() -> Self {
        Self::new()
    }
}

/// Corners of a triangle.
type Corners = [DVec3; 3];

#[cfg(test)]
mod tests;
