//! Bases of triangles: which sides meet, and the points of patches.

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
use crate::cull::Everything;
use crate::edge::Divides;
use crate::error::MOST;
use crate::patch::{Patch, PatchPoint};
use crate::surface::{Placed, Relief};
use crate::view::{Voxel, log2};
use crate::{BaseSurface, MeshSettings, MesherError, Seams, Side, Weights, cubic, point};

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
    /// Of what its triangles are parts, where a smooth base was halved.
    parts: Option<Parts>,
    /// What keeps triangles on one side of the relief.
    one_side: Option<OneSide>,
    is_welded: bool,
    can_fold: bool,
    /// The triangle of the whole mesh that each is a part of; empty where they are these.
    whole: Vec<u32>,
    /// Its border, where it is to be made solid.
    border: Option<Border>,
    /// Where all patches may lie, also those that were left out.
    everything: Option<Everything>,
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
    /// The base with at most so many triangles of its own, if large ones are cut.
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
                        // A welded mesh is where the first edge at a seam is.
                        let seen = if is_welded { all[0] } else { *ends };
                        let (shape, part) = match &parts {
                            Some(parts) => parts.of_side(seen),
                            None => (
                                along_whole(&corners, seen, settings.base),
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
                            // All are as far from the relief on one side.
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
            everything: None,
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
        let depths = corners.map(|vertex| 1.0 / self.share(vertex));
        level(depths, corners.map(|vertex| self.footprints[vertex as usize]), weights)
    }

    /// A corner as the displacement sees it: in a welded mesh all sides see the same.
    fn at_corner(&self, vertex: u32) -> Placed {
        let seen = self.corners.seen(vertex);
        let level = self.level([seen], [1.0]);
        let mut base = self.corners.base(seen);
        let mut lift_m = self.raise_m();
        if let Some((shape, weights)) = self.parts.as_ref().and_then(|parts| parts.of_vertex(seen)) {
            base.position = shape.position(weights).unwrap_or(base.position);
            lift_m += shape.lift_m(weights);
        }
        Placed { level, lift_m, ..Placed::new(base) }
    }

    /// How a smooth base leaves a patch, and which part of that the patch is; none where it is all of it.
    fn shape(&self, patch: u32) -> (Shape, Option<PartWeights>) {
        if let Some(parts) = &self.parts {
            let (shape, weights) = parts.of_patch(patch);
            return (shape, Some(weights));
        }
        let (corners, sides) = (self.triangles[patch as usize], self.edges.sides(patch));
        let shape = match self.base {
            BaseSurface::Flat => Shape::Flat,
            BaseSurface::Lift => Shape::Lift(sides.map(|side| self.lift(self.seen(side)))),
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

    /// By how much all points are displaced farther, in metres.
    fn raise_m(&self) -> f64 {
        self.one_side.as_ref().map_or(0.0, |side| side.raise_m)
    }

    /// A point along an edge as the displacement sees it: in a welded mesh all sides see the same.
    fn on_edge(&self, edge: u32, at: u32) -> Placed {
        AlongEdge::new(self, edge).placed(self.edges.place(edge, at))
    }

    /// The edge between the same positions that says where the points of an edge are.
    fn seen(&self, edge: u32) -> u32 {
        if self.is_welded { self.edges.first_at_seam(edge) } else { edge }
    }

    /// The inner control points of an edge that is a cubic, as its ends are ordered.
    fn bent(&self, edge: u32) -> [DVec3; 2] {
        cubic::bent(self.edges.ends(self.seen(edge)).map(|end| self.corners.base(end)))
    }

    fn lift(&self, edge: u32) -> f64 {
        if self.base == BaseSurface::Lift { self.edges.lift(edge) } else { 0.0 }
    }

    /// The vertex at a corner of the base, by its number among these.
    pub fn corner_vertex(&self, relief: &Relief, number: u32) -> Vertex {
        let vertex = self.corners.used[number as usize];
        let seen = self.at_corner(vertex);
        let own = Placed { base: self.corners.base(vertex), ..seen };
        relief.vertex_at(relief.displaced(&seen), &own, &self.corners.frame(vertex))
    }

    /// How a corner of the base is numbered, by its number among these.
    pub fn corner_numbered(&self, number: u32) -> Numbered {
        self.corners.numbered(self.corners.used[number as usize])
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

    /// The weights of the two ends of a side of a patch, as it runs, at one of its points.
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
            PatchPoint::Inner { weights, .. } => Inside::new(self, patch).direction(weights),
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
}

/// How a smooth base goes along an edge of a mesh that is not halved.
fn along_whole(corners: &Corners, ends: [u32; 2], base: BaseSurface) -> Shape {
    let [a, b] = ends.map(|end| corners.vertex(end));
    let [along, turn] = [a.position - b.position, a.normal - b.normal].map(|of| of.as_dvec3());
    let edge = WholeEdge { ends: ends.map(|end| corners.base(end)), lift_m: 0.5 * along.dot(turn) };
    Shape::along(&edge, base)
}

/// The level whose texels are as wide as a voxel, where corners lie at those depths in the picture and have
/// so many texels in a voxel where the depth is 1.
fn level<const N: usize>(depths: [f64; N], texels: [f64; N], weights: [f64; N]) -> f64 {
    let (mut depth, mut sum) = (0.0, 0.0);
    for k in 0..N {
        depth += weights[k] * depths[k];
        sum += weights[k] * texels[k];
    }
    log2((sum * depth).max(1.0))
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
