//! Shared parts of tests across crates and benchmarks: cases of both backends, exported shaders, claims. What
//! needs the core alone is in `relief-testing`. Never published.

pub mod accuracy;
pub mod adapter;
pub mod baked;
pub mod cast;
pub mod claims;
pub mod compilers;
pub mod curved;
pub mod detail;
pub mod exported;
pub mod glb;
pub mod motif_rays;
pub mod object_pictures;
pub mod objects;
pub mod one_source;
pub mod pairs;
pub mod probes;
pub mod shadows;
pub mod slices;
pub mod spheres;
pub mod translucent;
pub mod volume_rays;

use std::path::PathBuf;

use relief_core::mesh::Mesh;
use relief_io::{MeshOptions, read_mesh};

/// The folder of real maps, from the environment variable `RELIEF_DATA`; `None` when unset or absent, and
/// then a test that needs it skips and says so.
pub fn data_dir() -> Option<PathBuf> {
    std::env::var_os("RELIEF_DATA").map(PathBuf::from).filter(|folder| folder.is_dir())
}

/// A mesh of spot in that folder: `spot_triangulated.obj`, without any symmetry but one, or
/// `spot_control_mesh.obj`, which it was made from. `None` where the folder is absent, which is said.
///
/// # Panics
///
/// When the folder has no such mesh.
pub fn spot(name: &str) -> Option<Mesh> {
    let Some(folder) = data_dir() else {
        println!("skipped: RELIEF_DATA names no folder of data");
        return None;
    };
    let file = folder.join("spot").join(name);
    Some(read_mesh(&file, &MeshOptions::default()).unwrap_or_else(|error| panic!("{error}")).mesh)
}
