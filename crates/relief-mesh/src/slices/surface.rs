//! Slices along the base, at equal heights.
//!
//! Source: Kautz and Seidel 2001, section 3.1.

use relief_core::SliceAxis;
use relief_core::mesh::Vertex;

use super::{SliceBlock, SliceError, SliceVertex, Slicer};

impl Slicer<'_> {
    /// Returns a whole slice. Numbers begin with 1 at the top; the last slice lies at height 0.
    pub(super) fn of_surface(&self, number: u64) -> Result<SliceBlock, SliceError> {
        let corners = self.base.vertices().iter().map(|vertex| self.at_layer(vertex, number));
        let triangles = self.base.triangles().to_vec();
        Ok(SliceBlock { vertices: corners.collect::<Result<_, _>>()?, triangles })
    }

    /// Adds all slices over a triangle of the base.
    pub(super) fn along(&self, number: u32, block: &mut SliceBlock) -> Result<(), SliceError> {
        let [a, b, c] = self.base.corners(number);
        for layer in 1..=self.layers {
            block.push(&[self.at_layer(a, layer)?, self.at_layer(b, layer)?, self.at_layer(c, layer)?]);
        }
        Ok(())
    }

    fn at_layer(&self, vertex: &Vertex, number: u64) -> Result<SliceVertex, SliceError> {
        let spacing = (self.layers as f64).recip();
        self.corner(vertex, 1.0 - number as f64 * spacing, spacing, SliceAxis::Height)
    }
}
