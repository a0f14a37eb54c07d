//! Light from all around, given by the direction, and equirectangular pictures of it.

use std::f64::consts::{PI, TAU};

use glam::DVec3;
use relief_io::Picture;

/// Columns of the pictures.
const WIDTH: u32 = 1024;

/// Parts of 1 to which the pictures are rounded, so that both programs read the same short numbers.
const PARTS: f64 = 10_000.0;

/// The light that comes from a unit direction.
pub type Light = fn(DVec3) -> DVec3;

/// Surroundings by name.
pub const ALL: [(&str, Light); 2] = [("sky", sky), ("room", room)];

/// A sky over brown ground, with a wide glow.
fn sky(toward: DVec3) -> DVec3 {
    let pale = (1.0 - toward.y.max(0.0)).powi(4);
    let air = DVec3::new(0.15, 0.3, 0.65).lerp(DVec3::new(0.75, 0.8, 0.85), pale);
    let below = step(-toward.y, 0.0, 0.1);
    let glow = 2.0 * (30.0 * (toward.dot(DVec3::new(1.0, 1.0, 1.0).normalize()) - 1.0)).exp();
    air.lerp(DVec3::new(0.25, 0.2, 0.15), below) + DVec3::new(1.0, 0.9, 0.7) * glow
}

/// A dim room of coloured walls with three bright windows.
fn room(toward: DVec3) -> DVec3 {
    let walls = DVec3::splat(0.15) + DVec3::new(0.1, 0.06, 0.02) * toward.x + DVec3::splat(0.05) * toward.y;
    let (across, up) = (toward.x.atan2(toward.z), toward.y.asin());
    let window = |[middle, half]: [f64; 2], [bottom, top]: [f64; 2]| {
        // The angle to the middle, from -pi to pi.
        let beside = (across - middle + PI).rem_euclid(TAU) - PI;
        let inside = |value: f64, low: f64, high: f64| {
            step(value, low - 0.05, low + 0.05) * step(-value, -high - 0.05, -high + 0.05)
        };
        inside(beside, -half, half) * inside(up, bottom, top)
    };
    walls
        + DVec3::new(4.0, 4.2, 4.5) * window([0.9, 0.35], [0.1, 0.8])
        + DVec3::new(3.0, 2.4, 1.6) * window([-1.2, 0.2], [0.0, 0.5])
        + DVec3::new(2.0, 2.4, 3.0) * window([2.9, 0.5], [-0.2, 0.6])
}

/// Rises smoothly from 0 to 1 between two values.
fn step(value: f64, low: f64, high: f64) -> f64 {
    let part = ((value - low) / (high - low)).clamp(0.0, 1.0);
    part * part * (3.0 - 2.0 * part)
}

/// An equirectangular picture as Relief reads it: `-z` in the middle, `+x` to the right of it.
pub fn picture(light: Light) -> Picture {
    let (width, height) = (WIDTH, WIDTH / 2);
    let texel = |at: u32| {
        let (flat, up) = ((f64::from(at / width) + 0.5) / f64::from(height) * PI).sin_cos();
        let (sin, cos) = (((f64::from(at % width) + 0.5) / f64::from(width) - 0.5) * TAU).sin_cos();
        let seen = light(DVec3::new(sin * flat, up, -cos * flat));
        let [red, green, blue] = seen.to_array().map(|part| ((part * PARTS).round() / PARTS) as f32);
        [red, green, blue, 1.0]
    };
    Picture { width, height, texels: (0..width * height).map(texel).collect() }
}
