//! A complete scene, its surfaces, their descriptions in files, and the way from one to the other.

mod builder;
mod choices;
mod color_place;
mod error;
mod file;
mod framing;
mod keys;
mod keys_table;
mod light_direction;
mod limits;
mod load;
mod load_surface;
mod look;
mod maps;
mod mesh_choice;
mod mesh_defaults;
mod metres;
mod object;
mod picture_size;
mod seen_heights;
mod settings;
mod spec;
mod surface;
mod surface_colors;
mod surface_spec;
mod view;

pub use builder::SceneBuilder;
pub use choices::{BackendChoice, ProjectionChoice};
pub use color_place::ColorPlace;
pub use error::{SceneError, ValueError, ValueProblem};
pub use file::{parse_scene, read_scene};
pub use framing::Framing;
pub use keys_table::{Form, Key, keys};
pub use light_direction::{LightDirection, LightDirectionError};
pub use limits::{DEFAULT_MAX_MEMORY, DEFAULT_SAMPLES, MAX_EXPOSURE, MAX_IMAGE_SIDE, MAX_SAMPLES};
pub use look::Look;
pub use mesh_choice::{MeshChoice, UnknownMesh};
pub use object::{ObjectProblem, SceneObject};
pub use picture_size::{MapSizeProblem, PictureSize, PictureSizeError};
pub use spec::{LightSpec, SceneSpec};
pub use surface::Surface;
pub use surface_colors::{DrawnMaterial, SurfaceColors};
pub use surface_spec::{MaterialSpec, SurfaceSpec};
pub use view::View;

use crate::background::Background;
use crate::depth_buffer::DepthBuffer;
use crate::environment::Environment;
use crate::light::Light;
use crate::tone::Tone;
use glam::Vec3;
use relief_core::ByteSize;
use relief_core::camera::Camera;
pub use relief_core::mesh::UvProjection;
use relief_io::ReadNote;
use relief_shaders::Selection;
pub use relief_shaders::wgsl::Sampling;
use std::sync::Arc;

/// A complete scene.
#[derive(Clone, Debug)]
pub struct Scene {
    pub(crate) surfaces: Vec<Surface>,
    pub(crate) camera: Camera,
    pub(crate) depth_buffer: DepthBuffer,
    pub(crate) lights: Vec<Light>,
    pub(crate) ambient: Vec3,
    pub(crate) environment: Option<Arc<Environment>>,
    pub(crate) background: Background,
    pub(crate) size: [u32; 2],
    pub(crate) samples: u32,
    pub(crate) exposure: f32,
    pub(crate) tone: Tone,
    pub(crate) backend: BackendChoice,
    pub(crate) sampling: Sampling,
    pub(crate) geometry_memory: ByteSize,
    pub(crate) culls: bool,
    pub(crate) notes: Vec<ReadNote>,
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

    /// Moves the camera. The lights stay where they are, also the light of a [`Look`].
    pub fn set_camera(&mut self, camera: Camera) {
        self.camera = camera;
    }

    /// The depth buffer that the picture's `z` are of.
    pub fn depth_buffer(&self) -> DepthBuffer {
        self.depth_buffer
    }

    /// The lights, at most [`MAX_LIGHTS`](crate::light::MAX_LIGHTS).
    pub fn lights(&self) -> &[Light] {
        &self.lights
    }

    /// Irradiance that reaches every surface from everywhere.
    pub fn ambient(&self) -> Vec3 {
        self.ambient
    }

    /// The surroundings, which surfaces with the ambient light `environment` see; none for a generated sky.
    pub fn environment(&self) -> Option<&Arc<Environment>> {
        self.environment.as_ref()
    }

    /// What pixels show that no surface covers.
    pub fn background(&self) -> Background {
        self.background
    }

    /// Width and height of the picture in pixels.
    pub fn size(&self) -> [u32; 2] {
        self.size
    }

    /// Samples of a pixel.
    pub fn samples(&self) -> u32 {
        self.samples
    }

    /// Stops by which light is brightened.
    pub fn exposure(&self) -> f32 {
        self.exposure
    }

    /// The tone curve.
    pub fn tone(&self) -> Tone {
        self.tone
    }

    /// The surroundings, where they are seen behind the scene.
    pub fn environment_behind(&self) -> Option<Arc<Environment>> {
        let is_seen = self.background == Background::Environment;
        is_seen.then(|| self.environment.clone().unwrap_or_else(Environment::sky))
    }

    /// What computes the picture. Where that is not said it is the CPU if a surface's shadows are rays
    /// through the whole scene, and a GPU, of any kind, if the images of an object are counted in a stencil
    /// buffer.
    pub fn backend(&self) -> BackendChoice {
        let any = |of: fn(&Selection) -> bool| self.surfaces.iter().any(|surface| of(surface.selection()));
        if self.backend != BackendChoice::Auto {
            self.backend
        } else if any(|selection| selection.rays_through_scene().is_some()) {
            BackendChoice::Cpu
        } else if any(Selection::counts_in_stencil) {
            BackendChoice::Gpu
        } else {
            BackendChoice::Auto
        }
    }

    /// How textures are read.
    pub fn sampling(&self) -> Sampling {
        self.sampling
    }

    /// The most memory that all displaced triangles may take, with what is built on them.
    pub fn geometry_memory(&self) -> ByteSize {
        self.geometry_memory
    }

    /// What the readers of its files left out or assumed.
    pub fn notes(&self) -> &[ReadNote] {
        &self.notes
    }

    /// Whether displaced triangles that nothing sees are left out.
    pub fn culls(&self) -> bool {
        self.culls
    }
}

#[cfg(test)]
mod tests;
