//! Meshes as the shaders have them: triangles with their corners, and what is known of their shells.

use std::sync::Arc;

use relief_core::HeightMap;
use relief_shaders::cpu::{Corner, Shell, Triangle};
use relief_shaders::surface::Proposal;

use crate::kept::kept;
use crate::mesh::{Mesh, Vertex};
use crate::scene::Surface;

/// The triangles of a scene's surfaces.
#[derive(Debug, Default)]
pub struct KeptTriangles {
    /// Of meshes alone.
    polygons: Vec<(Arc<Mesh>, Arc<[Triangle]>)>,
    /// Of meshes under height maps.
    shells: Vec<(Arc<Mesh>, Arc<HeightMap>, Arc<[Triangle]>)>,
}

impl KeptTriangles {
    /// The triangles of a surface: those made for it before, if any were.
    pub fn of(&mut self, surface: &Surface, before: &Self) -> Arc<[Triangle]> {
        let mesh = surface.mesh();
        if surface.selection().paths().proposal == Proposal::Polygons {
            return kept(&mut self.polygons, &before.polygons, mesh, || polygons(mesh));
        }
        let map = surface.height_map();
        let known = self.shells.iter().chain(&before.shells);
        let is_same = |known: &&(Arc<Mesh>, Arc<HeightMap>, Arc<[Triangle]>)| {
            Arc::ptr_eq(&known.0, mesh) && Arc::ptr_eq(&known.1, map)
        };
        let made = known.into_iter().find(is_same).map(|(.., made)| Arc::clone(made));
        let made = made.unwrap_or_else(|| shells(mesh, map));
        self.shells.push((Arc::clone(mesh), Arc::clone(map), Arc::clone(&made)));
        made
    }
}

/// The triangles of a mesh, of whose shells nothing is known.
fn polygons(mesh: &Mesh) -> Arc<[Triangle]> {
    (0..mesh.triangles().len() as u32).map(|number| triangle(mesh, number, Shell::whole())).collect()
}

/// The triangles of a mesh with their shells.
fn shells(mesh: &Mesh, map: &HeightMap) -> Arc<[Triangle]> {
    let welded = mesh.welded();
    let [low, high] = map.extremes();
    let numbered = (0u32..).zip(mesh.triangles());
    let triangles = numbered.map(|(number, corners)| {
        let order = Shell::order_of(corners.map(|corner| welded[corner as usize]));
        triangle(mesh, number, Shell::new([low, high], order))
    });
    triangles.collect()
}

fn triangle(mesh: &Mesh, number: u32, shell: Shell) -> Triangle {
    let corner = |vertex: &Vertex| {
        Corner::new(
            vertex.position.to_array(),
            vertex.normal.to_array(),
            vertex.tangent.to_array(),
            vertex.bitangent.to_array(),
            vertex.uv.to_array(),
        )
    };
    let [a, b, c] = mesh.corners(number).map(corner);
    Triangle { a, b, c, shell }
}

/// The largest absolute coordinate of a mesh, in metres.
pub fn extent_m(mesh: &Mesh) -> f32 {
    mesh.vertices().iter().fold(0.0, |extent, vertex| vertex.position.abs().max_element().max(extent))
}
