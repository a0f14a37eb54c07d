//! 16-bit floats (IEEE 754 binary16) with a choice of the side to round to.

use exr::prelude::f16;

/// The side to round to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Side {
    /// To the nearest, ties to the even one.
    Nearest,
    /// Toward minus infinity.
    Down,
    /// Toward plus infinity.
    Up,
}

/// The value that a 16-bit float gives back for a value stored in it. Rounded down it is at most the value, rounded up
/// at least: what is above 65504 becomes 65504 or infinity by the side. NaN stays NaN.
pub fn round(value: f32, side: Side) -> f32 {
    let nearest = f16::from_f32(value);
    let stored = nearest.to_f32();
    match side {
        Side::Down if stored > value => below(nearest).to_f32(),
        // The next value above is the negative of the next below the negative.
        Side::Up if stored < value => -below(-nearest).to_f32(),
        _ => stored,
    }
}

/// The next 16-bit float below a number that is not minus infinity.
fn below(value: f16) -> f16 {
    let bits = value.to_bits();
    match bits {
        // From both zeros to the least negative number.
        0 | 0x8000 => f16::from_bits(0x8001),
        // Positive numbers grow with their bits, negative ones fall.
        1..=0x7fff => f16::from_bits(bits - 1),
        _ => f16::from_bits(bits + 1),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_number_stays_and_what_lies_between_goes_to_its_side() {
        let numbers: Vec<f32> = (0..0x7c00u16)
            .flat_map(|bits| [bits, bits | 0x8000])
            .map(|bits| f16::from_bits(bits).to_f32())
            .collect();
        for &number in &numbers {
            for side in [Side::Nearest, Side::Down, Side::Up] {
                assert_eq!(round(number, side), number);
            }
        }
        let mut sorted = numbers;
        sorted.sort_by(f32::total_cmp);
        sorted.dedup();
        for pair in sorted.windows(2) {
            for part in [0.1, 0.5, 0.9] {
                let between = pair[0] + part * (pair[1] - pair[0]);
                assert_eq!(round(between, Side::Down), pair[0], "{between} down");
                assert_eq!(round(between, Side::Up), pair[1], "{between} up");
            }
        }
    }

    #[test]
    fn beyond_the_largest_numbers() {
        assert_eq!(round(1e6, Side::Down), 65504.0);
        assert_eq!(round(1e6, Side::Up), f32::INFINITY);
        assert_eq!(round(-1e6, Side::Up), -65504.0);
        assert_eq!(round(f32::INFINITY, Side::Down), f32::INFINITY);
        assert_eq!(round(1e-30, Side::Down), 0.0);
        assert!(round(1e-30, Side::Up) > 0.0);
        assert!(round(f32::NAN, Side::Down).is_nan());
    }
}
