//! The bytes of linear numbers in sRGB, by the numbers where the next byte begins: the curve
//! itself has a power for each.

use std::sync::OnceLock;

use super::srgb;

/// Number of equal parts of the numbers from 0 to 1 that a first guess distinguishes: a power of two.
const PARTS: usize = 4096;

/// Where each byte begins.
pub(super) struct Levels {
    /// The least number of each byte; the last one is never reached.
    begin: [f32; 257],
    /// The byte of the least number of each part.
    of_part: [u8; PARTS + 1],
}

impl Levels {
    pub(super) fn get() -> &'static Self {
        static LEVELS: OnceLock<Levels> = OnceLock::new();
        LEVELS.get_or_init(Self::new)
    }

    fn new() -> Self {
        let mut begin = [f32::INFINITY; 257];
        for (level, begin) in begin.iter_mut().take(256).enumerate() {
            // The bits of numbers from 0 to 1 grow with them, and bytes never fall.
            let (mut below, mut above) = (0u32, 1f32.to_bits());
            while below < above {
                let middle = below + (above - below) / 2;
                match usize::from(by_curve(f32::from_bits(middle))) < level {
                    true => below = middle + 1,
                    false => above = middle,
                }
            }
            *begin = f32::from_bits(below);
        }
        Self { begin, of_part: std::array::from_fn(|part| by_curve(part as f32 / PARTS as f32)) }
    }

    /// Returns the byte of a number; numbers outside of 0 to 1 are clamped, and NaN is 0.
    #[inline]
    pub(super) fn of(&self, linear: f32) -> u8 {
        let linear = if linear > 0.0 { linear.min(1.0) } else { 0.0 };
        let mut byte = self.of_part[(linear * PARTS as f32) as usize];
        // A part holds few beginnings.
        while linear >= self.begin[usize::from(byte) + 1] {
            byte += 1;
        }
        byte
    }
}

/// The byte by the curve.
fn by_curve(linear: f32) -> u8 {
    let [encoded, ..] = srgb([linear; 3]);
    (f64::from(encoded) * 255.0).round() as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bytes_are_those_of_the_curve() {
        let levels = Levels::get();
        let near = levels.begin[1..256].iter().flat_map(|begin| {
            let bits = begin.to_bits();
            (bits - 2..=bits + 2).map(f32::from_bits)
        });
        let spread = (0..1_000_000).map(|step| step as f32 / 999_999.0);
        let parts = (0..=PARTS).map(|part| part as f32 / PARTS as f32);
        let others = [-1.0, -0.0, 1.5, f32::INFINITY, f32::NEG_INFINITY, f32::NAN, f32::MIN_POSITIVE];
        for linear in near.chain(spread).chain(parts).chain(others) {
            assert_eq!(levels.of(linear), by_curve(linear), "{linear}");
        }
    }
}
