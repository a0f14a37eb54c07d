//! Size of a picture: columns and rows, or one pixel per texel of a height map.

use std::fmt;
use std::str::FromStr;

use super::error::{ValueError, ValueProblem};
use super::{MAX_IMAGE_SIDE, MeshChoice, ProjectionChoice, SceneSpec, Surface, View};
use relief_core::mesh::Builtin;

/// Largest distance of the outermost texel from its pixel, in pixels.
const MOST_BESIDE: f64 = 0.05;

/// Size of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PictureSize {
    /// Columns and rows, each from 1 to [`MAX_IMAGE_SIDE`].
    Pixels([u32; 2]),
    /// One pixel per texel of the height map, which fills the picture. Tiles repeat the texels.
    ///
    /// The scene must have one surface on the built-in plane, not rotated, seen in the view `top`
    /// with the projection `orthographic`.
    Map,
}

/// Error for a text that is no size.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("write it as WxH, as in 800x600, or as map")]
pub struct PictureSizeError;

/// Reason why a picture cannot have one pixel per texel.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum MapSizeProblem {
    /// There are several surfaces.
    #[error("'map' is one pixel for each texel of one surface, and the scene has {0}: give width and height")]
    Several(usize),
    /// The surface has no height map.
    #[error(
        "'map' is one pixel for each texel of a height map, and the surface has none: give width and height"
    )]
    NoMap,
    /// The height map lies on another mesh.
    #[error(
        "'map' is one pixel for each texel, which needs the mesh 'plane': leave the mesh out, or give width \
         and height"
    )]
    OtherMesh,
    /// The plane is rotated.
    #[error(
        "'map' is one pixel for each texel, and the plane is rotated: leave its rotation out, or give width \
         and height"
    )]
    Turned,
    /// A tile ends within a texel. Holds the texels along both axes.
    #[error(
        "'map' is one pixel for each texel, and the tiles have {} by {} texels: choose tiles of whole \
         texels, or give width and height", .0[0], .0[1]
    )]
    PartTexels([f64; 2]),
    /// Texels are not square. Holds width over height.
    #[error(
        "'map' is one pixel for each texel, and texels are {:.4} times as wide as high: choose a 'tile-size' \
         of square texels, or give width and height", .0
    )]
    NotSquare(f64),
}

impl From<[u32; 2]> for PictureSize {
    fn from(size: [u32; 2]) -> Self {
        PictureSize::Pixels(size)
    }
}

impl fmt::Display for PictureSize {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            PictureSize::Pixels([width, height]) => write!(f, "{width}x{height}"),
            PictureSize::Map => f.write_str("map"),
        }
    }
}

impl FromStr for PictureSize {
    type Err = PictureSizeError;

    fn from_str(text: &str) -> Result<Self, PictureSizeError> {
        if text == "map" {
            return Ok(PictureSize::Map);
        }
        let (width, height) = text.split_once(['x', 'X']).ok_or(PictureSizeError)?;
        let side = |text: &str| text.parse().map_err(|_| PictureSizeError);
        Ok(PictureSize::Pixels([side(width)?, side(height)?]))
    }
}

/// Refuses pictures without pixels or with too many along a side.
pub(super) fn check_size([width, height]: [u32; 2]) -> Result<[u32; 2], ValueError> {
    if [width, height].iter().all(|side| (1..=MAX_IMAGE_SIDE).contains(side)) {
        return Ok([width, height]);
    }
    Err(ValueProblem::Size { width, height }.of("size"))
}

impl SceneSpec {
    /// Returns whether the picture has one pixel per texel.
    pub(super) fn is_of_map_size(&self) -> bool {
        self.size == Some(PictureSize::Map)
    }

    /// Returns the size in pixels if it is known without a file.
    pub(super) fn pixels(&self) -> Option<[u32; 2]> {
        match self.size {
            Some(PictureSize::Pixels(size)) => Some(size),
            Some(PictureSize::Map) | None => None,
        }
    }

    /// Checks everything about a picture with one pixel per texel that needs no file.
    pub(super) fn check_map_size(&self) -> Result<(), ValueError> {
        let of_size = |problem: ValueProblem| Err(problem.of("size"));
        if self.view != Some(View::Top) {
            return of_size(ValueProblem::Needs("view top"));
        }
        if self.projection != Some(ProjectionChoice::Orthographic) {
            return of_size(ValueProblem::Needs("projection orthographic"));
        }
        let surfaces = self.each_surface();
        let [surface] = &surfaces[..] else {
            return of_size(MapSizeProblem::Several(surfaces.len()).into());
        };
        if surface.object.is_some() || surface.volume.is_some() || surface.is_mesh_alone() {
            return of_size(MapSizeProblem::NoMap.into());
        }
        if !matches!(surface.mesh, None | Some(MeshChoice::Builtin(Builtin::Plane))) {
            return of_size(MapSizeProblem::OtherMesh.into());
        }
        if surface.rotation.is_some_and(|turns| turns.iter().any(|turn| *turn != 0.0)) {
            return of_size(MapSizeProblem::Turned.into());
        }
        Ok(())
    }

    /// Returns the size of a picture with one pixel per texel of `surface`, which was loaded from
    /// this description.
    pub(super) fn map_size(&self, surface: &Surface) -> Result<[u32; 2], ValueError> {
        let of_size = |problem: MapSizeProblem| ValueProblem::from(problem).of("size");
        let map = surface.height_map();
        let tiles = self.each_surface().first().and_then(|surface| surface.tile).unwrap_or([1.0; 2]);
        let in_tile = [map.width(), map.height()].map(f64::from);
        let texels = [0, 1].map(|axis| in_tile[axis] * f64::from(tiles[axis]));
        let whole = texels.map(f64::round);
        let is_whole = |axis: usize| (texels[axis] - whole[axis]).abs() <= MOST_BESIDE && whole[axis] >= 1.0;
        if !(is_whole(0) && is_whole(1)) {
            return Err(of_size(MapSizeProblem::PartTexels(texels)));
        }
        // A number beyond `u32` saturates, which is too large as well.
        let size = check_size(whole.map(|side| side as u32))?;
        let tile_m = surface.metric().tile_m;
        let wide = tile_m[0] / in_tile[0] / (tile_m[1] / in_tile[1]);
        let is_square = (wide - 1.0).abs() * 0.5 * whole[0].max(whole[1]) <= MOST_BESIDE;
        if !is_square {
            return Err(of_size(MapSizeProblem::NotSquare(wide)));
        }
        Ok(size)
    }
}
