//! Steps that show: a smooth relief that was rounded to few levels.

use relief_core::EqualSteps;

use crate::omissions::{BANDED, Remark};
use crate::samples::Samples;

/// Least number of texels. The runs of smaller maps say little.
const FEWEST_TEXELS: usize = 4096;

/// Least and greatest number of levels. Masks have fewer; the steps of more levels do not show.
const LEVELS: [usize; 2] = [8, 512];

/// Length of a flat run in texels.
const RUN: usize = 4;

/// Least part of the texels that lie in flat runs.
const FLAT: f64 = 0.2;

/// Least part of the unequal neighbours that are one step apart.
const BY_ONE: f64 = 0.45;

/// Returns a remark on a map whose steps show. All of this holds for it:
///
/// * it has at least [`FEWEST_TEXELS`] texels;
/// * its values lie on equal steps, and their number is within [`LEVELS`];
/// * at least [`FLAT`] of its texels lie in a run of [`RUN`] equal texels, along a row or a column;
/// * of the neighbours that differ, at least [`BY_ONE`] differ by one step: the relief rises and
///   falls a step at a time.
pub(crate) fn banding(samples: &Samples) -> Option<Remark> {
    let values = &samples.values;
    if values.len() < FEWEST_TEXELS {
        return None;
    }
    let steps = EqualSteps::of(values.iter().copied().filter(|value| !value.is_nan()))?;
    if !(LEVELS[0]..=LEVELS[1]).contains(&steps.levels) {
        return None;
    }
    let [width, height] = [samples.width, samples.height].map(|side| side as usize);
    let mut lines = Lines { values, steps, is_flat: vec![false; values.len()], unequal: 0, by_one: 0 };
    (0..height).for_each(|row| lines.take(row * width, 1, width));
    (0..width).for_each(|column| lines.take(column, width, height));
    let known = values.iter().filter(|value| !value.is_nan()).count();
    let flat = lines.is_flat.iter().filter(|flat| **flat).count() as f64 / known as f64;
    let by_one = lines.by_one as f64 / lines.unequal.max(1) as f64;
    (flat >= FLAT && by_one >= BY_ONE).then(|| {
        let percent = (100.0 * flat).round();
        let text = format!(
            "a smooth relief in {} levels, whose steps show: {percent} % of its texels lie in flat runs",
            steps.levels
        );
        Remark::new(&BANDED, text)
    })
}

/// Lines of a map, taken one after the other.
struct Lines<'a> {
    values: &'a [f32],
    steps: EqualSteps,
    /// Texels in flat runs.
    is_flat: Vec<bool>,
    /// Pairs of neighbours that differ, and the ones among them that differ by one step.
    unequal: u64,
    by_one: u64,
}

impl Lines<'_> {
    /// Takes the line of `count` texels that begins at `first`.
    fn take(&mut self, first: usize, stride: usize, count: usize) {
        let at = |place: usize| first + place * stride;
        let mut begin = 0;
        for place in 1..=count {
            let value = self.values[at(place - 1)];
            let next = (place < count).then(|| self.values[at(place)]);
            if next == Some(value) {
                continue;
            }
            // A texel without a value differs from all others, so it is alone.
            if place - begin >= RUN {
                (begin..place).for_each(|place| self.is_flat[at(place)] = true);
            }
            begin = place;
            if let Some(next) = next.filter(|next| !next.is_nan() && !value.is_nan()) {
                self.unequal += 1;
                let apart = self.steps.place(next) - self.steps.place(value);
                self.by_one += u64::from(apart.abs() == 1);
            }
        }
    }
}
