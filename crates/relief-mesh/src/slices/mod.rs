//! Slices through the space above a base that a relief fills, as triangles with a height at each corner.
//!
//! Source: Kautz and Seidel 2001, *Hardware Accelerated Displacement Mapping for Image Based Rendering*,
//! section 3. A slice is drawn where the height map is as high as the slice; whatever draws it decides that
//! point by point.

mod error;
mod surface;

use std::sync::atomic::Ordering;

use relief_core::HeightMap;
use relief_core::mesh::{Mesh, Vertex};

pub use self::error::SliceError;
use crate::Watch;

/// Which slices there are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SliceSettings {
    /// Slices over the displacement from height 0 to 1, at least 1.
    pub count: u32,
}

/// A corner of a slice.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SliceVertex {
    /// The corner in the world, with the normal, the tangents and the texture coordinates of the point of the
    /// base under it.
    pub vertex: Vertex,
    /// Its height, from 0 to 1.
    pub height: f32,
    /// How far the next slice is, as a height.
    pub spacing: f32,
}

/// Some slices, or parts of them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SliceBlock {
    /// The corners.
    pub vertices: Vec<SliceVertex>,
    /// The corners of each triangle, counter-clockwise where the base is seen from its front.
    pub triangles: Vec<[u32; 3]>,
}

/// Makes the slices of a mesh under a height map.
///
/// ```
/// use relief_core::{HeightMap, Wrap, mesh::torus};
/// use relief_mesh::{SliceSettings, Slicer, Watch};
///
/// let map = HeightMap::from_fn(64, 32, Wrap::Repeat, |i, j| ((i ^ j) & 8) as f32 / 8.0)?;
/// let map = map.with_displacement(0.02, 0.0)?;
/// let base = torus(16, 8)?;
/// let slicer = Slicer::new(&base, &map, SliceSettings { count: 20 })?;
/// let mut triangles = 0;
/// slicer.each(&Watch::NOBODY, |block| triangles += block.triangles.len())?;
/// assert_eq!((triangles, slicer.triangles()), (20 * base.triangles().len(), 20 * 256));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Slicer<'a> {
    base: &'a Mesh,
    /// Metres between the heights 0 and 1, and of the height 0.
    scale_m: f64,
    bias_m: f64,
    settings: SliceSettings,
}

impl<'a> Slicer<'a> {
    /// The slices of a base through the displacement of a height map.
    ///
    /// # Errors
    ///
    /// When there is no slice.
    pub fn new(base: &'a Mesh, map: &HeightMap, settings: SliceSettings) -> Result<Self, SliceError> {
        if settings.count == 0 {
            return Err(SliceError::None);
        }
        Ok(Self { base, scale_m: map.scale_m(), bias_m: map.bias_m(), settings })
    }

    /// How many corners its slices have at most.
    pub fn vertices(&self) -> u64 {
        u64::from(self.settings.count) * self.base.vertices().len() as u64
    }

    /// How many triangles its slices have at most.
    pub fn triangles(&self) -> u64 {
        u64::from(self.settings.count) * self.base.triangles().len() as u64
    }

    /// Hands over all slices, block by block, always in the same order; the triangles of a block name its own
    /// corners.
    ///
    /// # Errors
    ///
    /// When it was cancelled, or a corner lies farther away than `f32` can tell.
    pub fn each(&self, watch: &Watch, mut take: impl FnMut(&SliceBlock)) -> Result<(), SliceError> {
        let count = self.settings.count;
        for number in 1..=count {
            if watch.cancel.load(Ordering::Relaxed) {
                return Err(SliceError::Cancelled);
            }
            take(&self.of_surface(number)?);
            (watch.tell)(number as f32 / count as f32);
        }
        Ok(())
    }

    /// A corner that lies at a height over a point of the base.
    fn corner(&self, base: &Vertex, height: f64, spacing: f64) -> Result<SliceVertex, SliceError> {
        let metres = self.bias_m + self.scale_m * height;
        let position = (base.position.as_dvec3() + base.normal.as_dvec3() * metres).as_vec3();
        if !position.is_finite() {
            return Err(SliceError::NotFinite);
        }
        let vertex = Vertex { position, ..*base };
        Ok(SliceVertex { vertex, height: height as f32, spacing: spacing as f32 })
    }
}

#[cfg(test)]
mod tests;
