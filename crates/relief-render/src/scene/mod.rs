//! Scenes: everything that a picture is made from.
//!
//! * [`Scene`] is complete, loaded and checked; the backends take it. Programs make one with a [`SceneBuilder`].
//! * [`SceneSpec`] is a description with gaps: a scene file is one, the command line's flags are another, laid over the
//!   first. [`SceneSpec::load`] reads the files that it names and gives a [`Scene`].

mod builder;
mod choices;
mod error;
mod file;
mod load;
mod spec;

pub use builder::{MAX_IMAGE_SIDE, SceneBuilder};
pub use choices::{BackendChoice, Sampling};
pub use error::{SceneError, ValueError, ValueProblem};
pub use file::read_scene;
pub use load::DEFAULT_MAX_MEMORY;
pub use spec::{LightSpec, MaterialSpec, SceneSpec};

use crate::camera::Camera;
use crate::light::Light;
use crate::material::Material;
use crate::mesh::Mesh;
use glam::Vec3;
use relief_core::{HeightMap, Metric};
use relief_io::Picture;
use relief_shaders::Selection;

/// A complete scene.
#[derive(Clone, Debug)]
pub struct Scene {
    pub(crate) mesh: Mesh,
    pub(crate) height_map: HeightMap,
    pub(crate) color: Option<Picture>,
    pub(crate) normal_map: Option<Picture>,
    pub(crate) camera: Camera,
    pub(crate) lights: Vec<Light>,
    pub(crate) ambient: Vec3,
    pub(crate) material: Material,
    pub(crate) background: Vec3,
    pub(crate) size: [u32; 2],
    pub(crate) selection: Selection,
    pub(crate) backend: BackendChoice,
    pub(crate) sampling: Sampling,
    pub(crate) two_sided: bool,
}

impl Scene {
    /// Starts a scene in which that height map lies on the built-in plane; everything else has its default, which the
    /// builder's functions state.
    pub fn builder(height_map: HeightMap) -> SceneBuilder {
        SceneBuilder::new(height_map)
    }

    /// The base mesh, tiled.
    pub fn mesh(&self) -> &Mesh {
        &self.mesh
    }

    /// The height map with its wrap and displacement.
    pub fn height_map(&self) -> &HeightMap {
        &self.height_map
    }

    /// The colour picture, if there is one; it multiplies the material's diffuse colour and is laid out and wrapped as
    /// the height map is.
    pub fn color(&self) -> Option<&Picture> {
        self.color.as_ref()
    }

    /// The normal map, if there is one: in each texel a unit normal in tangent space, `x` along growing `u`, `y` along
    /// falling `v`, `z` out of the surface, and a 0. Without one, normals are derived from the height map.
    pub fn normal_map(&self) -> Option<&Picture> {
        self.normal_map.as_ref()
    }

    /// The metres of the surface: of a tile on the mean over the mesh, and of the relief.
    pub fn metric(&self) -> Metric {
        Metric { tile_m: self.mesh.tile_m(), scale_m: self.height_map.scale_m() }
    }

    /// The camera.
    pub fn camera(&self) -> &Camera {
        &self.camera
    }

    /// The lights, at most [`MAX_LIGHTS`](crate::light::MAX_LIGHTS).
    pub fn lights(&self) -> &[Light] {
        &self.lights
    }

    /// Irradiance that reaches every surface from everywhere.
    pub fn ambient(&self) -> Vec3 {
        self.ambient
    }

    /// The material.
    pub fn material(&self) -> &Material {
        &self.material
    }

    /// Linear colour of pixels that show no surface.
    pub fn background(&self) -> Vec3 {
        self.background
    }

    /// Width and height of the picture in pixels.
    pub fn size(&self) -> [u32; 2] {
        self.size
    }

    /// What is run: how the first hit is found, and how it is shaded.
    pub fn selection(&self) -> &Selection {
        &self.selection
    }

    /// What computes the picture.
    pub fn backend(&self) -> BackendChoice {
        self.backend
    }

    /// How textures are read.
    pub fn sampling(&self) -> Sampling {
        self.sampling
    }

    /// Whether triangles seen from behind are drawn.
    pub fn two_sided(&self) -> bool {
        self.two_sided
    }
}

#[cfg(test)]
mod tests;
