//! Cameras and sizes of scenes, judged by their pictures.

mod framing;
mod map_size;

use std::fs;
use std::path::{Path, PathBuf};

use glam::{DVec3, Vec3};
use proptest::prelude::*;
use relief_core::mesh::{Builtin, square};
use relief_core::{HeightMap, Wrap};
use relief_scene::{
    BackendChoice, Framing, PictureSize, ProjectionChoice, Scene, SceneBuilder, SceneSpec, Surface,
    SurfaceSpec, View,
};
use relief_shaders::Selection;

/// A file of the project, from its root.
fn shipped(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(path)
}

fn flat() -> Surface {
    let map = HeightMap::new(1, 1, vec![0.5], Wrap::Repeat).expect("a valid map");
    Surface::new(square(1).expect("a mesh"), map)
}
