//! Scenes, surfaces, their descriptions in scene files, and loading.

mod builder;
mod choices;
mod color_place;
mod depth;
mod error;
mod extinction;
mod file;
mod file_material;
mod framing;
mod hull_points;
mod key_groups;
mod key_numbers;
mod keys;
mod keys_table;
mod light_direction;
mod limits;
mod load;
mod load_object;
mod load_surface;
mod load_walls;
mod look;
mod maps;
mod material_spec;
mod mesh_choice;
mod mesh_defaults;
mod metres;
mod normal_green;
mod object;
mod picture_size;
mod ramp;
mod reader;
mod settings;
mod shown;
mod solids;
mod spec;
mod surface;
mod surface_colors;
mod surface_parts;
mod surface_place;
mod surface_scale;
mod surface_selection;
mod surface_spec;
mod texture_set;
mod view;
mod viewer;
mod walls;

pub use builder::SceneBuilder;
pub use choices::{BackendChoice, ProjectionChoice};
pub use color_place::ColorPlace;
pub use depth::depth_remark;
pub use error::{SceneError, ValueError, ValueProblem};
pub use file::{parse_scene, parse_values, read_scene};
pub use framing::Framing;
pub use key_groups::KeyGroup;
pub use key_numbers::KeyNumber;
pub use keys_table::{Form, Key, keys};
pub use light_direction::{LightDirection, LightDirectionError};
pub use limits::{DEFAULT_MAX_MEMORY, DEFAULT_SAMPLES, MAX_EXPOSURE, MAX_IMAGE_SIDE, MAX_SAMPLES};
pub use look::Look;
pub use material_spec::MaterialSpec;
pub use mesh_choice::{MeshChoice, UnknownMesh};
pub use normal_green::green_remark;
pub use object::{ObjectProblem, SceneObject};
pub use picture_size::{MapSizeProblem, PictureSize, PictureSizeError};
pub use ramp::{RampChoice, RampError, UnknownRamp};
pub use reader::SceneReader;
pub use shown::Shown;
pub use spec::{LightSpec, SceneSpec};
pub use surface::Surface;
pub use surface_colors::{DrawnMaterial, SurfaceColors};
pub use surface_spec::SurfaceSpec;
pub use texture_set::NO_MAP;
pub use view::View;
pub use viewer::{DEFAULT_DIVIDER, ViewerSpec, viewer_keys};
pub use walls::{BadBase, BaseThickness};

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

/// Complete scene: loaded and checked, ready for a renderer.
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
    /// Returns the surfaces, at least one. A pixel shows the nearest; ties go to the lower index.
    pub fn surfaces(&self) -> &[Surface] {
        &self.surfaces
    }

    /// Returns the camera.
    pub fn camera(&self) -> &Camera {
        &self.camera
    }

    /// Replaces the camera. Lights stay where they are, including the light of a [`Look`].
    pub fn set_camera(&mut self, camera: Camera) {
        self.camera = camera;
    }

    /// Returns the depth buffer that defines the picture's AOV `z`.
    pub fn depth_buffer(&self) -> DepthBuffer {
        self.depth_buffer
    }

    /// Returns the lights, at most [`MAX_LIGHTS`](crate::light::MAX_LIGHTS).
    pub fn lights(&self) -> &[Light] {
        &self.lights
    }

    /// Returns the linear ambient irradiance, which reaches every surface from all directions.
    pub fn ambient(&self) -> Vec3 {
        self.ambient
    }

    /// Returns the environment map for surfaces with the ambient variant `environment`. `None`
    /// stands for the generated sky.
    pub fn environment(&self) -> Option<&Arc<Environment>> {
        self.environment.as_ref()
    }

    /// Returns the background, shown by pixels that no surface covers.
    pub fn background(&self) -> Background {
        self.background
    }

    /// Returns width and height of the picture in pixels.
    pub fn size(&self) -> [u32; 2] {
        self.size
    }

    /// Returns the number of samples per pixel, from 1 to [`MAX_SAMPLES`].
    pub fn samples(&self) -> u32 {
        self.samples
    }

    /// Returns the exposure in stops. Each stop doubles the light.
    pub fn exposure(&self) -> f32 {
        self.exposure
    }

    /// Returns the tone curve, which is applied after the exposure.
    pub fn tone(&self) -> Tone {
        self.tone
    }

    /// Returns the environment map that the background shows: the scene's own, or else the
    /// generated sky. `None` if the background is a colour or a gradient.
    pub fn environment_behind(&self) -> Option<Arc<Environment>> {
        let is_seen = self.background == Background::Environment;
        is_seen.then(|| self.environment.clone().unwrap_or_else(Environment::sky))
    }

    /// Returns the backend that computes the picture.
    ///
    /// If none was chosen, it is the CPU for surfaces whose shadow rays go through the whole scene.
    /// It is a GPU, of any kind, for objects whose images are counted in a stencil buffer.
    /// Otherwise it is [`BackendChoice::Auto`].
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

    /// Returns the way in which textures are read.
    pub fn sampling(&self) -> Sampling {
        self.sampling
    }

    /// Returns the memory limit for all displaced triangles and what is built on them.
    pub fn geometry_memory(&self) -> ByteSize {
        self.geometry_memory
    }

    /// Returns notes of the file readers: what they left out or assumed.
    pub fn notes(&self) -> &[ReadNote] {
        &self.notes
    }

    /// Returns whether displaced triangles that neither the camera nor a light can see are left
    /// out.
    pub fn culls(&self) -> bool {
        self.culls
    }
}

#[cfg(test)]
mod tests;
