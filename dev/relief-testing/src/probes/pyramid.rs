//! Places against the nodes over them.

use relief_core::HeightMap;

use super::Found;
use super::place::{Place, ROUNDING};
use relief_core::rng::Rng;

/// Whether the surface at a place is within what is said of it.
pub fn holds(map: &HeightMap, place: &Place, bounds: [f32; 2]) -> bool {
    room(map, place, bounds) >= -ROUNDING
}

/// Returns the distance of the surface at a place from its stated bounds, in heights, positive inside.
#[inline]
pub fn room(map: &HeightMap, place: &Place, [least, most]: [f32; 2]) -> f64 {
    let height = place.height(map);
    (height - f64::from(least)).min(f64::from(most) - height)
}

/// Probes the given number of places, each at a level; `bounds` is the least and the greatest height that a
/// level has for a cell, not wrapped. Finds room in heights at a place, and the level.
pub fn attack(
    map: &HeightMap,
    levels: usize,
    bounds: impl Fn(usize, [i64; 2]) -> [f32; 2],
    count: usize,
    seed: u64,
) -> Found<(Place, usize)> {
    let mut rng = Rng::new(seed);
    let mut found = Found::default();
    for _ in 0..count {
        let (place, level) = (Place::draw(&mut rng, map), rng.below(levels as u32) as usize);
        let room = room(map, &place, bounds(level, place.cell));
        found.add(room < -ROUNDING, room, (place, level));
    }
    found
}
