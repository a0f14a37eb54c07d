//! Medians of times, and how sure these are.

/// A median, and what the true one lies between at 95 in 100, whatever the times are distributed like.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Median {
    /// The median.
    pub middle: f64,
    /// The least that the true one is.
    pub low: f64,
    /// The greatest.
    pub high: f64,
}

impl Median {
    /// The median of some numbers; of none it is 0. Its interval has the ranks `n/2 ± 0.98 √n`, which of
    /// fewer than six are all: each number is below the true median with a chance of a half.
    pub fn of(mut numbers: Vec<f64>) -> Self {
        numbers.sort_unstable_by(f64::total_cmp);
        let count = numbers.len();
        if count == 0 {
            return Self::default();
        }
        let middle = 0.5 * (numbers[(count - 1) / 2] + numbers[count / 2]);
        let beside = 0.98 * (count as f64).sqrt();
        let low = ((count as f64 / 2.0 - beside).floor().max(1.0) as usize) - 1;
        Self { middle, low: numbers[low], high: numbers[count - 1 - low] }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rng::Rng;

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
        assert_eq!(Median::of(vec![3.0, 1.0]), Median { middle: 2.0, low: 1.0, high: 3.0 });
    }
}
