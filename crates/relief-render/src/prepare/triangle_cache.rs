//! Triangles of meshes for the shaders, with their shells, cached from frame to frame.

use std::sync::Arc;

use glam::Vec3;
use relief_core::HeightMap;
use relief_core::mesh::QuadricCoefficients;
use relief_shaders::cpu::{Corner, Shell};
use relief_shaders::field::Solids;
use relief_shaders::surface::{Proposal, Shown};

use super::displaced::corner;
use super::heights_under::HeightsUnder;
use crate::frame_cache::cached;
use crate::prepare::Triangles;
use relief_core::mesh::{Mesh, Vertex};
use relief_scene::Surface;

/// Cache of the triangles of a scene's surfaces.
#[derive(Debug, Default)]
pub struct TriangleCache {
    /// Triangles of meshes without shells.
    polygons: Vec<(Arc<Mesh>, Arc<Triangles>)>,
    /// Triangles for boxes around objects, whose shell is the box.
    boxes: Vec<(Arc<Mesh>, Arc<Triangles>)>,
    /// Triangles of meshes with quadrics.
    bent: Vec<(QuadricSource, Arc<Triangles>)>,
    /// Triangles of meshes with shells of height maps.
    shells: Vec<(ShellSource, Arc<Triangles>)>,
}

/// Source of triangles with shells.
#[derive(Clone, Debug)]
struct ShellSource {
    mesh: Arc<Mesh>,
    map: Arc<HeightMap>,
    /// Displacements of the heights 0 and 1 along the normals, in metres.
    shell_m: [f32; 2],
    /// Whether the base is smooth.
    lifted: bool,
    /// Number of the map's mip levels that may be traced.
    levels: u32,
    /// Whether both sides of the mesh are visible.
    both: bool,
    /// Whether a volume or a motif is shown, and no heights.
    is_solid: bool,
}

impl ShellSource {
    fn is(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.mesh, &other.mesh)
            && Arc::ptr_eq(&self.map, &other.map)
            && self.shell_m == other.shell_m
            && (self.lifted, self.levels, self.both) == (other.lifted, other.levels, other.both)
            && self.is_solid == other.is_solid
    }
}

/// Source of triangles with quadrics.
#[derive(Clone, Debug)]
struct QuadricSource {
    mesh: Arc<Mesh>,
    coefficients: QuadricCoefficients,
    /// Distance by which the base is moved along its normals, in metres.
    out_m: f32,
    /// Whether the base is smooth.
    lifted: bool,
}

impl QuadricSource {
    fn is(&self, other: &Self) -> bool {
        let settings = |of: &Self| (of.coefficients, of.out_m, of.lifted);
        Arc::ptr_eq(&self.mesh, &other.mesh) && settings(self) == settings(other)
    }

    /// Returns the triangles with their quadrics, and with the lifts of a smooth base.
    fn triangles(&self) -> Arc<Triangles> {
        let moved = (self.out_m > 0.0).then(|| moved_out(&self.mesh, self.out_m)).flatten();
        let mesh = moved.as_ref().unwrap_or(&self.mesh);
        let quadrics = mesh.quadrics(self.coefficients);
        let smooth = self.lifted.then(|| (mesh.welded(), mesh.lifts()));
        let numbered = (0u32..).zip(mesh.triangles());
        let shells = numbered.map(|(number, corners)| {
            smooth.as_ref().map_or_else(Shell::whole, |(welded, lifts)| {
                let places = Shell::places_of(corners.map(|corner| welded[corner as usize]));
                let lift = lifts[number as usize];
                Shell::between([0.0, 1.0], places, places.map(|place| lift[place as usize]))
            })
        });
        Arc::new(triangles(mesh, &quadrics, shells))
    }
}

/// Returns a mesh moved along its normals by `out_m` metres, with the tangents there. `None` if the
/// moved mesh is not valid.
fn moved_out(mesh: &Mesh, out_m: f32) -> Option<Mesh> {
    let quadrics = mesh.quadrics(QuadricCoefficients::Three);
    let vertices = mesh.vertices().iter().zip(quadrics).map(|(vertex, [a, b, c])| {
        let (t, s) = (vertex.tangent, vertex.bitangent);
        let (tt, ts, ss) = (t.dot(t), t.dot(s), s.dot(s));
        let area = tt * ss - ts * ts;
        let dual = |x: f32, y: f32| (t * (x * ss - y * ts) + s * (y * tt - x * ts)) / area;
        // The normal turns with the texture coordinates by the second derivatives of the quadric.
        let turned = |tangent: Vec3, x: f32, y: f32| {
            let moved = tangent - dual(x, y) * out_m;
            if moved.is_finite() && moved.dot(tangent) > 0.0 { moved } else { tangent }
        };
        let (tangent, bitangent) = (turned(t, 2.0 * a, b), turned(s, b, 2.0 * c));
        Vertex { position: vertex.position + vertex.normal * out_m, tangent, bitangent, ..*vertex }
    });
    Mesh::new(vertices.collect(), mesh.triangles().to_vec()).ok()
}

impl TriangleCache {
    /// Returns the triangles of a surface, cached or new. `shell_m` are the displacements of the
    /// heights 0 and 1 along the normals, in metres.
    pub fn of(&mut self, surface: &Surface, shell_m: [f32; 2], before: &Self) -> Arc<Triangles> {
        let (mesh, selection) = (surface.mesh(), surface.selection());
        if let Some(coefficients) = selection.quadrics() {
            let (mesh, lifted) = (Arc::clone(mesh), selection.has_smooth_base());
            let of = QuadricSource { mesh, coefficients, out_m: moved_out_m(surface), lifted };
            let mut known = self.bent.iter().chain(&before.bent);
            let made = known.find(|(known, _)| known.is(&of)).map(|(_, made)| Arc::clone(made));
            let made = made.unwrap_or_else(|| of.triangles());
            self.bent.push((of, Arc::clone(&made)));
            return made;
        }
        if selection.paths().shown == Shown::Object {
            return cached(&mut self.boxes, &before.boxes, mesh, || boxed(mesh, shell_m));
        }
        if selection.paths().proposal == Proposal::Polygons {
            return cached(&mut self.polygons, &before.polygons, mesh, || polygons(mesh));
        }
        let (mesh, map) = (Arc::clone(mesh), Arc::clone(surface.height_map()));
        let (lifted, levels) = (selection.has_smooth_base(), selection.levels_of(&map));
        let (both, is_solid) = (surface.two_sided(), selection.solids() != Solids::Heights);
        let of = ShellSource { mesh, map, shell_m, lifted, levels, both, is_solid };
        let mut known = self.shells.iter().chain(&before.shells);
        let made = known.find(|(known, _)| known.is(&of)).map(|(_, made)| Arc::clone(made));
        let made = made.unwrap_or_else(|| shells(&of));
        self.shells.push((of, Arc::clone(&made)));
        made
    }
}

/// Returns the distance by which a surface's base is moved along its normals, in metres, so that
/// all relief is carved into it. It is 0 unless its triangles have quadrics.
pub fn moved_out_m(surface: &Surface) -> f32 {
    let map = surface.height_map();
    let out_m = map.scale_m() as f32 + map.bias_m() as f32;
    if surface.selection().quadrics().is_some() { out_m.max(0.0) } else { 0.0 }
}

/// Returns the triangles of a mesh, with shells of all heights.
fn polygons(mesh: &Mesh) -> Arc<Triangles> {
    Arc::new(triangles(mesh, &[], std::iter::repeat(Shell::whole())))
}

/// Returns a triangle whose shell is the axis-aligned box around a mesh. `bottom` and `top` are the
/// displacements of the heights 0 and 1.
fn boxed(mesh: &Mesh, [bottom, top]: [f32; 2]) -> Arc<Triangles> {
    let positions = || mesh.vertices().iter().map(|vertex| vertex.position);
    let low = positions().fold(Vec3::INFINITY, Vec3::min);
    let extent = positions().fold(Vec3::NEG_INFINITY, Vec3::max) - low;
    let base = low - Vec3::Z * bottom;
    let vertex = |position: Vec3| Vertex { position, normal: Vec3::Z, ..mesh.vertices()[0] };
    let corners = [base, base + Vec3::X * extent.x, base + Vec3::Y * extent.y];
    let shell = Shell::between([0.0, extent.z / (top - bottom)], [0, 1, 2], [0.0; 3]);
    let corners = corners.map(|position| corner(&vertex(position)));
    Arc::new(Triangles::new(corners.to_vec(), std::iter::once(([0, 1, 2], shell))))
}

/// Returns the triangles of a mesh with their shells.
fn shells(of: &ShellSource) -> Arc<Triangles> {
    let ShellSource { mesh, map, shell_m, lifted, levels, both, is_solid } = of;
    let (welded, lifts) = (mesh.welded(), lifted.then(|| mesh.lifts()));
    // A volume or a motif may be solid at any height.
    let heights = (!is_solid).then(|| HeightsUnder::new(map, *levels));
    let numbered = (0u32..).zip(mesh.triangles());
    let shells = numbered.map(|(number, corners)| {
        let places = Shell::places_of(corners.map(|corner| welded[corner as usize]));
        let lift = lifts.as_ref().map_or([0.0; 3], |lifts| lifts[number as usize]);
        let corners = || mesh.corners(number).map(|corner| corner.uv.as_dvec2());
        let under = heights.as_ref().map_or([0.0, 1.0], |heights| heights.under(corners()));
        let shell = Shell::between(under, places, places.map(|place| lift[place as usize]));
        let ([lowest, highest], [down, up]) = (shell.offsets_m(*shell_m), mesh.fold_range(number));
        let is_between = |offset: f32| down < f64::from(offset) && f64::from(offset) < up;
        let is_whole = |lowest: f32, highest: f32| is_between(lowest) && is_between(highest);
        let is_folded = !is_whole(lowest, highest) || (*both && !is_whole(-highest, -lowest));
        if is_folded { shell.folded() } else { shell }
    });
    Arc::new(triangles(mesh, &[], shells))
}

/// Returns the triangles of a mesh with given shells, and with the quadrics of its vertices if
/// there are any.
fn triangles(mesh: &Mesh, quadrics: &[[f32; 3]], shells: impl Iterator<Item = Shell>) -> Triangles {
    let corners = (0..).zip(mesh.vertices()).map(|(place, vertex): (usize, &Vertex)| {
        let quadric = quadrics.get(place).copied().unwrap_or_default();
        Corner { of_surface: quadric.into(), ..corner(vertex) }
    });
    Triangles::new(corners.collect(), mesh.triangles().iter().copied().zip(shells))
}

/// Returns the largest absolute coordinate of a mesh, in metres.
pub fn extent_m(mesh: &Mesh) -> f32 {
    mesh.vertices().iter().fold(0.0, |extent, vertex| vertex.position.abs().max_element().max(extent))
}
