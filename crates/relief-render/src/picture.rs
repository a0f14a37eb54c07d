//! What a rendering is written as: a picture for the eye, and channels of numbers for everything else.

use crate::job::Rendering;

/// The names of the channels of [`aov`], in order.
pub const AOV_CHANNELS: [&str; 12] =
    ["hit", "uv.x", "uv.y", "height", "P.x", "P.y", "P.z", "N.x", "N.y", "N.z", "depth", "reads"];

/// The sRGB picture, RGB, 8 bits, over a background given in linear RGB.
pub fn srgb8(rendering: &Rendering, background: [f32; 3]) -> Vec<u8> {
    let background = background.map(srgb_byte);
    rendering
        .pixels
        .iter()
        .flat_map(|pixel| match pixel.hit {
            0 => background,
            _ => [pixel.color.x, pixel.color.y, pixel.color.z].map(srgb_byte),
        })
        .collect()
}

/// A linear value from 0 to 1 as an sRGB byte (IEC 61966-2-1); brighter values are cut off.
fn srgb_byte(linear: f32) -> u8 {
    let linear = linear.clamp(0.0, 1.0);
    let encoded = if linear <= 0.003_130_8 { 12.92 * linear } else { 1.055 * linear.powf(1.0 / 2.4) - 0.055 };
    (encoded * 255.0 + 0.5) as u8
}

/// The arbitrary output variables of a rendering: a plane of numbers for each of [`AOV_CHANNELS`].
///
/// `hit` is 1 or 0; `uv` is not wrapped; `height` is a texel value; `P` and `N` are in the world; `depth` is
/// in metres along the view axis. Pixels that no surface covers are 0 throughout.
pub fn aov(rendering: &Rendering) -> Vec<(&'static str, Vec<f32>)> {
    let plane = |place: usize| {
        rendering
            .pixels
            .iter()
            .map(|pixel| match place {
                _ if pixel.hit == 0 => 0.0,
                0 => 1.0,
                1 => pixel.uv.x,
                2 => pixel.uv.y,
                3 => pixel.height,
                4 => pixel.position.x,
                5 => pixel.position.y,
                6 => pixel.position.z,
                7 => pixel.normal.x,
                8 => pixel.normal.y,
                9 => pixel.normal.z,
                10 => pixel.depth,
                _ => pixel.reads as f32,
            })
            .collect()
    };
    AOV_CHANNELS.into_iter().enumerate().map(|(place, name)| (name, plane(place))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_srgb_curve_goes_through_its_fixed_points() {
        assert_eq!([0.0, 1.0, 2.0, -1.0].map(srgb_byte), [0, 255, 255, 0]);
        // Half the light is byte 188; a byte of 10 is on the linear part.
        assert_eq!(srgb_byte(0.5), 188);
        assert_eq!(srgb_byte(10.0 / 255.0 / 12.92), 10);
    }
}
