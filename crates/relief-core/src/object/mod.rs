//! Objects defined by images with depth, and exact hits with them.
//!
//! Kautz and Seidel 2001, section 4: in each image everything behind the visible surface, down to
//! the image's base plane, may be solid. The object is the intersection of these solids.
//!
//! Two tracers in `f64` share neither traversal nor root finder. [`ImageObject::first_hit`] asks
//! the images in turn where a ray is next in their solids. [`ImageObject::intervals`] intersects
//! the lists of all parameters at which the ray is in them. Both have a variant that uses
//! silhouettes only, for the visual hull of section 5.

mod atlas;
mod cells;
mod frames;
mod grid;
mod hull;
mod image_walk;
mod intervals;
mod patch;
mod view;

pub use atlas::AtlasLayout;
pub use frames::{LEAST_COVER, LEAST_FACING, ObjectFrames};
pub use grid::{FrameGrid, GridMapping};
pub use hull::SilhouetteError;
pub use image_walk::ObjectHit;
pub use patch::{AGREEMENT, MAX_DISTANCE};
pub use view::{View, ViewError, ViewRay};

use glam::DVec3;

use crate::mesh::{MeshError, Placement};
use crate::{HeightMap, HeightMapError, MaxPyramid, Wrap};

/// Most images of an object.
pub const MAX_VIEWS: usize = 1024;

/// Height up to which space is empty. A larger value would lose thin things at the base plane. With
/// a smaller one, rays along the base plane would hit non-existent solids in `f32`.
pub const EMPTY_HEIGHT: f64 = 1e-5;

/// Default jump of cells, in texels. Surfaces steeper than 76 degrees are seen better in another
/// image.
pub const DEFAULT_JUMP_TEXELS: f64 = 4.0;

/// Treatment of a cell between the centres of four texels whose heights differ by more than the
/// object's jump.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum JumpCells {
    /// Bilinear, as everywhere.
    Bilinear,
    /// At each position, the height of the nearest of the four texels. Ties go to the texel further
    /// right or down.
    Step,
    /// Everywhere the height of the highest texel.
    #[default]
    Highest,
    /// All cells are treated as with `Step`, even without a jump.
    Nearest,
}

/// An object defined by images with depth.
///
/// The solid of an image is the space above [`EMPTY_HEIGHT`] and at or below the height of its map.
/// Texels of 0 show nothing, and beside the image there are only such texels. Between the centres
/// of four texels the map is bilinear, except for [`JumpCells`] where they differ by more than the
/// jump. So the solid extends beside the image by half a texel, and neighbouring cells may differ
/// in height: there are walls between them. The object is the intersection of the solids.
#[derive(Clone, Debug, PartialEq)]
pub struct ImageObject {
    views: Vec<View>,
    layout: AtlasLayout,
    heights: HeightMap,
    /// Maxima over many cells.
    pyramid: MaxPyramid,
    /// Highest texel of each image.
    tops: Vec<f64>,
    /// Images whose silhouettes define the visual hull.
    silhouettes: Vec<usize>,
    cells: JumpCells,
    jump: f64,
}

/// Most texels that are tested for a solid.
const MOST_ASKED: usize = 4096;

/// Why images do not define an object.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ObjectError {
    /// There are no images, or too many.
    #[error("an object has 1 to {MAX_VIEWS} images, this one {0}")]
    BadCount(usize),
    /// The numbers of maps and views differ.
    #[error("{views} views and {maps} maps: each view needs one")]
    OtherCount {
        /// Number of views.
        views: usize,
        /// Number of maps.
        maps: usize,
    },
    /// A map has another size than its view.
    #[error("the map of image {number} is {}x{}, its view {}x{}", map[0], map[1], view[0], view[1])]
    OtherSize {
        /// Number of the image, counted from 0.
        number: usize,
        /// Columns and rows of the map.
        map: [u32; 2],
        /// Columns and rows of the view.
        view: [u32; 2],
    },
    /// The jump is negative or NaN.
    #[error("cells jump where they differ by {0} texels: it must be 0 or more")]
    BadJump(f64),
    /// The maps do not make a height map.
    #[error(transparent)]
    Heights(#[from] HeightMapError),
}

impl ImageObject {
    /// Creates an object from views and one map per view. Cells jump where their corners differ by
    /// more than `jump_texels` texels of the coarsest image.
    ///
    /// # Errors
    ///
    /// When there are no views or more than [`MAX_VIEWS`], maps do not fit their views, or the jump
    /// is negative or NaN.
    pub fn new(
        views: Vec<View>,
        maps: &[HeightMap],
        cells: JumpCells,
        jump_texels: f64,
    ) -> Result<Self, ObjectError> {
        if views.is_empty() || views.len() > MAX_VIEWS {
            return Err(ObjectError::BadCount(views.len()));
        }
        if views.len() != maps.len() {
            return Err(ObjectError::OtherCount { views: views.len(), maps: maps.len() });
        }
        for (number, (view, map)) in views.iter().zip(maps).enumerate() {
            let (view, map) = (view.size(), [map.width(), map.height()]);
            if view != map {
                return Err(ObjectError::OtherSize { number, map, view });
            }
        }
        if jump_texels.is_nan() || jump_texels < 0.0 {
            return Err(ObjectError::BadJump(jump_texels));
        }
        let layout = AtlasLayout::new(views.iter().map(View::size).collect())?;
        let [width, height] = layout.size();
        let texels = layout.pack(maps.iter().map(HeightMap::texels), 0.0);
        let heights = HeightMap::new(width, height, texels, Wrap::Clamp)?;
        let pyramid = MaxPyramid::new(&heights);
        let tops =
            maps.iter().map(|map| f64::from(map.texels().iter().copied().fold(0.0, f32::max))).collect();
        let silhouettes = Vec::new();
        let mut object = Self { views, layout, heights, pyramid, tops, silhouettes, cells, jump: 0.0 };
        object.silhouettes =
            (0..object.views.len()).filter(|number| object.opposite_silhouette(*number).is_none()).collect();
        Ok(object.with_jump(jump_texels))
    }

    /// Sets the treatment of cells that jump, and the jump in texels of the coarsest image.
    ///
    /// # Errors
    ///
    /// When the jump is negative or NaN.
    pub fn with_cells(mut self, cells: JumpCells, jump_texels: f64) -> Result<Self, ObjectError> {
        if jump_texels.is_nan() || jump_texels < 0.0 {
            return Err(ObjectError::BadJump(jump_texels));
        }
        self.cells = cells;
        Ok(self.with_jump(jump_texels))
    }

    fn with_jump(self, texels: f64) -> Self {
        Self { jump: self.jump_of(texels), ..self }
    }

    /// Difference of heights that is as large as `texels` texels of the coarsest image are wide.
    pub fn jump_of(&self, texels: f64) -> f64 {
        texels * self.views.iter().map(View::texel_height).fold(0.0, f64::max)
    }

    /// Returns the object, moved from where it is by a placement: turned, scaled and shifted once more.
    /// Its images are shared.
    ///
    /// # Errors
    ///
    /// When the placement has a number that is not finite, or its size is not positive.
    pub fn placed(&self, placement: &Placement) -> Result<Self, MeshError> {
        let views = self.views.iter().map(|view| view.placed(placement)).collect::<Result<_, _>>()?;
        Ok(Self { views, ..self.clone() })
    }

    /// Views of the images.
    pub fn views(&self) -> &[View] {
        &self.views
    }

    /// Layout of the images in [`heights`](Self::heights).
    pub fn layout(&self) -> &AtlasLayout {
        &self.layout
    }

    /// Atlas of the images' maps, placed by [`layout`](Self::layout), with a border of one texel of
    /// 0 around each. Heights are as in the images: 0 is an image's base plane, 1 its plane nearest
    /// to the viewer (see [`View`]).
    pub fn heights(&self) -> &HeightMap {
        &self.heights
    }

    /// Treatment of cells with height jumps.
    pub fn cells(&self) -> JumpCells {
        self.cells
    }

    /// Difference of heights, as in [`heights`](Self::heights), beyond which a cell jumps.
    pub fn jump(&self) -> f64 {
        self.jump
    }

    /// Axis-aligned box around the object: least and greatest coordinates. `None` if an image shows
    /// nothing.
    pub fn bounds(&self) -> Option<[DVec3; 2]> {
        let all = [DVec3::NEG_INFINITY, DVec3::INFINITY];
        (0..self.views.len()).try_fold(all, |[low, high], number| {
            let corners = self.corners_of(number)?;
            let [least, most] = corners
                .into_iter()
                .fold([DVec3::INFINITY, DVec3::NEG_INFINITY], |of, at| [of[0].min(at), of[1].max(at)]);
            let bounds = [low.max(least), high.min(most)];
            bounds[0].cmplt(bounds[1]).all().then_some(bounds)
        })
    }

    /// Whether any solid remains in the intersection of all images: whether the ray of a texel that
    /// shows something hits it. If there are many texels, an even selection over all images is
    /// tested.
    ///
    /// A single sheet has no solid, since images along it show nothing.
    pub fn has_solid(&self) -> bool {
        let texels = self.views.iter().zip(self.layout.places()).flat_map(|(view, place)| {
            let [columns, rows] = view.size();
            (0..rows).flat_map(move |y| (0..columns).map(move |x| (view, *place, [x, y])))
        });
        let seen: Vec<_> = texels
            .filter(|(_, place, [x, y])| {
                let texel = self.heights.texel(i64::from(place[0] + x), i64::from(place[1] + y));
                f64::from(texel) > EMPTY_HEIGHT
            })
            .collect();
        let step = seen.len().div_ceil(MOST_ASKED).max(1);
        seen.iter().step_by(step).any(|(view, _, [x, y])| {
            let [columns, rows] = view.size().map(f64::from);
            let ray = view.ray((f64::from(*x) + 0.5) / columns, (f64::from(*y) + 0.5) / rows);
            self.first_hit(&ray).is_some()
        })
    }

    /// Corners of the part of an image's space that may be solid: up to its highest texel. For a
    /// perspective image it is the whole space, since a silhouette has no height and widens with
    /// the distance from the eye.
    fn corners_of(&self, number: usize) -> Option<[DVec3; 8]> {
        let (view, place) = (&self.views[number], self.layout.places()[number]);
        let [columns, rows] = view.size();
        let (mut low, mut high, mut top) = ([u32::MAX; 2], [0; 2], 0.0_f32);
        for y in 0..rows {
            for x in 0..columns {
                let texel = self.heights.texel(i64::from(place[0] + x), i64::from(place[1] + y));
                if f64::from(texel) > EMPTY_HEIGHT {
                    low = [low[0].min(x), low[1].min(y)];
                    high = [high[0].max(x), high[1].max(y)];
                    top = top.max(texel);
                }
            }
        }
        if top == 0.0 {
            return None;
        }
        let top = if view.eye().is_some() { 1.0 } else { f64::from(top) };
        // Cells extend from a texel's centre to the centres of the neighbouring texels.
        let [left, up] = low.map(|at| f64::from(at) - 0.5);
        let [right, down] = high.map(|at| f64::from(at) + 1.5);
        Some(std::array::from_fn(|corner| {
            let [x, y, z] = [0, 1, 2].map(|axis| corner >> axis & 1);
            view.point(DVec3::new(
                [left, right][x] / f64::from(columns),
                [up, down][y] / f64::from(rows),
                [EMPTY_HEIGHT, top][z],
            ))
        }))
    }
}

#[cfg(test)]
mod tests;
