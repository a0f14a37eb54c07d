//! Medians of times with confidence intervals.

/// Confidence of intervals for a true median, from 0 to 1.
pub const SURE: f64 = 0.95;

/// Least number of values for an interval of that confidence.
pub const FEWEST: usize = 6;

/// Median with an interval for the true one, for any distribution of times.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Median {
    /// Median of the values.
    pub middle: f64,
    /// Lower end of the interval for the true median.
    pub low: f64,
    /// Upper end of the interval.
    pub high: f64,
    /// Least probability that the true median lies in the interval: [`SURE`] from [`FEWEST`] values
    /// on.
    pub confidence: f64,
}

impl Median {
    /// Computes the median of some numbers; 0 if there are none. The interval has the ranks `n/2 ±
    /// 0.98 √n`, which include all of fewer than eleven numbers. Each number is below the true
    /// median with probability one half. All of them are on one side of it in `2^(1 - n)` of the
    /// cases.
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
    fn intervals_have_their_stated_confidence() {
        for count in 1..400_usize {
            let numbers: Vec<f64> = (0..count).map(|number| number as f64).collect();
            let Median { low, high, confidence, .. } = Median::of(numbers);
            // The true median is outside when at most `low` of all numbers are below it, or above.
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
    fn the_interval_covers_the_median_as_often_as_stated() {
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
