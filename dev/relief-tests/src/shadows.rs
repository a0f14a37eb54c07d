//! Shadows beside the truth: the part of a light that arrives, as pictures show it.

use std::f64::consts::TAU;

use glam::{DVec3, Vec2, Vec3};
use relief_core::mesh::{Builtin, Mesh};
use relief_core::{HeightMap, Watch};
use relief_maps::Maps;
use relief_render::{Renderer, render};
use relief_scene::light::Light;
use relief_scene::material::Material;
use relief_scene::{BackendChoice, Scene, Surface, View};
use relief_shaders::Selection;
use relief_shaders::cpu::PixelOut;

/// The relief's depth as a part of a tile.
pub const DEPTH: f64 = 0.1;

/// Less light than this, as it would arrive without shadows, is no use for comparing.
const LEAST_LIGHT: f32 = 0.02;

/// A map on a mesh under a light.
#[derive(Clone, Copy, Debug)]
pub struct Lit<'a> {
    /// The heights.
    pub map: &'a HeightMap,
    /// The mesh; where it is curved, with several tiles.
    pub mesh: Builtin,
    /// Elevation of the light above the plane's horizon, in degrees.
    pub elevation_deg: f64,
    /// Diameter of the light's disc, in degrees.
    pub diameter_deg: f64,
    /// Width and height of the picture.
    pub size: [u32; 2],
    /// Backend of the picture.
    pub backend: BackendChoice,
}

impl Lit<'_> {
    fn mesh(&self) -> Mesh {
        let tiles = match self.mesh {
            Builtin::Plane => Vec2::ONE,
            _ => Vec2::new(6.0, 3.0),
        };
        let mesh = self.mesh.build(self.map.proportions()).expect("a built-in mesh");
        mesh.tiled(tiles).expect("a few tiles")
    }

    fn surface(&self, shadow: &str, settings: &[(&str, f64)]) -> Surface {
        let mesh = self.mesh();
        let [u, v] = mesh.tile_m();
        let depth = DEPTH * u.min(v);
        let map = self.map.clone().with_displacement(depth, -depth).expect("lengths");
        let mut selection = Selection::exact();
        selection.choose("shadow", shadow).expect("a shadow");
        for (key, value) in settings {
            selection.set(key, *value).expect("a setting");
        }
        Surface::new(mesh, map).with_selection(selection)
    }

    /// The direction toward the light's centre.
    fn toward(&self) -> DVec3 {
        let (sin, cos) = self.elevation_deg.to_radians().sin_cos();
        DVec3::new(-0.8 * cos, sin, -0.6 * cos)
    }

    fn scene(&self, surface: Surface, toward: DVec3) -> Scene {
        let light =
            Light::directional(toward, Vec3::ONE).and_then(|light| light.with_diameter(self.diameter_deg));
        let view = if self.mesh == Builtin::Plane { View::Top } else { View::Corner };
        under_one_light(surface, light.expect("a light"), view, self.size, self.backend)
    }

    /// The colours of a white surface under that light alone, with a shadow and its settings.
    fn colors(&self, shadow: &str, settings: &[(&str, f64)]) -> Vec<f32> {
        let scene = self.scene(self.surface(shadow, settings), self.toward());
        pixels(&scene).iter().map(|pixel| pixel.color.x).collect()
    }

    /// The part of the light that arrives at each pixel that it would light without shadows, for each of the
    /// shadows with their settings.
    pub fn parts<const N: usize>(&self, shadows: [(&str, &[(&str, f64)]); N]) -> [Vec<f32>; N] {
        let open = self.colors("none", &[]);
        shadows.map(|(shadow, settings)| {
            let shadowed = self.colors(shadow, settings);
            let lit = open.iter().zip(shadowed).filter(|(open, _)| **open > LEAST_LIGHT);
            lit.map(|(open, shadowed)| shadowed / open).collect()
        })
    }

    /// The part of the light's disc that is seen: a picture with hard shadows for each of 256 of its points,
    /// 16 sectors of 16 rings of the same area. None of it is what soft shadows are made with.
    pub fn truth(&self) -> Vec<f32> {
        const RINGS: u32 = 16;
        const SECTORS: u32 = 16;
        let (toward, radius) = (self.toward(), (0.5 * self.diameter_deg).to_radians().tan());
        let (right, up) = toward.any_orthonormal_pair();
        let open = self.colors("none", &[]);
        let mut sums = vec![0u32; open.len()];
        let (mut renderer, mut maps) = (Renderer::on_cpu(), Maps::in_memory());
        let scene = self.scene(self.surface("ray", &[]), toward);
        for ring in 0..RINGS {
            for sector in 0..SECTORS {
                let far = radius * ((f64::from(ring) + 0.5) / f64::from(RINGS)).sqrt();
                // Each ring is turned by a part of a sector.
                let turn = f64::from(sector) + (f64::from(ring) + 0.5) / f64::from(RINGS);
                let (sin, cos) = (turn / f64::from(SECTORS) * TAU).sin_cos();
                let light = Light::directional(toward + (right * cos + up * sin) * far, Vec3::ONE);
                let scene =
                    scene.to_builder().lights(vec![light.expect("a light")]).build().expect("a scene");
                let rendered = renderer.render(&scene, &mut maps, &Watch::none()).expect("a picture");
                for (sum, pixel) in sums.iter_mut().zip(&rendered.rendering.pixels) {
                    *sum += u32::from(pixel.lit > 0.5);
                }
            }
        }
        let lit = open.iter().zip(sums).filter(|(open, _)| **open > LEAST_LIGHT);
        lit.map(|(_, sum)| sum as f32 / (RINGS * SECTORS) as f32).collect()
    }
}

/// A white surface under one light, and nothing else that gives light.
pub fn under_one_light(
    surface: Surface,
    light: Light,
    view: View,
    size: [u32; 2],
    backend: BackendChoice,
) -> Scene {
    let white = Material::new(Vec3::ONE, Vec3::ZERO, 1).expect("a material");
    let scene = Scene::builder(surface.with_material(white)).lights(vec![light]).ambient(Vec3::ZERO);
    let scene = scene.fitted_camera(view, 30.0).background(Vec3::ZERO).samples(1);
    scene.size(size[0], size[1]).backend(backend).build().expect("a scene")
}

/// The pixels of a scene.
pub fn pixels(scene: &Scene) -> Vec<PixelOut> {
    render(scene, &mut Maps::in_memory(), &Watch::none()).expect("a picture").rendering.pixels
}

/// The share of pixels on which one says lit and the other dark.
pub fn wrong(parts: &[f32], truth: &[f32]) -> f64 {
    let wrong = parts.iter().zip(truth).filter(|(a, b)| (**a > 0.5) != (**b > 0.5)).count();
    wrong as f64 / parts.len() as f64
}

/// The mean of the differences' absolute values.
pub fn mean_error(parts: &[f32], truth: &[f32]) -> f64 {
    let sum: f64 = parts.iter().zip(truth).map(|(a, b)| f64::from((a - b).abs())).sum();
    sum / parts.len() as f64
}

/// The mean of the differences' squares.
pub fn squared_error(parts: &[f32], truth: &[f32]) -> f64 {
    let sum: f64 = parts.iter().zip(truth).map(|(a, b)| f64::from((a - b) * (a - b))).sum();
    sum / parts.len() as f64
}
