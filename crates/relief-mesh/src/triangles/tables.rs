//! Tables of a base, for programs that cut and displace it elsewhere, such as on a GPU.

use std::sync::Arc;

use glam::{DVec3, Vec2, Vec3};
use relief_core::mesh::Mesh;
use relief_core::{HeightBounds, HeightMap, Watch};

use super::cull::Bounds;
use super::edges::{Division, Edges};
use super::halves::{Limits, halved};
use super::{Corners, Triangles, texels_per_metre};
use crate::cull::{FullBounds, ROUNDING};
use crate::surface::Relief;
use crate::{BaseSurface, Directions, MesherError, Shading, View};

/// Longest side of a triangle, in texels. Longer ones are halved. Invisible parts of a triangle can
/// then be left out, and a part near the eye does not make all of it fine.
const LONGEST_TEXELS: f64 = 64.0;

/// Number of triangles beyond which nothing is halved any further.
const TRIANGLES: usize = 1 << 20;

/// Tables of a base of flat triangles whose points move along interpolated normals.
///
/// They hold all values for cutting each triangle by itself, so that neighbours meet, and for
/// displacing the pieces. Sides that are longer than 64 texels are halved. At hard edges and seams
/// a position has one direction and one place on the map, as with
/// [`Seams::Weld`](crate::Seams::Weld).
#[derive(Debug)]
pub struct BaseTables {
    /// Vertices.
    pub vertices: Vec<TableVertex>,
    /// Edges between two vertices.
    pub edges: Vec<TableEdge>,
    /// Triangles.
    pub patches: Vec<TablePatch>,
    /// Points whose convex hull contains the displaced base, up to rounding.
    around: Arc<[DVec3]>,
    largest_m: f64,
}

/// Vertex of a base.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TableVertex {
    /// Position in metres.
    pub position: Vec3,
    /// Direction of displacement, of any length: the same for all vertices at a position.
    pub direction: Vec3,
    /// Normal, of any length.
    pub normal: Vec3,
    /// Derivatives of the position by `u` and `v`.
    pub tangents: [Vec3; 2],
    /// Derivatives of the direction by `u` and `v`.
    pub turns: [Vec3; 2],
    /// Texture coordinates.
    pub uv: Vec2,
    /// Vertex whose texture coordinates define the displacement at this position.
    pub leader: u32,
    /// Texels of the map in a metre around it.
    pub texels_per_m: f32,
}

/// Edge between two vertices. At a seam several edges lie between the same positions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TableEdge {
    /// Vertices, in the same order for all edges between the same positions.
    pub ends: [u32; 2],
    /// Ends of the edge between these positions that defines their points.
    pub leader: [u32; 2],
    /// Greatest change of `u` and `v` along any edge between these positions.
    pub along: Vec2,
    /// First and last triangle at the edge, the same where there is one; `None` if there are more
    /// than two.
    pub patches: Option<[u32; 2]>,
}

/// Triangle of a base.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TablePatch {
    /// Vertices.
    pub corners: [u32; 3],
    /// Sides. The first one runs from the first vertex to the second.
    pub edges: [u32; 3],
    /// Least and greatest displacement of it in metres, over all levels of the map.
    pub metres: [f32; 2],
}

impl BaseTables {
    /// Creates the tables of a mesh that a map displaces. `coarser` holds the map's coarser levels.
    ///
    /// # Errors
    ///
    /// Fails if the mesh has no triangles or too many, or when cancelled.
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
            full_bounds: None,
        };
        Ok(base.tables(mesh, &relief))
    }

    /// Returns the bounds of the displaced base for a view, including invisible parts.
    pub fn full_bounds(&self, view: &View) -> FullBounds {
        let (eye, forward) = (view.camera.eye(), view.camera.forward());
        let nothing = [f64::INFINITY, f64::NEG_INFINITY];
        let [near, far] = self.around.iter().fold(nothing, |[near, far], point| {
            let depth = forward.dot(*point - eye);
            [near.min(depth), far.max(depth)]
        });
        let margin = ROUNDING * self.largest_m.max(eye.abs().max_element());
        FullBounds { depths_m: [near - margin, far + margin], around: self.around.to_vec() }
    }

    /// Returns the largest coordinate of the displaced base in metres.
    pub fn largest_m(&self) -> f64 {
        self.largest_m
    }
}

impl Triangles {
    /// Creates the tables of these triangles.
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
                leader: self.corners.leader(number),
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
            let most = &mut along[self.leader(edge) as usize];
            *most = most.max((b - a).abs());
        }
        let edges = (0..self.edges.count()).zip(owners).map(|(edge, (count, patches))| TableEdge {
            ends: self.edges.ends(edge),
            leader: self.edges.ends(self.leader(edge)),
            along: along[self.leader(edge) as usize],
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

/// Returns a displacement as it is stored: rounded away from 0, never toward it.
fn outward(metres: f64) -> f32 {
    let margin = f64::from(f32::EPSILON) * metres.abs();
    (metres + if metres < 0.0 { -margin } else { margin }) as f32
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
    fn seams_have_one_place_and_all_lies_within_what_is_around() {
        let tables = tables(&cube(1).expect("a mesh"), 32);
        for vertex in &tables.vertices {
            let leader = &tables.vertices[vertex.leader as usize];
            assert_eq!((leader.position, leader.direction), (vertex.position, vertex.direction));
        }
        for edge in &tables.edges {
            let at = |ends: [u32; 2]| ends.map(|end| tables.vertices[end as usize].position);
            assert_eq!(at(edge.ends), at(edge.leader));
        }
        assert!(tables.edges.iter().any(|edge| edge.ends != edge.leader));
        for patch in &tables.patches {
            assert!(-0.021 < patch.metres[0] && patch.metres[0] < patch.metres[1] && patch.metres[1] < 0.081);
        }
        let camera = Camera::new(DVec3::new(3.0, 0.0, 0.0), DVec3::ZERO, 40.0);
        let view = View::new(camera.expect("a camera"), [64, 64]);
        let [near, far] = tables.full_bounds(&view).depths_m;
        assert!(2.3 < near && near < 2.6 && 3.4 < far && far < 3.7, "{near} {far}");
    }
}
