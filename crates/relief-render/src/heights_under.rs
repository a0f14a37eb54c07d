//! The heights under triangles: as high and as low as their shells must reach.

use glam::DVec2;
use relief_core::{HeightMap, MaxPyramid, MinPyramid};

/// Texels beyond a triangle's own that its segments may read: they reach beyond it by rounding, and by as
/// much as they may be beside the ray.
const BEYOND_TEXELS: f64 = 2.0;

/// What is known of the heights under triangles.
pub enum HeightsUnder<'a> {
    /// Of the finest level: its lowest and its highest nodes.
    Finest(&'a HeightMap, MinPyramid, MaxPyramid),
    /// Of all levels.
    All([f32; 2]),
}

impl<'a> HeightsUnder<'a> {
    /// Over a map, of which all levels may be seen, or the finest alone.
    pub fn new(map: &'a HeightMap, levels: bool) -> Self {
        match levels {
            false => Self::Finest(map, MinPyramid::new(map), MaxPyramid::new(map)),
            true => Self::All(map.extremes()),
        }
    }

    /// The least and the greatest height under a triangle, by the texture coordinates of its corners, or less
    /// and more.
    pub fn under(&self, uv: [DVec2; 3]) -> [f32; 2] {
        let (map, lowest, highest) = match self {
            Self::All(extremes) => return *extremes,
            Self::Finest(map, lowest, highest) => (map, lowest, highest),
        };
        let size = DVec2::new(map.width().into(), map.height().into());
        let [a, b, c] = uv.map(|corner| corner * size - 0.5);
        let cells = |corner: DVec2| [corner.x.floor() as i64, corner.y.floor() as i64];
        let first = cells(a.min(b).min(c) - BEYOND_TEXELS);
        let last = cells(a.max(b).max(c) + BEYOND_TEXELS);
        [lowest.bound(first, last).0, highest.bound(first, last).0]
    }
}
