//! Reading and formatting of lengths with units.

use crate::values::six_digits;

/// Length in metres, and whether its unit was written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Length {
    pub metres: f64,
    pub has_unit: bool,
}

/// Reads a length, and whether its unit was written.
pub fn length_as_written(text: &str) -> Result<Length, String> {
    let has_unit = text.trim().parse::<f64>().is_err();
    length(text).map(|metres| Length { metres, has_unit })
}

/// Returns the unit that fits a length, and its number per metre: millimetres below 1 m, kilometres
/// from 10 km on.
pub fn fitting(metres: f64) -> (&'static str, f64) {
    match metres.abs() {
        length if length < 1.0 => ("mm", 1e3),
        length if length < 1e4 => ("m", 1.0),
        _ => ("km", 1e-3),
    }
}

/// Formats a length in a fitting unit, with at most six significant digits.
pub fn in_words(metres: f64) -> String {
    let (unit, factor) = fitting(metres);
    format!("{} {unit}", six_digits(metres * factor))
}

/// Reads a length in metres: a number, or one with its unit, as in `5cm` or `3ft`.
pub fn length(text: &str) -> Result<f64, String> {
    relief_io::metres(text).map_err(|error| error.to_string())
}

/// Reads a length in millimetres: a number, or one with its unit, as in `10cm`.
pub fn millimetres(text: &str) -> Result<f64, String> {
    match text.trim().parse::<f64>() {
        Ok(number) if number.is_finite() => Ok(number),
        Ok(_) => Err("it must be finite".to_owned()),
        Err(_) => length(text)
            .map(|metres| 1000.0 * metres)
            .map_err(|error| error.replace("a number of metres", "a number of millimetres")),
    }
}

/// Reads a length in metres, or `inf`.
pub fn length_or_infinity(text: &str) -> Result<f64, String> {
    if text.trim().eq_ignore_ascii_case("inf") { Ok(f64::INFINITY) } else { length(text) }
}

/// Reads one length for both axes, or two with a comma between them.
pub fn one_or_two_lengths(text: &str) -> Result<[f64; 2], String> {
    match text.split_once(',') {
        None => length(text).map(|both| [both, both]),
        Some(_) => two_lengths(text).map_err(|_| "write it as X or X,Y, in metres or with units".to_owned()),
    }
}

/// Reads two lengths `U,V`.
pub fn two_lengths(text: &str) -> Result<[f64; 2], String> {
    let wrong = || "write it as U,V, in metres or with units, as in 30cm,20cm".to_owned();
    let (first, second) = text.split_once(',').ok_or_else(wrong)?;
    if second.contains(',') {
        return Err(wrong());
    }
    Ok([length(first)?, length(second)?])
}

/// Reads two elevations `LOW,HIGH`, the second above the first.
pub fn elevations(text: &str) -> Result<[f64; 2], String> {
    let wrong = "write it as LOW,HIGH, in metres or with units, as in 236,1076 or 0.2km,1km";
    let both = two_lengths(text).map_err(|_| wrong.to_owned())?;
    if both[0] < both[1] { Ok(both) } else { Err("the second must be above the first".to_owned()) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_are_read_and_said_in_units_that_fit() {
        assert_eq!([millimetres("120"), millimetres("12cm")], [Ok(120.0), Ok(120.0)]);
        assert!(["", "inf", "wide", "mm"].iter().all(|bad| millimetres(bad).is_err()));
        let written = ["0.1", "0.1m"].map(|text| length_as_written(text).map(|length| length.has_unit));
        assert_eq!(written, [Ok(false), Ok(true)]);
        let words = [0.000_05, 0.999, -1.0, 9999.0, 1e4, 0.0].map(in_words);
        assert_eq!(words, ["0.05 mm", "999 mm", "-1 m", "9999 m", "10 km", "0 mm"]);
        assert_eq!(two_lengths("1ft, 2"), Ok([0.3048, 2.0]));
        assert_eq!((one_or_two_lengths("5cm"), one_or_two_lengths("1,2")), (Ok([0.05; 2]), Ok([1.0, 2.0])));
        assert!(["", "1", "1,2,3", "1,x"].iter().all(|bad| two_lengths(bad).is_err()));
        assert_eq!(elevations("-10.5,0.2km"), Ok([-10.5, 200.0]));
        assert!(["1", "2,1", "3,3", "1,inf", "nan,1"].iter().all(|bad| elevations(bad).is_err()));
    }
}
