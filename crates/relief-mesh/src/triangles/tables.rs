//! Bases as tables, for programs that cut and displace them elsewhere: on a GPU.

use std::sync::Arc;

use glam::{DVec3, Vec2, Vec3};
use relief_core::mesh::Mesh;
use relief_core::{HeightBounds, HeightMap, Watch};

use super::cull::Bounds;
use super::edges::{Division, Edges};
use super::halves::{Limits, halved};
use super::{Corners, Triangles, texels_per_metre};
use crate::cull::{Everything, ROUNDING};
use crate::surface::Relief;
use crate::{BaseSurface, Directions, MesherError, Shading, View};

/// The longest side of a triangle, in texels: longer ones are halved, so that what is not seen of a triangle
/// is left out, and what is near to the eye does not make all of it fine.
const LONGEST_TEXELS: f64 = 64.0;

/// Triangles that are not too many: with more nothing is halved any further.
const TRIANGLES: usize = 1 << 20;

/// A base of flat triangles whose points move along interpolated normals, as tables: what is to be known of
/// it to cut each triangle by itself, so that neighbours meet, and to displace what was cut.
///
/// Sides that are longer than 64 texels are halved. At hard edges and seams a position has one direction and
/// one place on the map, as [`Seams::Weld`](crate::Seams::Weld) says.
#[derive(Debug)]
pub struct BaseTables {
    /// The vertices.
    pub vertices: Vec<TableVertex>,
    /// The edges between two vertices.
    pub edges: Vec<TableEdge>,
    /// The triangles.
    pub patches: Vec<TablePatch>,
    /// Points whose hull has all of the displaced base within, but for rounding.
    around: Arc<[DVec3]>,
    largest_m: f64,
}

/// A vertex of a base.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TableVertex {
    /// Its position, in metres.
    pub position: Vec3,
    /// Along what it is displaced, of any length: the same for all vertices at a position.
    pub direction: Vec3,
    /// Its normal, of any length.
    pub normal: Vec3,
    /// The derivatives of the position by `u` and `v`.
    pub tangents: [Vec3; 2],
    /// Those of the direction.
    pub turns: [Vec3; 2],
    /// Its texture coordinates.
    pub uv: Vec2,
    /// The vertex whose texture coordinates say how far all at its position are displaced.
    pub seen: u32,
    /// Texels of the map in a metre around it.
    pub texels_per_m: f32,
}

/// An edge between two vertices. At a seam there are several between the same positions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TableEdge {
    /// The vertices, in an order that all edges between the same positions agree on.
    pub ends: [u32; 2],
    /// The ends of the edge between these positions that says where points are.
    pub seen: [u32; 2],
    /// By how much `u` and `v` change along it, or more where another edge between these positions has more.
    pub along: Vec2,
    /// The first and the last triangle that has it, the same where there is one; none where there are more
    /// than two.
    pub patches: Option<[u32; 2]>,
}

/// A triangle of a base.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TablePatch {
    /// Its vertices.
    pub corners: [u32; 3],
    /// Its sides: the first from its first vertex to its second one.
    pub edges: [u32; 3],
    /// The least and the greatest displacement on it in all levels of the map, in metres.
    pub metres: [f32; 2],
}

impl BaseTables {
    /// The tables of a mesh that a map displaces, seen in its levels, of which the map is the first.
    ///
    /// # Errors
    ///
    /// When the mesh has no triangles, they are too many, or it was cancelled.
    pub fn new(
        mesh: &Mesh,
        map: &HeightMap,
        coarser: &[HeightMap],
        watch: &Watch,
    ) -> Result<Self, MesherError> {
        if mesh.triangles().is_empty() {
            return Err(MesherError::Empty);
        }
        let relief = Relief::new(map, Directions::Raw, Shading::Exact).with_levels(coarser);
        let sides = relief.sides();
        let whole = Corners::new(mesh, &mesh.welded(), [true, false], Directions::Raw);
        let limits = Limits { most: u64::MAX, max_bytes: u64::MAX, watch: *watch };
        let cut = halved(mesh, &relief, &limits, |halves, triangles| {
            let few = triangles.len() <= TRIANGLES.max(2 * mesh.triangles().len());
            halves.sides(if few { triangles } else { &[] }, |ends| {
                let [a, b] = ends.map(|end| halves.vertex(end));
                let along = (b.uv - a.uv).as_dvec2().abs();
                let middle = a.position * 0.5 + b.position * 0.5;
                (along.x * sides[0]).max(along.y * sides[1]) > LONGEST_TEXELS
                    && middle != a.position
                    && middle != b.position
            })
        })?;
        let (mesh, corners) = match &cut {
            None => (mesh, whole),
            Some(cut) => {
                let corners = Corners::new(&cut.mesh, &cut.mesh.welded(), [true, false], Directions::Raw);
                (&cut.mesh, corners.between(&whole, &cut.parents))
            }
        };
        let edges = Edges::new(mesh, &mesh.welded(), &corners, |_| Ok(Division::WHOLE))?;
        let base = Triangles {
            corners,
            edges,
            triangles: mesh.triangles().to_vec(),
            voxels: Vec::new(),
            footprints: Vec::new(),
            base: BaseSurface::Flat,
            parts: None,
            one_side: None,
            is_welded: true,
            can_fold: false,
            whole: Vec::new(),
            border: None,
            everything: None,
        };
        Ok(base.tables(mesh, &relief))
    }

    /// Where all of it may be, also what a camera does not see.
    pub fn everything(&self, view: &View) -> Everything {
        let (eye, forward) = (view.camera.eye(), view.camera.forward());
        let nothing = [f64::INFINITY, f64::NEG_INFINITY];
        let [near, far] = self.around.iter().fold(nothing, |[near, far], point| {
            let depth = forward.dot(*point - eye);
            [near.min(depth), far.max(depth)]
        });
        let room = ROUNDING * self.largest_m.max(eye.abs().max_element());
        Everything { depths_m: [near - room, far + room], around: self.around.to_vec() }
    }

    /// The largest coordinate of all that is displaced, in metres.
    pub fn largest_m(&self) -> f64 {
        self.largest_m
    }
}

impl Triangles {
    /// Their tables.
    fn tables(&self, mesh: &Mesh, relief: &Relief) -> BaseTables {
        let sides = relief.sides();
        let vertices = (0..).zip(mesh.vertices()).map(|(number, vertex)| {
            let (base, frame) = (self.corners.base(number), self.corners.frame(number));
            TableVertex {
                position: vertex.position,
                direction: base.normal.as_vec3(),
                normal: frame.normal.as_vec3(),
                tangents: frame.tangents.map(|tangent| tangent.as_vec3()),
                turns: frame.turns.map(|turn| turn.as_vec3()),
                uv: vertex.uv,
                seen: self.corners.seen(number),
                texels_per_m: texels_per_metre(vertex, sides) as f32,
            }
        });
        let vertices: Vec<TableVertex> = vertices.collect();
        let mut owners: Vec<(u32, [u32; 2])> = vec![(0, [0; 2]); self.edges.count() as usize];
        for patch in 0..self.count() {
            for edge in self.edges.sides(patch) {
                let (count, patches) = &mut owners[edge as usize];
                *patches = if *count == 0 { [patch; 2] } else { [patches[0], patch] };
                *count += 1;
            }
        }
        let mut along = vec![Vec2::ZERO; self.edges.count() as usize];
        for edge in 0..self.edges.count() {
            let [a, b] = self.edges.ends(edge).map(|end| mesh.vertices()[end as usize].uv);
            let most = &mut along[self.seen(edge) as usize];
            *most = most.max((b - a).abs());
        }
        let edges = (0..self.edges.count()).zip(owners).map(|(edge, (count, patches))| TableEdge {
            ends: self.edges.ends(edge),
            seen: self.edges.ends(self.seen(edge)),
            along: along[self.seen(edge) as usize],
            patches: (count <= 2).then_some(patches),
        });
        let bounds = Bounds { relief, levels: relief.levels().map(HeightBounds::new).collect() };
        let patches = (0..self.count()).map(|patch| TablePatch {
            corners: self.triangles[patch as usize],
            edges: self.edges.sides(patch),
            metres: self.metres_of(&bounds, patch, 0..bounds.levels.len()).map(outward),
        });
        let patches: Vec<TablePatch> = patches.collect();
        let mut reaches = vec![[f32::INFINITY, f32::NEG_INFINITY]; vertices.len()];
        for patch in &patches {
            for corner in patch.corners {
                let [low, high] = &mut reaches[corner as usize];
                (*low, *high) = (low.min(patch.metres[0]), high.max(patch.metres[1]));
            }
        }
        let used = vertices.iter().zip(reaches).filter(|(_, [low, high])| low <= high);
        let around = used.flat_map(|(vertex, reach)| {
            let [position, direction] = [vertex.position, vertex.direction].map(Vec3::as_dvec3);
            reach.map(|metres| position + direction * f64::from(metres))
        });
        let around: Arc<[DVec3]> = around.collect();
        let largest_m = around.iter().fold(0.0, |most, point| point.abs().max_element().max(most));
        BaseTables { vertices, edges: edges.collect(), patches, around, largest_m }
    }
}

/// A displacement as it is stored: a little farther from none than it is, never nearer.
fn outward(metres: f64) -> f32 {
    let room = f64::from(f32::EPSILON) * metres.abs();
    (metres + if metres < 0.0 { -room } else { room }) as f32
}

#[cfg(test)]
mod tests {
    use relief_core::Wrap;
    use relief_core::camera::Camera;
    use relief_core::mesh::{cube, square, torus};

    use super::*;

    fn tables(mesh: &Mesh, side: u32) -> BaseTables {
        let map = HeightMap::from_fn(side, side, Wrap::Repeat, |i, j| ((i * 7 + j * 5) % 11) as f32 / 10.0);
        let map = map.expect("a map").with_displacement(0.1, -0.02).expect("lengths");
        BaseTables::new(mesh, &map, &[], &Watch::none()).expect("tables")
    }

    #[test]
    fn long_sides_are_halved_and_edges_know_their_triangles() {
        let plane = tables(&square(1).expect("a mesh"), 256);
        // A quarter of the side each, and a diagonal.
        assert_eq!((plane.patches.len(), plane.vertices.len()), (2 * 4 * 4, 5 * 5));
        let inner = plane.edges.iter().filter(|edge| edge.patches.is_some_and(|[a, b]| a != b)).count();
        assert_eq!((plane.edges.len(), inner), (3 * 16 + 8, 3 * 16 - 8));
        for (number, patch) in (0u32..).zip(&plane.patches) {
            for side in 0..3 {
                let edge = plane.edges[patch.edges[side] as usize];
                let ends = [patch.corners[side], patch.corners[(side + 1) % 3]];
                assert!(edge.ends == ends || edge.ends == [ends[1], ends[0]]);
                assert!(edge.patches.is_some_and(|of| of.contains(&number)));
            }
        }
        let torus = torus(12, 6).expect("a mesh");
        assert_eq!(tables(&torus, 16).patches.len(), torus.triangles().len());
    }

    #[test]
    fn seams_see_one_place_and_all_lies_within_what_is_around() {
        let tables = tables(&cube(1).expect("a mesh"), 32);
        for vertex in &tables.vertices {
            let seen = &tables.vertices[vertex.seen as usize];
            assert_eq!((seen.position, seen.direction), (vertex.position, vertex.direction));
        }
        for edge in &tables.edges {
            let at = |ends: [u32; 2]| ends.map(|end| tables.vertices[end as usize].position);
            assert_eq!(at(edge.ends), at(edge.seen));
        }
        assert!(tables.edges.iter().any(|edge| edge.ends != edge.seen));
        for patch in &tables.patches {
            assert!(-0.021 < patch.metres[0] && patch.metres[0] < patch.metres[1] && patch.metres[1] < 0.081);
        }
        let camera = Camera::new(DVec3::new(3.0, 0.0, 0.0), DVec3::ZERO, 40.0);
        let view = View::new(camera.expect("a camera"), [64, 64]);
        let [near, far] = tables.everything(&view).depths_m;
        assert!(2.3 < near && near < 2.6 && 3.4 < far && far < 3.7, "{near} {far}");
    }
}
