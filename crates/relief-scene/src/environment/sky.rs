//! Generated sky for scenes without an environment map.

use std::f32::consts::PI;

use relief_io::Picture;

/// Columns and rows. Few are enough, as the sky is smooth.
const SIZE: [u32; 2] = [512, 256];

const ZENITH: [f32; 3] = [0.10, 0.19, 0.42];
const HORIZON: [f32; 3] = [0.52, 0.57, 0.62];
const GROUND: [f32; 3] = [0.13, 0.11, 0.09];

/// Exponent of the pale band above the horizon. Larger exponents make it narrower.
const PALE: i32 = 4;

/// Height of the blend from ground to sky, as the `y` of a direction below the horizon.
const EDGE: f32 = 0.04;

/// Returns the sky as an equirectangular picture, the same in all columns.
pub fn picture() -> Picture {
    let [width, height] = SIZE;
    let row = |row: u32| {
        let up = ((row as f32 + 0.5) / height as f32 * PI).cos();
        let pale = (1.0 - up.max(0.0)).powi(PALE);
        let below = (-up / EDGE).clamp(0.0, 1.0);
        let color = |part: usize| {
            let sky = ZENITH[part] + (HORIZON[part] - ZENITH[part]) * pale;
            sky + (GROUND[part] - sky) * below
        };
        [color(0), color(1), color(2), 1.0]
    };
    let texels = (0..height).flat_map(|at| std::iter::repeat_n(row(at), width as usize));
    Picture { width, height, texels: texels.collect() }
}
