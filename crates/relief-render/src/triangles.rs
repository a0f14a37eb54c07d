//! Meshes as the shaders have them: triangles with their corners, and what is known of their shells.

use std::sync::Arc;

use glam::DVec2;
use relief_core::{HeightMap, MaxPyramid, MinPyramid};
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
    /// Whether coarser levels of the map are seen, too.
    levels: bool,
}

impl ShellsOf {
    fn is(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.mesh, &other.mesh)
            && Arc::ptr_eq(&self.map, &other.map)
            && (self.shell_m, self.lifted, self.levels) == (other.shell_m, other.lifted, other.levels)
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
        let (lifted, levels) = (selection.has_smooth_base(), selection.has_levels());
        let of = ShellsOf { mesh, map, shell_m, lifted, levels };
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
    let ShellsOf { mesh, map, shell_m, lifted, levels } = of;
    let (welded, lifts) = (mesh.welded(), lifted.then(|| mesh.lifts()));
    let heights = HeightsUnder::new(map, *levels);
    let numbered = (0u32..).zip(mesh.triangles());
    let triangles = numbered.map(|(number, corners)| {
        let places = Shell::places_of(corners.map(|corner| welded[corner as usize]));
        let lift = lifts.as_ref().map_or([0.0; 3], |lifts| lifts[number as usize]);
        let under = heights.under(mesh.corners(number).map(|corner| corner.uv.as_dvec2()));
        let shell = Shell::between(under, places, places.map(|place| lift[place as usize]));
        let ([lowest, highest], [down, up]) = (shell.offsets_m(*shell_m), mesh.fold_range(number));
        let is_folded = f64::from(lowest) <= down || f64::from(highest) >= up;
        triangle(mesh, number, if is_folded { shell.folded() } else { shell })
    });
    triangles.collect()
}

/// Texels beyond a triangle's own that its segments may read: they reach beyond it by rounding, and by as much
/// as they may be beside the ray.
const BEYOND_TEXELS: f64 = 2.0;

/// What is known of the heights under triangles.
enum HeightsUnder<'a> {
    /// Of the finest level: its lowest and its highest nodes.
    Finest(&'a HeightMap, MinPyramid, MaxPyramid),
    /// Of all levels.
    All([f32; 2]),
}

impl<'a> HeightsUnder<'a> {
    fn new(map: &'a HeightMap, levels: bool) -> Self {
        match levels {
            false => Self::Finest(map, MinPyramid::new(map), MaxPyramid::new(map)),
            true => Self::All(map.extremes()),
        }
    }

    /// The least and the greatest height under a triangle, by the texture coordinates of its corners, or less
    /// and more.
    fn under(&self, uv: [DVec2; 3]) -> [f32; 2] {
        let (map, lowest, highest) = match self {
            Self::All(extremes) => return *extremes,
            Self::Finest(map, lowest, highest) => (map, lowest, highest),
        };
        let size = DVec2::new(map.width().into(), map.height().into());
        let [a, b, c] = uv.map(|corner| corner * size - 0.5);
        let cells = |corner: DVec2| [corner.x.floor() as i64, corner.y.floor() as i64];
        let first = cells(a.min(b).min(c) - BEYOND_TEXELS);
        let last = cells(a.max(b).max(c) + BEYOND_TEXELS);
        [lowest.bound(first, last).0, highest.bound(first, last).0]
    }
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
