//! Range of raw values that are mapped to heights 0 to 1.

use std::fmt;
use std::str::FromStr;

/// Raw values that become heights 0 and 1, in the file's own units: sample values, not fractions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum HeightRange {
    /// Two given values, the first below the second.
    Between([f64; 2]),
    /// The least and the greatest value of all texels that have one, whatever their type: `auto`.
    Extremes,
}

/// Name of [`HeightRange::Extremes`].
const AUTO: &str = "auto";

impl HeightRange {
    /// Returns the two values, if they are given.
    pub const fn between(self) -> Option<[f64; 2]> {
        match self {
            HeightRange::Between(range) => Some(range),
            HeightRange::Extremes => None,
        }
    }
}

impl From<[f64; 2]> for HeightRange {
    fn from(range: [f64; 2]) -> Self {
        HeightRange::Between(range)
    }
}

impl fmt::Display for HeightRange {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            HeightRange::Between([low, high]) => write!(f, "{low},{high}"),
            HeightRange::Extremes => f.write_str(AUTO),
        }
    }
}

impl FromStr for HeightRange {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        if text.trim().eq_ignore_ascii_case(AUTO) {
            return Ok(HeightRange::Extremes);
        }
        let numbers = text.split_once(',').map(|(low, high)| [low, high].map(|part| part.trim().parse()));
        let Some([Ok(low), Ok(high)]) = numbers else {
            return Err("write it as A,B, or auto for the least and the greatest value".to_owned());
        };
        let range: [f64; 2] = [low, high];
        if range.iter().all(|value| value.is_finite()) {
            Ok(HeightRange::Between(range))
        } else {
            Err("it must be finite".to_owned())
        }
    }
}
