//! Places within the radius of a cell against what the cell says of them.

use relief::HeightMap;

use super::place::Place;
use super::pyramid::holds;
use crate::rng::Rng;

/// Probes so many pairs of places; `bounds` is the least and the greatest height that a cell, not wrapped, has for the
/// surface within `radius` texels. The first cell that is wrong, and the place where the surface is outside.
pub fn probe(
    map: &HeightMap,
    radius: u32,
    bounds: impl Fn([i64; 2]) -> [f32; 2],
    count: usize,
    seed: u64,
) -> Option<([i64; 2], Place)> {
    let mut rng = Rng::new(seed);
    let radius = i64::from(radius);
    (0..count).find_map(|_| {
        let from = Place::draw(&mut rng, map);
        let mut to = from;
        for axis in 0..2 {
            to.cell[axis] += match rng.below(4) {
                0 => -radius,
                1 => radius,
                _ => i64::from(rng.below(2 * radius as u32 + 1)) - radius,
            };
            // Anywhere over that cell is within the radius of somewhere over the first.
            to.within[axis] = if rng.below(2) == 0 { rng.unit() } else { f64::from(rng.below(2)) };
        }
        (!holds(map, &to, bounds(from.cell))).then_some((from.cell, to))
    })
}
