//! Scenes made by programs.

use super::limits::MAX_IMAGE_SIDE;
use super::{BackendChoice, Sampling, Scene, Surface, ValueError, error::ValueProblem};
use crate::camera::Camera;
use crate::light::{Light, LightError, MAX_LIGHTS, checked_colour};
use glam::{DVec3, Vec3};
use relief_shaders::{STAGES, SelectionError};

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
    surfaces: Vec<Surface>,
    camera: Option<Camera>,
    lights: Option<Vec<Light>>,
    ambient: Vec3,
    background: Vec3,
    size: [u32; 2],
    backend: BackendChoice,
    sampling: Sampling,
}

impl Scene {
    /// Starts a scene that shows a surface; everything else has its default, which the builder's functions
    /// state.
    pub fn builder(surface: Surface) -> SceneBuilder {
        SceneBuilder::showing(vec![surface])
    }

    /// A builder of a scene that differs from this one. What is not changed is shared with it, so that a
    /// renderer that has seen this one need not make it ready again.
    pub fn to_builder(&self) -> SceneBuilder {
        SceneBuilder::of(self)
    }
}

impl SceneBuilder {
    /// A scene that shows these surfaces.
    pub(super) fn showing(surfaces: Vec<Surface>) -> Self {
        Self {
            surfaces,
            camera: None,
            lights: None,
            ambient: DEFAULT_AMBIENT,
            background: DEFAULT_BACKGROUND,
            size: DEFAULT_SIZE,
            backend: BackendChoice::default(),
            sampling: Sampling::default(),
        }
    }

    pub(super) fn of(scene: &Scene) -> Self {
        Self {
            surfaces: scene.surfaces.clone(),
            camera: Some(scene.camera),
            lights: Some(scene.lights.clone()),
            ambient: scene.ambient,
            background: scene.background,
            size: scene.size,
            backend: scene.backend,
            sampling: scene.sampling,
        }
    }

    /// One more surface.
    pub fn surface(mut self, surface: Surface) -> Self {
        self.surfaces.push(surface);
        self
    }

    /// These surfaces in place of all others. A scene shows at least one.
    pub fn surfaces(mut self, surfaces: Vec<Surface>) -> Self {
        self.surfaces = surfaces;
        self
    }

    /// The camera. By default at (0.6, 0.9, 1.1), looking at the origin with a field of view of 40 degrees.
    pub fn camera(mut self, camera: Camera) -> Self {
        self.camera = Some(camera);
        self
    }

    /// The lights, at most [`MAX_LIGHTS`]; they may be none. By default one from the direction (0.5, 0.8,
    /// 0.3) with irradiance 1.
    pub fn lights(mut self, lights: Vec<Light>) -> Self {
        self.lights = Some(lights);
        self
    }

    /// Irradiance from everywhere, linear. By default 0.15.
    pub fn ambient(mut self, ambient: Vec3) -> Self {
        self.ambient = ambient;
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

    /// The scene.
    ///
    /// # Errors
    ///
    /// When there is no surface, the size is out of range, there are too many lights, a colour is negative or
    /// not finite, or what a surface selects cannot trace view rays.
    pub fn build(self) -> Result<Scene, ValueError> {
        let [width, height] = self.size;
        if !(self.size.iter().all(|side| (1..=MAX_IMAGE_SIDE).contains(side))) {
            return Err(ValueProblem::Size { width, height }.of("size"));
        }
        if self.surfaces.is_empty() {
            return Err(ValueProblem::NoSurface.of("surfaces"));
        }
        let problem = |key: &'static str| move |problem: ValueProblem| problem.of(key);
        let colour = |key: &'static str, colour: Vec3| {
            checked_colour(colour).map_err(ValueProblem::from).map_err(problem(key))
        };
        let (ambient, background) =
            (colour("ambient", self.ambient)?, colour("background", self.background)?);
        for surface in &self.surfaces {
            surface.selection().check().map_err(of_selection)?;
        }
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
            surfaces: self.surfaces,
            camera,
            lights,
            ambient,
            background,
            size: self.size,
            backend: self.backend,
            sampling: self.sampling,
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
