//! Places ahead of a cell against its frustum.

use relief_core::HeightMap;

use super::Found;
use super::place::{Place, ROUNDING};
use relief_core::rng::Rng;

/// The empty space over a rectangle of cells in one quadrant: `top`, and from the rectangle's edges on
/// `slope` heights a texel of Chebyshev distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frustum {
    /// Height of the top.
    pub top: f64,
    /// Heights a texel.
    pub slope: f64,
    /// First column and row of the rectangle in cells, not wrapped; may be minus infinity.
    pub low: [f64; 2],
    /// Where the rectangle ends; may be infinity.
    pub high: [f64; 2],
}

impl Frustum {
    /// The Chebyshev distance, in the quadrant, of a place from the rectangle.
    pub fn distance(&self, place: &Place, forward: [bool; 2]) -> f64 {
        let along = |axis: usize| {
            // Whole cells first, so that what is within the cell keeps its digits.
            let (cell, within) = (place.cell[axis] as f64, place.within[axis]);
            if forward[axis] { (cell - self.high[axis]) + within } else { (self.low[axis] - cell) - within }
        };
        along(0).max(along(1)).max(0.0)
    }

    /// Whether the surface at a place of the quadrant is not above the frustum.
    pub fn holds(&self, map: &HeightMap, place: &Place, forward: [bool; 2]) -> bool {
        self.room(map, place, forward) >= -ROUNDING
    }

    /// Returns the depth of the surface below the frustum at a place of the quadrant, in heights.
    pub fn room(&self, map: &HeightMap, place: &Place, forward: [bool; 2]) -> f64 {
        self.top + self.slope * self.distance(place, forward) - place.height(map)
    }
}

/// A place that a frustum has to clear.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// The dual cell whose frustum it is, not wrapped.
    pub cell: [i64; 2],
    /// The quadrant.
    pub forward: [bool; 2],
    /// The place.
    pub place: Place,
}

/// Probes the given number of places ahead of cells: at every distance up to three tiles, more of the near
/// ones, on the diagonal and beside it as often as elsewhere. `read` is the frustum for a ray over a cell,
/// not wrapped, in a quadrant. Finds room in heights.
pub fn attack(
    map: &HeightMap,
    read: impl Fn([i64; 2], [bool; 2]) -> Frustum,
    count: usize,
    seed: u64,
) -> Found<Contact> {
    let mut rng = Rng::new(seed);
    let farthest = (3.0 * f64::from(map.width().max(map.height())) + 2.0).log2();
    let mut found = Found::default();
    for _ in 0..count {
        let from = Place::draw(&mut rng, map);
        let forward = [rng.below(2) == 0, rng.below(2) == 0];
        let mut ahead = || rng.between(0.0, farthest).exp2() as i64 - 1;
        let (u, v) = (ahead(), ahead());
        let ahead = match rng.below(4) {
            0 => [u, u],
            1 => [u, u + i64::from(rng.below(3)) - 1],
            _ => [u, v],
        };
        let mut place = Place::draw(&mut rng, map);
        for axis in 0..2 {
            let by = ahead[axis].max(0);
            place.cell[axis] = from.cell[axis] + if forward[axis] { by } else { -by };
        }
        let room = read(from.cell, forward).room(map, &place, forward);
        found.add(room < -ROUNDING, room, Contact { cell: from.cell, forward, place });
    }
    found
}
