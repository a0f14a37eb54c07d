//! Volumes: a solid on a surface that is no height field, as values on a grid of voxels.

mod field;
mod integral;
mod layout;
mod trace;

use crate::{HeightMap, HeightMapError, Wrap};

pub use field::VolumeCell;
pub use layout::SliceLayout;
pub use trace::VolumeHit;

/// Most slices of a volume.
pub const MAX_SLICES: u32 = 4096;

/// Values on a grid over a tile of the base surface: a solid with overhangs, threads and hollows.
///
/// * Values are `f32` in `[0, 1]`. The solid is where they are [`Volume::SURFACE`] or more.
/// * Voxel `(i, j, k)` has its centre at texture coordinates `((i + ½) / W, (j + ½) / H)` and height
///   `(k + ½) / D`. Columns and rows are a height map's. Slice 0 is the lowest, at height 0.
/// * Between the centres the field is *trilinear*. It consists of *dual cells*: cell `(i, j, k)` lies
///   between the centres of voxel `(i, j, k)` and voxel `(i + 1, j + 1, k + 1)`.
/// * [`Wrap`] continues it beyond its edges along `u` and `v`. Along the height the outermost slices
///   continue, so the half voxels at heights 0 and 1 have their values.
/// * A height `h` lies `bias_m + scale_m * h` metres along the base's normal, as for a height map.
///
/// The slices lie side by side in one map, see [`Volume::atlas`]. Clones share it.
///
/// Szirmay-Kalos and Umenhoffer 2008, section 5.2.
///
/// ```
/// use relief_core::{Volume, Wrap};
///
/// // A ball in the middle of a tile.
/// let ball = Volume::from_fn([16, 16, 16], Wrap::Repeat, |[u, v, h]| {
///     let [x, y, z] = [u - 0.5, v - 0.5, h - 0.5];
///     0.5 + 4.0 * (0.3 - (x * x + y * y + z * z).sqrt())
/// })?;
/// assert!(ball.value_at([0.5, 0.5, 0.5]) > 0.5);
/// assert!(ball.value_at([0.5, 0.5, 0.95]) < 0.5);
/// # Ok::<(), relief_core::VolumeError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Volume {
    layout: SliceLayout,
    atlas: HeightMap,
}

/// Why values do not make a volume.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum VolumeError {
    /// A side is zero.
    #[error("a volume needs at least one voxel, this one is {}x{}x{}", size[0], size[1], size[2])]
    Empty {
        /// Columns, rows and slices.
        size: [u32; 3],
    },
    /// There are more slices than [`MAX_SLICES`], or more voxels than a height map may have texels.
    #[error(
        "a volume of {}x{}x{} is too large: at most {MAX_SLICES} slices, and {} voxels in all",
        size[0], size[1], size[2], crate::MAX_TEXELS
    )]
    TooLarge {
        /// Columns, rows and slices.
        size: [u32; 3],
    },
    /// The number of values is not columns times rows times slices.
    #[error(
        "a volume of {}x{}x{} needs {} values, {given} were given",
        size[0], size[1], size[2], size.iter().map(|&side| u64::from(side)).product::<u64>()
    )]
    WrongLength {
        /// Columns, rows and slices.
        size: [u32; 3],
        /// Number of values given.
        given: usize,
    },
    /// A value is NaN, infinite, or outside `[0, 1]`.
    #[error(
        "voxel ({}, {}, {}) is {value}: values must be finite and between 0 and 1",
        voxel[0], voxel[1], voxel[2]
    )]
    OutOfRange {
        /// Column, row and slice of the first such voxel.
        voxel: [u32; 3],
        /// Its value.
        value: f32,
    },
    /// A map has not the size of an atlas of such a volume.
    #[error(
        "a volume of {}x{}x{} lies in a map of {}x{}, this one has {}x{}",
        size[0], size[1], size[2], needed[0], needed[1], given[0], given[1]
    )]
    OtherAtlas {
        /// Columns, rows and slices.
        size: [u32; 3],
        /// Columns and rows of its atlas.
        needed: [u32; 2],
        /// Columns and rows of the map.
        given: [u32; 2],
    },
    /// The displacement does not fit.
    #[error(transparent)]
    Displacement(#[from] HeightMapError),
}

impl Volume {
    /// The value at which the surface lies. Greater values are solid.
    pub const SURFACE: f64 = 0.5;

    /// A volume of values in `[0, 1]`: slice by slice from the lowest, each row by row from the top. Its
    /// scale is 1 m and its bias 0.
    ///
    /// # Errors
    ///
    /// When a side is 0 or too large, the number of values is wrong, or one is not in `[0, 1]`.
    pub fn new(size: [u32; 3], values: &[f32], wrap: Wrap) -> Result<Self, VolumeError> {
        let layout = Self::check_size(size)?;
        let voxels = layout.voxels();
        if values.len() as u64 != voxels {
            return Err(VolumeError::WrongLength { size, given: values.len() });
        }
        if let Some(at) = values.iter().position(|value| !(0.0..=1.0).contains(value)) {
            return Err(VolumeError::OutOfRange { voxel: layout.voxel(at), value: values[at] });
        }
        let atlas =
            HeightMap::new(layout.atlas_size()[0], layout.atlas_size()[1], layout.pack(values), wrap)?;
        Ok(Self { layout, atlas })
    }

    /// The volume of that size whose [atlas](Self::atlas) is a map. What remains of the last row of
    /// slices is not looked at.
    ///
    /// # Errors
    ///
    /// When a side is 0 or too large, or the map has another size than the atlas.
    pub fn of_atlas(atlas: HeightMap, size: [u32; 3]) -> Result<Self, VolumeError> {
        let layout = Self::check_size(size)?;
        let (needed, given) = (layout.atlas_size(), [atlas.width(), atlas.height()]);
        if needed != given {
            return Err(VolumeError::OtherAtlas { size, needed, given });
        }
        Ok(Self { layout, atlas })
    }

    /// A volume whose values are computed at the voxels' centres, from `[u, v, h]` in `[0, 1]³`. They are
    /// clamped to `[0, 1]`; NaN becomes 0.
    ///
    /// # Errors
    ///
    /// When a side is 0 or too large.
    pub fn from_fn(
        size: [u32; 3],
        wrap: Wrap,
        mut value: impl FnMut([f64; 3]) -> f64,
    ) -> Result<Self, VolumeError> {
        let layout = Self::check_size(size)?;
        let centre = |at: u32, side: u32| (f64::from(at) + 0.5) / f64::from(side);
        let mut values = Vec::with_capacity(layout.voxels() as usize);
        for k in 0..size[2] {
            for j in 0..size[1] {
                for i in 0..size[0] {
                    let value = value([centre(i, size[0]), centre(j, size[1]), centre(k, size[2])]);
                    values.push(if value.is_nan() { 0.0 } else { value.clamp(0.0, 1.0) as f32 });
                }
            }
        }
        Self::new(size, &values, wrap)
    }

    /// Checks that a volume of that size is accepted, and returns where its slices lie. Call it before
    /// allocating memory for the values.
    ///
    /// # Errors
    ///
    /// When a side is 0 or too large.
    pub fn check_size(size: [u32; 3]) -> Result<SliceLayout, VolumeError> {
        if size.contains(&0) {
            return Err(VolumeError::Empty { size });
        }
        let voxels = size.iter().map(|&side| u128::from(side)).product::<u128>();
        if size[2] > MAX_SLICES || voxels > u128::from(crate::MAX_TEXELS) {
            return Err(VolumeError::TooLarge { size });
        }
        let layout = SliceLayout::new(size);
        let [width, height] = layout.atlas_size();
        HeightMap::check_size(width, height).map_err(|_| VolumeError::TooLarge { size })?;
        Ok(layout)
    }

    /// Sets scale and bias: height `h` lies `bias_m + scale_m * h` metres along the base's normal.
    ///
    /// # Errors
    ///
    /// When `scale_m` is negative or either is not finite.
    pub fn with_displacement(self, scale_m: f64, bias_m: f64) -> Result<Self, VolumeError> {
        Ok(Self { atlas: self.atlas.with_displacement(scale_m, bias_m)?, ..self })
    }

    /// Sets the wrap along `u` and `v`.
    #[must_use]
    pub fn with_wrap(self, wrap: Wrap) -> Self {
        Self { atlas: self.atlas.with_wrap(wrap), ..self }
    }

    /// Columns, rows and slices.
    pub fn size(&self) -> [u32; 3] {
        self.layout.size()
    }

    /// The continuation beyond the edges.
    pub fn wrap(&self) -> Wrap {
        self.atlas.wrap()
    }

    /// Where the slices lie in the atlas.
    pub fn layout(&self) -> SliceLayout {
        self.layout
    }

    /// All slices side by side in one map, with the volume's wrap, scale and bias: the form in which
    /// renderers hold it. As a height map it means nothing.
    pub fn atlas(&self) -> &HeightMap {
        &self.atlas
    }

    /// The value of a voxel. Column and row are wrapped; the slice is clamped.
    #[inline]
    pub fn voxel(&self, i: i64, j: i64, k: i64) -> f32 {
        let [width, height, slices] = self.size();
        let column = self.wrap().index(i, width);
        let row = self.wrap().index(j, height);
        let slice = Wrap::Clamp.index(k, slices);
        let [x, y] = self.layout.place(slice);
        let at = (y + row) as usize * self.layout.atlas_size()[0] as usize + (x + column) as usize;
        self.atlas.texels()[at]
    }

    /// The values of all voxels: slice by slice from the lowest, each row by row from the top.
    pub fn values(&self) -> Vec<f32> {
        self.layout.unpack(self.atlas.texels())
    }
}

#[cfg(test)]
mod tests;
