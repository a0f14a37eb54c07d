//! Amounts of memory.

use std::fmt;
use std::str::FromStr;

/// A number of bytes, written as `4GiB`, `512 MiB`, `64KiB`, `100B` or a plain number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ByteSize(pub u64);

/// The text is not an amount of memory.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "'{0}' is not an amount of memory: write a whole number of bytes, or of KiB, MiB, GiB or TiB as in 4GiB"
)]
pub struct BadByteSize(String);

const UNITS: [(&str, u32); 5] = [("TiB", 40), ("GiB", 30), ("MiB", 20), ("KiB", 10), ("B", 0)];

impl FromStr for ByteSize {
    type Err = BadByteSize;

    fn from_str(text: &str) -> Result<Self, BadByteSize> {
        let unit = UNITS.iter().find_map(|&(unit, bits)| Some((text.strip_suffix(unit)?, 1u64 << bits)));
        let (number, factor) = unit.unwrap_or((text, 1));
        let bytes = number.trim().parse::<u64>().ok().and_then(|number| number.checked_mul(factor));
        bytes.map(ByteSize).ok_or_else(|| BadByteSize(text.to_owned()))
    }
}

impl fmt::Display for ByteSize {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match UNITS.iter().find(|(_, bits)| self.0 != 0 && self.0.trailing_zeros() >= *bits) {
            Some((unit, bits)) => write!(f, "{}{unit}", self.0 >> bits),
            None => write!(f, "0B"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn amounts_are_read_and_written_alike() {
        for (text, bytes) in
            [("4GiB", 4 << 30), ("3 MiB", 3 << 20), ("1023", 1023), ("0", 0), ("1TiB", 1 << 40)]
        {
            assert_eq!(text.parse(), Ok(ByteSize(bytes)), "{text}");
            assert_eq!(ByteSize(bytes).to_string().parse(), Ok(ByteSize(bytes)), "{text}");
        }
        // Without a unit, the number would be read as a multiple of the unit beside it.
        assert_eq!(ByteSize(1).to_string(), "1B");
        for text in ["", "GiB", "B", "-1", "1.5GiB", "4GB", "20000000TiB", "4 gib"] {
            assert!(text.parse::<ByteSize>().is_err(), "{text}");
        }
    }
}
