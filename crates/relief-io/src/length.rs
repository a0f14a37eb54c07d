//! Parser of lengths as people write them: numbers of metres, or numbers with a unit.

use relief_core::registry::UnknownName;

use crate::LengthUnit;

/// Error in the text of a length.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum LengthError {
    /// The text is not a number, with or without a unit.
    #[error("write it as a number of metres, or with its unit, as in 5cm or 3ft")]
    NoNumber,
    /// The number or its metres are infinite or NaN.
    #[error("it must be finite")]
    NotFinite,
    /// The unit's name is unknown.
    #[error(transparent)]
    Unit(UnknownName),
}

/// Parses a length and converts it to metres: a plain number of metres, or a number with a
/// [`LengthUnit`], such as `5cm` or `3 ft`.
///
/// # Errors
///
/// When the text is not a number with a known unit, or not finite in metres.
///
/// # Examples
///
/// ```
/// assert_eq!(relief_io::metres("2.5km")?, 2500.0);
/// assert_eq!(relief_io::metres("0.05")?, 0.05);
/// # Ok::<(), relief_io::LengthError>(())
/// ```
pub fn metres(text: &str) -> Result<f64, LengthError> {
    let text = text.trim();
    let unit = text.trim_start_matches(|sign: char| !sign.is_alphabetic() || matches!(sign, 'e' | 'E'));
    let (number, unit) = match text.parse::<f64>() {
        Ok(number) => (number, LengthUnit::METRE),
        Err(_) => {
            let number = text.strip_suffix(unit).unwrap_or(text).trim();
            (number.parse().map_err(|_| LengthError::NoNumber)?, unit.parse().map_err(LengthError::Unit)?)
        }
    };
    let metres = number * unit.metres();
    if metres.is_finite() { Ok(metres) } else { Err(LengthError::NotFinite) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_are_converted_to_metres() {
        let cases = [
            ("0.05", 0.05),
            ("5cm", 0.05),
            (" -3 ft ", -0.9144),
            ("1e3mm", 1.0),
            ("2.5KM", 2500.0),
            ("40um", 4e-5),
            ("1in", 0.0254),
            ("2 mi", 3218.688),
            ("3937us-ft", 1200.0),
            ("3e-2", 0.03),
        ];
        for (text, expected) in cases {
            let found = metres(text).unwrap_or_else(|error| panic!("{text}: {error}"));
            assert!((found - expected).abs() <= 1e-12 * expected.abs(), "{text}: {found}");
        }
        for bad in ["", "m", "five", "5 lightyears", "inf", "nan", "1e308km", "5cm3", "é", "5é", "5€m", "€"]
        {
            assert!(metres(bad).is_err(), "{bad}");
        }
        assert!(metres("5fe").is_err_and(|error| error.to_string().contains("did you mean")));
    }
}
