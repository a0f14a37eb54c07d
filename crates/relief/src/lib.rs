//! Displacement mapping: a height map and a mesh go in; a picture, baked maps, a displaced mesh or a shader
//! that any engine can use comes out.
//!
//! The root holds the core: [`HeightMap`], [`Path`], [`Hit`], in [`mesh`] what it lies on, and in [`exact`]
//! the answer that every faster method is judged by. Every other crate of the project is a module. All but
//! [`shaders`] have a feature of the module's name; all features are on by default.
//!
//! | module | what it is for |
//! | --- | --- |
//! | [`shaders`] | methods, their shaders as WGSL, and rays through them on the CPU |
//! | [`bake`] | auxiliary maps that methods read |
//! | [`capture`] | image-based objects: captured from meshes, read from and written to files |
//! | [`compare`] | methods beside the truth and beside each other |
//! | [`displace`] | displaced meshes without cracks, streamed |
//! | [`export`] | methods as shaders for other programs: WGSL, GLSL, HLSL, MSL, SPIR-V |
//! | [`io`] | height maps, pictures, normal maps and meshes, from and to files and bytes |
//! | [`maps`] | baked maps: looked up, baked and cached |
//! | [`scene`] | scenes and scene files: cameras, lights, materials, looks |
//! | [`render`] | pictures of scenes, on the CPU |
//! | [`render::gpu`] | the same pictures on a GPU; its feature is `gpu` |
//!
//! `glam` is the crate whose vectors and matrices the interfaces use. The feature `lanes` adds SIMD for AVX2,
//! AVX-512 and NEON.
//!
//! # Load and inspect
//!
//! ```
#![cfg_attr(feature = "io", doc = include_str!("../examples/inspect.rs"))]
//! ```
//!
//! # Bake a map to a file
//!
//! ```
#![cfg_attr(all(feature = "bake", feature = "io"), doc = include_str!("../examples/bake.rs"))]
//! ```
//!
//! # Rays, exactly and by a method
//!
//! ```
#![cfg_attr(feature = "maps", doc = include_str!("../examples/rays.rs"))]
//! ```
//!
//! # Displace a mesh into a file
//!
//! ```
#![cfg_attr(all(feature = "displace", feature = "io"), doc = include_str!("../examples/mesh.rs"))]
//! ```
//!
//! # The difference between two meshes
//!
//! ```
#![cfg_attr(all(feature = "bake", feature = "io"), doc = include_str!("../examples/between.rs"))]
//! ```
//!
//! # A mesh as images with depth
//!
//! ```
#![cfg_attr(feature = "capture", doc = include_str!("../examples/capture.rs"))]
//! ```
//!
//! # Render into memory
//!
//! ```
#![cfg_attr(feature = "render", doc = include_str!("../examples/render.rs"))]
//! ```
//!
//! # Several surfaces, several frames
//!
//! ```
#![cfg_attr(feature = "render", doc = include_str!("../examples/frames.rs"))]
//! ```
//!
//! # A device of one's own
//!
//! ```
#![cfg_attr(feature = "gpu", doc = include_str!("../examples/device.rs"))]
//! ```
//!
//! # A shader for another program
//!
//! ```
#![cfg_attr(feature = "export", doc = include_str!("../examples/export.rs"))]
//! ```
//!
//! # On the web
//!
//! Everything compiles for `wasm32-unknown-unknown`. Read files as bytes, keep maps in memory, and draw on a
//! GPU with the functions that are `async`. Two things panic there: ray casting ([`raycast`], and with it the
//! CPU backend and heights between meshes), which asks the system's clock while it builds its tree, and the
//! functions that wait for a GPU, [`Gpu::new`](render::gpu::Gpu::new),
//! [`GpuRenderer::render`](render::gpu::GpuRenderer::render) and [`block_on`](render::gpu::block_on).

pub use glam;
#[doc(inline)]
pub use relief_core::*;

/// Baking: from a height map to every map that displacement methods read.
#[cfg(feature = "bake")]
pub use relief_bake as bake;
/// Methods beside the truth and beside each other: errors, costs and pictures.
#[cfg(feature = "compare")]
pub use relief_compare as compare;
/// Methods as shaders for other programs, in any shading language, with a manifest of their bindings.
#[cfg(feature = "export")]
pub use relief_export as export;
/// Height maps, pictures, normal maps and meshes from files, and pictures, float channels and meshes to
/// files.
#[cfg(feature = "io")]
pub use relief_io as io;
/// Baked maps that methods read: looked up, baked and cached.
#[cfg(feature = "maps")]
pub use relief_maps as maps;
/// Displaced meshes: a height map and a mesh to triangles without cracks. ([`mesh`] holds the meshes
/// themselves.)
#[cfg(feature = "displace")]
pub use relief_mesh as displace;
/// Image-based objects: captured from meshes, read from and written to files. ([`object`] holds the objects
/// themselves.)
#[cfg(feature = "capture")]
pub use relief_object as capture;
/// Pictures of scenes, by two backends.
#[cfg(feature = "render")]
pub use relief_render as render;
/// Scenes and scene files, without a renderer.
#[cfg(feature = "scene")]
pub use relief_scene as scene;
/// Methods, and their shaders as WGSL and as Rust.
pub use relief_shaders as shaders;
