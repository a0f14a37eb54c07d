//! Any bytes as a mesh's file: an error or a mesh with frames, never a crash, never more memory than allowed.

#![no_main]

use libfuzzer_sys::fuzz_target;
use relief_core::mesh::UvProjection;
use relief_io::{MeshOptions, Source, Up, read_mesh};

/// Enough for every small file, and far below the fuzzer's own limit.
const MAX_BYTES: u64 = 64 << 20;

fuzz_target!(|bytes: &[u8]| {
    // The first byte chooses the format and the projection, the rest is the file.
    let Some((&choice, bytes)) = bytes.split_first() else { return };
    let name = ["a.gltf", "a.glb", "a.obj", "a.ply", "a.stl"][usize::from(choice) % 5];
    let projection = UvProjection::ALL.get(usize::from(choice / 5) % 4).copied();
    let up = [None, Some(Up::Y), Some(Up::Z)][usize::from(choice) % 3];
    let options = MeshOptions { projection, up, colors: choice >= 128, max_bytes: MAX_BYTES };
    if let Ok(file) = read_mesh(Source::bytes(name, bytes), &options) {
        assert!(!file.mesh.triangles().is_empty());
        for vertex in file.mesh.vertices() {
            assert!((vertex.normal.length() - 1.0).abs() < 1e-5);
            assert!(vertex.tangent.length() > 0.0 && vertex.bitangent.length() > 0.0);
        }
        file.mesh.measures();
    }
});
