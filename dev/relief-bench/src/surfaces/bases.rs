//! The meshes that surfaces are measured on.

use std::path::{Path, PathBuf};

use glam::Vec2;
use relief_core::HeightMap;
use relief_core::mesh::{Mesh, MeshError, Placement, Vertex, cylinder, sphere, torus};
use relief_io::{MeshOptions, read_mesh};
use relief_tests::accuracy::maps;
use relief_tests::data_dir;

/// Tiles of the map over the built-in meshes.
pub const TILES: Vec2 = Vec2::new(6.0, 3.0);

/// The file of a mesh without any symmetry but one, in the folder of real data.
const SPOT: &str = "spot/spot_triangulated.obj";

/// Tiles along `u` for each along `v` by which the texture of the sheared sphere is slanted: the sides of its
/// tiles meet at 45 degrees at the equator.
const SHEAR: f32 = 1.0;

/// The names of all meshes.
pub const NAMES: &[&str] = &[
    "torus-128x64",
    "torus-32x16",
    "torus-16x8",
    "cylinder-128",
    "cylinder-32",
    "sphere-128x64",
    "sphere-32x16",
    "sphere-sheared",
    "spot",
];

/// A mesh, and the one that stands for the smooth surface that it was made from.
pub struct Base {
    /// Name of the mesh.
    pub name: &'static str,
    /// The mesh.
    pub mesh: Mesh,
    /// The smooth one, where there is one.
    pub smooth: Option<Mesh>,
    /// Whether it is a cylinder: its rims are hard edges.
    pub has_rims: bool,
}

impl Base {
    /// The mesh of that name; `None` for spot where the folder of real data is missing, which is said.
    pub fn of(name: &'static str) -> Result<Option<Self>, String> {
        if name == "spot" {
            return Ok(spot()?.map(|mesh| Self { name, mesh, smooth: None, has_rims: false }));
        }
        let built = |build: fn(u32, u32) -> Result<Mesh, MeshError>, [a, b]: [u32; 2], smooth: [u32; 2]| {
            Ok([build(a, b)?, build(smooth[0], smooth[1])?])
        };
        let smooth = [512, 256];
        let meshes: Result<[Mesh; 2], MeshError> = match name {
            "torus-128x64" => built(torus, [128, 64], smooth),
            "torus-32x16" => built(torus, [32, 16], smooth),
            "torus-16x8" => built(torus, [16, 8], smooth),
            "cylinder-128" => built(cylinder, [128, 1], [512, 1]),
            "cylinder-32" => built(cylinder, [32, 1], [512, 1]),
            "sphere-32x16" => built(sphere, [32, 16], smooth),
            _ => built(sphere, [128, 64], smooth),
        };
        let tiled = |mesh: Mesh| {
            let tiled = mesh.tiled(TILES)?;
            if name == "sphere-sheared" { sheared(&tiled) } else { Ok(tiled) }
        };
        let meshes = meshes.and_then(|[mesh, smooth]| Ok((tiled(mesh)?, tiled(smooth)?)));
        let (mesh, smooth) = meshes.map_err(|error| error.to_string())?;
        Ok(Some(Self { name, mesh, smooth: Some(smooth), has_rims: name.starts_with("cylinder") }))
    }
}

/// The sample map that all meshes carry.
pub fn cobbles() -> Result<HeightMap, String> {
    let named = maps().into_iter().find(|named| named.name == "cobbles");
    named.map(|named| named.map).ok_or_else(|| "there is no such map".to_owned())
}

/// The same surface under a slanted texture: `u` grows with `v`, whole tiles along a seam as before.
fn sheared(mesh: &Mesh) -> Result<Mesh, MeshError> {
    let slanted = |vertex: &Vertex| Vertex {
        uv: vertex.uv + Vec2::new(SHEAR * vertex.uv.y, 0.0),
        bitangent: vertex.bitangent - SHEAR * vertex.tangent,
        ..*vertex
    };
    Mesh::new(mesh.vertices().iter().map(slanted).collect(), mesh.triangles().to_vec())
}

/// The mesh of the file, as large as the others.
/// The mesh spot; none, which is said, where the folder of real data is missing.
pub fn spot() -> Result<Option<Mesh>, String> {
    spot_file().map(|path| from_file(&path)).transpose()
}

/// File of the mesh.
pub fn spot_file() -> Option<PathBuf> {
    let file = data_dir().map(|folder| folder.join(SPOT)).filter(|path| path.is_file());
    if file.is_none() {
        println!("spot is left out: RELIEF_DATA names no folder that has {SPOT}\n");
    }
    file
}

/// The tree of leaf cards.
pub fn tree() -> Result<Mesh, String> {
    read(&data("tree.obj"))
}

/// A file of the project's own data.
pub fn data(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data").join(name)
}

fn read(path: &Path) -> Result<Mesh, String> {
    Ok(read_mesh(path, &MeshOptions::default()).map_err(|error| format!("{}: {error}", path.display()))?.mesh)
}

fn from_file(path: &Path) -> Result<Mesh, String> {
    let mesh = read(path)?;
    let farthest = mesh.vertices().iter().map(|vertex| vertex.position.length()).fold(0.0, f32::max);
    let placement = Placement { size: 0.5 / f64::from(farthest), ..Placement::default() };
    let placed = mesh.placed(&placement).and_then(|mesh| mesh.tiled(TILES));
    placed.map_err(|error| error.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_name_but_that_of_a_file_is_a_mesh() {
        for &name in NAMES.iter().filter(|name| **name != "spot") {
            let base = Base::of(name).expect("a mesh").expect("a built-in one");
            let smooth = base.smooth.expect("a smooth one");
            assert!(base.mesh.triangles().len() < smooth.triangles().len(), "{name}");
        }
    }

    #[test]
    fn a_slanted_texture_has_the_frame_that_belongs_to_it() {
        let [straight, slanted] = ["sphere-128x64", "sphere-sheared"]
            .map(|name| Base::of(name).expect("a mesh").expect("a built-in one").mesh);
        for (a, b) in straight.vertices().iter().zip(slanted.vertices()) {
            // A step in the texture that keeps the old `u` leads along the old bitangent.
            let along = b.bitangent + SHEAR * b.tangent;
            assert!((along - a.bitangent).length() < 1e-5 && b.tangent == a.tangent);
            assert_eq!(b.uv - a.uv, Vec2::new(SHEAR * a.uv.y, 0.0));
        }
    }
}
