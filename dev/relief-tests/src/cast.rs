//! Shadows that surfaces throw on each other, and the lines in which they meet, beside exact judges.

use std::sync::Arc;

use glam::{DVec3, Vec2};
use rayon::prelude::*;
use relief_core::camera::{Camera, Ray};
use relief_core::exact::{DisplacedMesh, Sides};
use relief_core::mesh::{Mesh, Placement, rectangle, torus};
use relief_core::{HeightMap, Watch, Wrap};
use relief_maps::Maps;
use relief_render::render;
use relief_scene::light::Light;
use relief_scene::{BackendChoice, Scene, Surface};
use relief_shaders::Selection;

use relief_testing::maps;
use relief_testing::outline::Mask;

/// Metres between a point and where a ray to it ends: less than counts, and more than rounding.
const ON_SURFACE_M: f64 = 1e-6;

/// A torus that is half sunk into a ground, both under the same relief.
#[derive(Clone, Debug)]
pub struct Meeting {
    map: Arc<HeightMap>,
    meshes: Vec<Arc<Mesh>>,
    judges: Vec<DisplacedMesh>,
    camera: Camera,
}

/// Facts about a pixel: the surface that it shows, and whether the light arrives there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shown {
    /// The surface's number.
    pub surface: u32,
    /// Whether it is lit.
    pub lit: bool,
}

impl Meeting {
    /// The scene.
    ///
    /// # Panics
    ///
    /// Never: all of it is possible.
    pub fn new() -> Self {
        let map = maps::ALL[2].build(Wrap::Repeat).with_displacement(0.03, -0.01).expect("lengths");
        let ground = rectangle([2.4, 2.4], 1).and_then(|mesh| mesh.tiled(Vec2::splat(8.0))).expect("a mesh");
        let placement = Placement {
            position_m: DVec3::new(0.05, 0.2, 0.0),
            rotation_degrees: DVec3::new(70.0, 0.0, 15.0),
            ..Placement::default()
        };
        let ring = torus(48, 24).and_then(|mesh| mesh.tiled(Vec2::new(8.0, 3.0)));
        let ring = ring.and_then(|mesh| mesh.placed(&placement)).expect("a mesh");
        let meshes = [ground, ring];
        let judge = |mesh: &Mesh| DisplacedMesh::new(mesh, &map, map.scale_m(), map.bias_m());
        let judges = meshes.iter().map(|mesh| judge(mesh).expect("a few tiles")).collect();
        let camera = Camera::new(DVec3::new(0.9, 1.3, 1.7), DVec3::new(0.0, 0.1, 0.0), 40.0);
        Self {
            map: Arc::new(map.clone()),
            meshes: meshes.map(Arc::new).into(),
            judges,
            camera: camera.expect("a camera"),
        }
    }

    /// A light far away, and one at a point beside the ring.
    ///
    /// # Panics
    ///
    /// Never.
    pub fn lights() -> [Light; 2] {
        let white = glam::Vec3::ONE;
        [
            Light::directional(DVec3::new(-0.5, 0.9, 0.25), white).expect("a light"),
            Light::point(DVec3::new(-0.75, 0.9, 0.5), white).expect("a light"),
        ]
    }

    /// Contents of a picture with a shadow, under a light.
    ///
    /// # Panics
    ///
    /// When no picture can be made.
    pub fn rendered(
        &self,
        shadow: &str,
        settings: &[(&str, f64)],
        light: Light,
        size: [u32; 2],
        backend: BackendChoice,
    ) -> Vec<Option<Shown>> {
        let mut selection = Selection::exact();
        for (key, name) in [("surface", "prism"), ("detail", "none"), ("shadow", shadow)] {
            selection.choose(key, name).expect("a listed name");
        }
        for (key, value) in settings {
            selection.set(key, *value).expect("a setting");
        }
        let surfaces = self
            .meshes
            .iter()
            .map(|mesh| Surface::new(Arc::clone(mesh), Arc::clone(&self.map)).with_selection(selection));
        let surfaces: Vec<Surface> = surfaces.collect();
        let builder = Scene::builder(surfaces[0].clone()).surfaces(surfaces);
        let builder = builder.camera(self.camera).lights(vec![light]).samples(1);
        let scene = builder.size(size[0], size[1]).backend(backend).build().expect("a scene");
        let picture = render(&scene, &mut Maps::in_memory(), &Watch::none()).expect("a picture").rendering;
        let shown = |pixel: &relief_shaders::cpu::PixelOut| {
            (pixel.hit == 1).then_some(Shown { surface: pixel.surface, lit: pixel.lit > 0.5 })
        };
        picture.pixels.iter().map(shown).collect()
    }

    /// Picture that the judges see, under a light.
    pub fn judged(&self, light: Light, size: [u32; 2]) -> Vec<Option<Shown>> {
        let [columns, rows] = size;
        let pixel = |pixel: u32| {
            let ray = self.camera.ray(pixel % columns, pixel / columns, columns, rows);
            let (surface, t) = self.first(&ray)?;
            let point = ray.at(t);
            let from = match light {
                Light::Directional { toward, .. } => point + toward * 10.0,
                Light::Point { position_m, .. } => position_m,
            };
            let way = (point - from).length();
            let to_point = Ray { origin: from, direction: (point - from) / way };
            let lit = self.first(&to_point).is_none_or(|(_, t)| t > way - ON_SURFACE_M);
            Some(Shown { surface, lit })
        };
        (0..columns * rows).into_par_iter().map(pixel).collect()
    }

    /// The nearest hit: its surface, and where it is on the ray.
    fn first(&self, ray: &Ray) -> Option<(u32, f64)> {
        let hit = |judge: &DisplacedMesh| {
            judge.first_hit(ray.origin.to_array(), ray.direction.to_array(), Sides::Front)
        };
        let hits = (0..).zip(&self.judges).filter_map(|(number, judge)| Some((number, hit(judge)?.t)));
        hits.min_by(|a, b| a.1.total_cmp(&b.1))
    }
}

impl Default for Meeting {
    fn default() -> Self {
        Self::new()
    }
}

/// Pixels for which a condition holds.
pub fn mask(shown: &[Option<Shown>], size: [u32; 2], holds: impl Fn(Shown) -> bool) -> Mask {
    Mask::new(size, shown.iter().map(|shown| shown.is_some_and(&holds)).collect())
}

/// Part of the pixels that agree on light, among pixels in which both show the same surface.
pub fn agreement(a: &[Option<Shown>], b: &[Option<Shown>]) -> f64 {
    let both = a.iter().zip(b).filter_map(|(a, b)| a.zip(*b)).filter(|(a, b)| a.surface == b.surface);
    let (same, all) = both.fold((0, 0), |(same, all), (a, b)| (same + usize::from(a.lit == b.lit), all + 1));
    same as f64 / f64::from(all.max(1))
}
