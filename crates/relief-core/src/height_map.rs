//! The height map: the input from which everything else is derived.

mod surface;

use std::sync::{Arc, OnceLock};

use crate::area_mean::{coarser, coarser_size, level_count};
use crate::{HeightsHash, TexelMask, Wrap};

/// Longest side of a height map, in texels. Cell numbers up to this limit are exact in the shaders'
/// `f32`.
pub const MAX_SIDE: u32 = 1 << 20;

/// Most texels of a height map (4 GiB of `f32`).
pub const MAX_TEXELS: u64 = 1 << 30;

/// A rectangular map of heights, and the surface that it defines.
///
/// * Texels are `f32` in `[0, 1]`, row 0 on top, 1 is highest. Texel `(i, j)` has its centre at
///   texture coordinates `((i + ½) / W, (j + ½) / H)`. `(0, 0)` is the top-left corner, `u` grows
///   to the right and `v` downward.
/// * Between texel centres the surface is *bilinear*. All errors are measured against this surface.
///   It consists of *dual cells*: cell `(i, j)` is the square between the centres of the texels
///   `(i, j)` and `(i + 1, j + 1)`. So a point lies in the cell `floor(u W - ½), floor(v H - ½)`.
/// * A texel displaces the base surface along its unit normal by `bias_m + scale_m * texel` metres
///   (Szirmay-Kalos and Umenhoffer 2008, eq. 8).
/// * [`Wrap`] continues the map beyond its edges.
/// * `texel_size_m`, `physical_range`, `stated_displacement_m`, `filled_texels`, `holes` and
///   `nearly_grey_texels` are metadata. Slopes depend on the tangent frame alone, and holes have
///   heights as all texels do.
///
/// Clones share their texels, even with another wrap or displacement.
#[derive(Clone, Debug, PartialEq)]
pub struct HeightMap {
    width: u32,
    height: u32,
    heights: Arc<Heights>,
    wrap: Wrap,
    scale_m: f64,
    bias_m: f64,
    texel_size_m: Option<[f64; 2]>,
    physical_range: Option<[f64; 2]>,
    /// Whether texel size and physical range are in one unknown unit instead of metres.
    unnamed_unit: bool,
    /// Whether the source or the caller names the unit of the heights.
    named_heights: bool,
    stated_displacement_m: Option<[f64; 2]>,
    filled_texels: u64,
    holes: Option<Arc<TexelMask>>,
    nearly_grey_texels: u64,
}

/// Data shared by the clones of a map.
#[derive(Debug)]
struct Heights {
    texels: Vec<f32>,
    /// Computed at the first request.
    hash: OnceLock<HeightsHash>,
    /// Coarser mip levels, computed at the first request.
    coarser: OnceLock<Vec<HeightMap>>,
}

impl PartialEq for Heights {
    fn eq(&self, other: &Self) -> bool {
        self.texels == other.texels
    }
}

/// Why texels do not make a height map.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum HeightMapError {
    /// A side is zero.
    #[error("a height map needs at least one texel, this one is {width}x{height}")]
    Empty {
        /// Width in texels.
        width: u32,
        /// Height in texels.
        height: u32,
    },
    /// A side or the number of texels is above [`MAX_SIDE`] or [`MAX_TEXELS`].
    #[error(
        "a height map of {width}x{height} is too large: at most {MAX_SIDE} texels a side and {MAX_TEXELS} in \
         all"
    )]
    TooLarge {
        /// Width in texels.
        width: u32,
        /// Height in texels.
        height: u32,
    },
    /// The holes are marked for a map of another size.
    #[error("holes of {}x{} texels do not fit a height map of {}x{}", holes[0], holes[1], map[0], map[1])]
    OtherHoles {
        /// Columns and rows of the marked texels.
        holes: [u32; 2],
        /// Columns and rows of the map.
        map: [u32; 2],
    },
    /// The number of texels is not width times height.
    #[error(
        "a height map of {width}x{height} needs {} texels, {given} were given",
        u64::from(*width) * u64::from(*height)
    )]
    WrongLength {
        /// Width in texels.
        width: u32,
        /// Height in texels.
        height: u32,
        /// Number of texels given.
        given: usize,
    },
    /// A texel is NaN, infinite, or outside `[0, 1]`.
    #[error("texel ({column}, {row}) is {value}: heights must be finite and between 0 and 1")]
    OutOfRange {
        /// Column of the first such texel.
        column: u32,
        /// Row of the first such texel.
        row: u32,
        /// Value of that texel.
        value: f32,
    },
    /// Scale, bias, texel size or range is NaN, infinite, or (texel size) not positive.
    #[error("{what} is {value}: it must be {must}")]
    BadNumber {
        /// Name of the number.
        what: &'static str,
        /// Value of the number.
        value: f64,
        /// Accepted values.
        must: &'static str,
    },
}

impl HeightMap {
    /// A height map of texels in `[0, 1]`, row by row from the top, with scale 1 m and bias 0.
    ///
    /// # Errors
    ///
    /// When a side is 0 or too large, `texels.len()` is not `width * height`, or a texel is not in
    /// `[0, 1]`.
    pub fn new(width: u32, height: u32, texels: Vec<f32>, wrap: Wrap) -> Result<Self, HeightMapError> {
        Self::check_size(width, height)?;
        if texels.len() as u64 != u64::from(width) * u64::from(height) {
            return Err(HeightMapError::WrongLength { width, height, given: texels.len() });
        }
        if let Some(at) = texels.iter().position(|texel| !(0.0..=1.0).contains(texel)) {
            let (column, row) = ((at % width as usize) as u32, (at / width as usize) as u32);
            return Err(HeightMapError::OutOfRange { column, row, value: texels[at] });
        }
        Ok(Self {
            width,
            height,
            heights: Arc::new(Heights { texels, hash: OnceLock::new(), coarser: OnceLock::new() }),
            wrap,
            scale_m: 1.0,
            bias_m: 0.0,
            texel_size_m: None,
            physical_range: None,
            unnamed_unit: false,
            named_heights: false,
            stated_displacement_m: None,
            filled_texels: 0,
            holes: None,
            nearly_grey_texels: 0,
        })
    }

    /// A height map whose texels are computed from column and row. They are clamped to `[0, 1]`;
    /// NaN becomes 0.
    ///
    /// # Errors
    ///
    /// When a side is 0 or too large.
    pub fn from_fn(
        width: u32,
        height: u32,
        wrap: Wrap,
        mut texel: impl FnMut(u32, u32) -> f32,
    ) -> Result<Self, HeightMapError> {
        Self::check_size(width, height)?;
        let mut texels = Vec::with_capacity(width as usize * height as usize);
        for row in 0..height {
            for column in 0..width {
                let texel = texel(column, row);
                texels.push(if texel.is_nan() { 0.0 } else { texel.clamp(0.0, 1.0) });
            }
        }
        Self::new(width, height, texels, wrap)
    }

    /// Checks that a map of that size is accepted. Call it before allocating memory for the map.
    ///
    /// # Errors
    ///
    /// When a side is 0 or too large.
    pub fn check_size(width: u32, height: u32) -> Result<(), HeightMapError> {
        if width == 0 || height == 0 {
            return Err(HeightMapError::Empty { width, height });
        }
        let texels = u64::from(width) * u64::from(height);
        if width > MAX_SIDE || height > MAX_SIDE || texels > MAX_TEXELS {
            return Err(HeightMapError::TooLarge { width, height });
        }
        Ok(())
    }

    /// Sets the wrap.
    #[must_use]
    pub fn with_wrap(mut self, wrap: Wrap) -> Self {
        self.wrap = wrap;
        self
    }

    /// Sets scale and bias: texels are displaced by `bias_m + scale_m * texel` metres.
    ///
    /// # Errors
    ///
    /// When `scale_m` is negative or either is not finite.
    pub fn with_displacement(mut self, scale_m: f64, bias_m: f64) -> Result<Self, HeightMapError> {
        if !(scale_m >= 0.0 && scale_m.is_finite()) {
            let must = "finite and not negative";
            return Err(HeightMapError::BadNumber { what: "the scale", value: scale_m, must });
        }
        if !bias_m.is_finite() {
            return Err(HeightMapError::BadNumber { what: "the bias", value: bias_m, must: "finite" });
        }
        self.scale_m = scale_m;
        self.bias_m = bias_m;
        Ok(self)
    }

    /// Sets the size of a texel along `u` and `v`, in metres.
    ///
    /// # Errors
    ///
    /// When a size is not finite and positive.
    pub fn with_texel_size_m(mut self, size_m: [f64; 2]) -> Result<Self, HeightMapError> {
        if let Some(&value) = size_m.iter().find(|size| !(size.is_finite() && **size > 0.0)) {
            let must = "finite and positive";
            return Err(HeightMapError::BadNumber { what: "the texel size", value, must });
        }
        self.texel_size_m = Some(size_m);
        self.unnamed_unit = false;
        Ok(self)
    }

    /// States that texel size and physical range are in one unknown unit instead of metres. The
    /// map's proportions are then known, its lengths are not. A new texel size in metres makes them
    /// known.
    #[must_use]
    pub fn with_unnamed_unit(mut self) -> Self {
        self.unnamed_unit = true;
        self
    }

    /// States that the source names the unit of the heights. Such heights need less doubt.
    #[must_use]
    pub fn with_named_heights(mut self) -> Self {
        self.named_heights = true;
        self
    }

    /// Whether the source names the unit of the heights.
    pub fn has_named_heights(&self) -> bool {
        self.named_heights
    }

    /// Sets the physical values of texel 0 and texel 1 (metres for elevation models).
    ///
    /// # Errors
    ///
    /// When a value is not finite.
    pub fn with_physical_range(mut self, range: [f64; 2]) -> Result<Self, HeightMapError> {
        if let Some(&value) = range.iter().find(|value| !value.is_finite()) {
            return Err(HeightMapError::BadNumber { what: "the physical range", value, must: "finite" });
        }
        self.physical_range = Some(range);
        Ok(self)
    }

    /// Sets the displacements of texel 0 and texel 1, in metres, that the source states for its
    /// mesh. They replace the map's scale and bias.
    ///
    /// # Errors
    ///
    /// When a value is not finite, or the first is the greater.
    pub fn with_stated_displacement_m(self, [low, high]: [f64; 2]) -> Result<Self, HeightMapError> {
        let map = self.with_displacement(high - low, low)?;
        Ok(Self { stated_displacement_m: Some([low, high]), ..map })
    }

    /// Sets the number of texels that had no value in the source and were filled.
    #[must_use]
    pub fn with_filled_texels(mut self, count: u64) -> Self {
        self.filled_texels = count;
        self
    }

    /// Marks texels as holes. Holes keep a height, since all texels have one, but it means nothing.
    /// An empty mask removes all holes.
    ///
    /// # Errors
    ///
    /// When the mask has another size than the map.
    pub fn with_holes(mut self, holes: impl Into<Arc<TexelMask>>) -> Result<Self, HeightMapError> {
        let holes = holes.into();
        let [of_holes, of_map] = [[holes.width(), holes.height()], [self.width, self.height]];
        if of_holes != of_map {
            return Err(HeightMapError::OtherHoles { holes: of_holes, map: of_map });
        }
        self.holes = (holes.count() > 0).then_some(holes);
        Ok(self)
    }

    /// Sets the number of texels whose red, green and blue in the source were not quite equal.
    #[must_use]
    pub fn with_nearly_grey_texels(mut self, count: u64) -> Self {
        self.nearly_grey_texels = count;
        self
    }

    /// Width in texels.
    #[inline]
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Height (number of rows) in texels.
    #[inline]
    pub fn height(&self) -> u32 {
        self.height
    }

    /// All texels, row by row from the top.
    #[inline]
    pub fn texels(&self) -> &[f32] {
        &self.heights.texels
    }

    /// Returns all texels. They are copied if a clone of the map still shares them.
    pub fn into_texels(self) -> Vec<f32> {
        Arc::try_unwrap(self.heights).map_or_else(|shared| shared.texels.clone(), |own| own.texels)
    }

    /// Whether the two maps share their texels in memory, as clones do.
    pub fn shares_texels(&self, other: &HeightMap) -> bool {
        Arc::ptr_eq(&self.heights, &other.heights)
    }

    /// Hash that identifies the map's size and heights. The first call hashes all texels.
    pub fn heights_hash(&self) -> HeightsHash {
        *self.heights.hash.get_or_init(|| HeightsHash::of(self.width, self.height, self.texels()))
    }

    /// Number of mip levels: the map itself and the coarser levels down to a single texel.
    pub fn levels(&self) -> u32 {
        level_count([self.width, self.height])
    }

    /// Returns a mip level; level 0 is the map itself.
    ///
    /// Each level has half the sides of the previous one, rounded down, but at least 1. A texel is
    /// the mean over the area that it covers. Levels beyond the coarsest are the single texel
    /// again. Wrap, scale and bias are kept, metadata is not.
    ///
    /// The first call for a coarser level computes all of them. They take a third of the map's
    /// memory.
    #[must_use]
    pub fn level(&self, level: u32) -> HeightMap {
        let Some(last) = level.min(self.levels() - 1).checked_sub(1) else { return self.clone() };
        let Self { wrap, scale_m, bias_m, .. } = *self;
        HeightMap { wrap, scale_m, bias_m, ..self.coarser()[last as usize].clone() }
    }

    /// Least and greatest texel.
    pub fn extremes(&self) -> [f32; 2] {
        let wider = |[low, high]: [f32; 2], texel: &f32| [low.min(*texel), high.max(*texel)];
        self.texels().iter().fold([f32::INFINITY, f32::NEG_INFINITY], wider)
    }

    /// Mean of all texels, except for rounding: the texel of the coarsest level.
    pub fn mean(&self) -> f32 {
        self.level(self.levels() - 1).texels()[0]
    }

    /// All mip levels from 1 on, with sizes and texels only. Clones share them, so wrap, scale and
    /// bias may differ from the map's; [`level`](Self::level) sets them.
    pub fn coarser(&self) -> &[HeightMap] {
        self.heights.coarser.get_or_init(|| {
            let mut levels: Vec<HeightMap> = Vec::new();
            for _ in 1..self.levels() {
                let finer = levels.last().unwrap_or(self);
                let size = [finer.width, finer.height];
                let texels = coarser(finer.texels().as_chunks::<1>().0, size).into_flattened();
                let [width, height] = coarser_size(size);
                let heights = Heights { texels, hash: OnceLock::new(), coarser: OnceLock::new() };
                levels.push(HeightMap {
                    width,
                    height,
                    heights: Arc::new(heights),
                    texel_size_m: None,
                    physical_range: None,
                    filled_texels: 0,
                    holes: None,
                    nearly_grey_texels: 0,
                    ..*self
                });
            }
            levels
        })
    }

    /// Continuation of the map beyond its edges.
    #[inline]
    pub fn wrap(&self) -> Wrap {
        self.wrap
    }

    /// Lengths in metres that the source states: the tile along `u` and `v`, and the difference
    /// between heights 0 and 1. `None` if it does not state both, or if the relief is level.
    pub fn stated_lengths_m(&self) -> Option<([f64; 2], f64)> {
        self.stated_lengths().filter(|_| !self.unnamed_unit)
    }

    /// Lengths as in [`stated_lengths_m`](Self::stated_lengths_m), in metres or in an [unknown
    /// unit](Self::with_unnamed_unit). Their ratio is known in both cases.
    pub fn stated_lengths(&self) -> Option<([f64; 2], f64)> {
        let (tile, [zero, one]) = (self.stated_tile()?, self.physical_range?);
        let span = (one - zero).abs();
        (span > 0.0).then_some((tile, span))
    }

    /// Length of the tile along `u` and `v` in metres, if the source states it.
    pub fn stated_tile_m(&self) -> Option<[f64; 2]> {
        self.stated_tile().filter(|_| !self.unnamed_unit)
    }

    fn stated_tile(&self) -> Option<[f64; 2]> {
        let [u, v] = self.texel_size_m?;
        Some([u * f64::from(self.width), v * f64::from(self.height)])
    }

    /// Lengths of the tile along `u` and `v`, relative to the longer one. They are as the source
    /// states, or as for square texels.
    pub fn proportions(&self) -> [f64; 2] {
        let tile = self.stated_tile().unwrap_or([f64::from(self.width), f64::from(self.height)]);
        tile.map(|length| length / tile[0].max(tile[1]))
    }

    /// Displacement, in metres, of texel 1 above texel 0.
    #[inline]
    pub fn scale_m(&self) -> f64 {
        self.scale_m
    }

    /// Displacement, in metres, of texel 0.
    #[inline]
    pub fn bias_m(&self) -> f64 {
        self.bias_m
    }

    /// Size of a texel along `u` and `v` in metres, if the file states it.
    #[inline]
    pub fn texel_size_m(&self) -> Option<[f64; 2]> {
        self.texel_size_m.filter(|_| !self.unnamed_unit)
    }

    /// Physical values of texel 0 and texel 1, if known.
    #[inline]
    pub fn physical_range(&self) -> Option<[f64; 2]> {
        self.physical_range
    }

    /// Displacements of texel 0 and texel 1, in metres, that the source states for its mesh, if
    /// any.
    #[inline]
    pub fn stated_displacement_m(&self) -> Option<[f64; 2]> {
        self.stated_displacement_m
    }

    /// Number of texels that had no value in the source and were filled from their surroundings.
    #[inline]
    pub fn filled_texels(&self) -> u64 {
        self.filled_texels
    }

    /// Texels that are holes: they had no value in the source, or a value that means "none". `None`
    /// if there are no holes.
    #[inline]
    pub fn holes(&self) -> Option<&Arc<TexelMask>> {
        self.holes.as_ref()
    }

    /// Number of texels whose red, green and blue in the source were not quite equal, so that their
    /// mean was taken.
    #[inline]
    pub fn nearly_grey_texels(&self) -> u64 {
        self.nearly_grey_texels
    }
}

#[cfg(test)]
mod tests;
