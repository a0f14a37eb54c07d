//! Logarithms and powers of two by sums, products and a quotient of 64 bits: the same bits on every system,
//! and in less time than the system's own, which serve all numbers.

use std::f64::consts::{LN_2, LOG2_E, SQRT_2};

/// Bits of a number's digits, and the exponent of 1.
const DIGITS: u32 = 52;
const ONE: i64 = 1023;

/// Coefficients of `artanh(t) / t` by powers of `t²`, highest first: 1 / 17 to 1.
const ARTANH: [f64; 9] =
    [1.0 / 17.0, 1.0 / 15.0, 1.0 / 13.0, 1.0 / 11.0, 1.0 / 9.0, 1.0 / 7.0, 1.0 / 5.0, 1.0 / 3.0, 1.0];

/// Coefficients of `exp` by powers, highest first: 1 / 12! to 1.
const EXP: [f64; 13] = {
    let mut all = [1.0; 13];
    let mut power = 1;
    while power < all.len() {
        all[12 - power] = all[13 - power] / power as f64;
        power += 1;
    }
    all
};

/// Returns the logarithm to base 2 of a positive number, within 1e-15 of itself or of 1;
/// of 0 a number below -1000.
#[inline(always)]
pub fn log2(number: f64) -> f64 {
    let bits = number.to_bits();
    let exponent = (bits >> DIGITS) as i64 - ONE;
    let digits = f64::from_bits(bits & ((1 << DIGITS) - 1) | (ONE as u64) << DIGITS);
    let is_high = digits > SQRT_2;
    let digits = if is_high { 0.5 * digits } else { digits };
    let part = (digits - 1.0) / (digits + 1.0);
    let series = ARTANH.into_iter().fold(0.0, |sum, next| sum * (part * part) + next);
    (exponent + i64::from(is_high)) as f64 + 2.0 * LOG2_E * part * series
}

/// Returns two to a power up to 1000, within 1e-14 of itself; 0 for a power below -1000.
#[inline(always)]
pub fn exp2(power: f64) -> f64 {
    let nearest = (power + 0.5f64.copysign(power)) as i64;
    let part = (power - nearest as f64) * LN_2;
    let near = EXP.into_iter().fold(0.0, |sum, next| sum * part + next);
    let two = f64::from_bits(((nearest.clamp(-1000, 1000) + ONE) as u64) << DIGITS);
    if power < -1000.0 { 0.0 } else { near * two }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn logarithms_and_powers_are_the_systems() {
        for step in -20_000..20_000 {
            let power = f64::from(step) * 1e-3 + 1e-7;
            let number = power.exp2();
            assert!((exp2(power) / number - 1.0).abs() < 1e-14, "2 to {power}: {}", exp2(power));
            let wrong = (log2(number) - number.log2()).abs();
            assert!(wrong < 4e-15 * power.abs().max(1.0), "log2 of {number}: {}", log2(number));
        }
        assert_eq!((log2(1.0), exp2(0.0), exp2(-2200.0)), (0.0, 1.0, 0.0));
        assert!(log2(0.0) < -1000.0 && log2(f64::INFINITY) > 1000.0);
    }
}
