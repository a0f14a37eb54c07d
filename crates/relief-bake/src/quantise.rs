//! Rounding to fewer bits, on the safe side.

use rayon::prelude::*;
use relief_core::{HeightMap, HeightMapError, Rounding};

/// Returns `value` as decoded from an unsigned normalised integer of `bits` bits, at most 32.
/// Values outside of `[0, 1]` are clamped, and NaN becomes 0. With 0 bits, `value` itself is
/// returned.
///
/// The decoded value is `code / (2^bits - 1)` in `f32`, as a GPU decodes it. Rounded down it is at
/// most `value`, rounded up at least.
#[inline]
pub fn unorm(value: f32, bits: u32, rounding: Rounding) -> f32 {
    if bits == 0 { value } else { Unorm::new(bits).value(value, rounding) }
}

/// Rounds every value as [`unorm`] does, in parallel. `[low, high]` are the values of the codes 0
/// and `2^bits - 1`: a value becomes `low + (high - low) * unorm((value - low) / (high - low))`,
/// all in `f32`.
pub fn to_nearest(values: &mut [f32], [low, high]: [f32; 2], bits: u32) {
    if bits == 0 {
        return;
    }
    let (unorm, span) = (Unorm::new(bits), high - low);
    values.par_chunks_mut(CHUNK).for_each(|values| {
        for value in values {
            *value = low + span * unorm.nearest((*value - low) / span);
        }
    });
}

/// Values that one task rounds: some ten microseconds of work.
const CHUNK: usize = 1 << 14;

/// Unsigned normalised integers of a number of bits.
#[derive(Clone, Copy)]
struct Unorm {
    /// The greatest code.
    most: f64,
}

impl Unorm {
    #[inline]
    fn new(bits: u32) -> Self {
        Self { most: ((1u64 << bits) - 1) as f64 }
    }

    #[inline]
    fn value(self, value: f32, rounding: Rounding) -> f32 {
        match rounding {
            Rounding::Nearest => self.nearest(value),
            Rounding::Down => {
                // The code below decodes to no more than the value, since rounding keeps the order.
                // The next code may do so, too.
                let code = self.scaled(value) as u32;
                let next = self.decode((f64::from(code) + 1.0).min(self.most));
                if next <= value { next } else { self.decode(f64::from(code)) }
            }
            Rounding::Up => {
                let scaled = self.scaled(value);
                let below = f64::from(scaled as u32);
                let code = if below < scaled { below + 1.0 } else { below };
                let before = self.decode((code - 1.0).max(0.0));
                if before >= value { before } else { self.decode(code) }
            }
        }
    }

    /// Rounds to the nearest; halves go up. The sum with a half is exact wherever it decides.
    #[inline]
    fn nearest(self, value: f32) -> f32 {
        self.decode(f64::from((self.scaled(value) + 0.5) as u32))
    }

    /// Returns the value in steps: exact for up to 29 bits.
    #[inline]
    fn scaled(self, value: f32) -> f64 {
        f64::from(value.clamp(0.0, 1.0)) * self.most
    }

    #[inline]
    fn decode(self, code: f64) -> f32 {
        (code / self.most) as f32
    }
}

/// Returns a copy of the map with texels rounded to the nearest integers of `bits` bits.
///
/// # Errors
///
/// Never fails for a valid map; errors of the map's constructor are passed on.
pub fn heights(map: &HeightMap, bits: u32) -> Result<HeightMap, HeightMapError> {
    heights_in_place(map.clone(), bits)
}

/// Rounds as [`heights`] does, but takes the map over instead of copying it.
///
/// # Errors
///
/// Fails as [`heights`] does.
pub fn heights_in_place(map: HeightMap, bits: u32) -> Result<HeightMap, HeightMapError> {
    let (width, height, wrap) = (map.width(), map.height(), map.wrap());
    let (scale_m, bias_m) = (map.scale_m(), map.bias_m());
    let mut texels = map.into_texels();
    to_nearest(&mut texels, [0.0, 1.0], bits);
    HeightMap::new(width, height, texels, wrap)?.with_displacement(scale_m, bias_m)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Definition: the nearest code, or the last one on the safe side.
    fn by_search(value: f32, bits: u32, rounding: Rounding) -> f32 {
        let most = ((1u64 << bits) - 1) as f64;
        let exact = f64::from(value.clamp(0.0, 1.0)) * most;
        let decode = |code: f64| (code / most) as f32;
        let (mut code, step) = match rounding {
            Rounding::Nearest => return decode(exact.round()),
            Rounding::Down => ((exact + 2.0).floor().min(most), -1.0),
            Rounding::Up => ((exact - 2.0).ceil().max(0.0), 1.0),
        };
        while (step < 0.0 && code > 0.0 && decode(code) > value)
            || (step > 0.0 && code < most && decode(code) < value)
        {
            code += step;
        }
        decode(code)
    }

    #[test]
    fn every_value_is_the_definitions() {
        let mut state = 1u32;
        for bits in 1..=24 {
            let most = (1u32 << bits) - 1;
            let check = |value: f32| {
                for rounding in [Rounding::Nearest, Rounding::Down, Rounding::Up] {
                    let (found, expected) = (unorm(value, bits, rounding), by_search(value, bits, rounding));
                    assert_eq!(found, expected, "{value:e}, {bits} bits, {rounding:?}");
                }
            };
            for value in [0.0, -0.0, 1.0, 0.5, -1.0, 2.0, f32::MIN_POSITIVE, f32::INFINITY, f32::NEG_INFINITY]
            {
                check(value);
            }
            for _ in 0..20_000 {
                state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                check((state >> 8) as f32 / (1 << 24) as f32);
                // At a code, half-way to the next one, and beside both.
                let code = f64::from((state >> 5) & most);
                for at in [code, code + 0.5] {
                    let at = (at / f64::from(most)) as f32;
                    for value in [at, at.next_up(), at.next_down()] {
                        check(value);
                    }
                }
            }
        }
        assert_eq!(unorm(f32::NAN, 8, Rounding::Nearest), 0.0);
        assert_eq!(unorm(0.3, 0, Rounding::Down), 0.3);
    }

    #[test]
    fn planes_are_rounded_as_single_values_are() {
        let values: Vec<f32> = (0..100_000).map(|k| k as f32 / 50_000.0 - 1.0).collect();
        for bits in [0, 8, 16] {
            let mut rounded = values.clone();
            to_nearest(&mut rounded, [-1.0, 1.0], bits);
            for (value, rounded) in values.iter().zip(rounded) {
                let part = unorm((value + 1.0) / 2.0, bits, Rounding::Nearest);
                let expected = if bits == 0 { *value } else { 2.0 * part - 1.0 };
                assert_eq!(rounded, expected);
            }
        }
    }

    #[test]
    fn rounding_keeps_its_side_and_loses_less_than_a_step() {
        for bits in [8, 16] {
            let step = 1.0 / ((1u32 << bits) - 1) as f32;
            for k in 0..100_000u32 {
                let value = k as f32 / 99_999.0;
                let (down, up) = (unorm(value, bits, Rounding::Down), unorm(value, bits, Rounding::Up));
                assert!(down <= value && value - down <= step * 1.01, "{bits} bits: {value} down to {down}");
                assert!(up >= value && up - value <= step * 1.01, "{bits} bits: {value} up to {up}");
                assert_eq!(unorm(down, bits, Rounding::Down), down);
                assert_eq!(unorm(up, bits, Rounding::Up), up);
            }
        }
    }
}
