//! Descriptions of scenes, with gaps.

use super::keys::{amount, background, length, lengths, light_direction, numbers, parsed, picture_size};
use super::{BackendChoice, Look, PictureSize, ProjectionChoice, Sampling, SurfaceSpec, View};
use crate::background::Background;
use crate::depth_buffer::Clip;
use crate::tone::Tone;
use relief_core::ByteSize;
use relief_shaders::{AMBIENT, STAGES};
use serde::Deserialize;
use std::path::PathBuf;

/// A scene as a scene file or the command line describes it: what is not said is `None` and has a default.
///
/// The keys of a scene file are the fields' names with `-` for `_`, and those are the flags of the command
/// line.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields, default)]
pub struct SceneSpec {
    /// What every surface is unless it says otherwise. Its keys stand in the scene file itself.
    #[serde(skip)]
    pub surface: SurfaceSpec,
    /// The surfaces, `[[surfaces]]` in a scene file. None: one that is as [`Self::surface`] says.
    #[serde(skip)]
    pub surfaces: Vec<SurfaceSpec>,
    /// The look: `studio` (default), `sun`, `overcast` or `plain`. It says what the camera, the lights, the
    /// light from all around, the background and the tone curve are where nothing else is said of them.
    #[serde(deserialize_with = "parsed")]
    pub look: Option<Look>,
    /// From where the camera looks that sees all of the scene, where neither `eye` nor `target` is given:
    /// `corner`, `three-quarter`, `top`, `front` or `right`. By default as the look has it.
    #[serde(deserialize_with = "parsed")]
    pub view: Option<View>,
    /// Position of the eye in metres. Without it and `target` the camera is fitted to scene and picture; with
    /// `target` alone it is (0.6, 0.9, 1.1).
    #[serde(deserialize_with = "lengths")]
    pub eye: Option<[f64; 3]>,
    /// The point looked at, in metres. With `eye` alone it is the origin.
    #[serde(deserialize_with = "lengths")]
    pub target: Option<[f64; 3]>,
    /// How space becomes a picture: `perspective` (default) or `orthographic`.
    #[serde(deserialize_with = "parsed")]
    pub projection: Option<ProjectionChoice>,
    /// Vertical field of view of a perspective in degrees. By default 40.
    pub fov: Option<f64>,
    /// Metres from the lower to the upper edge of an orthographic picture. A fitted camera knows them itself,
    /// another one needs them.
    #[serde(deserialize_with = "length")]
    pub view_height: Option<f64>,
    /// Near end of the depth buffer for the picture's `z`: `standard` (default) or `reversed`.
    #[serde(deserialize_with = "parsed")]
    pub clip: Option<Clip>,
    /// Metres from the eye to that buffer's near plane. By default it is before the scene.
    #[serde(deserialize_with = "length")]
    pub near: Option<f64>,
    /// Metres to its far plane, in perspective also `inf`. By default it is behind the scene.
    #[serde(deserialize_with = "length")]
    pub far: Option<f64>,
    /// Width and height of the picture in pixels, or `map`: one pixel for each texel, seen from above by
    /// parallel rays. By default 800 and 600. With `view` `top` and `projection` `orthographic` the default
    /// is 800 for the longer side, in the proportions of the scene, except in the look `plain`.
    #[serde(deserialize_with = "picture_size")]
    pub size: Option<PictureSize>,
    /// Samples of a pixel, 1 to 1024: more make edges smoother. By default 4.
    pub samples: Option<u32>,
    /// Stops by which light is brightened, from -32 to 32: each doubles it. By default the look's.
    pub exposure: Option<f32>,
    /// The tone curve: `none` or `agx`. By default the look's.
    #[serde(deserialize_with = "parsed")]
    pub tone: Option<Tone>,
    /// Direction toward the look's light, which keeps its colour (white and of irradiance 1 in `plain` and
    /// `overcast`): a vector, or a text such as `"az=315,alt=45"` (see
    /// [`LightDirection`](super::LightDirection)). By default the look's direction.
    #[serde(deserialize_with = "light_direction")]
    pub light: Option<[f64; 3]>,
    /// All lights, in place of `light`.
    pub lights: Option<Vec<LightSpec>>,
    /// Diameter in degrees, 0 to 90, of lights infinitely far away that do not say their own. By default
    /// 0.53, as the sun's.
    pub light_angle: Option<f64>,
    /// Radiance of the sky all around, linear red, green, blue: what a white surface reflects of it. By
    /// default the look's. In a scene file, numbers under the key `ambient` are this colour, too; surfaces
    /// then have the ambient light `constant`, unless they see surroundings.
    #[serde(deserialize_with = "numbers")]
    pub ambient_color: Option<[f32; 3]>,
    /// The surroundings' file, an equirectangular picture twice as wide as high: where it is given, surfaces
    /// see it unless they name another ambient light. By default a generated sky.
    pub environment: Option<PathBuf>,
    /// What pixels show that no surface covers: a linear colour, `gradient` or `environment`. By default the
    /// look's.
    #[serde(deserialize_with = "background")]
    pub background: Option<Background>,
    /// What computes the picture: `auto` (default), `cpu` or `gpu`.
    #[serde(deserialize_with = "parsed")]
    pub backend: Option<BackendChoice>,
    /// How textures are read: `exact` (default) or `fast`.
    #[serde(deserialize_with = "parsed")]
    pub sampling: Option<Sampling>,
    /// The most memory that maps and picture may take. By default 4 GiB.
    #[serde(deserialize_with = "amount")]
    pub max_memory: Option<ByteSize>,
}

/// A light: exactly one of `direction` and `position` is given.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields, default)]
pub struct LightSpec {
    /// Direction toward a light infinitely far away: a vector of any length, or a text such as
    /// `"az=315,alt=45"`.
    #[serde(deserialize_with = "light_direction")]
    pub direction: Option<[f64; 3]>,
    /// Position of a point light in metres.
    #[serde(deserialize_with = "lengths")]
    pub position: Option<[f64; 3]>,
    /// Linear red, green, blue. By default white.
    #[serde(deserialize_with = "numbers")]
    pub color: Option<[f32; 3]>,
    /// Factor on the colour: irradiance on a surface that faces the light (of a point light, at 1 m). By
    /// default 1.
    pub intensity: Option<f32>,
    /// Diameter of a light infinitely far away in degrees, 0 to 90.
    pub angle: Option<f64>,
    /// Radius of a point light in metres. By default 0.
    #[serde(deserialize_with = "length")]
    pub radius: Option<f64>,
}

impl SceneSpec {
    /// A description of a surface alone.
    pub fn of_surface(surface: SurfaceSpec) -> Self {
        Self { surface, ..Self::default() }
    }

    /// This description with everything that `over` says in place of what it said itself. What it says of
    /// surfaces holds for each of them; surfaces of its own take the place of all.
    ///
    /// What belongs to something replaced goes with it: of the scene's keys `light` and `lights` each other,
    /// a `view` with an eye or a target and these with a view, a `size` of the map with another view, `fov`,
    /// an infinite `far` or `view-height` with another projection, `environment` with another ambient light
    /// and the surfaces' with an environment; with another `look` lights, ambient light, background, exposure
    /// and tone curve, and not the camera; of a
    /// surface's see [`SurfaceSpec::overridden_by`].
    #[must_use]
    pub fn overridden_by(mut self, over: SceneSpec) -> SceneSpec {
        if over.look.is_some() {
            (self.light, self.lights, self.light_angle, self.ambient_color) = (None, None, None, None);
            (self.background, self.exposure, self.tone) = (None, None, None);
            for surface in self.surfaces.iter_mut().chain([&mut self.surface]) {
                surface.forget_ambient();
            }
        }
        if over.light.is_some() || over.lights.is_some() {
            (self.light, self.lights) = (None, None);
        }
        if over.eye.is_some() || over.target.is_some() {
            self.view = None;
        }
        if over.view.is_some() {
            (self.eye, self.target, self.view_height) = (None, None, None);
        }
        let is_from_elsewhere = over.eye.is_some()
            || over.target.is_some()
            || over.view.is_some_and(|view| view != View::Top)
            || over.projection == Some(ProjectionChoice::Perspective);
        if is_from_elsewhere {
            self.size = self.size.filter(|size| *size != PictureSize::Map);
        }
        match over.projection {
            Some(ProjectionChoice::Perspective) => self.view_height = None,
            Some(ProjectionChoice::Orthographic) => {
                self.fov = None;
                self.far = self.far.filter(|far| far.is_finite());
            }
            None => {}
        }
        if over.surface.names_other_ambient() {
            self.environment = None;
        } else if over.environment.is_some() && !over.surface.stages.contains_key(STAGES[AMBIENT].key) {
            for surface in self.surfaces.iter_mut().chain([&mut self.surface]) {
                surface.forget_ambient();
            }
        }
        let of_each = |surface: SurfaceSpec| surface.overridden_by(over.surface.clone());
        let surfaces = if over.surfaces.is_empty() {
            self.surfaces.into_iter().map(of_each).collect()
        } else {
            over.surfaces
        };
        SceneSpec {
            surface: self.surface.overridden_by(over.surface),
            surfaces,
            look: over.look.or(self.look),
            view: over.view.or(self.view),
            eye: over.eye.or(self.eye),
            target: over.target.or(self.target),
            projection: over.projection.or(self.projection),
            fov: over.fov.or(self.fov),
            view_height: over.view_height.or(self.view_height),
            clip: over.clip.or(self.clip),
            near: over.near.or(self.near),
            far: over.far.or(self.far),
            size: over.size.or(self.size),
            samples: over.samples.or(self.samples),
            exposure: over.exposure.or(self.exposure),
            tone: over.tone.or(self.tone),
            light: over.light.or(self.light),
            lights: over.lights.or(self.lights),
            light_angle: over.light_angle.or(self.light_angle),
            ambient_color: over.ambient_color.or(self.ambient_color),
            environment: over.environment.or(self.environment),
            background: over.background.or(self.background),
            backend: over.backend.or(self.backend),
            sampling: over.sampling.or(self.sampling),
            max_memory: over.max_memory.or(self.max_memory),
        }
    }

    /// The surfaces, each with what it does not say itself from what is said of all.
    pub fn each_surface(&self) -> Vec<SurfaceSpec> {
        if self.surfaces.is_empty() {
            return vec![self.surface.clone()];
        }
        let whole = |own: &SurfaceSpec| self.surface.clone().overridden_by(own.clone());
        self.surfaces.iter().map(whole).collect()
    }
}
