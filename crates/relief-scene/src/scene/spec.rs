//! Descriptions of scenes, as in scene files. Missing values have defaults.

use super::keys::{amount, background, length, lengths, light_direction, numbers, parsed, picture_size};
use super::{BackendChoice, Look, PictureSize, ProjectionChoice, Sampling, SurfaceSpec, View, ViewerSpec};
use crate::background::Background;
use crate::depth_buffer::Clip;
use crate::tone::Tone;
use relief_core::ByteSize;
use relief_shaders::{AMBIENT, DETAIL, Entry, STAGES};
use serde::Deserialize;
use std::path::PathBuf;

/// Description of a scene, from a scene file or the command line. A value that is `None` has a
/// default.
///
/// The keys of a scene file are the fields' names with `-` for `_`. The flags of the command line
/// have the same names.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields, default)]
pub struct SceneSpec {
    /// Common values of all surfaces, which each surface may override. In a scene file, their keys
    /// stand beside the scene's own.
    #[serde(skip)]
    pub surface: SurfaceSpec,
    /// Surfaces, `[[surfaces]]` in a scene file. If empty, the scene has one surface,
    /// [`Self::surface`].
    #[serde(skip)]
    pub surfaces: Vec<SurfaceSpec>,
    /// Look: `studio` (default), `sun`, `overcast` or `plain`. It holds the defaults of camera,
    /// lights, ambient light, background, exposure and tone curve.
    #[serde(deserialize_with = "parsed")]
    pub look: Option<Look>,
    /// Side from which a fitted camera looks: `corner`, `three-quarter`, `top`, `front` or `right`.
    /// The camera shows the whole scene. Excludes `eye` and `target`. Default: the look's view.
    #[serde(deserialize_with = "parsed")]
    pub view: Option<View>,
    /// Position of the eye in metres. Default: (0.6, 0.9, 1.1) if `target` is given, otherwise the
    /// camera is fitted to the scene.
    #[serde(deserialize_with = "lengths")]
    pub eye: Option<[f64; 3]>,
    /// Point in metres at which the camera looks. Default: the origin if `eye` is given, otherwise
    /// the camera is fitted to the scene.
    #[serde(deserialize_with = "lengths")]
    pub target: Option<[f64; 3]>,
    /// Projection of the camera: `perspective` (default) or `orthographic`.
    #[serde(deserialize_with = "parsed")]
    pub projection: Option<ProjectionChoice>,
    /// Vertical field of view of a perspective camera in degrees. Default: 40.
    pub fov: Option<f64>,
    /// Height of an orthographic picture in metres, from its lower to its upper edge. Required with
    /// `eye` or `target`; a fitted camera computes it.
    #[serde(deserialize_with = "length")]
    pub view_height: Option<f64>,
    /// Near end of the depth buffer for the picture's AOV `z`: `standard` (default, 0 is near) or
    /// `reversed` (1 is near).
    #[serde(deserialize_with = "parsed")]
    pub clip: Option<Clip>,
    /// Distance from the eye to the depth buffer's near plane in metres. Default: before the scene.
    #[serde(deserialize_with = "length")]
    pub near: Option<f64>,
    /// Distance from the eye to the depth buffer's far plane in metres. May be `inf` in
    /// perspective. Default: behind the scene.
    #[serde(deserialize_with = "length")]
    pub far: Option<f64>,
    /// Width and height of the picture in pixels, or `map`: one pixel per texel, seen from above by
    /// parallel rays. Default: 800 and 600.
    ///
    /// With `view` `top` and `projection` `orthographic`, the default is 800 for the longer side in
    /// the scene's proportions, except in the look `plain`.
    #[serde(deserialize_with = "picture_size")]
    pub size: Option<PictureSize>,
    /// Samples per pixel, 1 to 1024. More samples give smoother edges. Default: 4.
    pub samples: Option<u32>,
    /// Exposure in stops, from -32 to 32. Each stop doubles the light. Default: the look's
    /// exposure.
    pub exposure: Option<f32>,
    /// Tone curve: `none` or `agx`. Default: the look's curve.
    #[serde(deserialize_with = "parsed")]
    pub tone: Option<Tone>,
    /// Direction toward the look's light: a vector of any length, or a text such as
    /// `"az=315,alt=45"` (see [`LightDirection`](super::LightDirection)). Default: the look's
    /// direction.
    ///
    /// The light keeps its colour. In `plain` and `overcast` it is white with irradiance 1.
    #[serde(deserialize_with = "light_direction")]
    pub light: Option<[f64; 3]>,
    /// All lights, in place of `light`. Default: the look's light.
    pub lights: Option<Vec<LightSpec>>,
    /// Apparent diameter in degrees, 0 to 90, of directional lights without an `angle` of their
    /// own. Default: 0.53, as the sun's.
    pub light_angle: Option<f64>,
    /// Radiance of the sky in all directions, linear red, green and blue: the light that a white
    /// surface reflects. Default: the look's.
    ///
    /// In a scene file, three numbers under the key `ambient` set this colour, too. Surfaces then
    /// have the ambient variant `constant`, unless they use the environment map.
    #[serde(deserialize_with = "numbers")]
    pub ambient_color: Option<[f32; 3]>,
    /// File of the environment map, an equirectangular picture twice as wide as high. If given,
    /// surfaces use it unless they name another ambient variant. Default: a generated sky.
    pub environment: Option<PathBuf>,
    /// Background, shown by pixels that no surface covers: a linear colour, `gradient` or
    /// `environment`. Default: the look's background.
    #[serde(deserialize_with = "background")]
    pub background: Option<Background>,
    /// Backend that computes the picture: `auto` (default), `cpu` or `gpu`.
    #[serde(deserialize_with = "parsed")]
    pub backend: Option<BackendChoice>,
    /// Sampling of textures: `exact` (default) or `fast`.
    #[serde(deserialize_with = "parsed")]
    pub sampling: Option<Sampling>,
    /// Memory limit for maps and picture. Default: 4 GiB.
    #[serde(deserialize_with = "amount")]
    pub max_memory: Option<ByteSize>,
    /// What a viewer shows of the scene. Pictures do not depend on it.
    pub viewer: ViewerSpec,
}

/// Description of a light, with exactly one of `direction` and `position`.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields, default)]
pub struct LightSpec {
    /// Direction toward a directional light: a vector of any length, or a text such as
    /// `"az=315,alt=45"`.
    #[serde(deserialize_with = "light_direction")]
    pub direction: Option<[f64; 3]>,
    /// Position of a point light in metres.
    #[serde(deserialize_with = "lengths")]
    pub position: Option<[f64; 3]>,
    /// Linear red, green, blue. By default white.
    #[serde(deserialize_with = "numbers")]
    pub color: Option<[f32; 3]>,
    /// Factor on the colour, at least 0. The product is the irradiance on a surface that faces the
    /// light; of a point light, at 1 m. Default: 1.
    pub intensity: Option<f32>,
    /// Apparent diameter of a directional light in degrees, 0 to 90. Default: `light-angle` of the
    /// scene.
    pub angle: Option<f64>,
    /// Radius of a point light in metres. Default: 0.
    #[serde(deserialize_with = "length")]
    pub radius: Option<f64>,
}

impl SceneSpec {
    /// Creates the description of a scene with one surface and defaults.
    pub fn of_surface(surface: SurfaceSpec) -> Self {
        Self { surface, ..Self::default() }
    }

    /// Returns all files and folders that it names.
    pub fn files(&self) -> impl Iterator<Item = &PathBuf> {
        let surfaces = self.surfaces.iter().chain([&self.surface]);
        surfaces.flat_map(SurfaceSpec::files).chain(&self.environment)
    }

    /// Returns all files and folders that it names, to be changed.
    pub fn files_mut(&mut self) -> impl Iterator<Item = &mut PathBuf> {
        let Self { surfaces, surface, environment, .. } = self;
        surfaces.iter_mut().chain([surface]).flat_map(SurfaceSpec::files_mut).chain(environment)
    }

    /// Returns this description with the values of `over` in place of its own.
    ///
    /// Values for all surfaces in `over` override each surface. If `over` has surfaces, they
    /// replace all surfaces.
    ///
    /// Values that belong to a replaced value are dropped:
    ///
    /// * `light` and `lights` replace each other.
    /// * `eye` or `target` replaces `view`; `view` replaces `eye`, `target` and `view-height`.
    /// * Another view or projection replaces the size `map`.
    /// * Another `projection` drops `fov`, an infinite `far`, or `view-height`.
    /// * Another ambient variant drops `environment`; `environment` drops the surfaces' ambient variants.
    /// * Another `look` drops lights, ambient light, background, exposure and tone curve, but not the
    ///   camera.
    /// * For keys of surfaces see [`SurfaceSpec::overridden_by`].
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
            viewer: self.viewer.overridden_by(over.viewer),
        }
    }

    /// Returns this description with the finest level of the maps on every surface, unless it names a level
    /// of detail: where hits are compared with the exact ones.
    #[must_use]
    pub fn at_finest_level(mut self) -> Self {
        let finest = STAGES[DETAIL].first(Entry::is_idle).map_or("", |(_, entry)| entry.name);
        for surface in self.surfaces.iter_mut().chain([&mut self.surface]) {
            surface.stages.entry(STAGES[DETAIL].key.to_owned()).or_insert_with(|| finest.to_owned());
        }
        self
    }

    /// Returns all surfaces. Values that a surface lacks come from [`Self::surface`].
    pub fn each_surface(&self) -> Vec<SurfaceSpec> {
        if self.surfaces.is_empty() {
            return vec![self.surface.clone()];
        }
        let whole = |own: &SurfaceSpec| self.surface.clone().overridden_by(own.clone());
        self.surfaces.iter().map(whole).collect()
    }
}
