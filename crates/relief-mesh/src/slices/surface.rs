//! Slices that run along the base, at equal heights.
//!
//! Source: Kautz and Seidel 2001, section 3.1.

use super::{SliceBlock, SliceError, Slicer};

impl Slicer<'_> {
    /// The slice of that number, from 1 on, from the top: the last one lies at height 0.
    pub(super) fn of_surface(&self, number: u32) -> Result<SliceBlock, SliceError> {
        let spacing = f64::from(self.settings.count).recip();
        let height = 1.0 - f64::from(number) * spacing;
        let corners = self.base.vertices().iter().map(|vertex| self.corner(vertex, height, spacing));
        Ok(SliceBlock {
            vertices: corners.collect::<Result<_, _>>()?,
            triangles: self.base.triangles().to_vec(),
        })
    }
}
