//! How cone ratios are stored: metres (or tiles) from the axis for each unit of height above the apex, as
//! numbers below 1.

use crate::Metric;

/// The ratio that is stored as √½, in tiles for each unit of height where lengths are counted in tiles: the
/// half ratio of [`Metric::UNIT`].
pub const HALF_RATIO: f64 = 0.125;

/// The ratio that is stored as √½: an eighth of the shorter side of the tile, in metres for each unit of
/// height.
pub fn half_ratio(metric: &Metric) -> f64 {
    HALF_RATIO * metric.tile_m[0].min(metric.tile_m[1])
}

/// The stored value of a ratio `m`: `sqrt(m / (m + half))`, rounded down and below 1. It increases with the
/// ratio, has no greatest ratio, and spends its steps on ratios from a hundredth of `half` to ten times
/// `half`.
pub fn encode(ratio: f32, half: f64) -> f32 {
    let ratio = f64::from(ratio);
    let mut value = down((ratio / (ratio + half)).sqrt()).min(1f32.next_down());
    while value > 0.0 && decode(value, half) > ratio {
        value = value.next_down();
    }
    value
}

/// The ratio that a stored value `v` below 1 stands for: `half v² / (1 - v²)`, metres for each unit of
/// height.
pub fn decode(value: f32, half: f64) -> f64 {
    let squared = f64::from(value) * f64::from(value);
    half * squared / (1.0 - squared)
}

/// The nearest `f32` that is not above the value, and not below 0.
pub fn down(value: f64) -> f32 {
    let near = value as f32;
    if f64::from(near) > value { near.next_down().max(0.0) } else { near }
}
