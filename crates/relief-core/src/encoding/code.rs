//! Values stored as 8-bit codes. Shaders decode them to the same values on every machine.

use super::Rounding;

/// Codes 0 to 255 for the values of a range. Code `c` stands for `low + step * c`, computed in
/// `f32` with separate rounding of product and sum.
///
/// A GPU returns a code divided by 255, perhaps with a wrong last bit. A shader recovers the code
/// as `floor(255 v + 1/2)` and then computes the value in the same way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Codes {
    /// The value of code 0.
    pub low: f32,
    /// Difference between the values of consecutive codes.
    pub step: f32,
}

/// Greatest code.
const MOST: f32 = 255.0;

impl Codes {
    /// Creates the codes for a range of values. The value of code 255 is at or above the range's
    /// upper end.
    pub fn of_range([low, high]: [f32; 2]) -> Self {
        let mut step = (high - low) / MOST;
        while low + step * MOST < high {
            step = step.next_up();
        }
        Self { low, step }
    }

    /// The value of a code.
    #[inline]
    pub fn value(self, code: u8) -> f32 {
        self.low + self.step * f32::from(code)
    }

    /// Code with the value nearest to `value`, on the side that `rounding` allows. `None` if there
    /// is no such code, and for NaN.
    pub fn code(self, value: f32, rounding: Rounding) -> Option<u8> {
        if value.is_nan() {
            return None;
        }
        let at = if self.step > 0.0 { (value - self.low) / self.step } else { 0.0 };
        // Rounding can have moved it to a neighbouring code, never farther.
        let about = at.clamp(0.0, MOST) as u8;
        let mut near = about.saturating_sub(1)..=about.saturating_add(2);
        match rounding {
            Rounding::Down => near.rfind(|&code| self.value(code) <= value),
            Rounding::Up => near.find(|&code| self.value(code) >= value),
            Rounding::Nearest => {
                let apart = |code: &u8| (f64::from(self.value(*code)) - f64::from(value)).abs();
                let code = near.min_by(|a, b| apart(a).total_cmp(&apart(b)))?;
                (apart(&code) <= f64::from(self.step)).then_some(code)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_code_is_its_own_and_what_lies_between_goes_to_its_side() {
        for range in [[0.0, 1.0], [-1.0, 1.0], [0.0, 0.25], [0.0, 3.7], [-5e-3, 1e9], [2.0, 2.0]] {
            let codes = Codes::of_range(range);
            assert!(codes.value(255) >= range[1], "{range:?}");
            if codes.step == 0.0 {
                assert_eq!(codes.code(range[0], Rounding::Up), Some(0));
                continue;
            }
            for code in 0..=255 {
                let value = codes.value(code);
                for rounding in [Rounding::Nearest, Rounding::Down, Rounding::Up] {
                    assert_eq!(codes.code(value, rounding), Some(code), "{range:?} {code} {rounding:?}");
                }
                let (below, above) = (value.next_down(), value.next_up());
                assert_eq!(codes.code(below, Rounding::Up), Some(code));
                assert_eq!(codes.code(above, Rounding::Down), Some(code));
                assert_eq!(codes.code(below, Rounding::Down), code.checked_sub(1));
                assert_eq!(codes.code(above, Rounding::Up), code.checked_add(1));
            }
            for outside in [codes.value(0) - 2.0 * codes.step, codes.value(255) + 2.0 * codes.step] {
                assert_eq!(codes.code(outside, Rounding::Nearest), None, "{range:?} {outside}");
            }
            assert_eq!(codes.code(f32::NAN, Rounding::Nearest), None);
        }
    }

    #[test]
    fn a_code_survives_a_last_bit_of_the_gpus_division() {
        for code in 0..=255u8 {
            let exact = f32::from(code) / 255.0;
            for read in [exact.next_down(), exact, exact.next_up()] {
                assert_eq!((255.0 * read + 0.5).floor(), f32::from(code));
            }
        }
    }
}
