//! Medians of times, and how sure these are.

/// How sure intervals are that are said to hold the true median, as a part of 1.
pub const SURE: f64 = 0.95;

/// The fewest numbers whose median has such an interval.
pub const FEWEST: usize = 6;

/// A median, and what the true one lies between, whatever the times are distributed like.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Median {
    /// The median.
    pub middle: f64,
    /// The least that the true one is.
    pub low: f64,
    /// The greatest.
    pub high: f64,
    /// In what part of all cases the true one lies between these, at least: [`SURE`] from [`FEWEST`] numbers
    /// on.
    pub confidence: f64,
}

impl Median {
    /// The median of some numbers; of none it is 0. Its interval has the ranks `n/2 ± 0.98 √n`, which of
    /// fewer than eleven are all: each number is below the true median with a chance of a half, so that all of
    /// them are on one side of it in `2^(1 - n)` of the cases.
    pub fn of(mut numbers: Vec<f64>) -> Self {
        numbers.sort_unstable_by(f64::total_cmp);
        let count = numbers.len();
        if count == 0 {
            return Self::default();
        }
        let middle = 0.5 * (numbers[(count - 1) / 2] + numbers[count / 2]);
        let beside = 0.98 * (count as f64).sqrt();
        let low = ((count as f64 / 2.0 - beside).floor().max(1.0) as usize) - 1;
        let confidence = if count < FEWEST { 1.0 - 0.5_f64.powi(count as i32 - 1) } else { SURE };
        Self { middle, low: numbers[low], high: numbers[count - 1 - low], confidence }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use relief_core::rng::Rng;

    #[test]
    fn intervals_are_as_sure_as_they_say() {
        for count in 1..400_usize {
            let numbers: Vec<f64> = (0..count).map(|number| number as f64).collect();
            let Median { low, high, confidence, .. } = Median::of(numbers);
            // The true median is not between them when at most `low` of all numbers are below it, or above.
            let mut ways = 0.5_f64.powi(count as i32);
            let mut outside = 0.0;
            for below in 0..=low as usize {
                outside += 2.0 * ways;
                ways *= (count - below) as f64 / (below + 1) as f64;
            }
            assert_eq!(low + high, count as f64 - 1.0);
            assert!(1.0 - outside >= confidence - 1e-12, "{count}: {} is not {confidence}", 1.0 - outside);
            assert_eq!(confidence >= SURE, count >= FEWEST, "{count}");
        }
        assert_eq!(
            [1, 2, 3, 5].map(|count| Median::of(vec![1.0; count]).confidence),
            [0.0, 0.5, 0.75, 0.9375]
        );
    }

    #[test]
    fn the_interval_holds_the_true_median_as_often_as_it_says() {
        let mut rng = Rng::new(1);
        let mut held = 0;
        for _ in 0..1000 {
            // Skewed: mostly short, sometimes long. The true median is a quarter.
            let median = Median::of((0..25).map(|_| rng.unit().powi(2)).collect());
            assert!(median.low <= median.middle && median.middle <= median.high);
            held += u32::from(median.low <= 0.25 && 0.25 <= median.high);
        }
        assert!((930..=990).contains(&held), "{held} of 1000");
        assert_eq!(Median::of(vec![]), Median::default());
        assert_eq!(Median::of(vec![3.0, 1.0]), Median { middle: 2.0, low: 1.0, high: 3.0, confidence: 0.5 });
    }
}
