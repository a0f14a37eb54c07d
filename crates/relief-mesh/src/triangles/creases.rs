//! How finely sides must be cut: the surface has a crease wherever a side crosses a line between cells, and a
//! step of the side's lattice that goes over one is off by a quarter of the step times the change of slope.

use relief_core::{HeightMap, MaxPyramid};

use crate::filling::least_tolerance;
use crate::interior::STEPS;
use crate::surface::Relief;
use crate::{MeshSettings, MesherError};

/// The longest side of a patch, in texels.
pub const LONGEST: f64 = 128.0;

/// The most steps of a side's lattice, and the fewest.
pub const MOST_STEPS: u32 = 1 << 11;
const FEWEST_STEPS: u32 = 16;

/// The most steps a texel.
const FINEST: u32 = 1 << 9;

/// The part of a change of slope that remains over a step that is as fine as can be, with something left for
/// all else.
const LEFT: f64 = 0.6 / FINEST as f64;

/// The greatest change of slope that a map can have at a texel, along both axes together.
const MOST_CHANGE: f32 = 4.0;

/// The changes of slope of a relief.
pub struct Creases {
    /// As parts of [`MOST_CHANGE`].
    changes: MaxPyramid,
    /// As a height of the map.
    tolerance: f64,
}

impl Creases {
    /// Those of a relief, for a tolerance that is a height of its map.
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

    /// Whether sides and triangles can keep to the tolerance, which was that many metres where directions of
    /// displacement are that long.
    pub fn check(&self, relief: &Relief, settings: &MeshSettings, longest: f64) -> Result<(), MesherError> {
        let greatest = f64::from(self.changes.highest() * MOST_CHANGE);
        let least = least_tolerance(relief, settings.judge).max(LEFT * greatest);
        if self.tolerance < least {
            let least_m = least * relief.height_m(settings.error_m, longest);
            return Err(MesherError::TooFine { error_m: settings.error_m, least_m });
        }
        Ok(())
    }

    /// Steps that a side needs, whose ends have those places in the map, `i` the centre of texel `i`: a power
    /// of two.
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

    /// Steps of the lattice of a side.
    pub fn steps(&self, ends: [[f64; 2]; 2]) -> u32 {
        self.needed(ends).min(MOST_STEPS.into()) as u32
    }

    /// Whether a side is too long for its lattice, or to be filled at once.
    pub fn is_long(&self, ends: [[f64; 2]; 2]) -> bool {
        let [from, to] = ends;
        // A little longer by rounding is as good.
        (to[0] - from[0]).hypot(to[1] - from[1]) > LONGEST * 1.001 || self.needed(ends) > MOST_STEPS.into()
    }

    /// How many triangles one becomes at least, whose corners have those places.
    pub fn fewest([a, b, c]: [[f64; 2]; 3]) -> u64 {
        let [ab, ac, bc] = [[a, b], [a, c], [b, c]].map(|[from, to]| [to[0] - from[0], to[1] - from[1]]);
        let area = 0.5 * (ab[0] * ac[1] - ab[1] * ac[0]).abs();
        let longest = [ab, ac, bc].map(|side| side[0].hypot(side[1])).into_iter().fold(0.0, f64::max);
        // None has more area than half of the square over its longest side.
        (area / (0.5 * LONGEST * LONGEST)).max(longest / LONGEST).max(1.0) as u64
    }
}
