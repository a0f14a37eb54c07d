//! Scenes made by programs.

use super::{BackendChoice, Sampling, Scene, ValueError, error::ValueProblem};
use crate::camera::Camera;
use crate::light::{Light, LightError, MAX_LIGHTS, checked_colour};
use crate::material::Material;
use crate::mesh::{Builtin, Mesh};
use glam::{DVec3, Vec3};
use relief_core::HeightMap;
use relief_io::{NormalMap, Picture};
use relief_shaders::{STAGES, Selection, SelectionError};

/// The longest side of a picture in pixels.
pub const MAX_IMAGE_SIDE: u32 = 32_768;

/// The default position of the eye, in metres.
pub(super) const DEFAULT_EYE: DVec3 = DVec3::new(0.6, 0.9, 1.1);
/// The default vertical field of view, in degrees.
pub(super) const DEFAULT_FOV: f64 = 40.0;
/// The direction toward the default light.
const DEFAULT_LIGHT: DVec3 = DVec3::new(0.5, 0.8, 0.3);
const DEFAULT_AMBIENT: Vec3 = Vec3::splat(0.15);
const DEFAULT_BACKGROUND: Vec3 = Vec3::splat(0.05);
/// The default method.
pub(super) const DEFAULT_METHOD: &str = "exact";
/// The default width and height, in pixels.
pub(super) const DEFAULT_SIZE: [u32; 2] = [800, 600];

/// A scene under construction; made by [`Scene::builder`].
#[derive(Clone, Debug)]
#[must_use = "a builder makes no scene until it is built"]
pub struct SceneBuilder {
    height_map: HeightMap,
    mesh: Option<Mesh>,
    color: Option<Picture>,
    normal_map: Option<Picture>,
    camera: Option<Camera>,
    lights: Option<Vec<Light>>,
    ambient: Vec3,
    material: Material,
    background: Vec3,
    size: [u32; 2],
    selection: Option<Selection>,
    backend: BackendChoice,
    sampling: Sampling,
    two_sided: bool,
}

impl SceneBuilder {
    pub(super) fn new(height_map: HeightMap) -> Self {
        Self {
            height_map,
            mesh: None,
            color: None,
            normal_map: None,
            camera: None,
            lights: None,
            ambient: DEFAULT_AMBIENT,
            material: Material::default(),
            background: DEFAULT_BACKGROUND,
            size: DEFAULT_SIZE,
            selection: None,
            backend: BackendChoice::default(),
            sampling: Sampling::default(),
            two_sided: false,
        }
    }

    /// The base mesh, with its tile factors applied. By default the built-in plane.
    pub fn mesh(mut self, mesh: Mesh) -> Self {
        self.mesh = Some(mesh);
        self
    }

    /// A colour picture, which multiplies the material's diffuse colour. By default none.
    pub fn color(mut self, color: Picture) -> Self {
        self.color = Some(color);
        self
    }

    /// A tangent-space normal map. By default none: normals are derived from the height map.
    pub fn normal_map(mut self, map: NormalMap) -> Self {
        // Four numbers a texel, as the shaders take them.
        let texels = map.normals.iter().map(|&[x, y, z]| [x, y, z, 0.0]).collect();
        self.normal_map = Some(Picture { width: map.width, height: map.height, texels });
        self
    }

    /// The camera. By default at (0.6, 0.9, 1.1), looking at the origin with a field of view of 40 degrees.
    pub fn camera(mut self, camera: Camera) -> Self {
        self.camera = Some(camera);
        self
    }

    /// The lights, at most [`MAX_LIGHTS`]; they may be none. By default one from the direction (0.5, 0.8, 0.3) with
    /// irradiance 1.
    pub fn lights(mut self, lights: Vec<Light>) -> Self {
        self.lights = Some(lights);
        self
    }

    /// Irradiance from everywhere, linear. By default 0.15.
    pub fn ambient(mut self, ambient: Vec3) -> Self {
        self.ambient = ambient;
        self
    }

    /// The material. By default light grey.
    pub fn material(mut self, material: Material) -> Self {
        self.material = material;
        self
    }

    /// Linear colour of pixels that show no surface. By default dark grey, 0.05.
    pub fn background(mut self, background: Vec3) -> Self {
        self.background = background;
        self
    }

    /// Width and height of the picture in pixels, each from 1 to [`MAX_IMAGE_SIDE`]. By default 800 and 600.
    pub fn size(mut self, width: u32, height: u32) -> Self {
        self.size = [width, height];
        self
    }

    /// What is run: how the first hit is found, and how it is shaded. By default the method `exact`.
    pub fn selection(mut self, selection: Selection) -> Self {
        self.selection = Some(selection);
        self
    }

    /// What computes the picture. By default a GPU if there is one, else the CPU.
    pub fn backend(mut self, backend: BackendChoice) -> Self {
        self.backend = backend;
        self
    }

    /// How textures are read. By default exactly.
    pub fn sampling(mut self, sampling: Sampling) -> Self {
        self.sampling = sampling;
        self
    }

    /// Whether triangles seen from behind are drawn. By default they are not.
    pub fn two_sided(mut self, two_sided: bool) -> Self {
        self.two_sided = two_sided;
        self
    }

    /// The scene.
    ///
    /// # Errors
    ///
    /// When the size is out of range, there are too many lights, a colour is negative or not finite, or what is selected
    /// cannot trace view rays.
    pub fn build(self) -> Result<Scene, ValueError> {
        let [width, height] = self.size;
        if !(self.size.iter().all(|side| (1..=MAX_IMAGE_SIDE).contains(side))) {
            return Err(ValueProblem::Size { width, height }.of("size"));
        }
        let problem = |key: &'static str| move |problem: ValueProblem| problem.of(key);
        let colour = |key: &'static str, colour: Vec3| {
            checked_colour(colour).map_err(ValueProblem::from).map_err(problem(key))
        };
        let (ambient, background) =
            (colour("ambient", self.ambient)?, colour("background", self.background)?);
        let selection = self.selection.map_or_else(|| Selection::method(DEFAULT_METHOD), Ok);
        let selection = selection.and_then(|selection| selection.check().map(|()| selection));
        let selection = selection.map_err(of_selection)?;
        let mesh = match self.mesh {
            Some(mesh) => mesh,
            None => Builtin::Plane.build().map_err(ValueProblem::from).map_err(problem("mesh"))?,
        };
        let camera = match self.camera {
            Some(camera) => camera,
            None => Camera::new(DEFAULT_EYE, DVec3::ZERO, DEFAULT_FOV)
                .map_err(ValueProblem::from)
                .map_err(problem("eye"))?,
        };
        let lights = match self.lights {
            Some(lights) => lights,
            None => vec![
                Light::directional(DEFAULT_LIGHT, Vec3::ONE)
                    .map_err(ValueProblem::from)
                    .map_err(problem("light"))?,
            ],
        };
        if lights.len() > MAX_LIGHTS {
            return Err(ValueProblem::from(LightError::TooMany(lights.len())).of("lights"));
        }
        Ok(Scene {
            mesh,
            height_map: self.height_map,
            color: self.color,
            normal_map: self.normal_map,
            camera,
            lights,
            ambient,
            material: self.material,
            background,
            size: self.size,
            selection,
            backend: self.backend,
            sampling: self.sampling,
            two_sided: self.two_sided,
        })
    }
}

/// The error of a selection, with the key of the scene that it comes from.
pub(super) fn of_selection(error: SelectionError) -> ValueError {
    let key = match &error {
        // A name is unknown of a method, or of a stage by its title.
        SelectionError::Unknown(unknown) => {
            STAGES.iter().find(|stage| stage.title == unknown.kind).map_or("method", |stage| stage.key)
        }
        SelectionError::Impossible { key, .. } => key,
        _ => "set",
    };
    ValueProblem::from(Box::new(error)).of(key)
}
