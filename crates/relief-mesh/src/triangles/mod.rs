//! Bases of triangles: shared sides, and the points of patches.

mod adapted;
mod along_edge;
mod border;
mod corners;
mod creases;
mod cull;
mod edges;
mod halves;
mod inside;
mod near;
mod one_side;
mod patch_border;
mod profile;
mod shape;
mod solid;
mod tables;

use glam::DVec3;
use relief_core::Watch;
use relief_core::mesh::{Mesh, Vertex};

pub use self::adapted::Adapted;
use self::along_edge::AlongEdge;
pub use self::along_edge::EdgeVertices;
use self::border::Border;
use self::corners::Corners;
use self::creases::Creases;
use self::edges::{Division, Edges};
use self::halves::{Halves, Limits, PartWeights};
pub use self::inside::Inside;
use self::one_side::OneSide;
pub use self::patch_border::PatchBorder;
use self::shape::{Parts, Shape, WholeEdge};
pub use self::solid::Solid;
pub use self::tables::{BaseTables, TableEdge, TablePatch, TableVertex};
use crate::cull::FullBounds;
use crate::edge::Divides;
use crate::error::MOST;
use crate::patch::{Patch, PatchPoint};
use crate::surface::{Relief, SurfacePoint};
use crate::view::{Voxel, log2};
use crate::{BaseSurface, MeshSettings, MesherError, Seams, Side, Weights, cubic, point};

/// Base of triangles, with the points of its sides counted.
#[derive(Debug)]
pub struct Triangles {
    corners: Corners,
    edges: Edges,
    triangles: Vec<[u32; 3]>,
    /// Vertices in grid space; empty if sides are not divided by voxels.
    voxels: Vec<Voxel>,
    /// Texels of the map in the width of a voxel around each vertex, at depth 1; empty if there are
    /// no coarser levels.
    footprints: Vec<f64>,
    base: BaseSurface,
    /// Whole triangles, where a smooth base was halved.
    parts: Option<Parts>,
    /// Factors that keep triangles on one side of the relief.
    one_side: Option<OneSide>,
    is_welded: bool,
    can_fold: bool,
    /// Triangle of the whole mesh to which each triangle belongs; empty if none is halved.
    whole: Vec<u32>,
    /// Border, if a solid is to be made.
    border: Option<Border>,
    /// Bounds of all patches, including the ones left out.
    full_bounds: Option<FullBounds>,
}

/// Numbers of a vertex of the written mesh: its own, and the number that shares its normal.
#[derive(Clone, Copy, Debug)]
pub struct Numbered {
    pub number: u32,
    /// Number of the first vertex at the same position of the same surface.
    pub smooth: u32,
}

impl Numbered {
    /// Creates the numbers of a vertex whose normal is not shared.
    pub fn both(number: u32) -> Self {
        Self { number, smooth: number }
    }
}

impl Triangles {
    /// Creates the base. Where large triangles are cut, it has at most `most` triangles.
    pub fn new(
        mesh: &Mesh,
        relief: &Relief,
        settings: &MeshSettings,
        most: u64,
        watch: &Watch,
    ) -> Result<Self, MesherError> {
        let is_welded = settings.seams == Seams::Weld;
        let sides = relief.sides();
        let mut point_of = mesh.welded();
        let shared = [is_welded, settings.solid_m.is_some()];
        let mut corners = Corners::new(mesh, &point_of, shared, settings.directions);
        let limits = Limits { most, max_bytes: settings.max_bytes, watch: *watch };
        let (mut creases, mut halved) = (None, None);
        let part = settings.side.part();
        let error_m = part * settings.error_m;
        if let Divides::Along(_) = settings.edges.divides {
            let tolerance = relief.tolerance(error_m, corners.longest());
            let found = Creases::new(relief, tolerance)?;
            found.check(relief, settings, corners.longest() / part)?;
            halves::check(mesh, relief, &limits)?;
            let long = |halves: &Halves, triangles: &[[u32; 3]]| halves.beyond(&found, triangles);
            halved = halves::halved(mesh, relief, &limits, long)?;
            creases = Some(found);
        }
        if let Divides::Voxels(parts) = settings.edges.divides {
            halved = near::halved(mesh, relief, parts, settings, &limits)?;
        }
        let mut parts = None;
        if let Some(halved) = &halved {
            if settings.base != BaseSurface::Flat {
                let whole = (is_welded, settings.base);
                parts = Some(Parts::new(mesh, &point_of, &corners, whole, halved)?);
            }
            point_of = halved.mesh.welded();
            corners = Corners::new(&halved.mesh, &point_of, shared, settings.directions)
                .between(&corners, &halved.parents);
        }
        let mesh = halved.as_ref().map_or(mesh, |halved| &halved.mesh);
        // Before sides are divided, which may take long.
        let border = settings.solid_m.map(|_| Border::new(mesh, &point_of, is_welded)).transpose()?;
        let is_sided = matches!(settings.edges.divides, Divides::Along(_)) && settings.side != Side::Both;
        let side = (settings.side, settings.error_m);
        let lifts_m = match (&parts, settings.base) {
            (_, BaseSurface::Flat | BaseSurface::Pn) => Vec::new(),
            (Some(parts), BaseSurface::Lift) => parts.lifts_m(),
            (None, BaseSurface::Lift) => shape::lifts_m(mesh, &point_of),
        };
        let lift_m = |triangle: usize| lifts_m.get(triangle).copied().unwrap_or(0.0);
        let one_side =
            is_sided.then(|| OneSide::new(mesh, &point_of, &corners, relief, lift_m, side)).transpose()?;
        let (mut voxels, mut footprints) = (Vec::new(), Vec::new());
        let most = |parts: &mut dyn Iterator<Item = u64>| Ok(Division::Even(parts.max().unwrap_or(1)));
        let edges = match settings.edges.divides {
            Divides::Evenly(evenly) => Edges::new(mesh, &point_of, &corners, |all| {
                most(&mut all.iter().map(|ends| {
                    let [a, b] = ends.map(|end| corners.vertex(end).uv.as_dvec2());
                    (evenly.parts)([(b.x - a.x) * sides[0], (b.y - a.y) * sides[1]], settings)
                }))
            })?,
            Divides::Voxels(parts) => {
                let view = settings.view.ok_or(MesherError::NoView { edges: settings.edges.name })?;
                let grid = view.voxels()?;
                let places = mesh.vertices().iter().map(|vertex| grid.of(vertex.position.as_dvec3()));
                voxels = places.collect::<Vec<Voxel>>();
                if relief.has_levels() {
                    let around = |vertex: &Vertex| grid.size_m() * texels_per_metre(vertex, sides);
                    footprints = mesh.vertices().iter().map(around).collect();
                }
                Edges::new(mesh, &point_of, &corners, |all| {
                    most(&mut all.iter().map(|ends| {
                        let voxels = parts(ends.map(|end| voxels[end as usize].at));
                        if settings.weights == Weights::NONE {
                            return voxels;
                        }
                        let ends = ends.map(|end| corners.vertex(end));
                        let factor = settings.weights.factor(relief, &view, ends);
                        // A float that is too large becomes the greatest number.
                        (voxels as f64 * factor).ceil().max(1.0) as u64
                    }))
                })?
            }
            Divides::Along(along) => {
                let reaches = reaches(mesh, &corners);
                Edges::new(mesh, &point_of, &corners, |all| {
                    let Some(creases) = &creases else { return Ok(Division::WHOLE) };
                    let edge = |ends: &[u32; 2]| {
                        let [a, b] = ends.map(|end| reaches[end as usize]);
                        // The first edge at a seam defines the points of a welded mesh.
                        let leader = if is_welded { all[0] } else { *ends };
                        let (shape, part) = match &parts {
                            Some(parts) => parts.of_side(leader),
                            None => (
                                along_whole(&corners, leader, settings.base),
                                [point::CORNERS[0], point::CORNERS[1]],
                            ),
                        };
                        let points = ends.map(|end| point_of[end as usize]);
                        let ends = ends.map(|end| corners.base(end));
                        profile::Edge {
                            ends,
                            shape,
                            part,
                            factor: one_side.as_ref().map_or(1.0, |side| side.of_side(points)),
                            // On one side all triangles have the same distance from the relief.
                            reach: if is_sided { corners.longest() } else { a.min(b) },
                        }
                    };
                    let edges: Vec<profile::Edge> = all.iter().map(edge).collect();
                    Ok(profile::division(relief, creases, &edges, along, error_m))
                })?
            }
        };
        let triangles = mesh.triangles().to_vec();
        let whole = halved.map_or_else(Vec::new, |halved| halved.whole);
        let first = corners.used.first().map(|&vertex| corners.base(vertex).normal);
        let can_fold = corners.used.iter().any(|&vertex| Some(corners.base(vertex).normal) != first);
        let base = settings.base;
        Ok(Self {
            corners,
            edges,
            triangles,
            voxels,
            footprints,
            base,
            parts,
            one_side,
            is_welded,
            can_fold,
            whole,
            border,
            full_bounds: None,
        })
    }

    /// Returns the share of a vertex along the sides that end at it.
    fn share(&self, vertex: u32) -> f64 {
        self.voxels.get(vertex as usize).map_or(1.0, |voxel| voxel.share)
    }

    /// Returns the number of patches.
    pub fn count(&self) -> u32 {
        self.triangles.len() as u32
    }

    /// Returns a patch as the input of an interior.
    pub fn patch(&self, patch: u32) -> Patch<'static> {
        let parts = self.edges.sides(patch).map(|edge| self.edges.parts(edge));
        let voxel = |vertex: u32| self.voxels.get(vertex as usize).map_or([0; 3], |voxel| voxel.at);
        Patch::Triangle { parts, voxels: self.triangles[patch as usize].map(voxel) }
    }

    /// Returns the number of vertices at corners of the base.
    pub fn corner_count(&self) -> u32 {
        self.corners.used.len() as u32
    }

    /// Returns the number of edges of the base, one for every pair of vertices at their ends.
    pub fn edge_count(&self) -> u32 {
        self.edges.count()
    }

    /// Returns the number of vertices between the ends of an edge.
    pub fn points_of_edge(&self, edge: u32) -> u32 {
        self.edges.points(edge)
    }

    /// Returns the number of vertices at corners and along edges.
    pub fn border_count(&self) -> u64 {
        self.edges.end()
    }

    /// Returns the level of the map at a point of an edge or a triangle, by the weights of its
    /// corners. Its texels are as wide as the voxel there.
    ///
    /// Gumhold and Hüttner 1999 take the level from the distance of points (section 4.1), along an
    /// edge of two points. Two edges that meet would not agree in their corner. The size of a voxel
    /// is the same for both.
    fn level<const N: usize>(&self, corners: [u32; N], weights: [f64; N]) -> f64 {
        if self.footprints.is_empty() {
            return 0.0;
        }
        let depths = corners.map(|vertex| 1.0 / self.share(vertex));
        level(depths, corners.map(|vertex| self.footprints[vertex as usize]), weights)
    }

    /// Returns a corner as its leader defines it: in a welded mesh all sides have the same leader.
    fn at_corner(&self, vertex: u32) -> SurfacePoint {
        let leader = self.corners.leader(vertex);
        let level = self.level([leader], [1.0]);
        let mut base = self.corners.base(leader);
        let mut lift_m = self.raise_m();
        if let Some((shape, weights)) = self.parts.as_ref().and_then(|parts| parts.of_vertex(leader)) {
            base.position = shape.position(weights).unwrap_or(base.position);
            lift_m += shape.lift_m(weights);
        }
        SurfacePoint { level, lift_m, ..SurfacePoint::new(base) }
    }

    /// Returns the shape of a smooth base over a patch, and the weights of the patch in it. Without
    /// weights the patch is the whole triangle.
    fn shape(&self, patch: u32) -> (Shape, Option<PartWeights>) {
        if let Some(parts) = &self.parts {
            let (shape, weights) = parts.of_patch(patch);
            return (shape, Some(weights));
        }
        let (corners, sides) = (self.triangles[patch as usize], self.edges.sides(patch));
        let shape = match self.base {
            BaseSurface::Flat => Shape::Flat,
            BaseSurface::Lift => Shape::Lift(sides.map(|side| self.lift(self.leader(side)))),
            BaseSurface::Pn => {
                let bent = [0, 1, 2].map(|k| {
                    let [first, second] = self.bent(sides[k]);
                    let is_forth = self.edges.ends(sides[k])[0] == corners[k];
                    if is_forth { [first, second] } else { [second, first] }
                });
                Shape::Cubic(corners.map(|vertex| self.corners.base(vertex).position), bent)
            }
        };
        (shape, None)
    }

    /// Returns the extra displacement of all points in metres.
    fn raise_m(&self) -> f64 {
        self.one_side.as_ref().map_or(0.0, |side| side.raise_m)
    }

    /// Returns a point along an edge as the edge's leader defines it.
    fn on_edge(&self, edge: u32, at: u32) -> SurfacePoint {
        AlongEdge::new(self, edge).surface_point(self.edges.place(edge, at))
    }

    /// Returns the leader of an edge: the edge between the same positions that defines its points.
    fn leader(&self, edge: u32) -> u32 {
        if self.is_welded { self.edges.first_at_seam(edge) } else { edge }
    }

    /// Returns the inner control points of a cubic edge, in the order of its ends.
    fn bent(&self, edge: u32) -> [DVec3; 2] {
        cubic::bent(self.edges.ends(self.leader(edge)).map(|end| self.corners.base(end)))
    }

    fn lift(&self, edge: u32) -> f64 {
        if self.base == BaseSurface::Lift { self.edges.lift(edge) } else { 0.0 }
    }

    /// Returns the displaced vertex at a corner of the base. `number` is as in
    /// [`corner_numbered`](Self::corner_numbered).
    pub fn corner_vertex(&self, relief: &Relief, number: u32) -> Vertex {
        let vertex = self.corners.used[number as usize];
        let leading = self.at_corner(vertex);
        let own = SurfacePoint { base: self.corners.base(vertex), ..leading };
        relief.vertex_at(relief.displaced(&leading), &own, &self.corners.frame(vertex))
    }

    /// Returns the numbers of the vertex at a corner of the base: its own, and the number of the
    /// first corner that shares its normal.
    ///
    /// `number` counts from 0 the corners that triangles use, in the order in which they are
    /// written. It is the vertex's own number.
    pub fn corner_numbered(&self, number: u32) -> Numbered {
        self.corners.numbered(self.corners.used[number as usize])
    }

    /// Returns the edge at a side of a patch, and whether both run the same way.
    fn side(&self, patch: u32, side: u32) -> (u32, bool) {
        let edge = self.edges.sides(patch)[side as usize];
        let from = self.triangles[patch as usize][side as usize];
        (edge, self.edges.ends(edge)[0] == from)
    }

    /// Returns the edge at a side of a patch, and the place on it of a point of the side. Edges are
    /// counted from the end that comes first by its bits, and not as the patch runs.
    fn on_side(&self, patch: u32, side: u32, at: u32) -> (u32, u32) {
        let (edge, is_forth) = self.side(patch, side);
        (edge, if is_forth { at } else { self.edges.parts(edge) - at })
    }

    /// Returns the weights of the two ends of a patch's side at one of its points, as the patch
    /// runs.
    fn parts_before(&self, patch: u32, side: u32, at: u32) -> [f64; 2] {
        if at == 0 {
            return [1.0, 0.0];
        }
        let (_, is_forth) = self.side(patch, side);
        let (edge, at) = self.on_side(patch, side, at);
        let [before, all] = self.edges.place(edge, at);
        let shares = self.edges.ends(edge).map(|end| self.share(end));
        let [of_a, of_b] = point::weights(shares, before, all).map(|weight| weight / f64::from(all));
        let sum = of_a + of_b;
        if is_forth { [of_a / sum, of_b / sum] } else { [of_b / sum, of_a / sum] }
    }

    /// Returns whether points move along different directions.
    pub fn can_fold(&self) -> bool {
        self.can_fold
    }

    /// Returns the directions of displacement at the corners of a patch, of any length.
    pub fn directions(&self, patch: u32) -> [DVec3; 3] {
        self.triangles[patch as usize].map(|vertex| self.at_corner(vertex).base.normal)
    }

    /// Returns the direction of displacement at a point of a patch, of any length.
    pub fn direction(&self, patch: u32, point: &PatchPoint) -> DVec3 {
        match *point {
            PatchPoint::Border { side, at: 0 } => self.directions(patch)[side as usize],
            PatchPoint::Border { side, at } => {
                let (edge, at) = self.on_side(patch, side, at);
                self.on_edge(edge, at).base.normal
            }
            PatchPoint::Inner { weights, .. } => Inside::new(self, patch).direction(weights),
        }
    }

    /// Returns the number of the mesh's triangle that contains a patch.
    pub fn whole(&self, patch: u32) -> u32 {
        self.whole.get(patch as usize).copied().unwrap_or(patch)
    }

    /// Returns the middle of a patch.
    pub fn middle(&self, patch: u32) -> DVec3 {
        let [a, b, c] = self.triangles[patch as usize].map(|vertex| self.corners.base(vertex).position);
        (a + b + c) / 3.0
    }
}

/// Returns the shape of a smooth base along an edge of a mesh that is not halved.
fn along_whole(corners: &Corners, ends: [u32; 2], base: BaseSurface) -> Shape {
    let [a, b] = ends.map(|end| corners.vertex(end));
    let [along, turn] = [a.position - b.position, a.normal - b.normal].map(|of| of.as_dvec3());
    let edge = WholeEdge { ends: ends.map(|end| corners.base(end)), lift_m: 0.5 * along.dot(turn) };
    Shape::along(&edge, base)
}

/// Returns the level whose texels are as wide as a voxel. `depths` are the depths of the corners in
/// the picture, `texels` the texels in a voxel where the depth is 1.
fn level<const N: usize>(depths: [f64; N], texels: [f64; N], weights: [f64; N]) -> f64 {
    let (mut depth, mut sum) = (0.0, 0.0);
    for k in 0..N {
        depth += weights[k] * depths[k];
        sum += weights[k] * texels[k];
    }
    log2((sum * depth).max(1.0))
}

/// Returns the length of the longest direction of displacement of the triangles around each vertex.
fn reaches(mesh: &Mesh, corners: &Corners) -> Vec<f64> {
    let mut reaches = vec![0.0_f64; mesh.vertices().len()];
    for triangle in mesh.triangles() {
        let lengths = triangle.map(|vertex| corners.base(vertex).normal.length());
        let longest = lengths.into_iter().fold(0.0, f64::max);
        for &vertex in triangle {
            reaches[vertex as usize] = reaches[vertex as usize].max(longest);
        }
    }
    reaches
}

/// Returns the texels of a map in a metre around a vertex, along `u` or `v`, whichever has more.
/// `sides` are the map's columns and rows. Returns 0 where the texture has no extent.
fn texels_per_metre(vertex: &Vertex, sides: [f64; 2]) -> f64 {
    let along = [vertex.tangent, vertex.bitangent].map(|tangent| tangent.as_dvec3().length());
    let texels = [0, 1].map(|axis| sides[axis] / along[axis]).into_iter().filter(|texels| texels.is_finite());
    texels.fold(0.0, f64::max)
}

/// Returns a number of points as `u32`, or an error if there are too many.
fn counted(points: u64) -> Result<u32, MesherError> {
    match u32::try_from(points) {
        Ok(points) if u64::from(points) <= MOST => Ok(points),
        _ => Err(MesherError::TooLarge { vertices: points, triangles: 0 }),
    }
}

/// Returns the bits that vertices of one smooth surface share at a position: see
/// [`Numbered::smooth`].
fn surface_bits(vertex: &Vertex) -> [[u32; 3]; 2] {
    [vertex.position, vertex.normal].map(point::bits)
}
