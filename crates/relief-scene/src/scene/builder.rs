//! Builder of scenes for programs.

use super::framing::{Framing, fitted_to_visible, proportional_size};
use super::limits::{DEFAULT_MAX_MEMORY, DEFAULT_SAMPLES, MAX_EXPOSURE, MAX_SAMPLES};
use super::picture_size::check_size;
use super::surface_spec::environment;
use super::view::{Fit, View, fitted};
use super::{BackendChoice, Look, Sampling, Scene, Surface, ValueError, error::ValueProblem};
use crate::background::Background;
use crate::depth_buffer::DepthBuffer;
use crate::environment::Environment;
use crate::light::{Light, LightError, MAX_LIGHTS, SUN_DEG, checked_colour};
use crate::tone::Tone;
use glam::{DVec3, Vec3};
use relief_core::ByteSize;
use relief_core::camera::{Camera, CameraError};
use relief_shaders::field::Solids;
use relief_shaders::{AMBIENT, STAGES, SelectionError};
use std::sync::{Arc, LazyLock};

/// Default position of the eye in metres if only the target is given.
pub(super) const DEFAULT_EYE: DVec3 = DVec3::new(0.6, 0.9, 1.1);
/// Default vertical field of view in degrees.
pub(super) const DEFAULT_FOV: f64 = 40.0;
/// Stage and variant that environment maps and refraction need.
pub(super) static AMBIENT_ENVIRONMENT: LazyLock<String> =
    LazyLock::new(|| format!("{} {}", STAGES[AMBIENT].key, environment()));
/// Default method.
pub(super) const DEFAULT_METHOD: &str = "exact";
/// Default method of depth objects.
pub(super) const DEFAULT_METHOD_OF_OBJECTS: &str = "depth-object";

/// Default method of volumes.
pub(super) const DEFAULT_METHOD_OF_VOLUMES: &str = "voxels";

/// Default method of motifs.
pub(super) const DEFAULT_METHOD_OF_MOTIFS: &str = "shell-map";
/// Default width and height in pixels.
pub(super) const DEFAULT_SIZE: [u32; 2] = [800, 600];

/// Builder of a [`Scene`]; see [`Scene::builder`].
#[derive(Clone, Debug)]
#[must_use = "a builder makes no scene until it is built"]
pub struct SceneBuilder {
    surfaces: Vec<Surface>,
    camera: CameraChoice,
    /// `None` stands for the look's framing.
    framing: Option<Framing>,
    depth_buffer: DepthBuffer,
    look: Look,
    /// Whether surfaces get the sky and the shadows of the look.
    adapts_surfaces: bool,
    lights: Option<Vec<Light>>,
    /// Direction toward the look's light. `None` stands for the look's direction.
    light_toward: Option<DVec3>,
    light_angle: f64,
    ambient: Option<Vec3>,
    environment: Option<Arc<Environment>>,
    background: Option<Background>,
    /// `None` stands for the default, or for the proportions of the visible scene.
    size: Option<[u32; 2]>,
    samples: u32,
    exposure: Option<f32>,
    tone: Option<Tone>,
    backend: BackendChoice,
    sampling: Sampling,
    geometry_memory: ByteSize,
    culls: bool,
}

/// Camera, or the way to fit one.
#[derive(Clone, Copy, Debug)]
enum CameraChoice {
    Given(Camera),
    /// Fitted in a view. `None` stands for the look's view.
    Fitted(Option<View>, Fit),
}

impl Scene {
    /// Returns a builder of a scene that shows one surface, with defaults for everything else. Each
    /// function of the builder states its default.
    pub fn builder(surface: Surface) -> SceneBuilder {
        SceneBuilder::showing(vec![surface])
    }

    /// Returns a builder that starts with this scene's values. Unchanged parts are shared with this
    /// scene, so a renderer need not prepare them again.
    pub fn to_builder(&self) -> SceneBuilder {
        SceneBuilder::of(self)
    }
}

impl SceneBuilder {
    /// Creates a builder of a scene that shows these surfaces.
    pub(super) fn showing(surfaces: Vec<Surface>) -> Self {
        Self {
            surfaces,
            camera: CameraChoice::Fitted(None, Fit::Perspective(DEFAULT_FOV)),
            framing: None,
            depth_buffer: DepthBuffer::default(),
            look: Look::default(),
            adapts_surfaces: true,
            lights: None,
            light_toward: None,
            light_angle: SUN_DEG,
            ambient: None,
            environment: None,
            background: None,
            size: None,
            samples: DEFAULT_SAMPLES,
            exposure: None,
            tone: None,
            backend: BackendChoice::default(),
            sampling: Sampling::default(),
            geometry_memory: DEFAULT_MAX_MEMORY,
            culls: true,
        }
    }

    pub(super) fn of(scene: &Scene) -> Self {
        Self {
            surfaces: scene.surfaces.clone(),
            camera: CameraChoice::Given(scene.camera),
            framing: None,
            depth_buffer: scene.depth_buffer,
            look: Look::default(),
            adapts_surfaces: true,
            lights: Some(scene.lights.clone()),
            light_toward: None,
            light_angle: SUN_DEG,
            ambient: Some(scene.ambient),
            environment: scene.environment.clone(),
            background: Some(scene.background),
            size: Some(scene.size),
            samples: scene.samples,
            exposure: Some(scene.exposure),
            tone: Some(scene.tone),
            backend: scene.backend,
            sampling: scene.sampling,
            geometry_memory: scene.geometry_memory,
            culls: scene.culls,
        }
    }

    /// Adds a surface.
    pub fn surface(mut self, surface: Surface) -> Self {
        self.surfaces.push(surface);
        self
    }

    /// Replaces all surfaces. A scene needs at least one.
    pub fn surfaces(mut self, surfaces: Vec<Surface>) -> Self {
        self.surfaces = surfaces;
        self
    }

    /// Sets the look: the defaults of light, sky, background, exposure, tone curve and camera.
    /// Default: [`Look::Plain`].
    ///
    /// Looks with a sky change surfaces with the ambient variant `constant`, the default: they get
    /// `sky`, or `hemisphere` without a relief. If there are several surfaces, those with the
    /// shadow `ray` get `map`, so that they cast shadows on each other. A builder from
    /// [`Scene::to_builder`] already has values for everything else.
    pub fn look(mut self, look: Look) -> Self {
        self.look = look;
        self
    }

    /// Sets the look for surfaces that already have its sky and shadows, or others by name.
    pub(super) fn look_beside_surfaces(mut self, look: Look) -> Self {
        (self.look, self.adapts_surfaces) = (look, false);
        self
    }

    /// Sets the camera. Default: the look's view, fitted to the scene, with a vertical field of
    /// view of 40 degrees.
    pub fn camera(mut self, camera: Camera) -> Self {
        self.camera = CameraChoice::Given(camera);
        self
    }

    /// Fits a perspective camera: in `view`, it shows the whole scene as large as the picture
    /// allows. `fov_degrees` is the vertical field of view.
    pub fn fitted_camera(mut self, view: View, fov_degrees: f64) -> Self {
        self.camera = CameraChoice::Fitted(Some(view), Fit::Perspective(fov_degrees));
        self
    }

    /// Fits a camera with parallel rays: in `view`, it shows the whole scene as large as the
    /// picture allows.
    pub fn fitted_orthographic_camera(mut self, view: View) -> Self {
        self.camera = CameraChoice::Fitted(Some(view), Fit::Orthographic);
        self
    }

    /// Sets the extent of the scene that a fitted camera shows. Default: [`Framing::Volume`] in
    /// [`Look::Plain`], otherwise [`Framing::Visible`].
    pub fn framing(mut self, framing: Framing) -> Self {
        self.framing = Some(framing);
        self
    }

    /// Sets the depth buffer for the picture's AOV `z`. Default: 0 is near, with planes around the
    /// scene.
    pub fn depth_buffer(mut self, depth_buffer: DepthBuffer) -> Self {
        self.depth_buffer = depth_buffer;
        self
    }

    /// Sets the lights, at most [`MAX_LIGHTS`]; may be empty. Default: the look's. [`Look::Plain`]
    /// has one from the direction (-0.6, 0.6, -0.1) with irradiance 1.
    pub fn lights(mut self, lights: Vec<Light>) -> Self {
        self.lights = Some(lights);
        self
    }

    /// Sets the direction toward the look's light, in world space and of any length. The light
    /// keeps its colour. A look without a light gets a white one of irradiance 1. Default: the
    /// look's direction.
    pub fn light_toward(mut self, direction: DVec3) -> Self {
        self.light_toward = Some(direction);
        self
    }

    /// Sets the apparent diameter of the look's light in degrees, from 0 to 90. Default: 0.53, the
    /// sun's.
    pub fn light_angle(mut self, degrees: f64) -> Self {
        self.light_angle = degrees;
        self
    }

    /// Sets the environment map. Surfaces with the ambient variant `environment` see it instead of
    /// constant ambient light. Default: a generated sky.
    pub fn environment(mut self, environment: impl Into<Arc<Environment>>) -> Self {
        self.environment = Some(environment.into());
        self
    }

    /// Sets the linear ambient irradiance. Default: the look's, 0.12 each in [`Look::Plain`].
    pub fn ambient(mut self, ambient: Vec3) -> Self {
        self.ambient = Some(ambient);
        self
    }

    /// Sets the background, shown by pixels that no surface covers. Default: the look's, dark grey
    /// (0.05) in [`Look::Plain`].
    pub fn background(mut self, background: impl Into<Background>) -> Self {
        self.background = Some(background.into());
        self
    }

    /// Sets width and height of the picture in pixels, each from 1 to
    /// [`MAX_IMAGE_SIDE`](super::MAX_IMAGE_SIDE). Default: 800 and 600.
    ///
    /// In the view `top` with parallel rays, the default is 800 for the longer side in the scene's
    /// proportions, except in [`Look::Plain`].
    pub fn size(mut self, width: u32, height: u32) -> Self {
        self.size = Some([width, height]);
        self
    }

    /// Sets the samples per pixel, from 1 to [`MAX_SAMPLES`]. The colour is their mean in linear
    /// light. All other values belong to the pixel's centre. Default: 4.
    pub fn samples(mut self, samples: u32) -> Self {
        self.samples = samples;
        self
    }

    /// Sets the exposure in stops, from -[`MAX_EXPOSURE`] to [`MAX_EXPOSURE`]. Each stop doubles
    /// the light. Default: the look's, 0 in [`Look::Plain`].
    pub fn exposure(mut self, stops: f32) -> Self {
        self.exposure = Some(stops);
        self
    }

    /// Sets the tone curve, which follows the exposure. Default: the look's, none in
    /// [`Look::Plain`].
    pub fn tone(mut self, tone: Tone) -> Self {
        self.tone = Some(tone);
        self
    }

    /// Sets the backend that computes the picture. Default: a GPU if there is one, otherwise the
    /// CPU.
    pub fn backend(mut self, backend: BackendChoice) -> Self {
        self.backend = backend;
        self
    }

    /// Sets the sampling of textures. Default: exact.
    pub fn sampling(mut self, sampling: Sampling) -> Self {
        self.sampling = sampling;
        self
    }

    /// Sets the memory limit for all displaced triangles and what is built on them. A picture that
    /// needs more is refused before memory is allocated. Default: 4 GiB.
    pub fn geometry_memory(mut self, memory: ByteSize) -> Self {
        self.geometry_memory = memory;
        self
    }

    /// Sets whether displaced triangles of the geometry `remesh` are left out if neither the camera
    /// nor a light can see them. The picture does not change. Default: `true`.
    pub fn culls(mut self, culls: bool) -> Self {
        self.culls = culls;
        self
    }

    /// Checks all values and returns the scene.
    ///
    /// # Errors
    ///
    /// When there is no surface or there are too many lights; when size, samples or exposure is out
    /// of range, or a colour is negative or not finite; when a surface's selection cannot trace
    /// view rays; when an environment map is given that no surface sees, or a surface refracts
    /// light without seeing one; when a normal map or creases are chosen for a surface that uses
    /// its vertices' normals.
    pub fn build(mut self) -> Result<Scene, ValueError> {
        let look = self.look.parts();
        let framing = self.framing.unwrap_or(look.framing);
        let size = match (self.size, self.camera) {
            (Some(size), _) => check_size(size)?,
            (None, CameraChoice::Fitted(view, fit))
                if framing.fills_to_border(view.unwrap_or(look.view), fit) =>
            {
                let [width, height] = DEFAULT_SIZE;
                let view = view.unwrap_or(look.view);
                proportional_size(&self.surfaces, view, width.max(height)).unwrap_or(DEFAULT_SIZE)
            }
            (None, _) => DEFAULT_SIZE,
        };
        if self.adapts_surfaces {
            self.look.adapt(&mut self.surfaces, size);
        }
        if !(1..=MAX_SAMPLES).contains(&self.samples) {
            let value = f64::from(self.samples);
            return Err(ValueProblem::Number { value, must: "from 1 to 1024" }.of("samples"));
        }
        let exposure = self.exposure.unwrap_or(look.exposure);
        if !(-MAX_EXPOSURE..=MAX_EXPOSURE).contains(&exposure) {
            let value = f64::from(exposure);
            return Err(ValueProblem::Number { value, must: "from -32 to 32 stops" }.of("exposure"));
        }
        if self.surfaces.is_empty() {
            return Err(ValueProblem::NoSurface.of("surfaces"));
        }
        let problem = |key: &'static str| move |problem: ValueProblem| problem.of(key);
        let colour = |key: &'static str, colour: Vec3| {
            checked_colour(colour).map_err(ValueProblem::from).map_err(problem(key))
        };
        let ambient = colour("ambient-color", self.ambient.unwrap_or(look.ambient))?;
        let background = self.background.unwrap_or(look.background);
        for part in background.colours() {
            colour("background", part)?;
        }
        for surface in &self.surfaces {
            surface.selection().check().map_err(of_selection)?;
            match (surface.object(), surface.selection().object_cells()) {
                (None, Some(_)) => return Err(ValueProblem::NoObject.of("method")),
                (Some(_), None) => return Err(ValueProblem::Object.of("method")),
                (Some(object), Some(_)) => object
                    .check(surface.selection())
                    .map_err(|error| ValueProblem::from(error).of("object"))?,
                (None, None) => {}
            }
            match (surface.solids(), surface.selection().solids()) {
                (has, shown) if has == shown => {}
                (Solids::Volumes, _) => return Err(ValueProblem::Volume.of("method")),
                (Solids::Motifs, _) => return Err(ValueProblem::Motif.of("method")),
                (_, Solids::Motifs) => return Err(ValueProblem::NoMotif.of("method")),
                _ => return Err(ValueProblem::NoVolume.of("method")),
            }
            if surface.motif().is_some() && surface.normal_map().is_some() {
                return Err(ValueProblem::NormalsOfMotif.of("normal"));
            }
            if surface.volume().is_some() && surface.normal_map().is_some() {
                return Err(ValueProblem::NormalsOfVolume.of("normal"));
            }
            if !surface.selection().has_normals_of_relief() {
                if surface.normal_map().is_some() {
                    return Err(ValueProblem::VertexNormals.of("normal"));
                }
                if surface.has_creases() {
                    return Err(ValueProblem::VertexNormals.of("creases"));
                }
            }
            if surface.material().transmission() > 0.0 && !surface.selection().sees_environment() {
                return Err(ValueProblem::Needs(&AMBIENT_ENVIRONMENT).of("transmission"));
            }
        }
        let is_seen = background == Background::Environment
            || self.surfaces.iter().any(|surface| surface.selection().sees_environment());
        if self.environment.is_some() && !is_seen {
            return Err(ValueProblem::Needs(&AMBIENT_ENVIRONMENT).of("environment"));
        }
        let camera = match self.camera {
            CameraChoice::Given(camera) => camera,
            CameraChoice::Fitted(view, fit) => {
                let fitted = match framing {
                    Framing::Volume => fitted,
                    Framing::Visible => fitted_to_visible,
                };
                fitted(&self.surfaces, view.unwrap_or(look.view), fit, size).map_err(|error| {
                    let key = if matches!(error, CameraError::BadFov(_)) { "fov" } else { "view" };
                    ValueProblem::from(error).of(key)
                })?
            }
        };
        if let Some((key, value, must)) = self.depth_buffer.problem(camera.is_orthographic()) {
            return Err(ValueProblem::Number { value, must }.of(key));
        }
        let lights = match self.lights {
            Some(lights) => lights,
            None => look.lights(&camera, self.light_angle, self.light_toward).map_err(|error| {
                let is_size = matches!(error, LightError::BadDiameter(_));
                ValueProblem::from(error).of(if is_size { "light-angle" } else { "light" })
            })?,
        };
        if lights.len() > MAX_LIGHTS {
            return Err(ValueProblem::from(LightError::TooMany(lights.len())).of("lights"));
        }
        Ok(Scene {
            surfaces: self.surfaces,
            camera,
            depth_buffer: self.depth_buffer,
            lights,
            ambient,
            environment: self.environment,
            background,
            size,
            samples: self.samples,
            exposure,
            tone: self.tone.unwrap_or(look.tone),
            backend: self.backend,
            sampling: self.sampling,
            geometry_memory: self.geometry_memory,
            culls: self.culls,
            notes: Vec::new(),
        })
    }
}

/// Returns the error of a selection with the scene's key that caused it.
pub(super) fn of_selection(error: SelectionError) -> ValueError {
    let key = match &error {
        // An unknown name is a method's, or a stage's by its title.
        SelectionError::Unknown(unknown) => {
            STAGES.iter().find(|stage| stage.title == unknown.kind).map_or("method", |stage| stage.key)
        }
        SelectionError::Impossible { key, .. } | SelectionError::OneLevel { key, .. } => key,
        SelectionError::Pair { taker: (key, _), .. } => key,
        SelectionError::Surface { key, .. } => key,
        _ => "set",
    };
    ValueProblem::from(Box::new(error)).of(key)
}
