//! A piebald coat: dark patches on white, for models of animals.

use super::lattice::{fractal_noise, mix_colour, smooth_step};
use super::picture::Grid;

const SIDE: u32 = 256;

const WHITE: [f64; 3] = [236.0, 230.0, 220.0];
const DARK: [f64; 3] = [52.0, 38.0, 30.0];

/// Colours of the mesh.
pub fn colours() -> Grid<[f64; 3]> {
    Grid::square(SIDE, |u, v| {
        let patch = fractal_noise(u, v, 5, 3, 61) + 0.06 * fractal_noise(u, v, 48, 2, 62);
        let hair = 1.0 + 0.05 * fractal_noise(u, v, 64, 2, 63);
        mix_colour(WHITE, DARK, smooth_step(0.12, 0.2, patch)).map(|part| (part * hair).clamp(0.0, 255.0))
    })
}
