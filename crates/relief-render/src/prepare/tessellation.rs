//! Input of the shaders that tessellate base meshes.

use std::sync::Arc;

use relief_core::mesh::Mesh;
use relief_core::{HeightMap, Watch};
use relief_mesh::{BaseTables, Cull, FullBounds, MesherError, TableEdge, TablePatch, TableVertex, View};
use relief_shaders::cpu::{BaseEdge, BasePatch, BaseVertex, Tessellation as Grid};
use relief_shaders::wgsl::TESSELLATE_COUNTLESS;

/// Capacity in triangles for each voxel of the picture, and for each base triangle. Visible
/// surfaces have two triangles a voxel; back faces, and triangles beside and behind others, come on
/// top.
const TRIANGLES_PER_VOXEL: f64 = 8.0;
const TRIANGLES_PER_PATCH: u64 = 4;

/// Greatest numbers of triangles, and of points besides the base's vertices. A closed mesh has half
/// as many points as triangles; borders and seams have more.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Capacity {
    pub triangles: u32,
    pub points: u32,
}

impl Capacity {
    /// Returns the capacity for a number of triangles and for their points.
    pub fn of_triangles(triangles: u32) -> Self {
        Self { triangles, points: triangles / 2 + triangles / 8 }
    }

    /// Returns the lesser of two capacities, for triangles and points each.
    pub fn within(self, other: Self) -> Self {
        Self { triangles: self.triangles.min(other.triangles), points: self.points.min(other.points) }
    }
}

/// Division of base triangles.
#[derive(Clone, Copy, Debug)]
pub struct Division {
    /// Parts of sides for a unit of u and of v, or `None` if voxels divide them.
    pub parts_of_uv: Option<[f64; 2]>,
    /// Whether voxels fill the interior, too.
    pub is_swept: bool,
}

/// Tables of a base mesh for the shaders.
#[derive(Debug)]
pub struct TessellatedBase {
    tables: BaseTables,
    /// Vertices of the base.
    pub vertices: Vec<BaseVertex>,
    /// Edges of the base.
    pub edges: Vec<BaseEdge>,
    /// Triangles of the base.
    pub patches: Vec<BasePatch>,
}

/// Base mesh and the view for which it is tessellated.
#[derive(Clone, Debug)]
pub struct Tessellation {
    /// Tables of the base.
    pub base: Arc<TessellatedBase>,
    /// View, division and capacity.
    pub grid: Grid,
}

impl PartialEq for Tessellation {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.base, &other.base) && self.grid == other.grid
    }
}

impl TessellatedBase {
    /// Creates the tables of a mesh under a height map with several levels; the map is the first.
    pub fn new(
        mesh: &Mesh,
        map: &HeightMap,
        coarser: &[HeightMap],
        watch: &Watch,
    ) -> Result<Self, MesherError> {
        let mut tables = BaseTables::new(mesh, map, coarser, watch)?;
        // The base's own tables are held only here.
        let vertices = std::mem::take(&mut tables.vertices).iter().map(vertex).collect();
        let edges = std::mem::take(&mut tables.edges).iter().map(edge).collect();
        let patches = std::mem::take(&mut tables.patches).iter().map(patch).collect();
        Ok(Self { tables, vertices, edges, patches })
    }

    /// Returns bounds of all displaced triangles, including culled ones.
    pub fn everything(&self, view: &View) -> FullBounds {
        self.tables.full_bounds(view)
    }

    /// Returns the capacity for the triangles of a view.
    pub fn capacity(&self, view: &View, division: &Division) -> Capacity {
        match division.parts_of_uv {
            Some(parts_of_uv) => self.capacity_for_all(parts_of_uv),
            None => {
                let [width, height] = view.size.map(f64::from);
                let voxels = width * height / (view.pixels * view.pixels);
                // A float that is too large becomes the greatest number.
                let triangles = (TRIANGLES_PER_VOXEL * voxels) as u64;
                let triangles = triangles.saturating_add(TRIANGLES_PER_PATCH * self.patches.len() as u64);
                Capacity::of_triangles(u32::try_from(triangles).unwrap_or(u32::MAX))
            }
        }
    }

    /// Returns the capacity for all triangles, from the parts of sides for a unit of u and of v.
    fn capacity_for_all(&self, parts_of_uv: [f64; 2]) -> Capacity {
        let parts = self.edges.iter().map(|edge| {
            let [along, down] = [edge.along.x, edge.along.y].map(f64::from);
            (along * parts_of_uv[0]).max(down * parts_of_uv[1]).ceil().max(1.0)
        });
        let parts: Vec<f64> = parts.collect();
        let on_edges: f64 = parts.iter().map(|parts| parts - 1.0).sum();
        // Each row of a pattern has at most twice its parts, and one more on either side of it.
        let triangles = self.patches.iter().map(|patch| {
            let mut parts = [patch.edges.x, patch.edges.y, patch.edges.z].map(|edge| parts[edge as usize]);
            parts.sort_by(f64::total_cmp);
            parts[2] * (parts[0] + 2.0)
        });
        let triangles: f64 = triangles.sum();
        Capacity { triangles: triangles as u32, points: (on_edges + triangles / 2.0) as u32 }
    }

    /// Returns the view, the division and the capacity as input of the shaders.
    pub fn grid(
        &self,
        view: &View,
        cull: &Cull,
        levels: u32,
        division: &Division,
        capacity: Capacity,
    ) -> Result<Grid, MesherError> {
        let space = view.grid_space()?;
        let camera = &view.camera;
        let [eye, right, up, forward] = [camera.eye(), camera.right(), camera.up(), camera.forward()]
            .map(|v| v.as_vec3().extend(0.0).to_array());
        let planes = cull.planes(view, self.tables.largest_m());
        Ok(Grid {
            eye: eye.into(),
            right: right.into(),
            up: up.into(),
            forward: forward.into(),
            planes: planes.map(|plane| plane.as_vec4().to_array().into()),
            middle: space.middle.map(|place| place as f32).into(),
            per_m: space.per_m as f32,
            per_doubling: space.per_doubling as f32,
            near_m: space.near_m as f32,
            is_parallel: u32::from(camera.is_orthographic()),
            levels,
            vertices: self.vertices.len() as u32,
            edges: self.edges.len() as u32,
            patches: self.patches.len() as u32,
            most_points: capacity.points,
            most_triangles: capacity.triangles,
            parts_of_uv: division.parts_of_uv.unwrap_or_default().map(|parts| parts as f32).into(),
            is_swept: u32::from(division.is_swept),
        })
    }
}

fn vertex(of: &TableVertex) -> BaseVertex {
    let [tangent, bitangent] = of.tangents.map(|tangent| tangent.to_array().into());
    let [turn_u, turn_v] = of.turns.map(|turn| turn.to_array().into());
    BaseVertex {
        position: of.position.to_array().into(),
        seen: of.leader,
        direction: of.direction.to_array().into(),
        texels_per_m: of.texels_per_m,
        normal: of.normal.to_array().into(),
        tangent,
        bitangent,
        turn_u,
        turn_v,
        uv: of.uv.to_array().into(),
    }
}

fn edge(of: &TableEdge) -> BaseEdge {
    let patches = of.patches.unwrap_or([TESSELLATE_COUNTLESS; 2]);
    let along = of.along.to_array().into();
    BaseEdge { ends: of.ends.into(), seen: of.leader.into(), along, patches: patches.into() }
}

fn patch(of: &TablePatch) -> BasePatch {
    let [low_m, high_m] = of.metres;
    BasePatch { corners: of.corners.into(), low_m, edges: of.edges.into(), high_m }
}
