//! File names with a placeholder for a number: `%d`, or `%04d` for at least four digits.

use std::fmt::Write;

/// Most digits that a placeholder can ask for: names of files are short.
const MOST_DIGITS: usize = 32;

/// Name with a placeholder for a number, or without one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pattern {
    before: String,
    /// Least number of digits, and the text behind the number.
    placeholder: Option<(usize, String)>,
}

/// Reason that a name cannot be numbered.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum PatternError {
    /// The name has more than one placeholder.
    #[error("it has more than one placeholder for a number: write %d or %04d once")]
    Several,
    /// A percent sign has no known meaning.
    #[error("its '%' has no known meaning: write %d or %04d for a number, %% for a percent sign")]
    Unknown,
    /// A placeholder asks for too many digits.
    #[error("it asks for {0} digits: the most is {MOST_DIGITS}")]
    TooManyDigits(String),
}

/// Meaning of a percent sign.
enum Sign<'a> {
    /// Placeholder: the text of its least number of digits, and its length in bytes.
    Number(&'a str, usize),
    Percent,
    Unknown,
}

impl Pattern {
    /// Reads a name.
    ///
    /// # Errors
    ///
    /// When it has several placeholders, or a percent sign that is neither a placeholder nor `%%`.
    pub fn parse(text: &str) -> Result<Self, PatternError> {
        let mut pattern = Pattern { before: String::new(), placeholder: None };
        let mut rest = text;
        while let Some((plain, from)) = split_at_sign(rest) {
            pattern.end().push_str(plain);
            rest = match sign(from) {
                Sign::Unknown => return Err(PatternError::Unknown),
                Sign::Percent => {
                    pattern.end().push('%');
                    &from[2..]
                }
                Sign::Number(..) if pattern.has_placeholder() => return Err(PatternError::Several),
                Sign::Number(digits, length) => {
                    let least = if digits.is_empty() { Ok(1) } else { digits.parse() };
                    let least = least.ok().filter(|least| *least <= MOST_DIGITS);
                    let least = least.ok_or_else(|| PatternError::TooManyDigits(digits.to_owned()))?;
                    pattern.placeholder = Some((least, String::new()));
                    &from[length..]
                }
            };
        }
        pattern.end().push_str(rest);
        Ok(pattern)
    }

    /// Whether it has a placeholder for a number.
    pub fn has_placeholder(&self) -> bool {
        self.placeholder.is_some()
    }

    /// Returns the name with a number in place of the placeholder.
    pub fn with(&self, number: u32) -> String {
        let mut name = self.before.clone();
        if let Some((least, after)) = &self.placeholder {
            // Writing to a string cannot fail.
            let _ = write!(name, "{number:0least$}{after}");
        }
        name
    }

    /// Returns the text that grows while a name is read.
    fn end(&mut self) -> &mut String {
        match &mut self.placeholder {
            Some((_, after)) => after,
            None => &mut self.before,
        }
    }
}

/// Whether a name has a placeholder for a number, even if it is no valid pattern.
pub fn has_placeholder(text: &str) -> bool {
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

/// Splits a text before its first percent sign.
fn split_at_sign(text: &str) -> Option<(&str, &str)> {
    text.find('%').map(|at| text.split_at(at))
}

/// Reads the percent sign at the start of a text.
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
        // The percent sign and the zero before the digits, and the letter behind them.
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
            assert!(pattern.has_placeholder() && has_placeholder(name), "{name}");
            assert_eq!(pattern.with(number), expected, "{name}");
        }
    }

    #[test]
    fn names_without_a_placeholder_are_the_same_for_all_numbers() {
        for (name, expected) in [("", ""), ("a.png", "a.png"), ("a%%d.png", "a%d.png"), ("%%", "%")] {
            let pattern = Pattern::parse(name).expect("a name");
            assert!(!pattern.has_placeholder() && !has_placeholder(name), "{name}");
            assert_eq!(pattern.with(3), expected, "{name}");
        }
    }

    #[test]
    fn bad_patterns_are_refused() {
        for name in
            ["%", "50%.png", "a%4d", "a%i", "a%0d", "a%", "a%D", "a%04", "a%-4d", "a% d", "%04x", "%ö"]
        {
            assert_eq!(Pattern::parse(name), Err(PatternError::Unknown), "{name}");
            // Without --frames it is a name like any other.
            assert!(!has_placeholder(name), "{name}");
        }
        for name in ["%d%d", "a%d/b%04d.png", "%d%%%d"] {
            assert_eq!(Pattern::parse(name), Err(PatternError::Several), "{name}");
            assert!(has_placeholder(name), "{name}");
        }
        for digits in ["33", "99999999999999999999999"] {
            let refused = Err(PatternError::TooManyDigits(digits.to_owned()));
            assert_eq!(Pattern::parse(&format!("a%0{digits}d")), refused);
        }
        assert!(has_placeholder("50%x_%d") && Pattern::parse("50%x_%d").is_err());
    }
}
