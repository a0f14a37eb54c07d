//! Slices that stand upright on the base, at equal `u` or `v`: lines on the base, extruded along
//! its normals.
//!
//! Source: Kautz and Seidel 2001, section 3.2. Lines lie on one lattice of texture space, so that
//! the slices of neighbouring triangles meet.

use relief_core::SliceAxis;

use super::{SliceBlock, SliceError, Slicer, between};

impl Slicer<'_> {
    /// Returns the numbers of the first and the last line over a triangle.
    fn line_numbers(&self, number: u32, axis: usize) -> [f64; 2] {
        let places = self.base.corners(number).map(|corner| f64::from(corner.uv[axis]) / self.step_uv[axis]);
        let [low, high] = [f64::min, f64::max].map(|of| places.into_iter().reduce(of).unwrap_or(0.0));
        [low.ceil(), high.floor()]
    }

    /// Returns an upper bound on the number of lines over a triangle.
    pub(super) fn lines(&self, number: u32, axis: usize) -> u64 {
        let [first, last] = self.line_numbers(number, axis);
        (last - first + 1.0).max(0.0) as u64
    }

    /// Adds the slices over a triangle, at equal `u` or `v`.
    pub(super) fn across(&self, number: u32, axis: usize, block: &mut SliceBlock) -> Result<(), SliceError> {
        let corners = self.base.corners(number);
        let step = self.step_uv[axis];
        let of_slice = if axis == 0 { SliceAxis::U } else { SliceAxis::V };
        let [first, _] = self.line_numbers(number, axis);
        for line in 0..self.lines(number, axis) {
            let value = (first + line as f64) * step;
            let mut ends = [[0, 1], [1, 2], [2, 0]].into_iter().filter_map(|side| {
                let [a, b] = side.map(|place: usize| corners[place]);
                let [from, to] = [a, b].map(|corner| f64::from(corner.uv[axis]));
                ((from > value) != (to > value)).then(|| between(a, b, (value - from) / (to - from)))
            });
            let (Some(one), Some(other)) = (ends.next(), ends.next()) else { continue };
            let corner = |point, height| self.corner(point, height, step, of_slice);
            block.push(&[corner(&one, 0.0)?, corner(&other, 0.0)?, corner(&other, 1.0)?, corner(&one, 1.0)?]);
        }
        Ok(())
    }
}
