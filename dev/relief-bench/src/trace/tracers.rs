//! The tracers that are compared, and the rays that they get.

use std::hint::black_box;
use std::ops::Range;

use glam::DVec3;
use parry3d::math::Vector;
use parry3d::query::{Ray, RayCast};
use parry3d::shape::HeightField;
use parry3d::utils::Array2;
use relief_core::exact::{FastTracer, cell_walk};
use relief_core::rng::Rng;
use relief_core::{HeightMap, Path};
use relief_shaders::cpu::MethodTracer;
use relief_shaders::{Selection, SlotMaps};

use super::view::{Ground, SCALE_M, SIZE, camera, sun};

/// Name of the tracer that is measured.
pub const FAST: &str = "exact, FastTracer";

/// Name of the other program's tracer.
pub const PARRY: &str = "parry3d 0.31.1, triangles";

/// Methods whose translated shaders are measured.
const METHODS: [&str; 3] = ["relief", "occlusion", "exact"];

/// Pixels along the side of the squares in which a picture's rays are ordered, as renderers do.
const SQUARE: u32 = 32;

/// Number of rays without order.
const SCATTERED: usize = 1 << 18;

/// Angles between scattered view rays and the normal, in degrees: from steep to grazing.
const SCATTERED_DEGREES: [f64; 2] = [5.0, 80.0];

/// Rays in both forms: as paths, and as parry3d takes them. Which are the same rays for view rays; shadow
/// rays begin where the respective program was hit.
pub struct Rays {
    /// Name in tables.
    pub name: &'static str,
    /// Whether the answer is only yes or no.
    pub shadow: bool,
    /// The paths.
    pub paths: Vec<Path>,
    /// The rays in the world, and their lengths.
    pub parry: Vec<(Ray, f32)>,
}

/// The view rays of the picture, in the order of small squares.
pub fn picture_rays(ground: &Ground) -> Result<Rays, String> {
    let camera = camera().map_err(|error| error.to_string())?;
    let [width, height] = SIZE;
    let mut paths = Vec::with_capacity(width as usize * height as usize);
    for top in (0..height).step_by(SQUARE as usize) {
        for left in (0..width).step_by(SQUARE as usize) {
            for y in top..(top + SQUARE).min(height) {
                for x in left..(left + SQUARE).min(width) {
                    let ray = camera.ray(x, y, width, height);
                    paths.extend(ground.path(ray.origin, ray.direction.normalize()));
                }
            }
        }
    }
    Ok(Rays::view("picture, view", paths))
}

/// View rays from anywhere on top in all directions, at angles from steep to grazing, in no order.
pub fn scattered_rays(ground: &Ground) -> Rays {
    let mut rng = Rng::new(3);
    let [width, depth] = ground.sides;
    let mut paths = Vec::with_capacity(SCATTERED);
    while paths.len() < SCATTERED {
        let [x, z] = [width, depth].map(|side| (rng.unit() - 0.5) * side);
        let (sin, cos) = rng.between(0.0, std::f64::consts::TAU).sin_cos();
        let (sine, cosine) = rng.between(SCATTERED_DEGREES[0], SCATTERED_DEGREES[1]).to_radians().sin_cos();
        paths.extend(ground.path(DVec3::new(x, SCALE_M, z), DVec3::new(sine * cos, -cosine, sine * sin)));
    }
    Rays::view("scattered, view", paths)
}

impl Rays {
    fn view(name: &'static str, paths: Vec<Path>) -> Self {
        let paths: Vec<Path> = paths.iter().map(in_f32).collect();
        let parry = paths.iter().map(world_ray).collect();
        Self { name, shadow: false, paths, parry }
    }

    /// The shadow rays from where these view rays hit, for either program from its own hits.
    pub fn shadows(&self, name: &'static str, ground: &Ground, tracer_set: &TracerSet) -> Self {
        let sun = sun();
        let to_sun = |point: DVec3| ground.path_to_sun(point, sun);
        let paths = self.paths.iter().filter_map(|path| {
            let hit = tracer_set.fast.trace(path).hit;
            hit.found.then(|| to_sun(Ground::point(hit.uv, hit.height))).flatten()
        });
        let parry = self.parry.iter().filter_map(|(ray, length)| {
            let t = tracer_set.parry.cast_local_ray(ray, *length, true)?;
            let point = ray.origin + ray.dir * t;
            to_sun(DVec3::new(point.x.into(), point.y.into(), point.z.into()))
        });
        Self {
            name,
            shadow: true,
            paths: paths.map(|path| in_f32(&path)).collect(),
            parry: parry.map(|path| world_ray(&path)).collect(),
        }
    }
}

/// The path rounded to what shaders and parry3d hold, so that all trace the same ray.
fn in_f32(path: &Path) -> Path {
    Path::from(&relief_shaders::cpu::Path::from(path))
}

fn world_ray(path: &Path) -> (Ray, f32) {
    let point = |p: DVec3| Vector::new(p.x as f32, p.y as f32, p.z as f32);
    let direction = DVec3::new(path.duv[0], path.h[1] * SCALE_M, path.duv[1]);
    (Ray::new(point(Ground::point(path.uv, path.h[0])), point(direction)), path.exit as f32)
}

/// The height field of parry3d: two triangles a cell.
pub fn parry_field(map: &HeightMap) -> HeightField {
    let heights = Array2::from_fn(map.height() as usize, map.width() as usize, |row, column| {
        map.texel(column as i64, row as i64)
    });
    let [width, depth] = Ground::of(map).sides;
    HeightField::new(heights, Vector::new(width as f32, SCALE_M as f32, depth as f32))
}

/// All tracers of one map.
pub struct TracerSet<'a> {
    /// The map.
    pub map: &'a HeightMap,
    /// The tracer that is measured.
    pub fast: FastTracer,
    /// Height field of parry3d, the other program.
    pub parry: HeightField,
    shaders: Vec<(String, MethodTracer<'a>)>,
}

/// One tracer.
pub enum Tracer<'a> {
    /// The exact tracer of renderers.
    Fast(&'a FastTracer),
    /// The truth.
    Walk(&'a HeightMap),
    /// A translated shader.
    Shader(&'a MethodTracer<'a>),
    /// The other program.
    Parry(&'a HeightField),
}

impl<'a> TracerSet<'a> {
    /// Creates all tracers of `map`.
    pub fn new(map: &'a HeightMap) -> Result<Self, String> {
        let shaders = METHODS.map(|method| {
            let selection = Selection::method(method).map_err(|error| error.to_string())?;
            let name =
                format!("shader, {method} ({} + {})", selection.search().name, selection.refine().name);
            Ok((name, MethodTracer::over(map, &selection, SlotMaps::default())))
        });
        Ok(Self {
            map,
            fast: FastTracer::new(map),
            parry: parry_field(map),
            shaders: shaders.into_iter().collect::<Result<_, String>>()?,
        })
    }

    /// Returns all tracers with their names, the measured one first.
    pub fn tracers(&self) -> Vec<(&str, Tracer<'_>)> {
        let mut tracers = vec![
            (FAST, Tracer::Fast(&self.fast)),
            (PARRY, Tracer::Parry(&self.parry)),
            ("exact, cell_walk in f64", Tracer::Walk(self.map)),
        ];
        tracers.extend(self.shaders.iter().map(|(name, tracer)| (name.as_str(), Tracer::Shader(tracer))));
        tracers
    }
}

impl Tracer<'_> {
    /// Returns the number of rays for this tracer.
    pub fn count(&self, rays: &Rays) -> usize {
        if matches!(self, Tracer::Parry(_)) { rays.parry.len() } else { rays.paths.len() }
    }

    /// The parameter of the first hit of a ray.
    pub fn hit(&self, rays: &Rays, at: usize) -> Option<f64> {
        let hit = match self {
            Tracer::Fast(tracer) => tracer.trace(&rays.paths[at]).hit,
            Tracer::Walk(map) => cell_walk(map, &rays.paths[at]).hit,
            Tracer::Shader(tracer) => tracer.first_hit(&rays.paths[at]),
            Tracer::Parry(field) => {
                let (ray, length) = &rays.parry[at];
                return field.cast_local_ray(ray, *length, true).map(f64::from);
            }
        };
        hit.found.then_some(hit.t)
    }

    /// Traces some rays and says how many hit: what is timed. Every answer is made whole, used or not.
    pub fn trace(&self, rays: &Rays, range: Range<usize>) -> usize {
        let paths = rays.paths.get(range.clone()).unwrap_or_default().iter();
        match self {
            Tracer::Fast(tracer) if rays.shadow => paths.filter(|path| tracer.is_blocked(path)).count(),
            Tracer::Fast(tracer) => paths.filter(|path| black_box(tracer.trace(path)).hit.found).count(),
            Tracer::Walk(map) => paths.filter(|path| black_box(cell_walk(map, path)).hit.found).count(),
            Tracer::Shader(tracer) => paths.filter(|path| black_box(tracer.first_hit(path)).found).count(),
            Tracer::Parry(field) => rays.parry[range]
                .iter()
                .filter(|(ray, length)| black_box(field.cast_local_ray(ray, *length, true)).is_some())
                .count(),
        }
    }
}
