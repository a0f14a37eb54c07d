//! Checks of heights that have been read: values that probably stand for nodata without being
//! declared, and a range that hides the relief. Only the samples themselves are held in memory.

use crate::height::HeightOptions;
use crate::layout::{Layout, SampleKind, SampleType};
use crate::nodata::NO_HEIGHT;
use crate::omissions::{ABSENT_NODATA, FITTED_RANGE, NARROW_RANGE, NEAR_NODATA, Remark, UNDECLARED_NODATA};
use crate::samples::Samples;

/// Greatest relative distance from the declared nodata value that lossy compression causes.
const LOSSY: f64 = 2.5e-4;

/// Least distance of a nodata value from all heights, in multiples of their whole relief.
const FAR: f64 = 3.0;

/// Like [`FAR`]: for values that are ends of a type or common as heights, and for all other values.
const FAR_ENDS: f64 = 5.0;
const FAR_OTHERS: f64 = 10.0;

/// Least number of different heights for another value to count as nodata by its distance alone.
const LEVELS: usize = 4;

/// Values that programs write as nodata. No picture and no ground has them.
const USUAL: [f64; 18] = [
    -9999.0,
    9999.0,
    -99999.0,
    99999.0,
    -999.0,
    -9999.9,
    -999.9,
    -999.25,
    -999_999.0,
    999_999.0,
    -32768.0,
    -32767.0,
    32767.0,
    -2_147_483_648.0,
    -2_147_483_647.0,
    2_147_483_647.0,
    -1e10,
    1e20,
];

/// Ends of types, and other values that are common both as nodata and as heights.
const ENDS: [f64; 7] = [0.0, -1.0, 255.0, 65535.0, 65534.0, 4_294_967_295.0, -128.0];

/// Least part of its type's range that a relief should use.
const NARROW: f64 = 0.1;

/// Part of 0 to 1 used by floats above which the choice of the range makes no difference.
const NEARLY_ALL: f64 = 0.9;

/// Number of the least and of the greatest different values that are inspected.
const VALUES: usize = 8;

/// Greatest number of nodata values at either end.
const MARKS: usize = 3;

/// Turns texels that nearly equal a nodata value into holes, and returns the notes for the user.
/// `is_noted` is set for files that Relief wrote, whose range is meaningful.
pub(crate) fn examine(
    samples: &mut Samples,
    layout: &Layout,
    sample: SampleType,
    options: &HeightOptions,
    is_noted: bool,
) -> Vec<Remark> {
    let mut remarks = Vec::new();
    let shown = |stored: f64| number(stored, sample);
    for declared in [layout.nodata, options.nodata].into_iter().flatten() {
        remarks.extend(near(samples, declared, sample));
    }
    if let Some(given) = options.nodata.filter(|_| samples.given_nodata == 0 && remarks.is_empty()) {
        let values = match samples.extremes {
            [least, greatest] if least <= greatest => {
                let [least, greatest] = samples.stored([least, greatest]).map(shown);
                format!("; its values go from {least} to {greatest}")
            }
            _ => String::new(),
        };
        let text = format!("no texel has the nodata value {} that was given{values}", shown(given));
        remarks.push(Remark::new(&ABSENT_NODATA, text));
    }
    if is_noted || samples.extremes[0] >= samples.extremes[1] {
        return remarks;
    }
    let ends = Ends::of(samples);
    if let Some(remark) = undeclared(&ends, samples, layout, sample) {
        remarks.push(remark);
        return remarks;
    }
    if options.range.is_none() {
        let taken = layout.height_full_scale();
        remarks.extend(range(samples.extremes, taken, sample, layout.is_elevation()));
    }
    remarks
}

/// Formats a number with the digits that its type holds.
fn number(value: f64, sample: SampleType) -> String {
    let is_large = value.abs() >= 1e15;
    match sample.kind {
        SampleKind::Float if sample.bits <= 32 && is_large => format!("{:e}", value as f32),
        SampleKind::Float if sample.bits <= 32 => (value as f32).to_string(),
        _ if is_large => format!("{value:e}"),
        _ => value.to_string(),
    }
}

/// Turns texels close to the declared nodata value into holes, if no other value is near it.
fn near(samples: &mut Samples, declared: f64, sample: SampleType) -> Option<Remark> {
    let mark = samples.raw(declared);
    let tolerance = LOSSY * declared.abs();
    let is_near = |value: f64| (value - mark).abs() <= tolerance;
    // A value far from all others is the least or the greatest.
    if !(declared.abs() < NO_HEIGHT && samples.extremes.into_iter().any(is_near)) {
        return None;
    }
    let none = [f64::INFINITY, f64::NEG_INFINITY];
    let wider = |[low, high]: [f64; 2], value: f64| [low.min(value), high.max(value)];
    let (mut rest, mut found, mut count) = (none, none, 0u64);
    for value in samples.raw_values() {
        if is_near(value) {
            found = wider(found, value);
            count += 1;
        } else {
            rest = wider(rest, value);
        }
    }
    let [low, high] = rest;
    let away = (low - mark).max(mark - high);
    if !(low <= high && away > 4.0 * tolerance && away >= FAR * (high - low)) {
        return None;
    }
    samples.forget(is_near, rest);
    let [least, greatest] = samples.stored(found).map(|value| number(value, sample));
    let values = if least == greatest { least } else { format!("{least} to {greatest}") };
    let declared = number(declared, sample);
    let text = format!(
        "{count} texels have {values}, which is the nodata value {declared} after lossy compression: they \
         are read as holes"
    );
    Some(Remark::new(&NEAR_NODATA, text))
}

/// Least and greatest different values, outermost first, with the number of texels of each. If
/// there are at most [`VALUES`] different values, both lists hold all of them.
struct Ends {
    low: Vec<(f64, u64)>,
    high: Vec<(f64, u64)>,
}

impl Ends {
    fn of(samples: &Samples) -> Self {
        let (mut low, mut high) = (Side::new(), Side::new());
        for &value in samples.values.iter().filter(|value| !value.is_nan()) {
            low.take(value);
            high.take(-value);
        }
        let raw = |(value, count): (f32, u64), sign: f64| (sign * f64::from(value) + samples.offset, count);
        Self {
            low: low.values().map(|value| raw(value, 1.0)).collect(),
            high: high.values().map(|value| raw(value, -1.0)).collect(),
        }
    }

    /// Number of different values: exact up to [`VALUES`], and one more than that beyond.
    fn levels(&self) -> usize {
        let is_all = self.low.len() < VALUES || self.high.last().is_some_and(|last| last.0 == self.low[0].0);
        if is_all { self.low.len() } else { VALUES + 1 }
    }
}

/// Least different values in ascending order.
struct Side {
    values: [(f32, u64); VALUES],
}

impl Side {
    fn new() -> Self {
        Self { values: [(f32::INFINITY, 0); VALUES] }
    }

    #[inline]
    fn take(&mut self, value: f32) {
        if value <= self.values[VALUES - 1].0 {
            self.insert(value);
        }
    }

    fn insert(&mut self, value: f32) {
        let at = self.values.partition_point(|(known, _)| *known < value);
        if self.values[at].0 != value {
            self.values.copy_within(at..VALUES - 1, at + 1);
            self.values[at] = (value, 0);
        }
        self.values[at].1 += 1;
    }

    fn values(self) -> impl Iterator<Item = (f32, u64)> {
        self.values.into_iter().filter(|(_, count)| *count > 0)
    }
}

/// Reports values at the ends that are far from all others.
fn undeclared(ends: &Ends, samples: &Samples, layout: &Layout, sample: SampleType) -> Option<Remark> {
    let levels = ends.levels();
    // The least and the greatest height without `lows` values at the low end and `highs` at the
    // high end; and the least distance of those values, relative to the distance that they need.
    // None if no height remains, or if any value is too near.
    let split = |lows: usize, highs: usize| -> Option<([f64; 2], f64)> {
        let rest = levels.checked_sub(lows + highs).filter(|rest| *rest > 0)?;
        let (low, high) = (ends.low.get(lows)?.0, ends.high.get(highs)?.0);
        let far = |mark: (f64, u64), away: f64| {
            let needed = needed(samples.stored([mark.0; 2])[0], mark.1, rest, layout.is_elevation(), sample)?;
            let relief = high - low;
            // If the heights are all equal, every mark is infinitely far in units of the relief.
            let ratio = if relief > 0.0 { away / relief } else { f64::INFINITY };
            (away > 0.0 && ratio >= needed).then_some(ratio / needed)
        };
        let below = ends.low[..lows].iter().map(|mark| far(*mark, low - mark.0));
        let above = ends.high[..highs].iter().map(|mark| far(*mark, mark.0 - high));
        let least = below.chain(above).try_fold(f64::INFINITY, |least, far| Some(least.min(far?)))?;
        Some(([low, high], least))
    };
    let sides = (0..=MARKS).flat_map(|lows| (0..=MARKS).map(move |highs| (lows, highs)));
    let possible = sides.filter(|sides| *sides != (0, 0));
    let found = possible.filter_map(|(lows, highs)| Some(((lows, highs), split(lows, highs)?)));
    // Choose the split that leaves the narrowest range of heights.
    let ((lows, highs), ([low, high], _)) =
        found.min_by(|(_, (a, _)), (_, (b, _))| (a[1] - a[0]).total_cmp(&(b[1] - b[0])))?;
    let marks = ends.low[..lows].iter().chain(&ends.high[..highs]);
    let most = marks.clone().max_by_key(|mark| mark.1)?;
    let each = marks.clone().map(|(value, count)| {
        let texels = if *count == 1 { "texel has" } else { "texels have" };
        format!("{count} {texels} {}", number(samples.stored([*value; 2])[0], sample))
    });
    let each = each.collect::<Vec<_>>().join(", ");
    // If white is stored as 0, values far above are stored far below.
    let is_below = (highs == 0) != samples.white.is_some();
    let side = match (lows, highs) {
        (0, _) | (_, 0) if is_below => "below",
        (0, _) | (_, 0) => "above",
        _ => "beyond",
    };
    // If all heights are equal, their digits may be lost beside the mark's.
    let rest = if low < high {
        let [low, high] = samples.stored([low, high]).map(|value| number(value, sample));
        format!(" ({low} to {high})")
    } else {
        String::new()
    };
    let what = if lows + highs == 1 { "a nodata value" } else { "nodata values" };
    let text = format!("{each}, far {side} the rest{rest}: {what}?");
    let mend = number(samples.stored([most.0; 2])[0], sample);
    Some(Remark::new(&UNDECLARED_NODATA, text).with_mend(mend))
}

/// Distance from all heights, in multiples of the relief, that a value needs to count as nodata.
/// None if it cannot count.
fn needed(value: f64, count: u64, rest: usize, is_elevation: bool, sample: SampleType) -> Option<f64> {
    if value.abs() >= NO_HEIGHT {
        return Some(1.0);
    }
    let is =
        |usual: f64| value == usual || (sample.kind == SampleKind::Float && value as f32 == usual as f32);
    if USUAL.into_iter().any(is) {
        return Some(FAR);
    }
    let has_levels = rest >= LEVELS && count > 1;
    let ends = if is_elevation { FAR } else { FAR_ENDS };
    let others = if is_elevation { FAR_ENDS } else { FAR_OTHERS };
    has_levels.then_some(if ENDS.contains(&value) { ends } else { others })
}

/// Note on the default range: that its part used is small, or that it was fitted to the extremes.
fn range(
    [least, greatest]: [f64; 2],
    taken: Option<f64>,
    sample: SampleType,
    is_elevation: bool,
) -> Option<Remark> {
    let used = greatest - least;
    let [low, high] = [least, greatest].map(|value| number(value, sample));
    if let Some(full) = taken.filter(|full| used < NARROW * full) {
        let percent = (1000.0 * used / full).round() / 10.0;
        let text = format!(
            "its values go from {low} to {high}, {percent} % of 0 to {full}, so that the relief is hardly \
             seen"
        );
        return Some(Remark::new(&NARROW_RANGE, text).with_mend(format!("{low},{high}")));
    }
    let is_fraction = sample.kind == SampleKind::Float && !is_elevation && least >= 0.0 && greatest <= 1.0;
    (taken.is_none() && is_fraction && used < NEARLY_ALL).then(|| {
        let text = format!(
            "heights 0 and 1 are its least and greatest value, {low} and {high}; in a file of integers they \
             would be the ends of the type"
        );
        Remark::new(&FITTED_RANGE, text).with_mend("0,1")
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_outermost_values_are_counted_in_any_order() {
        let mut side = Side::new();
        for value in [5.0, 3.0, 5.0, 9.0, 1.0, 3.0, 7.0, 2.0, 8.0, 6.0, 4.0, 1.0, 10.0] {
            side.take(value);
        }
        let found: Vec<_> = side.values().collect();
        let counts = [2, 1, 2, 1, 2, 1, 1, 1];
        assert_eq!(found, (1u8..9).map(f32::from).zip(counts).collect::<Vec<_>>());
    }

    #[test]
    fn numbers_have_the_digits_of_their_type() {
        let [float, double] = [32, 64].map(SampleType::float);
        assert_eq!(number(f64::from(-9999.9f32), float), "-9999.9");
        assert_eq!(number(f64::from(f32::MIN), float), "-3.4028235e38");
        assert_eq!(number(-0.1, double), "-0.1");
        assert_eq!(number(65535.0, SampleType::unsigned(16)), "65535");
    }
}
