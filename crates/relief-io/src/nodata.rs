//! Markers of texels without a value.

use half::f16;

use crate::layout::{SampleKind, SampleType};

/// Upper bound of heights in any unit. Greater numbers are limits of their type, which programs
/// write with more or fewer digits.
pub(crate) const NO_HEIGHT: f64 = 1e30;

/// Marker of texels without a value, for samples of one type.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Marker {
    /// Exactly this number.
    Number(f64),
    /// Every number that rounds to this `f32`. Programs that compute in floats store such numbers
    /// as doubles.
    Float(f32),
    /// Every number of at least [`NO_HEIGHT`] in size with the sign of this one.
    Limit(f64),
}

impl Marker {
    /// Creates a marker from a number that a file declares or a user gives, which may have fewer
    /// digits than the stored one.
    pub(crate) fn new(number: f64, sample: SampleType) -> Self {
        let float = number as f32;
        match (sample.kind, sample.bits) {
            (SampleKind::Float, 17..) if number.abs() >= NO_HEIGHT => Self::Limit(number),
            (SampleKind::Float, ..=16) => Self::Number(f16::from_f64(number).to_f64()),
            (SampleKind::Float, 33..) if float.is_normal() => Self::Float(float),
            (SampleKind::Float, 17..=32) => Self::Number(f64::from(float)),
            _ => Self::Number(number),
        }
    }

    /// Whether a stored number marks a texel without a value.
    pub(crate) fn marks(self, stored: f64) -> bool {
        match self {
            Self::Number(number) => stored == number,
            Self::Float(float) => stored as f32 == float,
            Self::Limit(number) => stored.abs() >= NO_HEIGHT && stored.signum() == number.signum(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_match_their_stored_form() {
        let double = SampleType::float(64);
        for (declared, sample, stored, marks) in [
            (-9999.0, SampleType::float(32), -9999.0, true),
            (-9999.0, SampleType::float(32), -9998.0, false),
            (0.1, SampleType::float(32), f64::from(0.1f32), true),
            (-3.4e38, SampleType::float(32), f64::from(f32::MIN), true),
            (-3.4e38, SampleType::float(32), f64::from(f32::MAX), false),
            (-3.4e38, SampleType::float(32), -9999.0, false),
            (1.70141e38, double, 1.701_410_009_187_828e38, true),
            (-1.797e308, double, f64::MIN, true),
            (-9999.9, double, f64::from(-9999.9f32), true),
            (-9999.9, double, -9999.8, false),
            (1e-50, double, 0.0, false),
            (-9999.0, SampleType::float(16), -10000.0, true),
            (70000.0, SampleType::float(16), 65504.0, false),
            (255.0, SampleType::unsigned(8), 255.0, true),
            (-1.0, SampleType::unsigned(8), 255.0, false),
            (0.5, SampleType::unsigned(8), 0.0, false),
        ] {
            let marker = Marker::new(declared, sample);
            assert_eq!(marker.marks(stored), marks, "{declared} of {sample}, {stored} stored");
            assert!(!marker.marks(f64::NAN));
        }
    }
}
