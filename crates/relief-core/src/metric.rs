//! World lengths of texture units.

use crate::HeightMap;

/// Lengths in metres of texture coordinates and heights, in which a map is baked. A step
/// `(du, dv, dh)` in texture coordinates and texel height is
/// `sqrt((tile_m[0] du)² + (tile_m[1] dv)² + (scale_m dh)²)` metres long.
///
/// Maps of distances, angles and cone ratios state their metric. A step through such a map divides
/// by the path's speed in that metric. So the map remains valid for any scale and any tile size on
/// the surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Metric {
    /// Length of a tile along `u` and `v` in metres.
    pub tile_m: [f64; 2],
    /// Displacement of texel 1 above texel 0 in metres.
    pub scale_m: f64,
}

/// Least and greatest length. Their squares are still normal numbers in `f32`.
const LEAST_M: f64 = 1e-15;
const MOST_M: f64 = 1e15;

/// The number is not a length, or `f32` cannot represent its square.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{what} is {value} m: it must be from {LEAST_M:e} to {MOST_M:e} m")]
pub struct MetricError {
    /// Name of the length.
    pub what: &'static str,
    /// Value in metres.
    pub value: f64,
}

impl Metric {
    /// Metric of 1 m for each tile and for the scale: texture units and heights as they are. The
    /// maps that searches read are baked in it, since a ray's path is in these units, too.
    pub const UNIT: Self = Self { tile_m: [1.0, 1.0], scale_m: 1.0 };

    /// Creates a metric from the tile's lengths along `u` and `v` and the scale, in metres.
    ///
    /// # Errors
    ///
    /// When a length is not from 1e-15 to 1e15 m.
    pub fn new(tile_m: [f64; 2], scale_m: f64) -> Result<Self, MetricError> {
        for (what, value) in
            [("the tile along u", tile_m[0]), ("the tile along v", tile_m[1]), ("the scale", scale_m)]
        {
            if !(LEAST_M..=MOST_M).contains(&value) {
                return Err(MetricError { what, value });
            }
        }
        Ok(Self { tile_m, scale_m })
    }

    /// Creates a metric with a tile of 1 m by 1 m and this scale in metres.
    ///
    /// # Errors
    ///
    /// When the scale is not from 1e-15 to 1e15 m.
    pub fn unit_tile(scale_m: f64) -> Result<Self, MetricError> {
        Self::new([1.0, 1.0], scale_m)
    }

    /// Size of a texel of `map` along `u` and `v` in metres.
    pub fn texel_m(&self, map: &HeightMap) -> [f64; 2] {
        [self.tile_m[0] / f64::from(map.width()), self.tile_m[1] / f64::from(map.height())]
    }
}
