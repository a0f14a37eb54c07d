//! Fineness of sides. The surface has a crease wherever a side crosses a line between cells. A step
//! of the side's lattice over a crease is off by a quarter of the step times the change of slope.

use relief_core::{HeightMap, MaxPyramid};

use crate::filling::least_tolerance;
use crate::interior::STEPS;
use crate::surface::Relief;
use crate::{MeshSettings, MesherError};

/// Longest side of a patch, in texels.
pub const LONGEST: f64 = 128.0;

/// Greatest and least number of steps of a side's lattice.
pub const MOST_STEPS: u32 = 1 << 11;
const FEWEST_STEPS: u32 = 16;

/// Greatest number of steps per texel.
const FINEST: u32 = 1 << 9;

/// Part of a change of slope that remains over the finest step, with a margin for all else.
const LEFT: f64 = 0.6 / FINEST as f64;

/// Greatest change of slope that a map can have at a texel, along both axes together.
const MOST_CHANGE: f32 = 4.0;

/// Changes of slope of a relief.
pub struct Creases {
    /// Changes as parts of [`MOST_CHANGE`].
    changes: MaxPyramid,
    /// Tolerance as a height of the map.
    tolerance: f64,
}

impl Creases {
    /// Finds the creases of a relief. `tolerance` is a height of its map.
    pub fn new(relief: &Relief, tolerance: f64) -> Result<Self, MesherError> {
        let map = relief.map();
        let change = |i: u32, j: u32| {
            let at = |di: i64, dj: i64| map.texel(i64::from(i) + di, j as i64 + dj);
            let across = at(-1, 0) - 2.0 * at(0, 0) + at(1, 0);
            let down = at(0, -1) - 2.0 * at(0, 0) + at(0, 1);
            ((across.abs() + down.abs()) / MOST_CHANGE).min(1.0)
        };
        let changes = HeightMap::from_fn(map.width(), map.height(), map.wrap(), change)?;
        Ok(Self { changes: MaxPyramid::new(&changes), tolerance })
    }

    /// Returns an error if sides and triangles cannot keep to the tolerance. `longest` is the
    /// length of directions at which it was converted to metres.
    pub fn check(&self, relief: &Relief, settings: &MeshSettings, longest: f64) -> Result<(), MesherError> {
        let greatest = f64::from(self.changes.highest() * MOST_CHANGE);
        let least = least_tolerance(relief, settings.judge).max(LEFT * greatest);
        if self.tolerance < least {
            let least_m = least * relief.height_m(settings.error_m, longest);
            return Err(MesherError::TooFine { error_m: settings.error_m, least_m });
        }
        Ok(())
    }

    /// Returns the number of steps that a side needs, a power of two. Its ends are places in the
    /// map: the centre of texel `i` is at `i`.
    fn needed(&self, [from, to]: [[f64; 2]; 2]) -> u64 {
        let first = [0, 1].map(|axis| from[axis].min(to[axis]).floor() as i64);
        let last = [0, 1].map(|axis| from[axis].max(to[axis]).floor() as i64);
        let change = f64::from(self.changes.bound(first, last).0 * MOST_CHANGE);
        // A crease then takes a quarter of the tolerance.
        let per_texel = (change / self.tolerance).clamp(STEPS.into(), FINEST.into());
        let length = (to[0] - from[0]).hypot(to[1] - from[1]);
        let steps = (length * per_texel).ceil().max(f64::from(FEWEST_STEPS)) as u64;
        steps.checked_next_power_of_two().unwrap_or(u64::MAX)
    }

    /// Returns the number of steps of a side's lattice.
    pub fn steps(&self, ends: [[f64; 2]; 2]) -> u32 {
        self.needed(ends).min(MOST_STEPS.into()) as u32
    }

    /// Returns whether a side is too long for its lattice, or for one filling.
    pub fn is_long(&self, ends: [[f64; 2]; 2]) -> bool {
        let [from, to] = ends;
        // A little longer by rounding is allowed.
        (to[0] - from[0]).hypot(to[1] - from[1]) > LONGEST * 1.001 || self.needed(ends) > MOST_STEPS.into()
    }

    /// Returns a lower bound on the number of triangles that a triangle is cut into, by the places
    /// of its corners.
    pub fn fewest([a, b, c]: [[f64; 2]; 3]) -> u64 {
        let [ab, ac, bc] = [[a, b], [a, c], [b, c]].map(|[from, to]| [to[0] - from[0], to[1] - from[1]]);
        let area = 0.5 * (ab[0] * ac[1] - ab[1] * ac[0]).abs();
        let longest = [ab, ac, bc].map(|side| side[0].hypot(side[1])).into_iter().fold(0.0, f64::max);
        // No piece has more area than half of the square over its longest side.
        (area / (0.5 * LONGEST * LONGEST)).max(longest / LONGEST).max(1.0) as u64
    }
}
