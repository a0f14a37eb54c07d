//! What a rendering is written as: a picture for the eye, and channels of numbers for everything else.

use relief_io::linear_to_srgb;
use relief_shaders::cpu::PixelOut;

use crate::job::Rendering;
use crate::tone::Tone;

/// The names of the channels of [`aov`], in order.
pub const AOV_CHANNELS: [&str; 18] = [
    "hit", "uv.x", "uv.y", "height", "P.x", "P.y", "P.z", "N.x", "N.y", "N.z", "depth", "reads", "steps",
    "bytes", "lit", "level", "z", "surface",
];

/// How linear light becomes the colours of a picture.
///
/// Light is brightened, goes through the tone curve, and is laid over the background, as much of it as covers
/// the pixel. The background is as it is given: neither brightened nor toned.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Look {
    /// Linear red, green and blue of what shows no surface.
    pub background: [f32; 3],
    /// Stops by which light is brightened: each doubles it.
    pub exposure: f32,
    /// The tone curve.
    pub tone: Tone,
}

impl Look {
    /// The linear colour of a pixel.
    pub fn linear(&self, pixel: &PixelOut) -> [f32; 3] {
        let (color, covered) = (pixel.color, pixel.color.w);
        if covered == 0.0 {
            return self.background;
        }
        let gain = self.exposure.exp2() / covered;
        let light = self.tone.apply([color.x, color.y, color.z].map(|light| light * gain));
        let over = |light: f32, background: f32| light * covered + background * (1.0 - covered);
        [0, 1, 2].map(|place| over(light[place], self.background[place]))
    }

    /// The sRGB colour of a pixel, each part from 0 to 1 (IEC 61966-2-1); brighter ones are cut off.
    pub fn srgb(&self, pixel: &PixelOut) -> [f32; 3] {
        srgb(self.linear(pixel))
    }
}

/// The sRGB colour of a linear one, each part from 0 to 1 (IEC 61966-2-1); brighter ones are cut off.
pub fn srgb(linear: [f32; 3]) -> [f32; 3] {
    linear.map(|linear| linear_to_srgb(f64::from(linear.clamp(0.0, 1.0))) as f32)
}

/// The sRGB picture, RGB, 8 bits.
pub fn srgb8(rendering: &Rendering, look: &Look) -> Vec<u8> {
    let byte = |part: f32| (part * 255.0 + 0.5) as u8;
    rendering.pixels.iter().flat_map(|pixel| look.srgb(pixel).map(byte)).collect()
}

/// The numbers of a pixel, one for each of [`AOV_CHANNELS`]; zeros where its centre shows no surface.
pub fn aov_of(pixel: &PixelOut) -> [f32; AOV_CHANNELS.len()] {
    if pixel.hit == 0 {
        return [0.0; AOV_CHANNELS.len()];
    }
    let PixelOut { uv, height, position, normal, depth, reads, steps, bytes, lit, level, z, surface, .. } =
        pixel;
    [
        1.0,
        uv.x,
        uv.y,
        *height,
        position.x,
        position.y,
        position.z,
        normal.x,
        normal.y,
        normal.z,
        *depth,
        *reads as f32,
        *steps as f32,
        *bytes as f32,
        *lit,
        *level as f32,
        *z,
        *surface as f32,
    ]
}

/// The arbitrary output variables of a rendering: a plane of numbers for each of [`AOV_CHANNELS`].
///
/// `hit` is 1 or 0; `uv` is not wrapped; `height` is a texel value; `P` and `N` are in the world; `depth` is
/// in metres along the view axis; `reads`, `steps` and `bytes` are what the ray [cost](relief_core::Cost);
/// `lit` is the part of the first light that arrives; `level` is the level of detail; `z` is what the scene's
/// [depth buffer](crate::depth_buffer::DepthBuffer) holds; `surface` is the surface's number in the scene.
/// Pixels that no surface covers are 0 throughout.
pub fn aov(rendering: &Rendering) -> Vec<(&'static str, Vec<f32>)> {
    let plane = |place: usize| rendering.pixels.iter().map(|pixel| aov_of(pixel)[place]).collect();
    AOV_CHANNELS.into_iter().enumerate().map(|(place, name)| (name, plane(place))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::job::uncovered;

    #[test]
    fn the_srgb_curve_goes_through_its_fixed_points() {
        let pixels = [0.0, 1.0, 2.0, -1.0, 0.5, 10.0 / 255.0 / 12.92];
        let pixels = pixels.map(|part| PixelOut { color: [part, part, part, 1.0].into(), ..uncovered() });
        let picture = Rendering { width: 6, height: 1, pixels: pixels.to_vec() };
        let look = Look { background: [0.0; 3], exposure: 0.0, tone: Tone::None };
        // Half the light is byte 188; a byte of 10 is on the linear part.
        let expected = [0, 255, 255, 0, 188, 10].map(|byte| [byte; 3]);
        assert_eq!(srgb8(&picture, &look), expected.as_flattened());
    }

    #[test]
    fn light_is_brightened_and_toned_before_it_is_laid_over_the_background() {
        let look = |exposure, tone| Look { background: [0.5, 0.25, 1.0], exposure, tone };
        let pixel = |light: f32, covered: f32| {
            let part = light * covered;
            PixelOut { color: [part, part, part, covered].into(), ..uncovered() }
        };
        let none = Tone::None;
        for exposure in [-2.0, 0.0, 5.0] {
            assert_eq!(look(exposure, Tone::Agx).linear(&pixel(0.0, 0.0)), [0.5, 0.25, 1.0]);
        }
        assert_eq!(look(0.0, none).linear(&pixel(0.25, 1.0)), [0.25; 3]);
        assert_eq!(look(2.0, none).linear(&pixel(0.25, 1.0)), [1.0; 3]);
        assert_eq!(look(1.0, none).linear(&pixel(0.25, 0.5)), [0.5, 0.375, 0.75]);
        // Toned after the mean of samples, and before the background.
        let toned = Tone::Agx.apply([4.0; 3]);
        let expected = [0, 1, 2].map(|at| 0.5 * toned[at] + 0.5 * [0.5, 0.25, 1.0][at]);
        assert_eq!(look(2.0, Tone::Agx).linear(&pixel(1.0, 0.5)), expected);
    }
}
