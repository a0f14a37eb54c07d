//! Scenes for displacement mapping: surfaces, lights, materials, cameras and looks, without a
//! renderer.
//!
//! * [`Scene`] is complete, loaded and checked. Renderers take it. A [`SceneBuilder`] makes one in
//!   a program.
//! * [`SceneSpec`] describes a scene and leaves gaps. A scene file is one description. The command's
//!   flags are another and override the file. [`SceneSpec::load`] reads the named files and returns
//!   a [`Scene`].
//! * [`keys`] lists every key of a scene file with its type, default and meaning.
//!
//! ```
//! use relief_core::{HeightMap, Wrap, mesh::torus};
//! use relief_scene::{Look, Scene, Surface, View};
//!
//! let heights = HeightMap::from_fn(64, 64, Wrap::Repeat, |i, j| ((i ^ j) & 8) as f32 / 8.0)?;
//! let surface = Surface::new(torus(96, 48)?, heights.with_displacement(0.02, 0.0)?);
//! let scene = Scene::builder(surface).look(Look::Sun).fitted_camera(View::Front, 40.0).build()?;
//! assert_eq!((scene.size(), scene.lights().len()), ([800, 600], 1));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Lights, materials, environment maps, backgrounds, depth buffers and tone curves each have a
//! module.

pub mod background;
pub mod depth_buffer;
pub mod engine_material;
pub mod environment;
pub mod light;
pub mod material;
pub mod material_maps;
pub mod motif;
mod scene;
pub mod shadow_map;
pub mod tone;

pub use scene::{
    BackendChoice, BadBase, BaseThickness, ColorPlace, DEFAULT_DIVIDER, DEFAULT_MAX_MEMORY, DEFAULT_SAMPLES,
    DrawnMaterial, Form, Framing, Key, KeyGroup, KeyNumber, LightDirection, LightDirectionError, LightSpec,
    Look, MAX_EXPOSURE, MAX_IMAGE_SIDE, MAX_SAMPLES, MapSizeProblem, MaterialSpec, MeshChoice, NO_MAP,
    ObjectProblem, PictureSize, PictureSizeError, ProjectionChoice, RampChoice, RampError, Sampling, Scene,
    SceneBuilder, SceneError, SceneObject, SceneReader, SceneSpec, Shown, Surface, SurfaceColors,
    SurfaceSpec, UnknownMesh, UnknownRamp, UvProjection, ValueError, ValueProblem, View, ViewerSpec,
    depth_remark, green_remark, keys, parse_scene, parse_values, read_scene, viewer_keys,
};
