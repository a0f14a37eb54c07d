//! Names with a place for a number: `%d`, or `%04d` for at least four digits.

use std::fmt::Write;

/// The most digits that a place can ask for: names of files are short.
const MOST_DIGITS: usize = 32;

/// A name with a place for a number, or without one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pattern {
    before: String,
    /// The digits at least, and what comes behind the number.
    place: Option<(usize, String)>,
}

/// Why a name is none that can be numbered.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum PatternError {
    /// It has more than one place.
    #[error("it has more than one place for a number: name files by %d or %04d once")]
    Several,
    /// A percent sign says nothing that is known.
    #[error("what its '%' stands for is not known: write %d or %04d for a number, %% for a percent sign")]
    Unknown,
    /// A place asks for more digits than names have.
    #[error("it asks for {0} digits, of at most {MOST_DIGITS}")]
    TooManyDigits(String),
}

/// What a percent sign begins.
enum Sign<'a> {
    /// A place for so many digits at least, written in so many bytes.
    Number(&'a str, usize),
    Percent,
    Unknown,
}

impl Pattern {
    /// Reads a name.
    ///
    /// # Errors
    ///
    /// When it has several places, or a percent sign that is neither one nor `%%`.
    pub fn parse(text: &str) -> Result<Self, PatternError> {
        let mut pattern = Pattern { before: String::new(), place: None };
        let mut rest = text;
        while let Some((plain, from)) = split_at_sign(rest) {
            pattern.end().push_str(plain);
            rest = match sign(from) {
                Sign::Unknown => return Err(PatternError::Unknown),
                Sign::Percent => {
                    pattern.end().push('%');
                    &from[2..]
                }
                Sign::Number(..) if pattern.has_place() => return Err(PatternError::Several),
                Sign::Number(digits, length) => {
                    let least = if digits.is_empty() { Ok(1) } else { digits.parse() };
                    let least = least.ok().filter(|least| *least <= MOST_DIGITS);
                    let least = least.ok_or_else(|| PatternError::TooManyDigits(digits.to_owned()))?;
                    pattern.place = Some((least, String::new()));
                    &from[length..]
                }
            };
        }
        pattern.end().push_str(rest);
        Ok(pattern)
    }

    /// Whether it has a place for a number.
    pub fn has_place(&self) -> bool {
        self.place.is_some()
    }

    /// The name with that number.
    pub fn with(&self, number: u32) -> String {
        let mut name = self.before.clone();
        if let Some((least, after)) = &self.place {
            // Text can always be written to.
            let _ = write!(name, "{number:0least$}{after}");
        }
        name
    }

    /// What is being read goes there.
    fn end(&mut self) -> &mut String {
        match &mut self.place {
            Some((_, after)) => after,
            None => &mut self.before,
        }
    }
}

/// Whether a name has a place for a number, whatever else it has.
pub fn has_place(text: &str) -> bool {
    let mut rest = text;
    while let Some((_, from)) = split_at_sign(rest) {
        rest = match sign(from) {
            Sign::Number(..) => return true,
            Sign::Percent => &from[2..],
            Sign::Unknown => &from[1..],
        };
    }
    false
}

/// What comes before the first percent sign, and what from it on.
fn split_at_sign(text: &str) -> Option<(&str, &str)> {
    text.find('%').map(|at| text.split_at(at))
}

/// What the percent sign says that the text begins with.
fn sign(text: &str) -> Sign<'_> {
    let after = &text[1..];
    if after.starts_with('%') {
        return Sign::Percent;
    }
    if after.starts_with('d') {
        return Sign::Number("", 2);
    }
    let Some(digits) = after.strip_prefix('0') else { return Sign::Unknown };
    let length = digits.bytes().take_while(u8::is_ascii_digit).count();
    if length > 0 && digits[length..].starts_with('d') {
        // The percent sign and the zero before the digits, the letter behind them.
        Sign::Number(&digits[..length], length + 3)
    } else {
        Sign::Unknown
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_take_their_places() {
        for (name, number, expected) in [
            ("a%d.png", 7, "a7.png"),
            ("a%04d.png", 7, "a0007.png"),
            ("a%04d.png", 12345, "a12345.png"),
            ("%02d", u32::MAX, "4294967295"),
            ("%010d.exr", 3, "0000000003.exr"),
            ("walk/%04d/object.toml", 47, "walk/0047/object.toml"),
            ("50%%/a%d%%d", 0, "50%/a0%d"),
            ("höhe_%03d_größe", 5, "höhe_005_größe"),
        ] {
            let pattern = Pattern::parse(name).expect("a pattern");
            assert!(pattern.has_place() && has_place(name), "{name}");
            assert_eq!(pattern.with(number), expected, "{name}");
        }
    }

    #[test]
    fn names_without_a_place_are_the_same_for_all_numbers() {
        for (name, expected) in [("", ""), ("a.png", "a.png"), ("a%%d.png", "a%d.png"), ("%%", "%")] {
            let pattern = Pattern::parse(name).expect("a name");
            assert!(!pattern.has_place() && !has_place(name), "{name}");
            assert_eq!(pattern.with(3), expected, "{name}");
        }
    }

    #[test]
    fn what_is_no_pattern_is_refused() {
        for name in
            ["%", "50%.png", "a%4d", "a%i", "a%0d", "a%", "a%D", "a%04", "a%-4d", "a% d", "%04x", "%ö"]
        {
            assert_eq!(Pattern::parse(name), Err(PatternError::Unknown), "{name}");
            // Where no frames are asked for it is a name like any other.
            assert!(!has_place(name), "{name}");
        }
        for name in ["%d%d", "a%d/b%04d.png", "%d%%%d"] {
            assert_eq!(Pattern::parse(name), Err(PatternError::Several), "{name}");
            assert!(has_place(name), "{name}");
        }
        for digits in ["33", "99999999999999999999999"] {
            let refused = Err(PatternError::TooManyDigits(digits.to_owned()));
            assert_eq!(Pattern::parse(&format!("a%0{digits}d")), refused);
        }
        assert!(has_place("50%x_%d") && Pattern::parse("50%x_%d").is_err());
    }
}
