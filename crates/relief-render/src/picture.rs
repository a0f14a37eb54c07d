//! Conversion of renderings to pictures for the eye, and to channels of numbers (AOVs).

use std::sync::Arc;

use rayon::prelude::*;
use relief_io::linear_to_srgb;
use relief_shaders::cpu::{Frame, PixelOut, background_row};

use crate::job::Rendering;
use crate::prepare::view_of;
use relief_scene::Scene;
use relief_scene::environment::Environment;
use relief_scene::tone::Tone;

mod levels;

use levels::Levels;

/// Names of the channels of [`aov`], in order.
pub const AOV_CHANNELS: [&str; 19] = [
    "hit",
    "uv.x",
    "uv.y",
    "height",
    "P.x",
    "P.y",
    "P.z",
    "N.x",
    "N.y",
    "N.z",
    "depth",
    "reads",
    "steps",
    "bytes",
    "lit",
    "level",
    "z",
    "surface",
    "transmittance",
];

/// Least number of pixels of a row that a core takes.
const ROW_PART: usize = 256;

/// Conversion of linear light to the colours of a scene's picture, row by row.
///
/// Exposure and tone curve are applied to the light, which is then blended over the background by
/// the share of the pixel that it covers. Background colours are used as given, without exposure
/// and tone curve. An environment map behind the scene is light, and gets both.
#[derive(Clone, Debug)]
pub struct Display {
    size: [u32; 2],
    /// Factor on the light, from the exposure.
    gain: f32,
    tone: Tone,
    /// The frame's camera and background.
    frame: Frame,
    /// The environment map, if it is visible behind the scene.
    environment: Option<Arc<Environment>>,
}

impl Display {
    /// Creates the display of a scene's picture.
    pub fn of(scene: &Scene) -> Self {
        Self {
            size: scene.size(),
            gain: scene.exposure().exp2(),
            tone: scene.tone(),
            frame: view_of(scene),
            environment: scene.environment_behind(),
        }
    }

    /// Removes the tone curve, for files of linear light.
    #[must_use]
    pub fn without_tone(self) -> Self {
        Self { tone: Tone::None, ..self }
    }

    /// Returns the linear colours of a row of the picture, counted from the top.
    pub fn linear_row(&self, row: u32, pixels: &[PixelOut]) -> Vec<[f32; 3]> {
        let size = [pixels.len() as u32, self.size[1]];
        let environment = self.environment.as_ref().map(|environment| &**environment.map());
        let mut behind = background_row(self.frame, environment, row, size);
        behind.par_iter_mut().zip(pixels).with_min_len(ROW_PART).for_each(|(behind, pixel)| {
            if environment.is_some() {
                *behind = self.shown(*behind, 1.0);
            }
            let (color, covered) = (pixel.color, pixel.color.w);
            if covered > 0.0 {
                let light = self.shown([color.x, color.y, color.z], covered);
                let over = |light: f32, background: f32| light * covered + background * (1.0 - covered);
                *behind = [0, 1, 2].map(|place| over(light[place], behind[place]));
            }
        });
        behind
    }

    /// Applies exposure and tone curve to a pixel's light. `covered` is the share of the pixel that
    /// a surface covers.
    fn shown(&self, light: [f32; 3], covered: f32) -> [f32; 3] {
        let gain = self.gain / covered;
        self.tone.apply(light.map(|light| light * gain))
    }
}

/// Converts a linear colour to sRGB, each channel from 0 to 1 (IEC 61966-2-1). Values outside are
/// clamped.
pub fn srgb(linear: [f32; 3]) -> [f32; 3] {
    linear.map(|linear| linear_to_srgb(f64::from(linear.clamp(0.0, 1.0))) as f32)
}

/// Converts a linear colour to the bytes of sRGB, rounded to the nearest as in files of eight bits.
pub fn bytes_of(linear: [f32; 3]) -> [u8; 3] {
    linear.map(|part| Levels::get().of(part))
}

/// Returns the linear colours of a scene's picture, row by row from the top.
pub fn linear(rendering: &Rendering, scene: &Scene) -> Vec<[f32; 3]> {
    let (display, width) = (Display::of(scene), rendering.width.max(1) as usize);
    let rows = rendering.pixels.chunks(width).enumerate();
    rows.flat_map(|(row, pixels)| display.linear_row(row as u32, pixels)).collect()
}

/// Returns a scene's sRGB picture: 8-bit RGB, row by row from the top.
///
/// # Examples
///
/// ```
/// use relief_core::mesh::square;
/// use relief_scene::{Look, Scene, Surface};
/// use relief_render::{picture, render};
///
/// let heights = relief_core::HeightMap::new(1, 1, vec![1.0], relief_core::Wrap::Repeat)?;
/// let surface = Surface::new(square(2)?, heights.with_displacement(0.1, -0.1)?);
/// let scene = Scene::builder(surface).look(Look::Studio).size(64, 48).build()?;
/// let rendered = render(&scene, &mut relief_maps::Maps::in_memory(), &relief_core::Watch::none())?;
/// assert_eq!(picture::srgb8(&rendered.rendering, &scene).len(), 64 * 48 * 3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn srgb8(rendering: &Rendering, scene: &Scene) -> Vec<u8> {
    linear(rendering, scene).into_iter().flat_map(bytes_of).collect()
}

/// Returns the numbers of a pixel, one for each of [`AOV_CHANNELS`]. All but the last are 0 where its
/// centre shows no opaque surface.
pub fn aov_of(pixel: &PixelOut) -> [f32; AOV_CHANNELS.len()] {
    if pixel.hit == 0 {
        let mut nothing = [0.0; AOV_CHANNELS.len()];
        nothing[AOV_CHANNELS.len() - 1] = pixel.transmittance;
        return nothing;
    }
    let PixelOut { uv, height, position, normal, depth, reads, steps, bytes, lit, .. } = pixel;
    let PixelOut { level, z, surface, transmittance, .. } = pixel;
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
        *transmittance,
    ]
}

/// Returns the arbitrary output variables (AOVs) of a rendering: a plane of numbers for each of
/// [`AOV_CHANNELS`].
///
/// `hit` is 1 or 0; `uv` is not wrapped; `height` is a height from 0 to 1; `P` and `N` are position
/// in metres and normal, in world space; `depth` is in metres along the view axis; `reads`, `steps`
/// and `bytes` are the ray's [cost](relief_core::Cost); `lit` is the share of the first light that
/// arrives, from 0 to 1; `level` is the level of detail; `z` is the value in the scene's [depth
/// buffer](relief_scene::depth_buffer::DepthBuffer) ; `surface` is the surface's number in the
/// scene; `transmittance` is the share of light from behind that comes through the translucent
/// surfaces, 1 without any. All but that belongs to opaque surfaces, and is 0 where there is none.
pub fn aov(rendering: &Rendering) -> Vec<(&'static str, Vec<f32>)> {
    let plane = |place: usize| rendering.pixels.iter().map(|pixel| aov_of(pixel)[place]).collect();
    AOV_CHANNELS.into_iter().enumerate().map(|(place, name)| (name, plane(place))).collect()
}

#[cfg(test)]
mod tests {
    use glam::{DVec3, Vec3};
    use relief_core::{HeightMap, Wrap};
    use relief_io::Picture;

    use super::*;
    use crate::job::uncovered;
    use relief_core::camera::{Camera, Projection};
    use relief_core::mesh::square;
    use relief_scene::background::Background;
    use relief_scene::{SceneBuilder, Surface};

    /// Creates a scene that shows a level square before a background.
    fn scene(background: Background) -> SceneBuilder {
        let heights = HeightMap::new(1, 1, vec![1.0], Wrap::Repeat).expect("a map");
        let surface = Surface::new(square(1).expect("a mesh"), heights);
        Scene::builder(surface).background(background)
    }

    fn colour(parts: [f32; 3]) -> Background {
        Background::Color(parts.into())
    }

    #[test]
    fn the_srgb_curve_goes_through_its_fixed_points() {
        let pixels = [0.0, 1.0, 2.0, -1.0, 0.5, 10.0 / 255.0 / 12.92];
        let pixels = pixels.map(|part| PixelOut { color: [part, part, part, 1.0].into(), ..uncovered() });
        let picture = Rendering { width: 6, height: 1, pixels: pixels.to_vec() };
        let scene = scene(colour([0.0; 3])).size(6, 1).build().expect("a scene");
        // Half the light is byte 188; a byte of 10 is on the linear part.
        let expected = [0, 255, 255, 0, 188, 10].map(|byte| [byte; 3]);
        assert_eq!(srgb8(&picture, &scene), expected.as_flattened());
    }

    #[test]
    fn light_is_brightened_and_toned_before_it_is_laid_over_the_background() {
        let background = [0.5, 0.25, 1.0];
        let shown = |exposure, tone, light: f32, covered: f32| {
            let scene = scene(colour(background)).exposure(exposure).tone(tone).size(1, 1);
            let part = light * covered;
            let pixel = PixelOut { color: [part, part, part, covered].into(), ..uncovered() };
            Display::of(&scene.build().expect("a scene")).linear_row(0, &[pixel])[0]
        };
        let none = Tone::None;
        for exposure in [-2.0, 0.0, 5.0] {
            assert_eq!(shown(exposure, Tone::Agx, 0.0, 0.0), background);
        }
        assert_eq!(shown(0.0, none, 0.25, 1.0), [0.25; 3]);
        assert_eq!(shown(2.0, none, 0.25, 1.0), [1.0; 3]);
        assert_eq!(shown(1.0, none, 0.25, 0.5), [0.5, 0.375, 0.75]);
        // Toned after the mean of samples, and before the background.
        let toned = Tone::Agx.apply([4.0; 3]);
        let expected = [0, 1, 2].map(|at| 0.5 * toned[at] + 0.5 * background[at]);
        assert_eq!(shown(2.0, Tone::Agx, 1.0, 0.5), expected);
    }

    #[test]
    fn a_gradient_goes_from_the_upper_edge_to_the_lower() {
        let [above, below] = [Vec3::new(0.2, 0.4, 0.8), Vec3::new(0.6, 0.4, 0.0)];
        let scene = scene(Background::Gradient([above, below])).size(2, 4).tone(Tone::Agx).exposure(3.0);
        let display = Display::of(&scene.build().expect("a scene"));
        for row in 0..4 {
            let expected = above.lerp(below, (row as f32 + 0.5) / 4.0);
            for shown in display.linear_row(row, &[uncovered(); 2]) {
                assert!((Vec3::from(shown) - expected).abs().max_element() < 1e-6, "{row}: {shown:?}");
            }
        }
    }

    #[test]
    fn surroundings_are_seen_where_the_camera_looks() {
        // White above the horizon, and black below: the camera stands upright and looks along it.
        let texel = |at: u32| if at < 128 * 32 { [1.0; 4] } else { [0.0, 0.0, 0.0, 1.0] };
        let sky = Picture { width: 128, height: 64, texels: (0..128 * 64).map(texel).collect() };
        let projection = Projection::Perspective { fov_degrees: 60.0 };
        let camera = Camera::with(DVec3::new(0.0, 0.0, 5.0), DVec3::ZERO, projection).expect("a camera");
        let scene = scene(Background::Environment)
            .environment(Environment::from_equirectangular(&sky).expect("surroundings"))
            .camera(camera)
            .size(8, 8)
            .build()
            .expect("surroundings that are seen behind the scene");
        let display = Display::of(&scene);
        let rows: Vec<f32> = (0..8).map(|row| display.linear_row(row, &[uncovered(); 8])[3][0]).collect();
        assert!(rows[..3].iter().all(|light| *light > 0.95), "{rows:?}");
        assert!(rows[5..].iter().all(|light| *light < 0.05), "{rows:?}");
    }
}
