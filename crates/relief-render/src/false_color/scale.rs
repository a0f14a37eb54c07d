//! Scales: from numbers to places along a legend.

use super::quantity::Form;

/// Mark of a pixel that shows no surface.
pub const NO_SURFACE: f32 = f32::NAN;

/// Mark of a pixel that shows a surface where the exact tracer finds none, or the other way round.
pub const NOT_COMPARABLE: f32 = f32::INFINITY;

/// Scale of a quantity, whose ends are the least and the greatest of its numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scale {
    form: Form,
    /// The least and the greatest number; none if there are no numbers.
    ends: Option<[f32; 2]>,
}

/// Number beside a legend's bar.
#[derive(Clone, Debug, PartialEq)]
pub struct Tick {
    /// Place along the bar, from 0 to 1.
    pub place: f32,
    /// Number as text.
    pub label: String,
}

impl Scale {
    /// Creates the scale of some numbers. Infinities and NaN do not count.
    pub fn of<'a>(form: Form, numbers: impl IntoIterator<Item = &'a f32>) -> Self {
        let finite = numbers.into_iter().copied().filter(|number| number.is_finite());
        let ends = finite.fold(None, |ends: Option<[f32; 2]>, number| match ends {
            None => Some([number; 2]),
            Some([least, most]) => Some([least.min(number), most.max(number)]),
        });
        Self { form, ends }
    }

    /// Returns the least and the greatest number; none if there are no numbers.
    pub fn ends(&self) -> Option<[f32; 2]> {
        self.ends
    }

    /// Returns the ends between which colours change.
    fn shown_ends(&self) -> Option<[f32; 2]> {
        match (self.form, self.ends) {
            (Form::Logarithmic(floor), Some([least, most])) => Some([least.max(floor), most.max(floor)]),
            (_, ends) => ends,
        }
    }

    /// Returns the place of a number along the scale, from 0 to 1. If all numbers are equal, it is
    /// in the middle; at the beginning if they are nothing, as errors of the exact picture are.
    pub fn place(&self, number: f32) -> f32 {
        let Some([least, most]) = self.shown_ends() else { return 0.0 };
        if least >= most {
            let is_nothing = match self.form {
                Form::Logarithmic(floor) => most <= floor,
                Form::Linear => most == 0.0,
                Form::Counts | Form::Directions => false,
            };
            return if is_nothing { 0.0 } else { 0.5 };
        }
        let part = match self.form {
            Form::Logarithmic(_) => (number.max(least) / least).ln() / (most / least).ln(),
            // In `f64` differences of large numbers do not overflow.
            _ => {
                let [number, least, most] = [number, least, most].map(f64::from);
                ((number - least) / (most - least)) as f32
            }
        };
        part.clamp(0.0, 1.0)
    }

    /// Whether all numbers have one colour.
    pub fn is_constant(&self) -> bool {
        self.shown_ends().is_some_and(|[least, most]| least >= most)
    }

    /// Returns the numbers for a bar's sides: the ends first, then round ones between them, the
    /// most important first.
    pub fn ticks(&self) -> Vec<Tick> {
        let Some([least, most]) = self.shown_ends() else { return Vec::new() };
        let at_floor = match (self.form, self.ends) {
            (Form::Logarithmic(floor), Some([least, _])) => least < floor,
            _ => false,
        };
        let first = Tick { place: self.place(least), label: self.label(least, at_floor) };
        if least >= most {
            return vec![Tick { label: format!("{} everywhere", first.label), ..first }];
        }
        let mut ticks = vec![first, Tick { place: 1.0, label: self.label(most, false) }];
        ticks.extend(
            self.between(f64::from(least), f64::from(most))
                .into_iter()
                .map(|number| Tick { place: self.place(number as f32), label: short(number) }),
        );
        ticks
    }

    fn label(&self, number: f32, is_floor: bool) -> String {
        let text = short(number.into());
        if is_floor { format!("<={text}") } else { text }
    }

    /// Returns round numbers between the ends.
    fn between(&self, least: f64, most: f64) -> Vec<f64> {
        if let Form::Logarithmic(_) = self.form {
            let powers = (least.log10().ceil() as i32)..=(most.log10().floor() as i32);
            return powers.map(|power| 10f64.powi(power)).collect();
        }
        let wanted = (most - least) / 4.0;
        let power = 10f64.powf(wanted.log10().floor());
        let step = [1.0, 2.0, 5.0, 10.0].map(|part| part * power).into_iter().find(|step| *step >= wanted);
        let mut step = step.unwrap_or(wanted);
        if self.form == Form::Counts {
            step = step.max(1.0).round();
        }
        let count = |number: f64| (number / step).ceil() as i64;
        (count(least)..=count(most))
            .map(|place| place as f64 * step)
            .filter(|number| *number < most)
            .collect()
    }
}

/// Formats a number in at most four significant digits and ten characters.
pub fn short(number: f64) -> String {
    if number == 0.0 {
        return "0".to_owned();
    }
    let power = number.abs().log10().floor() as i32;
    if !(-4..6).contains(&power) {
        return format!("{number:.2e}");
    }
    let digits = (3 - power).max(0) as usize;
    let text = format!("{number:.digits$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ends_are_the_least_and_the_greatest_number() {
        let scale = Scale::of(Form::Linear, &[3.0, f32::NAN, -1.0, f32::INFINITY, 1.0]);
        assert_eq!(scale.ends(), Some([-1.0, 3.0]));
        assert_eq!([-1.0, 0.0, 3.0, 9.0].map(|number| scale.place(number)), [0.0, 0.25, 1.0, 1.0]);
        let labels: Vec<String> = scale.ticks().into_iter().map(|tick| tick.label).collect();
        assert_eq!(labels, ["-1", "3", "-1", "0", "1", "2"]);
        let huge = Scale::of(Form::Linear, &[-3e38, 3e38]);
        assert_eq!(huge.place(0.0), 0.5);
    }

    #[test]
    fn equal_numbers_have_one_place_and_none_have_no_ends() {
        let one = Scale::of(Form::Linear, &[0.05, 0.05]);
        assert!(one.is_constant());
        assert_eq!(one.ticks(), [Tick { place: 0.5, label: "0.05 everywhere".to_owned() }]);
        let none = Scale::of(Form::Counts, &[f32::NAN]);
        assert_eq!((none.ends(), none.ticks(), none.is_constant()), (None, vec![], false));
    }

    #[test]
    fn counts_have_whole_ticks_and_errors_powers_of_ten() {
        let labels = |scale: Scale| scale.ticks().into_iter().map(|tick| tick.label).collect::<Vec<_>>();
        assert_eq!(labels(Scale::of(Form::Counts, &[3.0, 5.0])), ["3", "5", "3", "4"]);
        let errors = Scale::of(Form::Logarithmic(1e-3), &[0.0, 20.0]);
        assert_eq!(labels(errors), ["<=0.001", "20", "0.01", "0.1", "1", "10"]);
        assert_eq!((errors.place(0.0), errors.place(20.0)), (0.0, 1.0));
        let none = Scale::of(Form::Logarithmic(1e-3), &[0.0, 1e-5]);
        assert_eq!((labels(none), none.place(0.0)), (vec!["<=0.001 everywhere".to_owned()], 0.0));
        assert_eq!(Scale::of(Form::Linear, &[0.0]).place(0.0), 0.0);
    }

    #[test]
    fn labels_are_short() {
        let all = [0.0, 1.0, -0.000_123_4, 123_456.0, 1e-7, 3.402e38, -1.5, 0.1 + 0.2, 99_999.96];
        let expected = ["0", "1", "-0.0001234", "123456", "1.00e-7", "3.40e38", "-1.5", "0.3", "100000"];
        assert_eq!(all.map(short), expected);
        assert!(all.iter().all(|number| short(*number).len() <= 10));
    }
}
