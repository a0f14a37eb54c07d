//! Bases of triangles: which sides meet, and the points of patches.

mod adapted;
mod corners;
mod creases;
mod cubic;
mod cull;
mod edges;
mod halves;
mod near;
mod profile;

use glam::{DVec3, Vec3};
use relief_core::mesh::{BasePoint, Mesh, Vertex};

pub use self::adapted::Adapted;
use self::corners::Corners;
use self::creases::Creases;
use self::edges::{Division, Edges};
use crate::edge::Divides;
use crate::error::MOST;
use crate::patch::{Patch, PatchPoint};
use crate::surface::{Frame, Placed, Relief};
use crate::view::{Voxel, log2};
use crate::{BaseSurface, MeshSettings, MesherError, Seams, Weights, point};

/// A base of triangles, with the points of its sides counted.
#[derive(Debug)]
pub struct Triangles {
    corners: Corners,
    edges: Edges,
    triangles: Vec<[u32; 3]>,
    /// Where the vertices are in grid space; empty where the sides do not go by it.
    voxels: Vec<Voxel>,
    /// Texels of the map that a voxel is wide around each vertex where its depth is 1; empty where no coarser
    /// level is seen.
    footprints: Vec<f64>,
    base: BaseSurface,
    is_welded: bool,
    can_fold: bool,
    /// The triangle of the whole mesh that each is a part of; empty where they are these.
    whole: Vec<u32>,
    /// From where to where along the view axis all patches may lie, also those that were left out.
    depths_m: Option<[f64; 2]>,
}

/// A vertex of the mesh that is made: its number, and which vertices have the same normal.
#[derive(Clone, Copy, Debug)]
pub struct Numbered {
    pub number: u32,
    /// The number of the first vertex at the same position of the same surface.
    pub smooth: u32,
}

impl Numbered {
    /// One that has its normal for itself.
    pub fn both(number: u32) -> Self {
        Self { number, smooth: number }
    }
}

impl Triangles {
    pub fn new(mesh: &Mesh, relief: &Relief, settings: &MeshSettings) -> Result<Self, MesherError> {
        let is_welded = settings.seams == Seams::Weld;
        let sides = relief.sides();
        let mut point_of = mesh.welded();
        let mut corners = Corners::new(mesh, &point_of, is_welded);
        let (mut creases, mut halved) = (None, None);
        if let Divides::Along(_) = settings.edges.divides {
            let tolerance = relief.tolerance(settings.error_m, corners.longest());
            let found = Creases::new(relief, tolerance)?;
            found.check(relief, settings, corners.longest())?;
            halves::check(mesh, relief, settings)?;
            halved = halves::halved(mesh, relief, |halves, triangles| halves.beyond(&found, triangles))?;
            creases = Some(found);
        }
        if let Divides::Voxels(parts) = settings.edges.divides {
            halved = near::halved(mesh, relief, parts, settings)?;
        }
        if let Some(halved) = &halved {
            point_of = halved.mesh.welded();
            corners = Corners::new(&halved.mesh, &point_of, is_welded).between(&corners, &halved.parents);
        }
        let mesh = halved.as_ref().map_or(mesh, |halved| &halved.mesh);
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
                        profile::Edge { ends: ends.map(|end| corners.base(end)), reach: a.min(b) }
                    };
                    let edges: Vec<profile::Edge> = all.iter().map(edge).collect();
                    Ok(profile::division(relief, creases, &edges, along, settings))
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
            is_welded,
            can_fold,
            whole,
            depths_m: None,
        })
    }

    /// What a vertex counts along the sides that it is an end of.
    fn share(&self, vertex: u32) -> f64 {
        self.voxels.get(vertex as usize).map_or(1.0, |voxel| voxel.share)
    }

    /// How many patches there are.
    pub fn count(&self) -> u32 {
        self.triangles.len() as u32
    }

    /// A patch as interiors see it.
    pub fn patch(&self, patch: u32) -> Patch<'static> {
        let parts = self.edges.sides(patch).map(|edge| self.edges.parts(edge));
        let voxel = |vertex: u32| self.voxels.get(vertex as usize).map_or([0; 3], |voxel| voxel.at);
        Patch::Triangle { parts, voxels: self.triangles[patch as usize].map(voxel) }
    }

    /// Vertices at corners of the base.
    pub fn corner_count(&self) -> u32 {
        self.corners.used.len() as u32
    }

    /// Edges of the base; an edge is there once for every pair of vertices at its ends.
    pub fn edge_count(&self) -> u32 {
        self.edges.count()
    }

    /// Vertices between the ends of an edge.
    pub fn points_of_edge(&self, edge: u32) -> u32 {
        self.edges.points(edge)
    }

    /// Vertices at corners and along edges.
    pub fn border_count(&self) -> u64 {
        self.edges.end()
    }

    /// The level of the map that is seen at a point of an edge or a triangle, by the weights of its corners:
    /// that whose texels are as wide as the voxel there.
    ///
    /// Gumhold and Hüttner 1999 take it from how far apart points are (section 4.1), along an edge two of
    /// them. Two edges that meet would not agree in their corner; the size of a voxel is the same for both.
    fn level<const N: usize>(&self, corners: [u32; N], weights: [f64; N]) -> f64 {
        if self.footprints.is_empty() {
            return 0.0;
        }
        let (mut depth, mut texels) = (0.0, 0.0);
        for (vertex, weight) in corners.into_iter().zip(weights) {
            depth += weight / self.share(vertex);
            texels += weight * self.footprints[vertex as usize];
        }
        log2((texels * depth).max(1.0))
    }

    /// A corner as the displacement sees it: in a welded mesh all sides see the same.
    fn at_corner(&self, vertex: u32) -> Placed {
        let seen = self.corners.seen(vertex);
        Placed { level: self.level([seen], [1.0]), ..Placed::new(self.corners.base(seen)) }
    }

    /// A point along an edge as the displacement sees it: in a welded mesh all sides see the same.
    fn on_edge(&self, edge: u32, at: u32) -> Placed {
        let seen = self.seen(edge);
        let weights = self.along(edge, at);
        let [a, b] = self.edges.ends(seen).map(|end| self.corners.base(end));
        let mut base = BasePoint {
            position: point::between(a.position, b.position, weights),
            normal: point::between(a.normal, b.normal, weights),
            uv: point::between(a.uv, b.uv, weights),
        };
        let [of_a, of_b] = weights;
        let sum = of_a + of_b;
        let parts = weights.map(|of| of / sum);
        if self.base == BaseSurface::Pn {
            base.position = cubic::on_side([a.position, b.position], self.bent(edge), parts);
        }
        let lift_m = self.lift(seen) * (of_b * of_a / (sum * sum));
        Placed { base, lift_m, level: self.level(self.edges.ends(seen), parts) }
    }

    /// The edge between the same positions that says where the points of an edge are.
    fn seen(&self, edge: u32) -> u32 {
        if self.is_welded { self.edges.first_at_seam(edge) } else { edge }
    }

    /// The inner control points of an edge that is a cubic, as its ends are ordered.
    fn bent(&self, edge: u32) -> [DVec3; 2] {
        cubic::bent(self.edges.ends(self.seen(edge)).map(|end| self.corners.base(end)))
    }

    /// The weights that the ends of an edge have at a point of it.
    fn along(&self, edge: u32, at: u32) -> [f64; 2] {
        let shares = self.edges.ends(edge).map(|end| self.share(end));
        let [before, all] = self.edges.place(edge, at);
        point::weights(shares, before, all)
    }

    fn lift(&self, edge: u32) -> f64 {
        if self.base == BaseSurface::Lift { self.edges.lift(edge) } else { 0.0 }
    }

    /// The vertex at a corner of the base, by its number among these.
    pub fn corner_vertex(&self, relief: &Relief, number: u32) -> Vertex {
        let vertex = self.corners.used[number as usize];
        let seen = self.at_corner(vertex);
        let own = Placed { base: self.corners.base(vertex), ..seen };
        relief.vertex(relief.displaced(&seen), &own, &self.corners.frame(vertex))
    }

    /// How a corner of the base is numbered, by its number among these.
    pub fn corner_numbered(&self, number: u32) -> Numbered {
        self.corners.numbered(self.corners.used[number as usize])
    }

    /// How a vertex along an edge is numbered.
    pub fn edge_numbered(&self, edge: u32, at: u32) -> Numbered {
        self.edges.numbered(edge, at)
    }

    /// The vertex along an edge.
    pub fn edge_vertex(&self, relief: &Relief, edge: u32, at: u32) -> Vertex {
        let seen = self.on_edge(edge, at);
        let weights = self.along(edge, at);
        let part = weights[1] / (weights[0] + weights[1]);
        let [a, b] = self.edges.ends(edge);
        let frames = [a, b, a].map(|end| self.corners.frame(end));
        let frame = Frame::weighted(frames, [1.0 - part, part, 0.0]);
        let [a, b] = [a, b].map(|end| self.corners.base(end));
        let base = BasePoint { uv: point::between(a.uv, b.uv, weights), ..seen.base };
        relief.vertex(relief.displaced(&seen), &Placed { base, ..seen }, &frame)
    }

    /// The edge that a side of a patch is, and whether both run the same way.
    fn side(&self, patch: u32, side: u32) -> (u32, bool) {
        let edge = self.edges.sides(patch)[side as usize];
        let from = self.triangles[patch as usize][side as usize];
        (edge, self.edges.ends(edge)[0] == from)
    }

    /// The edge that a side of a patch is, and where on it a point of the side lies: edges are counted from
    /// the end that comes first by its bits, and not as the patch runs.
    fn on_side(&self, patch: u32, side: u32, at: u32) -> (u32, u32) {
        let (edge, is_forth) = self.side(patch, side);
        (edge, if is_forth { at } else { self.edges.parts(edge) - at })
    }

    /// The number and the position of a point of the border of a patch.
    pub fn border(&self, relief: &Relief, patch: u32, side: u32, at: u32) -> (Numbered, Vec3) {
        if at == 0 {
            let vertex = self.triangles[patch as usize][side as usize];
            let position = relief.displaced(&self.at_corner(vertex));
            return (self.corners.numbered(vertex), point::stored(position));
        }
        let (edge, at) = self.on_side(patch, side, at);
        let position = relief.displaced(&self.on_edge(edge, at));
        (self.edges.numbered(edge, at), point::stored(position))
    }

    /// Whether its points move along different directions.
    pub fn can_fold(&self) -> bool {
        self.can_fold
    }

    /// The directions of displacement at the corners of a patch, of any length.
    pub fn directions(&self, patch: u32) -> [DVec3; 3] {
        self.triangles[patch as usize].map(|vertex| self.at_corner(vertex).base.normal)
    }

    /// The direction of displacement at a point of a patch, of any length.
    pub fn direction(&self, patch: u32, point: &PatchPoint) -> DVec3 {
        match *point {
            PatchPoint::Border { side, at: 0 } => self.directions(patch)[side as usize],
            PatchPoint::Border { side, at } => {
                let (edge, at) = self.on_side(patch, side, at);
                self.on_edge(edge, at).base.normal
            }
            PatchPoint::Inner { weights, .. } => self.inside(patch, weights).0.base.normal,
        }
    }

    /// The number of the mesh's triangle that a patch is, or a part of.
    pub fn whole(&self, patch: u32) -> u32 {
        self.whole.get(patch as usize).copied().unwrap_or(patch)
    }

    /// The middle of a patch.
    pub fn middle(&self, patch: u32) -> DVec3 {
        let [a, b, c] = self.triangles[patch as usize].map(|vertex| self.corners.base(vertex).position);
        (a + b + c) / 3.0
    }

    /// An inner point, and its weights.
    fn inside(&self, patch: u32, [b, c]: [f64; 2]) -> (Placed, [f64; 3]) {
        let corners = self.triangles[patch as usize];
        let mut weights = [1.0 - b - c, b, c];
        if !self.voxels.is_empty() {
            let of_corners = [0, 1, 2].map(|k| weights[k] * self.share(corners[k]));
            let sum = of_corners[0] + of_corners[1] + of_corners[2];
            weights = of_corners.map(|of| of / sum);
        }
        let mut base = BasePoint::weighted(corners.map(|vertex| self.corners.base(vertex)), weights);
        let sides = self.edges.sides(patch);
        if self.base == BaseSurface::Pn {
            let bent = [0, 1, 2].map(|k| {
                let [first, second] = self.bent(sides[k]);
                let is_forth = self.edges.ends(sides[k])[0] == corners[k];
                if is_forth { [first, second] } else { [second, first] }
            });
            base.position =
                cubic::inside(corners.map(|vertex| self.corners.base(vertex).position), bent, weights);
        }
        let lifts = [0, 1, 2].map(|k| self.lift(self.seen(sides[k])) * weights[k] * weights[(k + 1) % 3]);
        let lift_m = lifts[0] + lifts[1] + lifts[2];
        (Placed { base, lift_m, level: self.level(corners, weights) }, weights)
    }

    /// The position of an inner point.
    pub fn inner(&self, relief: &Relief, patch: u32, weights: [f64; 2]) -> Vec3 {
        let (placed, _) = self.inside(patch, weights);
        point::stored(relief.displaced(&placed))
    }

    /// The vertex at an inner point that lies at a height of the map.
    fn inner_vertex_at(&self, relief: &Relief, patch: u32, weights: [f64; 2], height: f64) -> Vertex {
        let (placed, weights) = self.inside(patch, weights);
        self.vertex_inside(relief, patch, &relief.at_height(&placed, height), weights)
    }

    /// The vertex at an inner point.
    pub fn inner_vertex(&self, relief: &Relief, patch: u32, weights: [f64; 2]) -> Vertex {
        let (placed, weights) = self.inside(patch, weights);
        self.vertex_inside(relief, patch, &placed, weights)
    }

    fn vertex_inside(&self, relief: &Relief, patch: u32, placed: &Placed, weights: [f64; 3]) -> Vertex {
        let corners = self.triangles[patch as usize];
        let frame = Frame::weighted(corners.map(|vertex| self.corners.frame(vertex)), weights);
        relief.vertex(relief.displaced(placed), placed, &frame)
    }
}

/// The length of the longest direction of displacement of the triangles around each vertex.
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

/// Texels of a map of so many columns and rows in a metre around a vertex, along `u` or `v`, whichever has
/// more. None where the texture has no extent.
fn texels_per_metre(vertex: &Vertex, sides: [f64; 2]) -> f64 {
    let along = [vertex.tangent, vertex.bitangent].map(|tangent| tangent.as_dvec3().length());
    let texels = [0, 1].map(|axis| sides[axis] / along[axis]).into_iter().filter(|texels| texels.is_finite());
    texels.fold(0.0, f64::max)
}

/// A number of points as the mesh counts them, if that many are possible.
fn counted(points: u64) -> Result<u32, MesherError> {
    match u32::try_from(points) {
        Ok(points) if u64::from(points) <= MOST => Ok(points),
        _ => Err(MesherError::TooLarge { vertices: points, triangles: 0 }),
    }
}

/// What vertices of one smooth surface have in common at a position: see [`Numbered::smooth`].
fn surface_bits(vertex: &Vertex) -> [[u32; 3]; 2] {
    [vertex.position, vertex.normal].map(point::bits)
}
