//! Places within the radius of a cell against what the cell says of them.

use relief_core::HeightMap;

use super::Found;
use super::place::{Place, ROUNDING};
use super::pyramid::room;
use relief_core::rng::Rng;

/// Probes the given number of pairs of places; `bounds` is the least and the greatest height that a cell, not
/// wrapped, has for the surface within `radius` texels. Finds room in heights, for a cell at a place.
pub fn attack(
    map: &HeightMap,
    radius: u32,
    bounds: impl Fn([i64; 2]) -> [f32; 2],
    count: usize,
    seed: u64,
) -> Found<([i64; 2], Place)> {
    let mut rng = Rng::new(seed);
    let radius = i64::from(radius);
    let mut found = Found::default();
    for _ in 0..count {
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
        let room = room(map, &to, bounds(from.cell));
        found.add(room < -ROUNDING, room, (from.cell, to));
    }
    found
}
