//! A scene to a job: the shaders' settings, the triangles in the world and the camera's matrices.

use glam::{DMat4, DVec3, Vec3};
use relief_io::Picture;
use relief_shaders::SlotMaps;
use relief_shaders::cpu::{Choice, Corner, Light as ShaderLight, Settings, Triangle};

use crate::camera::Camera;
use crate::job::{Job, TexelMap};
use crate::light::Light;
use crate::mesh::{Mesh, Vertex};
use crate::scene::Scene;

/// The least distance of the near plane, as a part of the far plane's: depths have 24 bits, of which such a ratio leaves
/// ten at the far end. Smaller and distant surfaces flicker; larger and the eye cannot come close to a surface.
const NEAR_OVER_FAR: f64 = 1e-4;

/// What a job needs beyond the scene's own maps.
pub struct Prepared<'a> {
    scene: &'a Scene,
    maps: SlotMaps<'a>,
    settings: Settings,
    triangles: Vec<Triangle>,
    view_projection: [[f32; 4]; 4],
}

impl<'a> Prepared<'a> {
    /// Prepares a scene, with the baked maps that its stages read.
    pub fn new(scene: &'a Scene, maps: SlotMaps<'a>) -> Self {
        let mesh = scene.mesh();
        Self {
            scene,
            maps,
            settings: settings(scene, &maps),
            triangles: (0..mesh.triangles().len() as u32).map(|number| triangle(mesh, number)).collect(),
            view_projection: view_projection(scene.camera(), mesh, scene.size()).as_mat4().to_cols_array_2d(),
        }
    }

    /// The job of the scene.
    pub fn job(&self) -> Job<'_> {
        let scene = self.scene;
        let [width, height] = scene.size();
        let map = |picture: &'a Picture| TexelMap {
            width: picture.width,
            height: picture.height,
            texels: &picture.texels,
        };
        Job {
            width,
            height,
            settings: self.settings,
            triangles: &self.triangles,
            view_projection: self.view_projection,
            height_map: scene.height_map(),
            color_map: scene.color().map(map),
            normal_map: scene.normal_map().map(map),
            maps: self.maps,
            two_sided: scene.two_sided(),
        }
    }
}

fn settings(scene: &Scene, maps: &SlotMaps) -> Settings {
    let four = |v: Vec3| [v.x, v.y, v.z, 0.0];
    let place = |v: DVec3, w: f32| [v.x as f32, v.y as f32, v.z as f32, w];
    let (camera, material, height) = (scene.camera(), scene.material(), scene.height_map());
    let [columns, rows] = scene.size();
    let across = 2.0 * (camera.fov_degrees().to_radians() / 2.0).tan() / f64::from(rows);
    let (right, down) = (camera.right() * across, camera.up() * -across);
    let corner = camera.forward() - right * (f64::from(columns) / 2.0) - down * (f64::from(rows) / 2.0);

    let mut lights = [ShaderLight::new([0.0; 4], [0.0; 4]); relief_shaders::MAX_LIGHTS];
    for (slot, light) in lights.iter_mut().zip(scene.lights()) {
        *slot = match *light {
            Light::Directional { toward, irradiance } => {
                ShaderLight::new(place(toward, 0.0), four(irradiance))
            }
            Light::Point { position_m, intensity } => {
                ShaderLight::new(place(position_m, 1.0), four(intensity))
            }
        };
    }
    let size = |map: Option<&Picture>| map.map_or([1, 1], |map| [map.width, map.height]);
    Settings {
        choices: scene.selection().choices.map(|choice| Choice::from(&choice)),
        maps: maps.settings(),
        eye: place(camera.eye(), 1.0).into(),
        forward: place(camera.forward(), 0.0).into(),
        corner: place(corner, 0.0).into(),
        right: place(right, 0.0).into(),
        down: place(down, 0.0).into(),
        ambient: four(scene.ambient()).into(),
        diffuse: four(material.diffuse()).into(),
        specular: four(material.specular()).into(),
        lights,
        height_size: [height.width(), height.height()].into(),
        color_size: size(scene.color()).into(),
        normal_size: size(scene.normal_map()).into(),
        wrap: height.wrap() as u32,
        light_count: scene.lights().len() as u32,
        shininess: material.shininess(),
        has_color: u32::from(scene.color().is_some()),
        has_normal: u32::from(scene.normal_map().is_some()),
        scale_m: height.scale_m() as f32,
        bias_m: height.bias_m() as f32,
    }
}

fn triangle(mesh: &Mesh, number: u32) -> Triangle {
    let corner = |vertex: &Vertex| {
        Corner::new(
            vertex.position.to_array(),
            vertex.normal.to_array(),
            vertex.tangent.to_array(),
            vertex.bitangent.to_array(),
            vertex.uv.to_array(),
        )
    };
    let [a, b, c] = mesh.corners(number).map(corner);
    Triangle { a, b, c }
}

/// The matrix for the rasteriser, with planes that hold the whole mesh.
fn view_projection(camera: &Camera, mesh: &Mesh, size: [u32; 2]) -> DMat4 {
    let depth = |vertex: &Vertex| camera.forward().dot(vertex.position.as_dvec3() - camera.eye());
    let farthest = mesh.vertices().iter().map(depth).fold(0.0, f64::max);
    let nearest = mesh.vertices().iter().map(depth).fold(f64::INFINITY, f64::min);
    // A mesh behind the eye shows nothing, whatever the planes.
    let far = if farthest > 0.0 { farthest * 1.01 } else { 1.0 };
    let near = (nearest * 0.99).clamp(far * NEAR_OVER_FAR, far * 0.5);
    let aspect = f64::from(size[0]) / f64::from(size[1]);
    camera.view_projection(aspect, near, far).unwrap_or(DMat4::IDENTITY)
}
