//! Descriptions of scenes, with gaps.

use super::keys::{amount, numbers, parsed};
use super::{BackendChoice, Sampling, SurfaceSpec};
use relief_core::ByteSize;
use serde::Deserialize;

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
    /// Position of the eye in metres. By default (0.6, 0.9, 1.1).
    #[serde(deserialize_with = "numbers")]
    pub eye: Option<[f64; 3]>,
    /// The point looked at, in metres. By default the origin.
    #[serde(deserialize_with = "numbers")]
    pub target: Option<[f64; 3]>,
    /// Vertical field of view in degrees. By default 40.
    pub fov: Option<f64>,
    /// Width and height of the picture in pixels. By default 800 and 600.
    #[serde(deserialize_with = "numbers")]
    pub size: Option<[u32; 2]>,
    /// Direction toward the only light, white and of irradiance 1. By default (0.5, 0.8, 0.3).
    #[serde(deserialize_with = "numbers")]
    pub light: Option<[f64; 3]>,
    /// All lights, in place of `light`.
    pub lights: Option<Vec<LightSpec>>,
    /// Irradiance from everywhere, linear red, green, blue. By default 0.15 each.
    #[serde(deserialize_with = "numbers")]
    pub ambient: Option<[f32; 3]>,
    /// Linear colour of pixels that show no surface. By default 0.05 each.
    #[serde(deserialize_with = "numbers")]
    pub background: Option<[f32; 3]>,
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
    /// Direction toward a light infinitely far away, of any length.
    #[serde(deserialize_with = "numbers")]
    pub direction: Option<[f64; 3]>,
    /// Position of a point light in metres.
    #[serde(deserialize_with = "numbers")]
    pub position: Option<[f64; 3]>,
    /// Linear red, green, blue. By default white.
    #[serde(deserialize_with = "numbers")]
    pub color: Option<[f32; 3]>,
    /// Factor on the colour: irradiance on a surface that faces the light (of a point light, at 1 m). By
    /// default 1.
    pub intensity: Option<f32>,
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
    /// of a surface's see [`SurfaceSpec::overridden_by`].
    #[must_use]
    pub fn overridden_by(mut self, over: SceneSpec) -> SceneSpec {
        if over.light.is_some() || over.lights.is_some() {
            (self.light, self.lights) = (None, None);
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
            eye: over.eye.or(self.eye),
            target: over.target.or(self.target),
            fov: over.fov.or(self.fov),
            size: over.size.or(self.size),
            light: over.light.or(self.light),
            lights: over.lights.or(self.lights),
            ambient: over.ambient.or(self.ambient),
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
