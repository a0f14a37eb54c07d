//! Shadows beside the truth: the part of a light that arrives, as pictures show it.

use std::sync::Arc;

use glam::{DVec3, Vec2, Vec3};
use relief_core::HeightMap;
use relief_maps::Maps;
use relief_render::light::Light;
use relief_render::material::Material;
use relief_render::mesh::{Builtin, Mesh};
use relief_render::render;
use relief_render::scene::{BackendChoice, Scene, Surface, View};
use relief_shaders::Selection;

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
    /// How far the light is above the horizon of the plane, in degrees.
    pub elevation_deg: f64,
    /// How large its disc is, in degrees.
    pub diameter_deg: f64,
    /// Width and height of the picture.
    pub size: [u32; 2],
    /// What computes the picture.
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

    /// The colours of a white surface under that light alone, with a shadow and its settings.
    fn colors(&self, mesh: &Arc<Mesh>, shadow: &str, settings: &[(&str, f64)]) -> Vec<f32> {
        let [u, v] = mesh.tile_m();
        let depth = DEPTH * u.min(v);
        let map = self.map.clone().with_displacement(depth, -depth).expect("lengths");
        let mut selection = Selection::exact();
        selection.choose("shadow", shadow).expect("a shadow");
        for (key, value) in settings {
            selection.set(key, *value).expect("a setting");
        }
        let white = Material::new(Vec3::ONE, Vec3::ZERO, 1).expect("a material");
        let surface = Surface::new(Arc::clone(mesh), map).with_selection(selection).with_material(white);
        let (sin, cos) = self.elevation_deg.to_radians().sin_cos();
        let toward = DVec3::new(-0.8 * cos, sin, -0.6 * cos);
        let light =
            Light::directional(toward, Vec3::ONE).and_then(|light| light.with_diameter(self.diameter_deg));
        let scene = Scene::builder(surface).lights(vec![light.expect("a light")]).ambient(Vec3::ZERO);
        let view = if self.mesh == Builtin::Plane { View::Top } else { View::Corner };
        let scene = scene.fitted_camera(view, 30.0).background(Vec3::ZERO).samples(1);
        let scene = scene.size(self.size[0], self.size[1]).backend(self.backend).build().expect("a scene");
        let rendering = render(&scene, &mut Maps::in_memory(), &|_, _| {}).expect("a picture").rendering;
        rendering.pixels.iter().map(|pixel| pixel.color.x).collect()
    }

    /// The part of the light that arrives at each pixel that it would light without shadows, for each of the
    /// shadows with their settings.
    pub fn parts<const N: usize>(&self, shadows: [(&str, &[(&str, f64)]); N]) -> [Vec<f32>; N] {
        let mesh = Arc::new(self.mesh());
        let open = self.colors(&mesh, "none", &[]);
        shadows.map(|(shadow, settings)| {
            let shadowed = self.colors(&mesh, shadow, settings);
            let lit = open.iter().zip(shadowed).filter(|(open, _)| **open > LEAST_LIGHT);
            lit.map(|(open, shadowed)| shadowed / open).collect()
        })
    }

    /// The part of the light's disc that is seen, by rays to 256 of its points.
    pub fn truth(&self) -> Vec<f32> {
        let [parts] = self.parts([("soft", &[("shadow.samples", 256.0)])]);
        parts
    }
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
