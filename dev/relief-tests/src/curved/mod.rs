//! Pictures of curved surfaces beside what the exact judge of displaced meshes sees along the same rays.

mod comparison;

use std::f64::consts::TAU;
use std::sync::Arc;

use glam::DVec3;
use rayon::prelude::*;
use relief_core::camera::Camera;
use relief_core::exact::{DisplacedMesh, Side, Sides};
use relief_core::mesh::Mesh;
use relief_core::{HeightMap, Watch, Wrap};
use relief_maps::Maps;
use relief_render::Renderer;
use relief_scene::{BackendChoice, Scene, Surface};
use relief_shaders::Selection;

use relief_core::rng::Rng;
use relief_testing::outline::Mask;

pub use comparison::{Comparison, Differences, quantile};

/// Vertical field of view of all cameras, in degrees.
const FOV_DEGREES: f64 = 40.0;

/// How far from a pixel's middle silhouettes are looked for, in pixels.
const NEAR_PIXELS: f64 = 0.0625;

/// A relief on a mesh.
#[derive(Clone, Debug)]
pub struct Curved {
    mesh: Arc<Mesh>,
    map: Arc<HeightMap>,
}

/// Where a pixel's ray meets a relief.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Met {
    /// Metres along the view axis.
    pub depth_m: f64,
    /// Texture coordinates, not wrapped.
    pub uv: [f64; 2],
    /// Whether the judge's word counts: not where the shell is turned inside out, and not where the ray
    /// came to the relief from behind, through a gap of the relief itself, as there are at poles of texture
    /// coordinates and along hard edges.
    pub counts: bool,
}

/// Hits of every pixel's ray, from the top row on.
#[derive(Clone, Debug)]
pub struct Picture {
    /// Columns and rows.
    pub size: [u32; 2],
    /// The pixels.
    pub met: Vec<Option<Met>>,
}

/// Surface, base and method of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Drawn {
    /// The variant of the stage `surface`.
    pub surface: &'static str,
    /// Whether its base is smooth.
    pub lifted: bool,
    /// Whether its quadrics have two coefficients in place of three.
    pub two_coefficients: bool,
    /// The method that finds its hits.
    pub method: &'static str,
}

impl Drawn {
    /// On flat triangles, with the exact search.
    pub const fn flat(surface: &'static str) -> Self {
        Self { surface, lifted: false, two_coefficients: false, method: "exact" }
    }

    /// Selection, without levels of detail and without shadows.
    ///
    /// # Panics
    ///
    /// When there is no such surface or method.
    pub fn selection(self) -> Selection {
        let mut selection = Selection::method(self.method).expect("a method");
        for (key, name) in [("surface", self.surface), ("detail", "none"), ("shadow", "none")] {
            selection.choose(key, name).expect("a listed name");
        }
        if self.lifted {
            selection.set("surface.lift", 1.0).expect("a setting of this surface");
        }
        if self.two_coefficients {
            selection.set("surface.coefficients", 2.0).expect("a setting of this surface");
        }
        selection
    }
}

impl Curved {
    /// A map on a mesh, height 0 by `bias_m` metres along the normals and height 1 by `bias_m + scale_m`.
    ///
    /// # Panics
    ///
    /// When these are no lengths.
    pub fn new(mesh: Mesh, map: &HeightMap, scale_m: f64, bias_m: f64) -> Self {
        let map = map.clone().with_displacement(scale_m, bias_m).expect("lengths");
        Self { mesh: Arc::new(mesh), map: Arc::new(map) }
    }

    /// The base.
    pub fn mesh(&self) -> &Mesh {
        &self.mesh
    }

    /// The height map.
    pub fn map(&self) -> &HeightMap {
        &self.map
    }

    /// The judge of this relief.
    ///
    /// # Panics
    ///
    /// When the mesh has too many tiles.
    pub fn judge(&self) -> DisplacedMesh {
        let Self { mesh, map } = self;
        DisplacedMesh::new(mesh, map, map.scale_m(), map.bias_m()).expect("a few tiles")
    }

    /// A scene that shows it.
    ///
    /// # Panics
    ///
    /// When there is no such surface.
    pub fn scene(&self, drawn: Drawn, camera: Camera, size: [u32; 2], backend: BackendChoice) -> Scene {
        let surface = Surface::new(Arc::clone(&self.mesh), Arc::clone(&self.map));
        let scene = Scene::builder(surface.with_selection(drawn.selection())).camera(camera);
        let scene = scene.lights(Vec::new()).samples(1).size(size[0], size[1]).backend(backend);
        scene.build().expect("a scene")
    }

    /// A camera that looks at it from a random side and sees all of it, or, with `closeness` above 1, a part
    /// as much larger.
    pub fn random_camera(&self, rng: &mut Rng, closeness: f64) -> Camera {
        let up = rng.between(-1.0, 1.0);
        let (sin, cos) = rng.between(0.0, TAU).sin_cos();
        let level = (1.0 - up * up).sqrt();
        self.camera(DVec3::new(level * cos, up, level * sin), closeness)
    }

    /// The same from that side.
    pub fn camera(&self, from: DVec3, closeness: f64) -> Camera {
        let farthest = self.mesh.vertices().iter().map(|vertex| vertex.position.as_dvec3().length());
        let outward = (self.map.bias_m() + self.map.scale_m()).max(0.0);
        let radius = farthest.fold(0.0, f64::max) + outward;
        let distance = 1.02 * radius / (FOV_DEGREES / 2.0).to_radians().sin();
        let target = DVec3::ZERO;
        Camera::new(from.normalize() * (distance / closeness), target, FOV_DEGREES).expect("a camera")
    }
}

impl Picture {
    /// Contents of a scene's picture.
    ///
    /// # Panics
    ///
    /// When no picture can be made.
    pub fn rendered(scene: &Scene, renderer: &mut Renderer) -> Self {
        Self::rendered_on(scene, renderer).0
    }

    /// Contents of a scene's picture, and the backend's name: the number of threads, or
    /// the adapter and its driver.
    ///
    /// # Panics
    ///
    /// When no picture can be made.
    pub fn rendered_on(scene: &Scene, renderer: &mut Renderer) -> (Self, String) {
        let rendered = renderer.render(scene, &mut Maps::in_memory(), &Watch::none()).expect("a picture");
        let met = rendered.rendering.pixels.iter().map(|pixel| {
            let uv = [pixel.uv.x, pixel.uv.y].map(f64::from);
            (pixel.hit == 1).then(|| Met { depth_m: pixel.depth.into(), uv, counts: true })
        });
        (Self { size: scene.size(), met: met.collect() }, rendered.info.device)
    }

    /// The pixels that show the relief.
    pub fn mask(&self) -> Mask {
        Mask::new(self.size, self.met.iter().map(Option::is_some).collect())
    }
}

/// Picture that the judge sees through a camera.
#[derive(Clone, Debug)]
pub struct Judged<'a> {
    judge: &'a DisplacedMesh,
    camera: Camera,
    /// What it sees.
    pub picture: Picture,
}

impl<'a> Judged<'a> {
    /// Returns the picture that this judge sees through that camera.
    pub fn new(judge: &'a DisplacedMesh, camera: Camera, size: [u32; 2]) -> Self {
        let [columns, rows] = size;
        let met = (0..columns * rows).into_par_iter().map(|pixel| {
            let ray = camera.ray(pixel % columns, pixel / columns, columns, rows);
            let hit = |sides| judge.first_hit(ray.origin.to_array(), ray.direction.to_array(), sides);
            let first = hit(Sides::Both)?;
            let is_front = first.side == Side::Front;
            let seen = if is_front { first } else { hit(Sides::Front)? };
            Some(Met { depth_m: seen.t, uv: seen.uv, counts: is_front && !seen.folded })
        });
        Self { judge, camera, picture: Picture { size, met: met.collect() } }
    }

    /// Whether a silhouette runs through a pixel near its middle: one of the depths in a row there is off the
    /// straight line by more than the given metres.
    fn is_at_silhouette(&self, pixel: u32, jump_m: f64) -> bool {
        let [columns, rows] = self.picture.size;
        let [x, y] = [pixel % columns, pixel / columns];
        let ray = |x, y| self.camera.ray(x, y, columns, rows);
        let here = ray(x, y);
        let [right, down] = [ray(x + 1, y), ray(x, y + 1)].map(|beside| {
            [beside.origin - here.origin, beside.direction - here.direction]
                .map(|change| change * NEAR_PIXELS)
        });
        let depth = |dx: f64, dy: f64| {
            let [origin, direction] = [0, 1].map(|part| right[part] * dx + down[part] * dy);
            let [origin, direction] = [here.origin + origin, here.direction + direction];
            let hit = self.judge.first_hit(origin.to_array(), direction.to_array(), Sides::Front);
            hit.map(|hit| hit.t)
        };
        let middle = depth(0.0, 0.0);
        [[1.0, 0.0], [0.0, 1.0], [1.0, 1.0], [1.0, -1.0]].into_iter().any(|[dx, dy]| {
            let three = depth(-dx, -dy).zip(middle).zip(depth(dx, dy));
            three.is_none_or(|((before, here), after)| (before + after - 2.0 * here).abs() > jump_m)
        })
    }
}

impl Curved {
    /// How far a hit is behind another, in scales of the displacement.
    fn behind(&self, drawn: &Met, truth: &Met) -> f64 {
        (drawn.depth_m - truth.depth_m) / self.map.scale_m().abs()
    }

    /// Distance of two places of the map, in texels of its finest level. Whole tiles do not count where
    /// the map goes on as it began.
    pub fn texels(&self, a: [f64; 2], b: [f64; 2]) -> f64 {
        let apart = |axis: usize| {
            let apart = a[axis] - b[axis];
            match self.map.wrap() {
                Wrap::Repeat => apart - apart.round(),
                _ => apart,
            }
        };
        (apart(0) * f64::from(self.map.width())).hypot(apart(1) * f64::from(self.map.height()))
    }
}
