//! Layout of headerless files.

use std::fmt;
use std::str::FromStr;

/// Byte order of 16-bit samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ByteOrder {
    /// The low byte first: `le`.
    Little,
    /// The high byte first: `be`.
    Big,
}

/// Layout of a headerless file: unsigned 16-bit samples, row by row from the top. Written
/// `403x344,le`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct RawLayout {
    /// Width in texels, not 0.
    pub width: u32,
    /// Height in texels, not 0.
    pub height: u32,
    /// Byte order of the samples.
    pub order: ByteOrder,
}

/// Error of a text that is not a layout of a headerless file.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "'{0}' is not a layout of a raw file: write width x height and the byte order, as in 1024x1024,le (or be)"
)]
pub struct BadRawLayout(String);

impl FromStr for RawLayout {
    type Err = BadRawLayout;

    fn from_str(text: &str) -> Result<Self, BadRawLayout> {
        let parse = || {
            let (size, order) = text.split_once(',')?;
            let (width, height) = size.split_once('x')?;
            let order = match order {
                "le" => ByteOrder::Little,
                "be" => ByteOrder::Big,
                _ => return None,
            };
            let side = |text: &str| text.parse().ok().filter(|&side: &u32| side > 0);
            Some(Self { width: side(width)?, height: side(height)?, order })
        };
        parse().ok_or_else(|| BadRawLayout(text.to_owned()))
    }
}

impl fmt::Display for RawLayout {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let order = match self.order {
            ByteOrder::Little => "le",
            ByteOrder::Big => "be",
        };
        write!(f, "{}x{},{order}", self.width, self.height)
    }
}
