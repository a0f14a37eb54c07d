//! Ranges of frame numbers.

use std::ops::RangeInclusive;
use std::str::FromStr;

/// Most frames of a run.
const MOST_FRAMES: u64 = 1_000_000;

/// Form of a range.
const FORM: &str = "write it as A..B, inclusive, as in 0..47";

/// Frame numbers from a first to a last one, inclusive.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Frames {
    first: u32,
    last: u32,
}

impl FromStr for Frames {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (first, last) = text.split_once("..").ok_or(FORM)?;
        let number = |text: &str| -> Result<u32, String> {
            let text = text.trim();
            let is_digits = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
            match text.strip_prefix('-') {
                Some(digits) if is_digits(digits) => Err("frames are counted from 0 on".to_owned()),
                _ if is_digits(text) => {
                    text.parse().map_err(|_| format!("frames have numbers of at most {}", u32::MAX))
                }
                _ => Err(FORM.to_owned()),
            }
        };
        let frames = Self { first: number(first)?, last: number(last)? };
        let Self { first, last } = frames;
        if first > last {
            return Err(format!("{first} comes after {last}: {FORM}"));
        }
        match frames.count() {
            count if count > MOST_FRAMES => {
                Err(format!("{count} frames are too many: give at most {MOST_FRAMES}"))
            }
            _ => Ok(frames),
        }
    }
}

impl Frames {
    /// Returns the first number.
    pub fn first(self) -> u32 {
        self.first
    }

    /// Returns all numbers.
    pub fn numbers(self) -> RangeInclusive<u32> {
        self.first..=self.last
    }

    /// Returns the number of frames.
    pub fn count(self) -> u64 {
        u64::from(self.last).saturating_sub(u64::from(self.first)) + 1
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_are_read_or_refused() {
        let range = |text: &str| text.parse::<Frames>().map(|frames| (frames.numbers(), frames.count()));
        assert_eq!(range("0..47"), Ok((0..=47, 48)));
        assert_eq!(range("7..7"), Ok((7..=7, 1)));
        assert_eq!(range("1..1000000").map(|(_, count)| count), Ok(MOST_FRAMES));
        assert_eq!(range("4294967295..4294967295").map(|(_, count)| count), Ok(1));
        for (text, word) in [
            ("", "A..B"),
            ("7", "A..B"),
            ("0..=47", "A..B"),
            ("0..47..2", "A..B"),
            ("..4", "A..B"),
            ("4..", "A..B"),
            ("a..b", "A..B"),
            ("+1..2", "A..B"),
            ("-1..3", "from 0"),
            ("-3..-1", "from 0"),
            ("5..4", "5 comes after 4"),
            ("0..1000000", "1000001"),
            ("0..4294967295", "4294967296"),
            ("0..4294967296", "4294967295"),
        ] {
            let refused = range(text).expect_err("no range");
            assert!(refused.contains(word), "{text}: {refused}");
        }
    }
}
