//! Lengths with their units.

use relief_core::registry::UnknownName;

use crate::values::six_digits;

/// Units and their metres (the international foot and what is made of it).
const UNITS: [(&str, f64); 9] = [
    ("m", 1.0),
    ("mm", 1e-3),
    ("cm", 1e-2),
    ("km", 1e3),
    ("um", 1e-6),
    ("in", 0.0254),
    ("ft", 0.3048),
    ("yd", 0.9144),
    ("mi", 1609.344),
];

/// A length, and whether its unit was written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Length {
    pub metres: f64,
    pub has_unit: bool,
}

/// A length, with whether its unit was written.
pub fn length_as_written(text: &str) -> Result<Length, String> {
    let has_unit = text.trim().parse::<f64>().is_err();
    length(text).map(|metres| Length { metres, has_unit })
}

/// A length in the unit that fits it, and how many of that unit a metre is: millimetres below 1 m, kilometres
/// from 10 km on.
pub fn fitting(metres: f64) -> (&'static str, f64) {
    match metres.abs() {
        length if length < 1.0 => ("mm", 1e3),
        length if length < 1e4 => ("m", 1.0),
        _ => ("km", 1e-3),
    }
}

/// A length as people read it, of at most six digits that count.
pub fn in_words(metres: f64) -> String {
    let (unit, factor) = fitting(metres);
    format!("{} {unit}", six_digits(metres * factor))
}

/// Metres: a number of them, or one with its unit, as in `5cm` or `3ft`.
pub fn length(text: &str) -> Result<f64, String> {
    let text = text.trim();
    if let Ok(metres) = text.parse::<f64>() {
        return if metres.is_finite() { Ok(metres) } else { Err("it must be finite".to_owned()) };
    }
    let unit = text.trim_start_matches(|sign: char| !sign.is_alphabetic() || matches!(sign, 'e' | 'E'));
    let number = text.strip_suffix(unit).unwrap_or(text);
    let known = UNITS.iter().find(|(name, _)| name.eq_ignore_ascii_case(unit));
    match (number.trim().parse::<f64>(), known) {
        (Ok(number), Some((_, metres))) if (number * metres).is_finite() => Ok(number * metres),
        (Ok(_), None) => {
            Err(UnknownName::new("unit of length", unit, UNITS.map(|(name, _)| name)).to_string())
        }
        _ => Err("write it as a number of metres, or with its unit, as in 5cm or 3ft".to_owned()),
    }
}

/// Millimetres: a number of them, or a length with its unit, as in `10cm`.
pub fn millimetres(text: &str) -> Result<f64, String> {
    match text.trim().parse::<f64>() {
        Ok(number) if number.is_finite() => Ok(number),
        Ok(_) => Err("it must be finite".to_owned()),
        Err(_) => length(text)
            .map(|metres| 1000.0 * metres)
            .map_err(|error| error.replace("a number of metres", "a number of millimetres")),
    }
}

/// A length, or `inf` for one that is longer than all others.
pub fn length_or_infinity(text: &str) -> Result<f64, String> {
    if text.trim().eq_ignore_ascii_case("inf") { Ok(f64::INFINITY) } else { length(text) }
}

/// One length for both axes, or two between a comma.
pub fn one_or_two_lengths(text: &str) -> Result<[f64; 2], String> {
    match text.split_once(',') {
        None => length(text).map(|both| [both, both]),
        Some(_) => two_lengths(text).map_err(|_| "write it as X or X,Y, in metres or with units".to_owned()),
    }
}

/// Two lengths `U,V`.
pub fn two_lengths(text: &str) -> Result<[f64; 2], String> {
    let wrong = || "write it as U,V, in metres or with units, as in 30cm,20cm".to_owned();
    let (first, second) = text.split_once(',').ok_or_else(wrong)?;
    if second.contains(',') {
        return Err(wrong());
    }
    Ok([length(first)?, length(second)?])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_are_metres_whatever_their_unit() {
        let cases = [
            ("0.05", 0.05),
            ("5cm", 0.05),
            (" -3 ft ", -0.9144),
            ("1e3mm", 1.0),
            ("2.5KM", 2500.0),
            ("1in", 0.0254),
            ("3e-2", 0.03),
        ];
        for (text, metres) in cases {
            let found = length(text).unwrap_or_else(|error| panic!("{text}: {error}"));
            assert!((found - metres).abs() <= 1e-12 * metres.abs(), "{text}: {found}");
        }
        for bad in ["", "m", "five", "5 lightyears", "inf", "nan", "1e308km", "5cm3", "é", "5é", "5€m", "€"]
        {
            assert!(length(bad).is_err(), "{bad}");
        }
        assert!(length("5fe").is_err_and(|error| error.contains("did you mean")));
        assert_eq!([millimetres("120"), millimetres("12cm")], [Ok(120.0), Ok(120.0)]);
        assert!(["", "inf", "wide", "mm"].iter().all(|bad| millimetres(bad).is_err()));
        let written = ["0.1", "0.1m"].map(|text| length_as_written(text).map(|length| length.has_unit));
        assert_eq!(written, [Ok(false), Ok(true)]);
        let words = [0.000_05, 0.999, -1.0, 9999.0, 1e4, 0.0].map(in_words);
        assert_eq!(words, ["0.05 mm", "999 mm", "-1 m", "9999 m", "10 km", "0 mm"]);
        assert_eq!(two_lengths("1ft, 2"), Ok([0.3048, 2.0]));
        assert_eq!((one_or_two_lengths("5cm"), one_or_two_lengths("1,2")), (Ok([0.05; 2]), Ok([1.0, 2.0])));
        assert!(["", "1", "1,2,3", "1,x"].iter().all(|bad| two_lengths(bad).is_err()));
    }
}
