//! Level of detail beside many samples: maps seen so small that several texels lie in a pixel.

use std::sync::Arc;

use glam::{DVec3, Vec2};
use relief_core::camera::{Camera, Projection};
use relief_core::mesh::Builtin;
use relief_core::{HeightMap, Watch};
use relief_maps::Maps;
use relief_render::render;
use relief_scene::light::Light;
use relief_scene::{BackendChoice, Scene, Surface};
use relief_shaders::Selection;
use relief_shaders::cpu::PixelOut;

/// Tiles of the plane along each axis.
const TILES: f32 = 6.0;

/// The relief's depth as a part of a tile.
const DEPTH: f64 = 0.1;

/// Samples of the truth.
const MANY: u32 = 256;

/// How far the second frame is moved to the right, in pixels.
const STEP: f64 = 0.1;

/// A map on a plane, seen from an angle so that a pixel is some texels wide.
pub struct Seen<'a> {
    /// The map.
    pub map: &'a HeightMap,
    /// The method.
    pub method: &'a str,
    /// The shadow.
    pub shadow: &'a str,
    /// Texels beside each other in a pixel.
    pub texels: f64,
    /// Degrees between the direction of view and the plane's normal.
    pub tilt_deg: f64,
    /// Columns and rows of the picture.
    pub side: u32,
}

/// Results of one detail, beside many samples in the finest level.
#[derive(Clone, Copy, Debug)]
pub struct Shown {
    /// Root of the mean squared error of the linear colour.
    pub error: f64,
    /// Difference between two frames a tenth of a pixel apart, less the truth's difference.
    pub flicker: f64,
    /// Mean brightness, as a multiple of the truth's.
    pub brightness: f64,
    /// Mean reads of a pixel.
    pub reads: f64,
}

impl Seen<'_> {
    /// Results of each of these details.
    ///
    /// # Panics
    ///
    /// When a name is unknown, or no picture can be made.
    pub fn shown<const N: usize>(&self, details: [&str; N]) -> [Shown; N] {
        let truth = [0.0, STEP].map(|step| self.pixels("none", MANY, step));
        let still = difference(&truth[0], &truth[1]);
        details.map(|detail| {
            let frames = [0.0, STEP].map(|step| self.pixels(detail, 1, step));
            let reads: u64 = frames[0].iter().map(|pixel| u64::from(pixel.reads)).sum();
            Shown {
                error: difference(&frames[0], &truth[0]),
                flicker: difference(&frames[0], &frames[1]) - still,
                brightness: brightness(&frames[0]) / brightness(&truth[0]),
                reads: reads as f64 / frames[0].len() as f64,
            }
        })
    }

    /// The depth of the relief in pixels.
    pub fn depth(&self) -> f64 {
        DEPTH * f64::from(self.map.width()) / self.texels
    }

    /// Returns the selection, in that detail.
    ///
    /// # Panics
    ///
    /// When a name is unknown.
    pub fn selection(&self, detail: &str) -> Selection {
        let mut selection = Selection::method(self.method).expect("a method");
        for (stage, name) in [("shadow", self.shadow), ("detail", detail)] {
            selection.choose(stage, name).expect("a listed name");
        }
        selection
    }

    fn pixels(&self, detail: &str, samples: u32, step: f64) -> Vec<PixelOut> {
        self.pixels_of(self.selection(detail), [1.0, -1.0], samples, step)
    }

    /// Picture with that selection, moved by a number of pixels. The distance between the heights 1 and 0,
    /// and the height of 0 above the plane, are in depths of the relief.
    ///
    /// # Panics
    ///
    /// When no picture can be made.
    pub fn pixels_of(
        &self,
        selection: Selection,
        [scale, bias]: [f64; 2],
        samples: u32,
        step: f64,
    ) -> Vec<PixelOut> {
        let mesh = Builtin::Square.build([1.0, 1.0]).and_then(|mesh| mesh.tiled(Vec2::splat(TILES)));
        let mesh = mesh.expect("a few tiles");
        let tile_m = mesh.tile_m()[0];
        let [scale_m, bias_m] = [scale, bias].map(|part| part * DEPTH * tile_m);
        let map = self.map.clone().with_displacement(scale_m, bias_m).expect("lengths");
        let pixel_m = self.texels * tile_m / f64::from(map.width());
        let (sin, cos) = self.tilt_deg.to_radians().sin_cos();
        let back = DVec3::new(0.6 * sin, cos, 0.8 * sin);
        let projection = Projection::Orthographic { height_m: pixel_m * f64::from(self.side) };
        let camera = Camera::with(back * 4.0, DVec3::ZERO, projection).expect("a camera");
        let aside = camera.right() * (step * pixel_m);
        let camera = camera.moved(camera.eye() + aside, camera.target() + aside).expect("a camera");
        let light = Light::directional(DVec3::new(-0.6, 0.6, -0.1), glam::Vec3::ONE).expect("a light");
        let scene = Scene::builder(Surface::new(Arc::new(mesh), map).with_selection(selection));
        let scene = scene.camera(camera).lights(vec![light]).samples(samples).size(self.side, self.side);
        let scene = scene.backend(BackendChoice::Cpu).build().expect("a scene");
        render(&scene, &mut Maps::in_memory(), &Watch::none()).expect("a picture").rendering.pixels
    }
}

fn colors(pixel: &PixelOut) -> [f64; 3] {
    [pixel.color.x, pixel.color.y, pixel.color.z].map(f64::from)
}

fn difference(a: &[PixelOut], b: &[PixelOut]) -> f64 {
    let squared = |(a, b): (&PixelOut, &PixelOut)| {
        let parts = colors(a).into_iter().zip(colors(b)).map(|(a, b)| (a - b) * (a - b));
        parts.sum::<f64>()
    };
    (a.iter().zip(b).map(squared).sum::<f64>() / (3 * a.len()) as f64).sqrt()
}

fn brightness(pixels: &[PixelOut]) -> f64 {
    pixels.iter().flat_map(colors).sum()
}
