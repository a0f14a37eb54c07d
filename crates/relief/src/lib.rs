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
//! | [`session`] | a scene as one document that actions change, with undo, for viewers and editors |
//! | [`render`] | pictures of scenes, on the CPU |
//! | [`render::gpu`] | the same pictures on a GPU; its feature is `gpu` |
//!
//! `glam` is the crate whose vectors and matrices the interfaces use. The feature `lanes` adds SIMD for AVX2,
//! AVX-512 and NEON.
//!
//! The examples below are the files in `examples/`; tests run them.
//!
//! # Load and inspect
//!
#![cfg_attr(
    all(feature = "io", not(doctest)),
    doc = concat!("```\n", include_str!("../examples/inspect.rs"), "```")
)]
//!
//! # Render a scene to a PNG
//!
#![cfg_attr(
    all(feature = "render", not(doctest)),
    doc = concat!("```\n", include_str!("../examples/render.rs"), "```")
)]
//!
//! # Render a volume on a mesh
//!
#![cfg_attr(
    all(feature = "render", not(doctest)),
    doc = concat!("```\n", include_str!("../examples/volume.rs"), "```")
)]
//!
//! # Bake the maps of a material
//!
#![cfg_attr(
    all(feature = "bake", feature = "io", not(doctest)),
    doc = concat!("```\n", include_str!("../examples/material.rs"), "```")
)]
//!
//! # Compare methods
//!
#![cfg_attr(
    all(feature = "compare", not(doctest)),
    doc = concat!("```\n", include_str!("../examples/compare.rs"), "```")
)]
//!
//! # Bake a map to a file
//!
#![cfg_attr(
    all(feature = "bake", feature = "io", not(doctest)),
    doc = concat!("```\n", include_str!("../examples/bake.rs"), "```")
)]
//!
//! # Trace rays, exactly and by a method
//!
#![cfg_attr(
    all(feature = "maps", not(doctest)),
    doc = concat!("```\n", include_str!("../examples/rays.rs"), "```")
)]
//!
//! # Displace a mesh into a file
//!
#![cfg_attr(
    all(feature = "displace", feature = "io", not(doctest)),
    doc = concat!("```\n", include_str!("../examples/mesh.rs"), "```")
)]
//!
//! # Find the difference between two meshes
//!
#![cfg_attr(
    all(feature = "bake", feature = "io", not(doctest)),
    doc = concat!("```\n", include_str!("../examples/between.rs"), "```")
)]
//!
//! # Capture a mesh as images with depth
//!
#![cfg_attr(
    all(feature = "capture", not(doctest)),
    doc = concat!("```\n", include_str!("../examples/capture.rs"), "```")
)]
//!
//! # Render several surfaces and frames
//!
#![cfg_attr(
    all(feature = "render", not(doctest)),
    doc = concat!("```\n", include_str!("../examples/frames.rs"), "```")
)]
//!
//! # Draw with a device of the program's own
//!
#![cfg_attr(
    all(feature = "gpu", not(doctest)),
    doc = concat!("```\n", include_str!("../examples/device.rs"), "```")
)]
//!
//! # Export a shader for another program
//!
#![cfg_attr(
    all(feature = "export", not(doctest)),
    doc = concat!("```\n", include_str!("../examples/export.rs"), "```")
)]
//!
//! # On the web
//!
//! Everything compiles for `wasm32-unknown-unknown`. Keep files in memory ([`io::Files`]), and baked maps,
//! too. Draw on the CPU in one thread, with the same hits to the last bit, or on a GPU with the functions
//! that are `async`. What panics there are the functions that wait for a GPU,
//! [`Gpu::new`](render::gpu::Gpu::new), [`GpuRenderer::render`](render::gpu::GpuRenderer::render) and
//! [`block_on`](render::block_on).

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
/// Scenes as documents that actions change: for viewers, editors and scripts.
#[cfg(feature = "session")]
pub use relief_session as session;
/// Methods, and their shaders as WGSL and as Rust.
pub use relief_shaders as shaders;

/// Runs the examples, which documentation shows and cargo builds before the tests of this crate.
#[cfg(test)]
mod tests {
    use std::path::PathBuf;
    use std::process::Command;

    #[test]
    fn every_example_runs() {
        let exe = std::env::current_exe().expect("a test is a file");
        let built = exe.parent().and_then(|deps| deps.parent()).expect("a target folder").join("examples");
        let sources = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("examples");
        let mut names: Vec<_> = std::fs::read_dir(&sources)
            .expect("the examples")
            .map(|file| file.expect("an example").path().file_stem().expect("a name").to_owned())
            .collect();
        names.sort();
        assert!(names.len() >= 12, "{names:?}");
        for name in names {
            let folder = tempfile::tempdir().expect("a temporary folder");
            let run = Command::new(built.join(&name).with_extension(std::env::consts::EXE_EXTENSION))
                .current_dir(folder.path())
                .env("TMPDIR", folder.path())
                .env("TEMP", folder.path())
                .output()
                .unwrap_or_else(|error| panic!("{name:?}: {error}; `cargo test -p relief` builds it"));
            let said = String::from_utf8_lossy(&run.stderr);
            assert!(run.status.success() && !run.stdout.is_empty(), "{name:?}: {said}");
        }
    }
}
