//! Thin thorns on a flat ground: steep slopes, much occlusion, and tips that long steps miss.

use super::lattice::{random, signed, wrapped_difference};
use super::picture::Grid;

const SIDE: u32 = 256;
/// Thorns along a side.
const COUNT: u32 = 6;

struct Thorn {
    centre: [f64; 2],
    radius: f64,
    height: f64,
}

pub fn map() -> Grid<f64> {
    let cell = 1.0 / f64::from(COUNT);
    let thorns: Vec<Thorn> = (0..COUNT * COUNT)
        .map(|number| {
            let (i, j) = (number % COUNT, number / COUNT);
            Thorn {
                centre: [
                    (f64::from(i) + 0.5 + 0.25 * signed(i, j, 1)) * cell,
                    (f64::from(j) + 0.5 + 0.25 * signed(i, j, 2)) * cell,
                ],
                radius: cell * (0.4 + 0.25 * random(i, j, 3)),
                height: 0.45 + 0.55 * random(i, j, 4),
            }
        })
        .collect();
    Grid::square(SIDE, |u, v| {
        thorns.iter().fold(0.0, |highest: f64, thorn| {
            let (dx, dy) = (wrapped_difference(thorn.centre[0], u), wrapped_difference(thorn.centre[1], v));
            let inward = (1.0 - (dx * dx + dy * dy).sqrt() / thorn.radius).max(0.0);
            // Between a cone and a parabola: a broad foot and a sharp tip.
            highest.max(thorn.height * inward * (0.35 + 0.65 * inward))
        })
    })
}
