//! Places against the nodes over them.

use relief::HeightMap;

use super::place::{Place, ROUNDING};
use crate::rng::Rng;

/// Whether the surface at a place is within what is said of it.
pub fn holds(map: &HeightMap, place: &Place, [least, most]: [f32; 2]) -> bool {
    let height = place.height(map);
    f64::from(least) - ROUNDING <= height && height <= f64::from(most) + ROUNDING
}

/// Probes so many places, each at a level; `bounds` is the least and the greatest height that a level has for a cell, not
/// wrapped. The first place where the surface is outside, and the level.
pub fn probe(
    map: &HeightMap,
    levels: usize,
    bounds: impl Fn(usize, [i64; 2]) -> [f32; 2],
    count: usize,
    seed: u64,
) -> Option<(Place, usize)> {
    let mut rng = Rng::new(seed);
    (0..count).find_map(|_| {
        let (place, level) = (Place::draw(&mut rng, map), rng.below(levels as u32) as usize);
        (!holds(map, &place, bounds(level, place.cell))).then_some((place, level))
    })
}
