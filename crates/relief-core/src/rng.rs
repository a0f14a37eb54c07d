//! A small deterministic generator of random numbers.

use glam::DVec3;

/// SplitMix64 (Steele, Lea and Flood 2014): the same numbers from the same seed, everywhere.
#[derive(Clone, Debug)]
pub struct Rng {
    state: u64,
}

impl Rng {
    /// Creates a generator whose numbers depend on the seed alone.
    pub fn new(seed: u64) -> Self {
        Self { state: seed }
    }

    /// Returns the next 64 random bits.
    pub fn bits(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.state;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Returns a number in `[0, 1)`.
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Returns a number in `[low, high)`.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// Returns a whole number in `0..count`, or 0 if `count` is 0.
    pub fn below(&mut self, count: u32) -> u32 {
        ((u128::from(self.bits()) * u128::from(count)) >> 64) as u32
    }

    /// Returns one of the values, all equally likely. `values` must not be empty.
    pub fn pick<T: Copy>(&mut self, values: &[T]) -> T {
        values[self.below(values.len() as u32) as usize]
    }

    /// Returns a unit vector, all directions equally likely.
    pub fn direction(&mut self) -> DVec3 {
        loop {
            let point = 2.0 * DVec3::new(self.unit(), self.unit(), self.unit()) - 1.0;
            let length = point.length();
            if length > 0.1 && length <= 1.0 {
                return point / length;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_repeat_with_the_seed_and_stay_in_range() {
        let draw = |seed| {
            let mut rng = Rng::new(seed);
            (0..1000).map(|_| rng.unit()).collect::<Vec<_>>()
        };
        assert_eq!(draw(1), draw(1));
        assert_ne!(draw(1), draw(2));
        let numbers = draw(3);
        assert!(numbers.iter().all(|x| (0.0..1.0).contains(x)));
        assert!((numbers.iter().sum::<f64>() / 1000.0 - 0.5).abs() < 0.05);
        let mut rng = Rng::new(4);
        assert!((0..1000).all(|_| rng.below(3) < 3) && rng.below(0) == 0);
        let directions: Vec<DVec3> = (0..1000).map(|_| rng.direction()).collect();
        assert!(directions.iter().all(|direction| direction.is_normalized()));
        assert!(directions.iter().sum::<DVec3>().length() < 100.0);
    }
}
