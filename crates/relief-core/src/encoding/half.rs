//! 16-bit floats (IEEE 754 binary16) with a choice of rounding.

use half::f16;

use super::Rounding;

/// Value after storage as a 16-bit float. [`Rounding::Down`] returns at most `value`,
/// [`Rounding::Up`] at least `value`. Values above 65504 become 65504 or infinity, depending on the
/// rounding. NaN stays NaN.
pub fn round(value: f32, rounding: Rounding) -> f32 {
    rounded(value, rounding).to_f32()
}

/// Bits of the 16-bit float that [`round`] returns.
pub fn bits(value: f32, rounding: Rounding) -> u16 {
    rounded(value, rounding).to_bits()
}

/// Bits of the nearest 16-bit float that is 0 or normal, on the side that `rounding` allows. GPUs
/// may read subnormal numbers as 0.
pub fn normal_bits(value: f32, rounding: Rounding) -> u16 {
    let least = f16::MIN_POSITIVE;
    let stored = rounded(value, rounding);
    if stored.to_f32().abs() >= least.to_f32() || stored.is_nan() {
        return stored.to_bits();
    }
    match rounding {
        Rounding::Down if value < 0.0 => (-least).to_bits(),
        Rounding::Up if value > 0.0 => least.to_bits(),
        Rounding::Nearest if value.abs() > 0.5 * least.to_f32() => least.copysign(stored).to_bits(),
        _ => 0,
    }
}

/// Value of the bits of a 16-bit float.
#[inline]
pub fn value(bits: u16) -> f32 {
    f16::from_bits(bits).to_f32()
}

fn rounded(value: f32, rounding: Rounding) -> f16 {
    let nearest = f16::from_f32(value);
    let stored = nearest.to_f32();
    match rounding {
        Rounding::Down if stored > value => below(nearest),
        // Rounding up is rounding down of the negated number.
        Rounding::Up if stored < value => -below(-nearest),
        _ => nearest,
    }
}

/// Next 16-bit float below a number that is not minus infinity.
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
    use super::{value as decoded, *};

    #[test]
    fn every_number_stays_and_what_lies_between_goes_to_its_side() {
        let numbers: Vec<f32> = (0..0x7c00u16)
            .flat_map(|bits| [bits, bits | 0x8000])
            .map(|bits| f16::from_bits(bits).to_f32())
            .collect();
        for &number in &numbers {
            for side in [Rounding::Nearest, Rounding::Down, Rounding::Up] {
                assert_eq!(round(number, side), number);
            }
        }
        let mut sorted = numbers;
        sorted.sort_by(f32::total_cmp);
        sorted.dedup();
        for pair in sorted.windows(2) {
            for part in [0.1, 0.5, 0.9] {
                let between = pair[0] + part * (pair[1] - pair[0]);
                assert_eq!(round(between, Rounding::Down), pair[0], "{between} down");
                assert_eq!(round(between, Rounding::Up), pair[1], "{between} up");
            }
        }
    }

    #[test]
    fn numbers_without_subnormal_ones_keep_their_side() {
        let least = f16::MIN_POSITIVE.to_f32();
        for value in [0.0, 1e-9, 1e-5, 3e-5, 0.6 * least, 0.99 * least, least, 1.5 * least, 1.0] {
            for value in [value, -value] {
                let stored = |rounding| decoded(normal_bits(value, rounding));
                let (down, up) = (stored(Rounding::Down), stored(Rounding::Up));
                assert!(down <= value && value <= up && up - down <= least, "{value}: {down} to {up}");
                let near = stored(Rounding::Nearest);
                assert!((near - value).abs() <= 0.5 * least && (near == down || near == up));
                for bits in [down, up, near] {
                    assert!(bits == 0.0 || bits.abs() >= least, "{value}: {bits}");
                }
            }
        }
        assert!(decoded(normal_bits(f32::NAN, Rounding::Down)).is_nan());
        assert_eq!(normal_bits(1e6, Rounding::Down), f16::MAX.to_bits());
    }

    #[test]
    fn beyond_the_largest_numbers() {
        assert_eq!(round(1e6, Rounding::Down), 65504.0);
        assert_eq!(round(1e6, Rounding::Up), f32::INFINITY);
        assert_eq!(round(-1e6, Rounding::Up), -65504.0);
        assert_eq!(round(f32::INFINITY, Rounding::Down), f32::INFINITY);
        assert_eq!(round(1e-30, Rounding::Down), 0.0);
        assert!(round(1e-30, Rounding::Up) > 0.0);
        assert!(round(f32::NAN, Rounding::Down).is_nan());
    }
}
