//! Scenes: everything that a picture is made from.
//!
//! * [`Scene`] is complete, loaded and checked; the backends take it. Programs make one with a
//!   [`SceneBuilder`].
//! * [`SceneSpec`] is a description with gaps: a scene file is one, the command line's flags are another,
//!   laid over the first. [`SceneSpec::load`] reads the files that it names and gives a [`Scene`].

mod builder;
mod choices;
mod error;
mod file;
mod keys;
mod limits;
mod load;
mod load_surface;
mod metres;
mod spec;
mod surface;
mod surface_spec;

pub use builder::SceneBuilder;
pub use choices::BackendChoice;
pub use error::{SceneError, ValueError, ValueProblem};
pub use file::read_scene;
pub use limits::{DEFAULT_MAX_MEMORY, MAX_IMAGE_SIDE};
pub use spec::{LightSpec, SceneSpec};
pub use surface::Surface;
pub use surface_spec::{MaterialSpec, SurfaceSpec};

use crate::camera::Camera;
use crate::light::Light;
use glam::Vec3;
pub use relief_shaders::wgsl::Sampling;

/// A complete scene.
#[derive(Clone, Debug)]
pub struct Scene {
    pub(crate) surfaces: Vec<Surface>,
    pub(crate) camera: Camera,
    pub(crate) lights: Vec<Light>,
    pub(crate) ambient: Vec3,
    pub(crate) background: Vec3,
    pub(crate) size: [u32; 2],
    pub(crate) backend: BackendChoice,
    pub(crate) sampling: Sampling,
}

impl Scene {
    /// The surfaces, at least one. Of several the nearest is seen; of equally near ones the first.
    pub fn surfaces(&self) -> &[Surface] {
        &self.surfaces
    }

    /// The camera.
    pub fn camera(&self) -> &Camera {
        &self.camera
    }

    /// Moves the camera.
    pub fn set_camera(&mut self, camera: Camera) {
        self.camera = camera;
    }

    /// The lights, at most [`MAX_LIGHTS`](crate::light::MAX_LIGHTS).
    pub fn lights(&self) -> &[Light] {
        &self.lights
    }

    /// Irradiance that reaches every surface from everywhere.
    pub fn ambient(&self) -> Vec3 {
        self.ambient
    }

    /// Linear colour of pixels that show no surface.
    pub fn background(&self) -> Vec3 {
        self.background
    }

    /// Width and height of the picture in pixels.
    pub fn size(&self) -> [u32; 2] {
        self.size
    }

    /// What computes the picture.
    pub fn backend(&self) -> BackendChoice {
        self.backend
    }

    /// How textures are read.
    pub fn sampling(&self) -> Sampling {
        self.sampling
    }
}

#[cfg(test)]
mod tests;
