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
    shells: Vec<(ShellsOf, Arc<[Triangle]>)>,
}

/// What shells are made of.
#[derive(Clone, Debug)]
struct ShellsOf {
    mesh: Arc<Mesh>,
    map: Arc<HeightMap>,
    /// Where the heights 0 and 1 lie along the normals, in metres.
    shell_m: [f32; 2],
    /// Whether the base is smooth.
    lifted: bool,
}

impl ShellsOf {
    fn is(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.mesh, &other.mesh)
            && Arc::ptr_eq(&self.map, &other.map)
            && (self.shell_m, self.lifted) == (other.shell_m, other.lifted)
    }
}

impl KeptTriangles {
    /// The triangles of a surface whose heights 0 and 1 lie at these distances along the normals, in metres:
    /// those made for it before, if any were.
    pub fn of(&mut self, surface: &Surface, shell_m: [f32; 2], before: &Self) -> Arc<[Triangle]> {
        let (mesh, selection) = (surface.mesh(), surface.selection());
        if selection.paths().proposal == Proposal::Polygons {
            return kept(&mut self.polygons, &before.polygons, mesh, || polygons(mesh));
        }
        let (mesh, map) = (Arc::clone(mesh), Arc::clone(surface.height_map()));
        let of = ShellsOf { mesh, map, shell_m, lifted: selection.has_smooth_base() };
        let mut known = self.shells.iter().chain(&before.shells);
        let made = known.find(|(known, _)| known.is(&of)).map(|(_, made)| Arc::clone(made));
        let made = made.unwrap_or_else(|| shells(&of));
        self.shells.push((of, Arc::clone(&made)));
        made
    }
}

/// The triangles of a mesh, of whose shells nothing is known.
fn polygons(mesh: &Mesh) -> Arc<[Triangle]> {
    (0..mesh.triangles().len() as u32).map(|number| triangle(mesh, number, Shell::whole())).collect()
}

/// The triangles of a mesh with their shells.
fn shells(of: &ShellsOf) -> Arc<[Triangle]> {
    let ShellsOf { mesh, map, shell_m, lifted } = of;
    let (welded, lifts) = (mesh.welded(), lifted.then(|| mesh.lifts()));
    let [low, high] = map.extremes();
    let numbered = (0u32..).zip(mesh.triangles());
    let triangles = numbered.map(|(number, corners)| {
        let places = Shell::places_of(corners.map(|corner| welded[corner as usize]));
        let lift = lifts.as_ref().map_or([0.0; 3], |lifts| lifts[number as usize]);
        let shell = Shell::between([low, high], places, places.map(|place| lift[place as usize]));
        let ([lowest, highest], [down, up]) = (shell.offsets_m(*shell_m), mesh.fold_range(number));
        let is_folded = f64::from(lowest) <= down || f64::from(highest) >= up;
        triangle(mesh, number, if is_folded { shell.folded() } else { shell })
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
