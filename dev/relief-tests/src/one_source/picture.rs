//! A small scene, built by hand, and its picture by the translated shaders.

use std::sync::Arc;

use crate::baked::{in_slots, maps_for};
use glam::{DVec3, Vec3};
use relief_core::camera::Camera;
use relief_core::{Metric, Wrap};
use relief_render::job::{Job, JobSurface, LightViews, Rendering, uncovered};
use relief_render::mipmaps::Mipmaps;
use relief_scene::environment::Environment;
use relief_scene::material_maps::{MaterialMap, MaterialMaps, MaterialPictures};
use relief_shaders::cpu::{Corner, Frame, Light, PixelOut, Program, Shell, SurfaceSettings, Triangle};
use relief_shaders::{MapSlot, Selection};
use relief_testing::maps;

/// How near to a triangle's edge, in barycentric coordinates, either side may count: the rasteriser rounds
/// corners to a 256th of a pixel, which on the small triangles here is less than this. Larger would excuse
/// more pixels.
const EDGE: f64 = 2e-3;

/// A tile of relief above a floor, and a triangle that shows its back, seen by a camera at a slant.
pub struct Picture {
    job: Job,
}

/// Settings that vary.
pub struct Variation<'a> {
    /// The stages.
    pub selection: &'a Selection,
    /// The wrap of the height map.
    pub wrap: Wrap,
    /// Whether there is a normal map.
    pub normal_map: bool,
    /// Whether back faces are seen.
    pub two_sided: bool,
}

const NORMALS: [u32; 2] = [5, 3];
const COLORS: [u32; 2] = [3, 2];
const MATERIALS: [u32; 2] = [4, 3];

impl Picture {
    /// Scene in a picture of the given columns and rows.
    ///
    /// # Panics
    ///
    /// When the stages read maps that cannot be baked.
    pub fn new(width: u32, height: u32, variation: &Variation) -> Self {
        let named = maps::ALL.iter().find(|map| map.name == "natural 101x67").expect("it is listed");
        let map = named.build(variation.wrap).with_displacement(0.08, -0.02).expect("proper numbers");
        let camera =
            Camera::new(DVec3::new(0.2, 0.6, 1.1), DVec3::new(0.05, 0.0, 0.1), 48.0).expect("proper");
        let (eye, forward) = (camera.eye(), camera.forward());
        let per_pixel = 2.0 * camera.half_height() / f64::from(height);
        let (across, down) = (camera.right() * per_pixel, -camera.up() * per_pixel);
        let corner = forward - across * (f64::from(width) / 2.0) - down * (f64::from(height) / 2.0);
        let four = |v: DVec3, w: f32| v.as_vec3().extend(w).to_array();
        let mut lights = Frame::none().lights;
        lights[0] = Light::new(four(DVec3::new(0.4, 0.7, 0.3), 0.0), [0.9, 0.8, 0.7, 0.05], 0u32, 0u32);
        lights[1] = Light::new([-0.4, 0.5, 0.2, 1.0], [0.1, 0.2, 0.3, 0.02], 0u32, 0u32);
        let selection = variation.selection;
        let baked = maps_for(&map, selection);
        let aspect = f64::from(width) / f64::from(height);
        let view_projection = camera.view_projection(aspect, 0.05, 10.0).expect("proper planes");
        let frame = Frame {
            view_projection: view_projection.as_mat4().to_cols_array_2d().map(Into::into),
            eye: four(eye, 1.0).into(),
            eye_right: [0.0; 4].into(),
            eye_down: [0.0; 4].into(),
            forward: four(forward, 0.0).into(),
            corner: four(corner, 0.0).into(),
            right: four(across, 0.0).into(),
            down: four(down, 0.0).into(),
            ambient: [0.1, 0.1, 0.2, 0.0].into(),
            // Wide enough for several levels of detail.
            sample_width: 4.0,
            near: 0.05,
            clip: [1.0, -0.05, 0.0, 0.0].into(),
            lights,
            light_count: 2,
            ..Frame::none()
        };
        let picture = |[width, height]: [u32; 2], texel: fn(f32) -> [f32; 4]| {
            let texels = (0..width * height).map(|at| texel(at as f32 / 7.0)).collect();
            Arc::new(relief_io::Picture { width, height, texels })
        };
        let color = Arc::new(Mipmaps::of(picture(COLORS, |x| [x.fract(), 1.0 - x.fract(), 0.5, 1.0])));
        let normals = if variation.normal_map {
            let normals = picture(NORMALS, |x| [x.sin() * 0.3, x.cos() * 0.3, 0.9, 0.0]);
            Some(Arc::new(Mipmaps::of_normals(normals)))
        } else {
            Mipmaps::of_heights(&map, Metric::UNIT).map(Arc::new).filter(|_| selection.has_levels())
        };
        // Derived normals begin with the second level.
        let normal_levels =
            normals.as_ref().map_or(1, |normals| normals.levels() + u32::from(!variation.normal_map));
        let texel = |at: u32| std::array::from_fn(|part| (at as f32 * 0.37 + part as f32 * 0.21).fract());
        let mut pictures = MaterialPictures::default();
        for kind in [MaterialMap::Packed, MaterialMap::Emission] {
            let texels = (0..MATERIALS[0] * MATERIALS[1]).map(texel).collect();
            pictures[kind as usize] =
                Some(relief_io::Picture { width: MATERIALS[0], height: MATERIALS[1], texels });
        }
        let materials = MaterialMaps::new(&pictures, variation.wrap).expect("maps of a material");
        let materials = Arc::new(Mipmaps::of_materials(&materials, true));
        let mut held = in_slots(selection, baked);
        if selection.sees_environment() {
            held.push((MapSlot::Environment, Arc::clone(Environment::sky().map())));
        }
        let bound = held.iter().map(|(slot, map)| (*slot, &**map)).collect();
        let settings = SurfaceSettings {
            diffuse: [0.8, 0.7, 0.6, 0.0].into(),
            specular: [0.3, 0.3, 0.3, 0.0].into(),
            color_size: COLORS.into(),
            normal_size: normals.as_ref().map_or([1, 1], |normals| normals.size()).into(),
            color_levels: color.levels(),
            normal_levels,
            color_texels: 0.25,
            normal_texels: if variation.normal_map { 0.125 } else { 1.0 },
            emission: [0.1, 0.2, 0.1, 0.0].into(),
            material_size: MATERIALS.into(),
            material_levels: materials.levels(),
            material_texels: 0.25,
            roughness: 0.7,
            metallic: 0.9,
            has_material: 3,
            shininess: 20,
            has_color: 1,
            has_normal: u32::from(variation.normal_map),
            transmission: 0.5,
            ior: 1.5,
            ..SurfaceSettings::tracing(&map, selection, &bound)
        };
        let surface = JobSurface {
            settings,
            selection: *selection,
            triangles: Arc::new(triangles().into_iter().collect()),
            height_map: Arc::new(map),
            color: Some(color),
            normal_map: normals,
            material_maps: Some(materials),
            maps: held,
            two_sided: variation.two_sided,
        };
        let light_views = LightViews::default();
        Self { job: Job { width, height, samples: 1, frame, light_views, surfaces: vec![surface] } }
    }

    /// Input of a backend.
    pub fn job(&self) -> &Job {
        &self.job
    }

    fn surface(&self) -> &JobSurface {
        &self.job.surfaces[0]
    }

    /// What a pixel may be by the translated shaders: one answer, or several where the ray passes near an
    /// edge. An answer of nothing stands for a pixel that nothing covers.
    fn expected(&self, x: u32, y: u32) -> Vec<Option<PixelOut>> {
        let program = self.surface().program(self.job.frame, None);
        let point = [x as f32 + 0.5, y as f32 + 0.5];
        let mut met: Vec<Met> =
            self.surface().triangles.iter().filter_map(|each| self.meet(&program, &each, point)).collect();
        met.sort_by(|a, b| a.depth.total_cmp(&b.depth));
        let mut answers = Vec::new();
        for Met { certain, pixel, .. } in met {
            if pixel.hit == 0 {
                continue;
            }
            answers.push(Some(pixel));
            if certain {
                return answers;
            }
        }
        answers.push(None);
        answers
    }

    /// The picture by the translated shaders.
    pub fn on_cpu(&self) -> Rendering {
        let Job { width, height, .. } = self.job;
        let pixels = (0..height)
            .flat_map(|y| (0..width).map(move |x| (x, y)))
            .map(|(x, y)| self.expected(x, y)[0].unwrap_or_else(uncovered))
            .collect();
        Rendering { width, height, pixels }
    }

    /// Whether a rendering is this picture: every pixel one of its answers to rounding, few of them doubtful,
    /// and nearly all of them to the bit. The error says where not.
    pub fn check(&self, rendering: &Rendering) -> Result<(), String> {
        let (mut doubtful, mut inexact, mut covered) = (0, 0, 0);
        for (at, pixel) in rendering.pixels.iter().enumerate() {
            let (x, y) = (at as u32 % self.job.width, at as u32 / self.job.width);
            let expected = self.expected(x, y);
            if !expected.iter().any(|answer| is_close(answer.as_ref(), pixel)) {
                return Err(format!("pixel ({x}, {y}) is {pixel:?}, not one of {expected:?}"));
            }
            doubtful += usize::from(expected.len() > 1);
            covered += usize::from(pixel.hit == 1);
            inexact += usize::from(pixel.hit == 1 && !expected.contains(&Some(*pixel)));
        }
        let pixels = self.job.width as usize * self.job.height as usize;
        let complete = rendering.pixels.len() == pixels && covered * 5 > pixels;
        if complete && doubtful * 25 < pixels && inexact * 10_000 < covered {
            return Ok(());
        }
        let given = rendering.pixels.len();
        Err(format!(
            "{given} pixels, {covered} covered, {doubtful} doubtful, {inexact} without the same bits"
        ))
    }

    fn meet(&self, program: &Program, triangle: &Triangle, point: [f32; 2]) -> Option<Met> {
        let vector = |v: relief_shaders::cpu::Vec3<f32>| Vec3::new(v.x, v.y, v.z).as_dvec3();
        let direction = vector(program.pixel_direction(point));
        let eye = self.job.frame.eye;
        let eye = Vec3::new(eye.x, eye.y, eye.z).as_dvec3();
        let [a, b, c] = [triangle.a, triangle.b, triangle.c].map(|corner| vector(corner.position));
        let normal = (b - a).cross(c - a);
        let front = normal.dot(direction) < 0.0;
        if !front && !self.surface().two_sided {
            return None;
        }
        let depth = normal.dot(a - eye) / normal.dot(direction);
        let at = eye + direction * depth;
        let weight =
            |from: DVec3, to: DVec3| (to - from).cross(at - from).dot(normal) / normal.length_squared();
        let least = weight(a, b).min(weight(b, c)).min(weight(c, a));
        if depth <= 0.0 || least < -EDGE {
            return None;
        }
        let side = if front { 1.0 } else { -1.0 };
        let pixel = program.pixel_of(triangle, side, point);
        Some(Met { depth, certain: least > EDGE, pixel: program.shade_pixel(pixel) })
    }
}

/// A triangle that a ray meets.
struct Met {
    depth: f64,
    certain: bool,
    pixel: PixelOut,
}

/// Whether a pixel is the answer to 1e-5, in metres, as colour and as normal. Nothing is an answer, too.
fn is_close(answer: Option<&PixelOut>, pixel: &PixelOut) -> bool {
    const TOLERANCE: f32 = 1e-5;
    let numbers = |p: &PixelOut| {
        let (c, n, at) = (p.color, p.normal, p.position);
        [c.x, c.y, c.z, c.w, n.x, n.y, n.z, at.x, at.y, at.z, p.depth, p.height, p.uv.x, p.uv.y]
    };
    match answer {
        None => pixel.hit == 0,
        Some(answer) => {
            let close = |(a, b): (f32, f32)| (a - b).abs() <= TOLERANCE;
            pixel.hit == 1 && numbers(answer).into_iter().zip(numbers(pixel)).all(close)
        }
    }
}

/// A unit tile, a floor below it with nine tiles, and a triangle in front whose back faces the eye.
fn triangles() -> Vec<Triangle> {
    let shell = Shell::whole();
    let corner = |position: [f32; 3], normal: [f32; 3], length: f32, uv: [f32; 2]| {
        Corner::new(position, normal, [length, 0.0, 0.0], [0.0, 0.0, length], uv, [0.0; 3])
    };
    let level = |y: f32, half: f32, tiles: f32| {
        let at = |x: f32, z: f32| {
            let uv = [(x + 0.5) * tiles, (z + 0.5) * tiles];
            corner([2.0 * x * half, y, 2.0 * z * half], [0.0, 1.0, 0.0], 2.0 * half / tiles, uv)
        };
        let [a, b, c, d] = [at(-0.5, -0.5), at(-0.5, 0.5), at(0.5, 0.5), at(0.5, -0.5)];
        [Triangle { a, b, c, shell }, Triangle { a, b: c, c: d, shell }]
    };
    let down = [0.0, -1.0, 0.0];
    let back = Triangle {
        a: corner([-0.2, 0.15, 0.3], down, 1.0, [0.1, 0.2]),
        b: corner([0.2, 0.15, 0.3], down, 1.0, [0.5, 0.2]),
        c: corner([0.0, 0.15, 0.6], down, 1.0, [0.3, 0.5]),
        shell,
    };
    [&level(0.0, 0.5, 1.0)[..], &level(-0.2, 0.75, 3.0), &[back]].concat()
}
