//! Equal steps between the values of a quantised plane.

use std::collections::HashSet;

/// Most different values that are searched for a step: all values of 16 bits.
const MOST_LEVELS: usize = 1 << 16;

/// Least step in parts of the greatest value. `f32` blurs shorter ones.
const LEAST_STEP: f64 = 1.0 / (1 << 20) as f64;

/// Greatest distance of a value from its place, in steps, where places are multiples of the least
/// difference. A half float of an 8-bit value is this near.
const NEAR: f64 = 0.08;

/// Greatest distance, in steps, where all places are used. Values that were stretched to other
/// integers and rounded are this near.
const NEAR_STRETCHED: f64 = 0.4;

/// Least number of values that are taken for stretched ones.
const FEWEST_STRETCHED: usize = 16;

/// Equal steps on which all values of a plane lie.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EqualSteps {
    /// The least value.
    pub first: f64,
    /// Difference between neighbouring places.
    pub step: f64,
    /// Number of different values. Some places may have none.
    pub levels: usize,
}

impl EqualSteps {
    /// Finds the steps of finite `values`. Returns `None` if all are alike, if there are more than
    /// 65,536 different ones, or if they do not lie on equal steps.
    ///
    /// The step is the least difference, if all others are multiples of it. Values of 8 bits that
    /// were stretched have differences of, say, 2 and 3. There it is the mean difference, if every
    /// value is near its multiple. Otherwise a half or a third of the least difference may do.
    ///
    /// ```
    /// use relief_core::EqualSteps;
    ///
    /// let steps = EqualSteps::of((0..100u8).map(|code| f32::from(code % 20) / 255.0)).expect("20 levels");
    /// assert!((steps.step * 255.0 - 1.0).abs() < 1e-5 && steps.levels == 20);
    /// assert_eq!(EqualSteps::of((0..100u8).map(|code| f32::from(code).sqrt())), None);
    /// ```
    pub fn of(values: impl IntoIterator<Item = f32>) -> Option<Self> {
        let (mut found, mut last) = (HashSet::new(), None);
        for value in values {
            // Zeros of both signs are one value.
            let bits = (value + 0.0).to_bits();
            if last != Some(bits) {
                last = Some(bits);
                found.insert(bits);
                if found.len() > MOST_LEVELS {
                    return None;
                }
            }
        }
        let mut levels: Vec<f64> = found.into_iter().map(|bits| f64::from(f32::from_bits(bits))).collect();
        levels.sort_unstable_by(f64::total_cmp);
        Self::of_sorted(&levels)
    }

    fn of_sorted(levels: &[f64]) -> Option<Self> {
        let (first, last) = (*levels.first()?, *levels.last()?);
        let least = levels.windows(2).map(|pair| pair[1] - pair[0]).fold(f64::INFINITY, f64::min);
        let is_seen = |step: &f64| *step >= LEAST_STEP * first.abs().max(last.abs());
        let stretched = || {
            let mean = (last - first) / (levels.len() - 1) as f64;
            let is_near = levels.len() >= FEWEST_STRETCHED && is_near(levels, mean, NEAR_STRETCHED);
            is_near.then_some(mean)
        };
        let part = |part: f64| Some(least / part).filter(is_seen).and_then(|step| multiples(levels, step));
        let step = part(1.0).or_else(stretched).or_else(|| part(2.0)).or_else(|| part(3.0));
        let step = step.filter(|step| step.is_finite() && is_seen(step))?;
        Some(Self { first, step, levels: levels.len() })
    }

    /// Returns the place of a value, counted from the least.
    pub fn place(&self, value: f32) -> i64 {
        ((f64::from(value) - self.first) / self.step).round() as i64
    }
}

/// Returns the step near `guess` that divides all differences.
fn multiples(levels: &[f64], guess: f64) -> Option<f64> {
    let (mut step, mut places) = (guess, 0.0);
    for pair in levels.windows(2) {
        places += ((pair[1] - pair[0]) / step).round();
        // The farther, the more exactly is the step known.
        if places > 0.0 {
            step = (pair[1] - levels[0]) / places;
        }
    }
    is_near(levels, step, NEAR).then_some(step)
}

/// Returns whether all values lie within `near` steps of places that are `step` apart.
fn is_near(levels: &[f64], step: f64, near: f64) -> bool {
    let stretched = near == NEAR_STRETCHED;
    let off = |(at, level): (usize, &f64)| {
        let place = (level - levels[0]) / step;
        place - if stretched { at as f64 } else { place.round() }
    };
    let none = [f64::INFINITY, f64::NEG_INFINITY];
    let [low, high] =
        levels.iter().enumerate().map(off).fold(none, |[low, high], off| [low.min(off), high.max(off)]);
    high - low <= 2.0 * near
}

#[cfg(test)]
mod tests {
    use super::*;

    fn step(values: impl IntoIterator<Item = f32>) -> Option<f64> {
        EqualSteps::of(values).map(|steps| steps.step)
    }

    fn is(found: Option<f64>, expected: f64) -> bool {
        found.is_some_and(|found| (found / expected - 1.0).abs() < 1e-3)
    }

    #[test]
    fn codes_have_their_step() {
        let eight = |code: u32| code as f32 / 255.0;
        assert!(is(step((0..256).map(eight)), 1.0 / 255.0));
        assert!(is(step((20..60).map(eight)), 1.0 / 255.0));
        // Missing levels leave differences of two or more steps.
        assert!(is(step([3, 4, 9, 17, 200].map(eight)), 1.0 / 255.0));
        assert!(is(step((0..50).map(|code| eight(4 * code))), 4.0 / 255.0));
        assert!(is(step([0, 2, 5, 7, 12].map(eight)), 1.0 / 255.0), "differences of 2, 3 and 5");
        // Half floats of 8 bits: 11 significant bits.
        let half = |code: u32| {
            let (value, unit) = (eight(code), 2.0f32.powi(eight(code).log2().floor() as i32 - 10));
            (value / unit).round() * unit
        };
        assert!(is(step((1..256).map(half)), 1.0 / 255.0));
        // 8 bits in 16.
        assert!(is(step((0..256).map(|code| (257 * code) as f32 / 65535.0)), 257.0 / 65535.0));
        // 115 levels that were stretched to 256.
        let stretched = |code: u32| (f64::from(code) * 255.0 / 114.0).ceil() as f32 / 255.0;
        assert!(is(step((0..115).map(stretched)), 1.0 / 114.0));
        assert!(is(step((0..65536).map(|code| code as f32 / 65535.0)), 1.0 / 65535.0));
    }

    #[test]
    fn other_values_have_none() {
        assert_eq!(step([0.5; 9]), None, "a level map");
        assert_eq!(step([]), None);
        let mut rng = crate::rng::Rng::new(3);
        for count in [40, 1000, 70_000] {
            assert_eq!(step((0..count).map(|_| rng.between(0.0, 1.0) as f32)), None, "{count}");
        }
        assert_eq!(step((0..99).map(|at| (0.1 * at as f32).sin())), None);
    }
}
