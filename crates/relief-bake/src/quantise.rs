//! Fewer bits, on the safe side.

use relief::{HeightMap, HeightMapError};

use crate::Rounding;

/// The value that an unsigned normalised integer of so many bits gives back, for a value in `[0, 1]`; values outside are
/// cut off. With 0 bits the value itself.
///
/// The decoded value is `code / (2^bits - 1)` in `f32`, as a GPU decodes it; rounded down it is at most `value`, rounded
/// up at least.
pub fn unorm(value: f32, bits: u32, rounding: Rounding) -> f32 {
    if bits == 0 {
        return value;
    }
    let most = ((1u64 << bits) - 1) as f64;
    let exact = f64::from(value.clamp(0.0, 1.0)) * most;
    let decode = |code: f64| (code / most) as f32;
    let code = match rounding {
        Rounding::Nearest => exact.round(),
        // Decoding rounds too, so the neighbouring code is tried before it is trusted.
        Rounding::Down => (exact + 1.0).floor().min(most),
        Rounding::Up => (exact - 1.0).ceil().max(0.0),
    };
    let (code, step) = match rounding {
        Rounding::Nearest => return decode(code),
        Rounding::Down => (code, -1.0),
        Rounding::Up => (code, 1.0),
    };
    let mut code = code;
    while (step < 0.0 && code > 0.0 && decode(code) > value)
        || (step > 0.0 && code < most && decode(code) < value)
    {
        code += step;
    }
    decode(code)
}

/// The map whose texels are what integers of so many bits give back, to the nearest.
///
/// # Errors
///
/// None for a valid map; passed on from the map's constructor.
pub fn heights(map: &HeightMap, bits: u32) -> Result<HeightMap, HeightMapError> {
    let texels = map.texels().iter().map(|&texel| unorm(texel, bits, Rounding::Nearest)).collect();
    let decoded = HeightMap::new(map.width(), map.height(), texels, map.wrap())?;
    decoded.with_displacement(map.scale_m(), map.bias_m())
}

#[cfg(test)]
mod tests {
    use super::*;

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
