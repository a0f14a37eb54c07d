//! What tests and benchmarks share: adversarial maps and rays, a deterministic random generator, and the
//! judge that compares one tracer with another. Never published.

pub mod accuracy;
pub mod adapter;
pub mod baked;
pub mod brute;
pub mod cast;
pub mod claims;
pub mod compilers;
pub mod curved;
pub mod detail;
pub mod displaced;
pub mod exported;
pub mod glb;
pub mod judge;
pub mod maps;
pub mod mesh_distance;
pub mod object_pictures;
pub mod objects;
pub mod one_source;
pub mod outline;
pub mod pairs;
pub mod probes;
pub mod rays;
pub mod search;
pub mod shadows;
pub mod slices;
pub mod smooth_base;
pub mod spheres;

/// Random numbers that are the same from the same seed, everywhere.
pub use relief_compare::rng;

use std::path::PathBuf;

use relief_core::mesh::Mesh;
use relief_io::{MeshOptions, read_mesh};

/// How many adversarial rays a test sends through each map in each wrap. Tests that cost more a ray take a
/// fraction of it. All test times scale with it: 25,000 makes 1.2 million rays over [`maps::ALL`] in the
/// three wraps.
pub const RAYS_PER_MAP: usize = 25_000;

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

/// The steepest slope of a map along an axis, in heights a texel.
pub fn steepest(map: &relief_core::HeightMap) -> f64 {
    let cells = (0..i64::from(map.height())).flat_map(|j| (0..i64::from(map.width())).map(move |i| (i, j)));
    cells.fold(0.0, |steepest, (i, j)| {
        let [h00, h10, h01, h11] = map.cell(i, j).map(f64::from);
        let slopes = [h10 - h00, h01 - h00, h11 - h01, h11 - h10].map(f64::abs);
        slopes.into_iter().fold(steepest, f64::max)
    })
}
