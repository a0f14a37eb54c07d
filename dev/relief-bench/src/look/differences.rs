//! How far pictures lie apart, in parts of 255.

use super::Shown;

/// Differences of pixels in ascending order, each the greatest of its colour's three.
pub struct Differences(Vec<u8>);

impl Differences {
    /// Compares the pixels of two pictures at these places.
    pub fn of(ours: &Shown, theirs: &Shown, places: &[usize]) -> Self {
        let pairs = places.iter().filter_map(|place| ours[*place].zip(theirs[*place]));
        let greatest = |(a, b): ([u8; 3], [u8; 3])| {
            let [red, green, blue] = [0, 1, 2].map(|part| a[part].abs_diff(b[part]));
            red.max(green).max(blue)
        };
        let mut all: Vec<u8> = pairs.map(greatest).collect();
        all.sort_unstable();
        Self(all)
    }

    /// The share of the pixels that differ by at most `bound`.
    pub fn within(&self, bound: u8) -> f64 {
        self.0.partition_point(|difference| *difference <= bound) as f64 / self.0.len().max(1) as f64
    }

    /// The least difference that a percentage of the pixels does not exceed.
    pub fn percentile(&self, percent: usize) -> u8 {
        let place = (self.0.len() * percent).div_ceil(100).max(1) - 1;
        self.0.get(place).copied().unwrap_or_default()
    }

    /// The 50th and the 99th percentile and the greatest difference.
    pub fn spread(&self) -> String {
        [50, 99, 100].map(|percent| self.percentile(percent).to_string()).join(" / ")
    }
}

/// The places of the pixels that are covered in both pictures, and whose eight neighbours are.
pub fn inside(ours: &Shown, theirs: &Shown, columns: usize) -> Vec<usize> {
    let covered = |place: usize| {
        let of = |shown: &Shown| shown.get(place).is_some_and(Option::is_some);
        of(ours) && of(theirs)
    };
    let is_inside = |place: &usize| {
        let rows = [place.checked_sub(columns), Some(*place), Some(place + columns)];
        let beside = |middle: usize| {
            !middle.is_multiple_of(columns)
                && !(middle + 1).is_multiple_of(columns)
                && (middle - 1..=middle + 1).all(covered)
        };
        rows.into_iter().all(|middle| middle.is_some_and(beside))
    };
    (0..ours.len()).filter(is_inside).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn differences_are_the_greatest_of_three_parts() {
        let ours: Shown = (0..100).map(|_| Some([9, 9, 9])).collect();
        let theirs: Shown = (0..100).map(|at| Some([9, 9 + at, 8])).collect();
        let all = Differences::of(&ours, &theirs, &(0..100).collect::<Vec<_>>());
        assert_eq!((all.within(0), all.within(1), all.within(5)), (0.0, 0.02, 0.06));
        assert_eq!(all.spread(), "49 / 98 / 99");
    }

    #[test]
    fn pixels_at_the_silhouette_are_left_out() {
        let block = |from: usize| -> Shown {
            let is_covered = |at: usize| (from..5).contains(&(at % 6)) && (1..5).contains(&(at / 6));
            (0..36).map(|at| is_covered(at).then_some([0; 3])).collect()
        };
        assert_eq!(inside(&block(1), &block(1), 6), [14, 15, 20, 21]);
        assert_eq!(inside(&block(1), &block(2), 6), [15, 21]);
        let all = vec![Some([0; 3]); 9];
        assert_eq!(inside(&all, &all, 3), [4]);
    }
}
