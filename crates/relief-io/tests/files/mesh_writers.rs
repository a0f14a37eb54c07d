//! Written meshes are read back unchanged; failed writes leave nothing.

use std::io;
use std::path::Path;

use crate::common::Folder;
use glam::Vec3;
use relief_core::mesh::{Mesh, MeshBlock, UvProjection, cylinder, torus};
use relief_io::{
    MeshCounts, MeshFormat, MeshOptions, WriteError, WriteProblem, read_mesh, write_atomically, write_mesh,
};

const FORMATS: [(&str, MeshFormat); 4] = [
    ("mesh.glb", MeshFormat::Gltf),
    ("mesh.ply", MeshFormat::Ply),
    ("mesh.obj", MeshFormat::Obj),
    ("mesh.stl", MeshFormat::Stl),
];

fn counts(mesh: &Mesh) -> MeshCounts {
    MeshCounts { vertices: mesh.vertices().len() as u64, triangles: mesh.triangles().len() as u64 }
}

/// The mesh in blocks: vertices first, some at a time, triangles behind them.
fn blocks(mesh: &Mesh) -> Vec<MeshBlock> {
    let vertices = mesh.vertices().chunks(37);
    let of_vertices = vertices.map(|part| MeshBlock { vertices: part.to_vec(), ..MeshBlock::default() });
    let points: Vec<Vec3> = mesh.vertices().iter().map(|vertex| vertex.position).collect();
    let of_triangles = mesh.triangles().chunks(50).map(|part| MeshBlock {
        triangles: part.to_vec(),
        points: points.clone(),
        corners: part.to_vec(),
        ..MeshBlock::default()
    });
    of_vertices.chain(of_triangles).collect()
}

fn write(path: &Path, format: MeshFormat, mesh: &Mesh) -> Result<(), WriteError> {
    write_mesh(path, format, counts(mesh), |sink| blocks(mesh).iter().try_for_each(sink))
}

fn meshes() -> [Mesh; 2] {
    [torus(23, 11), cylinder(9, 4)].map(|mesh| mesh.expect("a mesh"))
}

/// The corners of all triangles.
fn corners(mesh: &Mesh) -> Vec<[Vec3; 3]> {
    let position = |corner: u32| mesh.vertices()[corner as usize].position;
    mesh.triangles().iter().map(|corners| corners.map(position)).collect()
}

#[test]
fn written_files_are_read_back() {
    let folder = Folder::new();
    for mesh in meshes() {
        for (name, format) in FORMATS {
            let path = folder.path().join(name);
            write(&path, format, &mesh).expect("the folder is writable");
            let written = std::fs::metadata(&path).expect("it was written").len();
            let (promised, is_text) = (format.bytes(counts(&mesh)), format == MeshFormat::Obj);
            assert!(written == promised || is_text && written > promised, "{name}: {written} {promised}");
            let projection = (format == MeshFormat::Stl).then_some(UvProjection::Box);
            let options = MeshOptions { projection, ..MeshOptions::default() };
            let found = read_mesh(path.as_path(), &options).unwrap_or_else(|error| panic!("{error}"));
            assert_eq!((found.format, found.degenerate, found.double), (format, 0, 0));
            if format == MeshFormat::Stl {
                // The conversion to millimetres and back changes at most the last bit.
                let apart = corners(&found.mesh)
                    .into_iter()
                    .zip(corners(&mesh))
                    .map(|(a, b)| (0..3).map(|k| (a[k] - b[k]).abs().max_element()).fold(0.0, f32::max));
                assert!(apart.fold(0.0, f32::max) < 2e-7);
                assert_eq!(found.mesh.triangles().len(), mesh.triangles().len());
                continue;
            }
            assert_eq!(corners(&found.mesh), corners(&mesh), "{name}");
            for triangle in 0..mesh.triangles().len() as u32 {
                for (a, b) in mesh.corners(triangle).into_iter().zip(found.mesh.corners(triangle)) {
                    assert!((a.normal - b.normal).length() < 2e-7, "{name}: {} {}", a.normal, b.normal);
                    assert!((a.uv - b.uv).length() < 2e-7, "{name}: {} {}", a.uv, b.uv);
                }
            }
        }
    }
}

#[test]
fn the_same_mesh_gives_the_same_bytes() {
    let folder = Folder::new();
    let mesh = &meshes()[0];
    for (name, format) in FORMATS {
        let read = |name: &str| std::fs::read(folder.path().join(name)).expect("it was written");
        write(&folder.path().join(name), format, mesh).expect("the folder is writable");
        let first = read(name);
        write(&folder.path().join(name), format, mesh).expect("the folder is writable");
        assert_eq!(first, read(name), "{name}");
    }
}

#[test]
fn tangents_of_a_glb_are_unit_vectors_with_handedness() {
    let folder = Folder::new();
    let path = folder.path().join("mesh.glb");
    let mesh = &meshes()[0];
    // Mirrored, the other sign.
    let mut mirrored = mesh.vertices().to_vec();
    mirrored.iter_mut().for_each(|vertex| {
        vertex.uv.x = -vertex.uv.x;
        vertex.tangent = -vertex.tangent;
    });
    let mirrored = Mesh::new(mirrored, mesh.triangles().to_vec()).expect("a mesh");
    for (mesh, expected) in [(mesh, 1.0), (&mirrored, -1.0)] {
        write(&path, MeshFormat::Gltf, mesh).expect("the folder is writable");
        let bytes = std::fs::read(&path).expect("it was written");
        let buffer = bytes.len() - 48 * mesh.vertices().len() - 12 * mesh.triangles().len();
        for (vertex, stored) in mesh.vertices().iter().zip(bytes[buffer..].chunks(48)) {
            let number = |at: usize| f32::from_le_bytes(stored[4 * at..4 * at + 4].try_into().expect("four"));
            let tangent = Vec3::new(number(6), number(7), number(8));
            assert!((tangent.length() - 1.0).abs() < 1e-6 && tangent.dot(vertex.normal).abs() < 1e-6);
            assert!(tangent.dot(vertex.tangent) > 0.0);
            assert_eq!(number(9), expected);
            // The bitangent of glTF's normal maps points up in the picture, against growing v.
            let up = vertex.normal.cross(tangent) * number(9);
            assert!(up.dot(vertex.bitangent) < 0.0);
        }
    }
}

#[test]
fn refused_or_failed_writes_leave_no_file() {
    let folder = Folder::new();
    let mesh = &meshes()[0];
    let entries = || std::fs::read_dir(folder.path()).expect("the folder is there").count();
    for (name, format) in FORMATS {
        let path = folder.path().join(name);
        let MeshCounts { vertices, triangles } = counts(mesh);
        for wrong in [
            MeshCounts { vertices: vertices + 1, triangles },
            MeshCounts { vertices, triangles: triangles - 1 },
            MeshCounts { vertices: 0, triangles },
            MeshCounts { vertices: 1 << 33, triangles },
            MeshCounts { vertices, triangles: 1 << 33 },
        ] {
            let written = write_mesh(&path, format, wrong, |sink| blocks(mesh).iter().try_for_each(sink));
            assert!(written.is_err(), "{name}: {wrong:?}");
            assert_eq!(entries(), 0, "{name}: {wrong:?}");
        }
        let failed = write_mesh(&path, format, counts(mesh), |sink| {
            sink(&blocks(mesh)[0])?;
            Err(io::Error::other("no more"))
        });
        assert!(matches!(failed.map_err(|error| error.problem), Err(WriteProblem::Io(_))));
        assert_eq!(entries(), 0, "{name}");
        // An existing file stays.
        write_atomically(&path, |out| out.write_all(b"old")).expect("the folder is writable");
        assert!(write_mesh(&path, format, counts(mesh), |_| Ok(())).is_err());
        assert_eq!(std::fs::read(&path).expect("it is there"), b"old");
        std::fs::remove_file(&path).expect("it is there");
    }
    // A GLB is limited to 4 GiB, other formats are not.
    let large = MeshCounts { vertices: 50_000_000, triangles: 200_000_000 };
    let refused = MeshFormat::Gltf.check(large).expect_err("it is too large").to_string();
    assert!(refused.contains("4 GiB") && refused.contains("PLY"), "{refused}");
    assert!(MeshFormat::Ply.check(large).is_ok() && MeshFormat::Stl.check(large).is_ok());
}
