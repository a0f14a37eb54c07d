//! Lower and upper bounds of the heights in a rectangle of texture coordinates.

use glam::DVec2;

use crate::{HeightMap, MaxPyramid, MinPyramid};

/// Bounds of the bilinear surface over rectangles of texture coordinates, from both pyramids.
#[derive(Clone, Debug)]
pub struct HeightBounds {
    size: DVec2,
    lowest: MinPyramid,
    highest: MaxPyramid,
}

impl HeightBounds {
    /// Builds the bounds of a map. They take 8/3 of its texels, as `f32`.
    pub fn new(map: &HeightMap) -> Self {
        let size = DVec2::new(map.width().into(), map.height().into());
        Self { size, lowest: MinPyramid::new(map), highest: MaxPyramid::new(map) }
    }

    /// Returns a lower and an upper bound of the heights between two texture coordinates and
    /// `beyond` texels around them.
    ///
    /// Coordinates are wrapped as the map is. `least` must not exceed `greatest` on either axis.
    pub fn between(&self, least: DVec2, greatest: DVec2, beyond: DVec2) -> [f32; 2] {
        let cells = |corner: DVec2| [corner.x.floor() as i64, corner.y.floor() as i64];
        let first = cells(least * self.size - 0.5 - beyond);
        let last = cells(greatest * self.size - 0.5 + beyond);
        [self.lowest.bound(first, last).0, self.highest.bound(first, last).0]
    }
}
