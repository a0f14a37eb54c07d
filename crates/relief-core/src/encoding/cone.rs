//! Storage of cone ratios as numbers below 1. A ratio is the cone's radius, in metres or tiles, per
//! unit of height above the apex.

use crate::Metric;

/// Ratio that is stored as √½ if lengths are counted in tiles: the half ratio of [`Metric::UNIT`],
/// in tiles per unit of height.
pub const HALF_RATIO: f64 = 0.125;

/// Ratio that is stored as √½: an eighth of the tile's shorter side, in metres per unit of height.
pub fn half_ratio(metric: &Metric) -> f64 {
    HALF_RATIO * metric.tile_m[0].min(metric.tile_m[1])
}

/// Returns the stored value of a ratio `m`: `sqrt(m / (m + half))`, rounded down and below 1.
///
/// It increases with the ratio and has no upper limit. Most of its steps cover ratios from a
/// hundredth of `half` to ten times `half`.
pub fn encode(ratio: f32, half: f64) -> f32 {
    let ratio = f64::from(ratio);
    let mut value = down((ratio / (ratio + half)).sqrt()).min(1f32.next_down());
    while value > 0.0 && decode(value, half) > ratio {
        value = value.next_down();
    }
    value
}

/// Returns the ratio of a stored value `v` below 1: `half v² / (1 - v²)`, in metres per unit of
/// height.
pub fn decode(value: f32, half: f64) -> f64 {
    let squared = f64::from(value) * f64::from(value);
    half * squared / (1.0 - squared)
}

/// Nearest `f32` that is at most `value`, but at least 0.
pub fn down(value: f64) -> f32 {
    let near = value as f32;
    if f64::from(near) > value { near.next_down().max(0.0) } else { near }
}
