//! The rays of a picture against a mesh of flat triangles, a tile of 8 x 8 points at a time.
//!
//! [`TileCaster`] looks up in the hierarchy of a [`RayCaster`] which triangles an area of the picture may
//! show, projects them and sorts them into tiles ([`Bins`]). What a tile lists is then tested against its rays
//! by the very formula of [`RayCaster`], for several rays at once: the same operations on the same numbers in
//! the same order, so that hits are the same to the last bit, and their order by `(t, triangle)` too. All that
//! projecting must guarantee is that no triangle is left out which a ray meets.
//!
//! Where tiles do not serve, their rays are cast one by one: where rays of a tile differ in the axis along
//! which they are longest, where a view is so fine that rays in `f32` stray by pixels, and where triangles are
//! so many that a hierarchy is quicker.

use glam::{DVec3, Vec3};

pub use self::bins::{Area, Bins};
use self::view::View;
use super::{Ray, RayCaster, Sides, SurfaceHit};
use crate::Lanes;

mod bins;
mod lanes;
mod view;

/// Points along a side of a tile.
pub const TILE: usize = 8;

/// Points of a tile.
pub const TILE_POINTS: usize = TILE * TILE;

/// The rays of a picture in single precision, by the arithmetic that shaders have: what is added to the first
/// of each three for a column to the right and a row down is in the other two.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PictureRays {
    /// Where the ray through the picture's upper left corner begins, and the steps.
    pub origin: [Vec3; 3],
    /// Its direction, and the steps.
    pub direction: [Vec3; 3],
}

impl PictureRays {
    /// The ray through a point of the picture, in pixels from its upper left corner.
    #[inline]
    pub fn ray(&self, point: [f32; 2]) -> Ray {
        let along = |[first, right, down]: [Vec3; 3]| (first + right * point[0]) + down * point[1];
        Ray { origin: along(self.origin).as_dvec3(), direction: along(self.direction).as_dvec3() }
    }

    /// The place of a pixel's point, which is that far off the pixel's centre.
    #[inline(always)]
    pub fn point(pixel: [u32; 2], offset: [f32; 2]) -> [f32; 2] {
        [pixel[0] as f32 + 0.5 + offset[0], pixel[1] as f32 + 0.5 + offset[1]]
    }
}

/// A triangle that a ray of a tile meets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TileHit {
    /// As in [`SurfaceHit`].
    pub t: f64,
    /// Number of the triangle in the mesh.
    pub triangle: u32,
    /// Whether its front is met.
    pub front: bool,
}

impl From<SurfaceHit> for TileHit {
    fn from(SurfaceHit { t, triangle, front, .. }: SurfaceHit) -> Self {
        Self { t, triangle, front }
    }
}

/// A mesh and a picture's rays, prepared for tiles.
#[derive(Clone, Debug)]
pub struct TileCaster<'a> {
    caster: &'a RayCaster,
    rays: PictureRays,
    sides: Sides,
    lanes: Lanes,
    /// Nothing where rays are cast one by one.
    view: Option<View>,
}

impl<'a> TileCaster<'a> {
    /// The rays of a picture of so many columns and rows.
    ///
    /// A width of one lane casts them one by one.
    pub fn new(caster: &'a RayCaster, rays: PictureRays, size: [u32; 2], sides: Sides, lanes: Lanes) -> Self {
        let view = if lanes == Lanes::One { None } else { View::new(&rays, size) };
        // Wider vectors divide no faster, which is most of the work, and what comes after them is slower.
        Self { caster, rays, sides, lanes: lanes.min(Lanes::Eight), view }
    }

    /// Sorts what an area of the picture may show into its tiles; all that the bins held is dropped.
    /// `offsets` are the least and the greatest of those that its rays will have.
    pub fn bin(&self, area: Area, offsets: [[f32; 2]; 2], bins: &mut Bins) {
        self.lanes.run_up_to_eight(bins::Binning { tiles: self, area, offsets, bins });
    }

    /// Casts the rays of a tile, by its number along the columns and the rows of the area that was binned,
    /// at an offset from the centres of its pixels.
    ///
    /// A tile that goes beyond the picture has rays there as well.
    pub fn cast(&self, bins: &Bins, tile: [u32; 2], offset: [f32; 2], hits: &mut TileHits) {
        hits.one_by_one = true;
        (hits.first, hits.offset) = (bins.area().pixel(tile), offset);
        let (Some(view), Some(entries)) = (&self.view, bins.entries(tile)) else { return };
        if entries.is_empty() {
            // Nothing is there, if the rays are proper ones or not.
            hits.one_by_one = false;
            hits.count = [0.0; TILE_POINTS];
            return;
        }
        self.lanes.run_up_to_eight(lanes::Casting { tiles: self, view, entries, hits });
    }

    /// What a ray of a tile that was cast meets, in the order of `(t, triangle)`. `point` is its number in the
    /// tile, row by row.
    pub fn hits<'b>(&'b self, hits: &'b TileHits, point: usize) -> impl Iterator<Item = TileHit> + 'b {
        let known = if hits.one_by_one { 0 } else { (hits.count[point] as usize).min(KEPT) };
        let are_all = !hits.one_by_one && hits.count[point] <= KEPT as f64;
        let mut number = 0;
        let mut last = None;
        let mut others = None;
        std::iter::from_fn(move || {
            if number < known {
                last = hits.kept(point, number);
                number += 1;
                return last;
            }
            if are_all {
                return None;
            }
            others.get_or_insert_with(|| self.others(hits, point, last)).next().map(TileHit::from)
        })
    }

    /// What a ray meets after a hit, or from its beginning.
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

/// How many hits of a ray are kept: those beyond are asked of the hierarchy. More are seldom looked at.
const KEPT: usize = 2;

/// The first hits of a tile's rays.
#[derive(Clone, Debug)]
pub struct TileHits {
    /// The rays must be cast one by one, and the rest says nothing.
    one_by_one: bool,
    /// The tile's upper left pixel, and how far off the pixels' centres the rays are.
    first: [u32; 2],
    offset: [f32; 2],
    /// How many hits each ray has.
    count: [f64; TILE_POINTS],
    /// Of the first ones the parameters.
    t: [[f64; TILE_POINTS]; KEPT],
    /// Twice the triangles' numbers, and one more at fronts.
    key: [[f64; TILE_POINTS]; KEPT],
}

impl TileHits {
    /// Room for those of a tile.
    pub fn new() -> Self {
        Self {
            one_by_one: true,
            first: [0; 2],
            offset: [0.0; 2],
            count: [0.0; TILE_POINTS],
            t: [[0.0; TILE_POINTS]; KEPT],
            key: [[0.0; TILE_POINTS]; KEPT],
        }
    }

    /// Whether a ray is known to meet nothing.
    pub fn is_miss(&self, point: usize) -> bool {
        !self.one_by_one && self.count[point] == 0.0
    }

    /// The first hit of a ray, where it is known and has one.
    pub fn first(&self, point: usize) -> Option<TileHit> {
        if self.one_by_one { None } else { self.kept(point, 0) }
    }

    /// One of the hits that are kept, by its number.
    #[inline]
    fn kept(&self, point: usize, number: usize) -> Option<TileHit> {
        (number < KEPT && (number as f64) < self.count[point]).then(|| {
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

/// The corners of a triangle.
type Corners = [DVec3; 3];

#[cfg(test)]
mod tests;
