//! Scenes made by programs.

use super::framing::{Framing, fitted_to_seen, proportional_size};
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
use relief_shaders::{AMBIENT, STAGES, SelectionError};
use std::sync::{Arc, LazyLock};

/// The position of the eye where only the target is given, in metres.
pub(super) const DEFAULT_EYE: DVec3 = DVec3::new(0.6, 0.9, 1.1);
/// The default vertical field of view, in degrees.
pub(super) const DEFAULT_FOV: f64 = 40.0;
/// What surroundings and light that is refracted need.
pub(super) static SEEN: LazyLock<String> =
    LazyLock::new(|| format!("{} {}", STAGES[AMBIENT].key, environment()));
/// The default method.
pub(super) const DEFAULT_METHOD: &str = "exact";
/// Default method of depth objects.
pub(super) const DEFAULT_METHOD_OF_OBJECTS: &str = "depth-object";
/// The default width and height, in pixels.
pub(super) const DEFAULT_SIZE: [u32; 2] = [800, 600];

/// A scene under construction; made by [`Scene::builder`].
#[derive(Clone, Debug)]
#[must_use = "a builder makes no scene until it is built"]
pub struct SceneBuilder {
    surfaces: Vec<Surface>,
    camera: CameraChoice,
    /// Unless it is the look's.
    framing: Option<Framing>,
    depth_buffer: DepthBuffer,
    look: Look,
    /// Whether surfaces get the sky and the shadows of the look.
    adapts_surfaces: bool,
    lights: Option<Vec<Light>>,
    /// Toward the look's light, in place of the look's own direction.
    light_toward: Option<DVec3>,
    light_angle: f64,
    ambient: Option<Vec3>,
    environment: Option<Arc<Environment>>,
    background: Option<Background>,
    /// Unless the proportions of what is seen, or the default, are to say it.
    size: Option<[u32; 2]>,
    samples: u32,
    exposure: Option<f32>,
    tone: Option<Tone>,
    backend: BackendChoice,
    sampling: Sampling,
    geometry_memory: ByteSize,
    culls: bool,
}

/// A camera, or how one is to be fitted.
#[derive(Clone, Copy, Debug)]
enum CameraChoice {
    Given(Camera),
    /// From there, or from where the look has it.
    Fitted(Option<View>, Fit),
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

    /// The look: light, sky, background, tone curve and camera, as far as nothing else is said of them by the
    /// other functions. By default [`Look::Plain`].
    ///
    /// Looks with a sky are for surfaces of the ambient light `constant`, which is what nobody chose: these
    /// get `sky`, or `hemisphere` where they have no relief to read. With several surfaces the ones with the shadow
    /// `ray` get `map`, so that they throw shadows on each other. A builder of a scene that exists
    /// ([`Scene::to_builder`]) says everything else already.
    pub fn look(mut self, look: Look) -> Self {
        self.look = look;
        self
    }

    /// The same for surfaces that have the look's sky and shadows already, unless other ones were named.
    pub(super) fn look_beside_surfaces(mut self, look: Look) -> Self {
        (self.look, self.adapts_surfaces) = (look, false);
        self
    }

    /// The camera. By default one that sees all of the scene from where the look has it, with a field of view
    /// of 40 degrees.
    pub fn camera(mut self, camera: Camera) -> Self {
        self.camera = CameraChoice::Given(camera);
        self
    }

    /// The camera that looks from there and sees all of the scene as large as the picture allows, with a
    /// vertical field of view in degrees.
    pub fn fitted_camera(mut self, view: View, fov_degrees: f64) -> Self {
        self.camera = CameraChoice::Fitted(Some(view), Fit::Perspective(fov_degrees));
        self
    }

    /// The same with parallel rays, as on a map.
    pub fn fitted_orthographic_camera(mut self, view: View) -> Self {
        self.camera = CameraChoice::Fitted(Some(view), Fit::Orthographic);
        self
    }

    /// What a fitted camera goes by.
    pub fn framing(mut self, framing: Framing) -> Self {
        self.framing = Some(framing);
        self
    }

    /// Sets the depth buffer for the picture's `z`. Default: 0 is near, with planes around the scene.
    pub fn depth_buffer(mut self, depth_buffer: DepthBuffer) -> Self {
        self.depth_buffer = depth_buffer;
        self
    }

    /// The lights, at most [`MAX_LIGHTS`]; they may be none. By default the look's: in [`Look::Plain`] one
    /// from the direction (-0.6, 0.6, -0.1) with irradiance 1.
    pub fn lights(mut self, lights: Vec<Light>) -> Self {
        self.lights = Some(lights);
        self
    }

    /// The direction toward the look's light, in the world and of any length. The light keeps its colour. A
    /// look without a light gets a white one of irradiance 1. By default the direction is the look's.
    pub fn light_toward(mut self, direction: DVec3) -> Self {
        self.light_toward = Some(direction);
        self
    }

    /// The diameter of the look's light in degrees, from 0 to 90. By default 0.53, the sun's.
    pub fn light_angle(mut self, degrees: f64) -> Self {
        self.light_angle = degrees;
        self
    }

    /// The surroundings, which surfaces with the ambient light `environment` see in place of the radiance
    /// that is the same from everywhere. By default a generated sky.
    pub fn environment(mut self, environment: impl Into<Arc<Environment>>) -> Self {
        self.environment = Some(environment.into());
        self
    }

    /// Irradiance from everywhere, linear. By default the look's: of [`Look::Plain`] 0.12.
    pub fn ambient(mut self, ambient: Vec3) -> Self {
        self.ambient = Some(ambient);
        self
    }

    /// What pixels show that no surface covers. By default the look's: in [`Look::Plain`] dark grey, 0.05.
    pub fn background(mut self, background: impl Into<Background>) -> Self {
        self.background = Some(background.into());
        self
    }

    /// Width and height of the picture in pixels, each from 1 to
    /// [`MAX_IMAGE_SIDE`](super::MAX_IMAGE_SIDE). By default 800 and 600. From the view `top` by parallel
    /// rays the default is 800 for the longer side, in the scene's proportions, except in [`Look::Plain`].
    pub fn size(mut self, width: u32, height: u32) -> Self {
        self.size = Some([width, height]);
        self
    }

    /// Sets the samples per pixel, from 1 to [`MAX_SAMPLES`]. The colour is their mean in linear light; all
    /// other values belong to the pixel's centre. Default: 4.
    pub fn samples(mut self, samples: u32) -> Self {
        self.samples = samples;
        self
    }

    /// Stops by which light is brightened, from -[`MAX_EXPOSURE`] to [`MAX_EXPOSURE`]. By default the look's:
    /// of [`Look::Plain`] 0.
    pub fn exposure(mut self, stops: f32) -> Self {
        self.exposure = Some(stops);
        self
    }

    /// The tone curve, which follows. By default the look's: of [`Look::Plain`] none.
    pub fn tone(mut self, tone: Tone) -> Self {
        self.tone = Some(tone);
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

    /// The most memory that all displaced triangles may take, with what is built on them: a picture that
    /// needs more is refused before it is taken. By default 4 GiB.
    pub fn geometry_memory(mut self, memory: ByteSize) -> Self {
        self.geometry_memory = memory;
        self
    }

    /// Whether displaced triangles that are made for the camera (the geometry `remesh`) are left out where it
    /// cannot see them, if no light looks at them either. By default they are; the picture is the same.
    pub fn culls(mut self, culls: bool) -> Self {
        self.culls = culls;
        self
    }

    /// The scene.
    ///
    /// # Errors
    ///
    /// When there is no surface, the size, the samples or the exposure are out of range, there are too many
    /// lights, a colour is negative or not finite, or what a surface selects cannot trace view rays; when
    /// surroundings are given that no surface sees, or a surface refracts light and sees none; when normals
    /// are chosen for a surface that uses its vertices' normals.
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
            if !surface.selection().has_normals_of_relief() {
                if surface.normal_map().is_some() {
                    return Err(ValueProblem::VertexNormals.of("normal"));
                }
                if surface.has_creases() {
                    return Err(ValueProblem::VertexNormals.of("creases"));
                }
            }
            if surface.material().transmission() > 0.0 && !surface.selection().sees_environment() {
                return Err(ValueProblem::Needs(&SEEN).of("transmission"));
            }
        }
        let is_seen = background == Background::Environment
            || self.surfaces.iter().any(|surface| surface.selection().sees_environment());
        if self.environment.is_some() && !is_seen {
            return Err(ValueProblem::Needs(&SEEN).of("environment"));
        }
        let camera = match self.camera {
            CameraChoice::Given(camera) => camera,
            CameraChoice::Fitted(view, fit) => {
                let fitted = match framing {
                    Framing::Volume => fitted,
                    Framing::Seen => fitted_to_seen,
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

/// The error of a selection, with the key of the scene that it comes from.
pub(super) fn of_selection(error: SelectionError) -> ValueError {
    let key = match &error {
        // A name is unknown of a method, or of a stage by its title.
        SelectionError::Unknown(unknown) => {
            STAGES.iter().find(|stage| stage.title == unknown.kind).map_or("method", |stage| stage.key)
        }
        SelectionError::Impossible { key, .. } | SelectionError::OneLevel { key, .. } => key,
        SelectionError::Pair { taker: (key, _), .. } => key,
        _ => "set",
    };
    ValueProblem::from(Box::new(error)).of(key)
}
