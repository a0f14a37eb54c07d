//! Displaced meshes, counted first and made block by block.

use std::convert::Infallible;
use std::sync::atomic::Ordering;

use glam::{DVec3, Vec2, Vec3};
use rayon::prelude::*;
use relief_core::HeightMap;
use relief_core::mesh::{Mesh, MeshBlock, PositionGrid, Vertex};

use crate::cache_order::cache_order;
use crate::crack::{CrackPart, CrackTest, Cracks};
use crate::edge::Divides;
use crate::error::MOST;
use crate::filling::Filling;
use crate::folds::{self, FoldedBase, Folds};
use crate::interior::{Cut, Fills, Pattern};
use crate::patch::{Patch, PatchPoint};
use crate::plan::{Plan, Work};
use crate::plane::{Adapted, Faces, Grid, Rectangle, Solid, Tile};
use crate::smooth::{self, Normals};
use crate::surface::Relief;
use crate::triangles::{self, Numbered, Triangles};
use crate::{
    Certificate, MeshSettings, MesherError, Part, Shading, Spacing, StreamError, Watch, Weights, check_pair,
};

/// Bytes of a vertex and a triangle of a block, whichever takes more, while it is made and looked at.
const BYTES_IN_A_BLOCK: u64 = 480;

/// Blocks that a thread has at hand.
const BLOCKS_PER_THREAD: usize = 2;

/// A displaced mesh that is known to the last vertex, and not made yet.
#[derive(Debug)]
pub struct Mesher {
    base: Base,
    solid: Option<Solid>,
    relief: Relief,
    shading: Shading,
    blocks: Vec<Work>,
    vertices: u64,
    triangles: u64,
    bytes: u64,
}

#[derive(Debug)]
enum Base {
    Triangles(Triangles, Pattern),
    Filled(triangles::Adapted),
    Grid(Grid, Pattern),
    Adapted(Adapted),
}

impl Base {
    /// The base of one that is not a plane.
    fn triangles(&self) -> Option<&Triangles> {
        match self {
            Self::Triangles(base, _) => Some(base),
            Self::Filled(filled) => Some(filled.base()),
            Self::Grid(..) | Self::Adapted(_) => None,
        }
    }

    /// Walls and a bottom under a plane.
    fn solid(&self, relief: &Relief, solid_m: f64) -> Option<Solid> {
        let map = relief.map();
        let lowest_m = relief.metres(f64::from(map.extremes()[0]));
        match self {
            Self::Triangles(..) | Self::Filled(_) => None,
            Self::Grid(grid, _) => Some(Solid::new(grid.walls(relief), lowest_m - solid_m)),
            Self::Adapted(plane) => {
                // Triangles may lie below the relief by their error.
                let lowest_m = lowest_m - plane.certificate().error_m;
                Some(Solid::new(plane.walls(relief), lowest_m - solid_m))
            }
        }
    }

    /// The rectangle of a plane.
    fn rectangle(&self) -> Option<&Rectangle> {
        match self {
            Self::Triangles(..) | Self::Filled(_) => None,
            Self::Grid(grid, _) => Some(grid.rectangle()),
            Self::Adapted(plane) => Some(plane.rectangle()),
        }
    }
}

/// How a mesh is handed over.
#[derive(Clone, Copy, Debug)]
pub struct Stream<'a> {
    /// Factor on all positions.
    pub size: f64,
    /// Whether the mesh is looked at for cracks.
    pub check: bool,
    /// The lattice that positions are rounded to, after they are made larger or smaller. Cracks are looked
    /// for in what this leaves.
    pub grid: Option<PositionGrid>,
    /// Whether the triangles of a block are put in an order in which a GPU finds most of their corners in
    /// its cache.
    pub cache_order: bool,
    /// Who watches.
    pub watch: Watch<'a>,
}

/// What is known of a mesh that was handed over.
#[derive(Clone, Debug, PartialEq)]
pub struct Streamed {
    /// The least and the greatest corner of a box around it, in metres.
    pub bounds_m: [Vec3; 2],
    /// What there is of cracks, if it was looked at.
    pub cracks: Option<Cracks>,
    /// What was folded over.
    pub folds: Folds,
    /// What a lattice changed, if there was one.
    pub rounded: Option<Rounded>,
}

/// What became of a mesh whose positions were rounded to a lattice.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rounded {
    /// The farthest that a vertex was moved, in metres. No point of the surface was moved farther.
    pub greatest_m: f64,
    /// Triangles that had an area and have none now.
    pub without_area: u64,
}

impl Rounded {
    /// What became of two meshes together.
    #[must_use]
    pub fn with(self, other: Self) -> Self {
        Self {
            greatest_m: self.greatest_m.max(other.greatest_m),
            without_area: self.without_area + other.without_area,
        }
    }
}

/// The least and the greatest numbers of a mesh's vertices.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// The positions, in metres.
    pub positions_m: [Vec3; 2],
    /// The texture coordinates.
    pub uvs: [Vec2; 2],
}

impl Bounds {
    /// Those of two meshes together.
    #[must_use]
    pub fn with(&self, other: &Self) -> Self {
        let ([a, b], [c, d]) = (self.positions_m, other.positions_m);
        let ([e, f], [g, h]) = (self.uvs, other.uvs);
        Self { positions_m: [a.min(c), b.max(d)], uvs: [e.min(g), f.max(h)] }
    }
}

/// A block that was made.
struct Made {
    block: MeshBlock,
    part: Option<CrackPart>,
    /// The smooth numbers of the triangles' corners.
    smooth: Vec<[u32; 3]>,
    bounds_m: [Vec3; 2],
    /// What is folded over, in the order of the base's triangles.
    folds: Vec<FoldedBase>,
    rounded: Rounded,
}

/// No box around nothing.
const EMPTY: [Vec3; 2] = [Vec3::INFINITY, Vec3::NEG_INFINITY];

impl Mesher {
    /// Counts the displaced mesh of a base and a height map: a base point is displaced by the map's
    /// [`displacement_m`](HeightMap::displacement_m) of the bilinear height at its texture coordinates, along
    /// its normal, by the formula of [`BasePoint`](relief_core::mesh::BasePoint).
    ///
    /// A mesh of two triangles that make a rectangle with straight texture is a plane, and cut along the
    /// lines of texels: its vertices are where the lines of the edge rule meet, with the border.
    ///
    /// The same input gives the same bits, whatever the number of threads.
    ///
    /// With the interior `adapt` the triangles are found here, because there is no other way to count them,
    /// and held. Its [`certificate`](Self::certificate) says how far the relief is from them.
    ///
    /// # Errors
    ///
    /// When edge rule and interior make no mesh together or not of this base, a setting is out of range, the
    /// tolerance cannot be kept, the base has no triangles, or the mesh would have more vertices or triangles
    /// than 32-bit numbers count, or take more than the memory allowed.
    pub fn new(mesh: &Mesh, map: &HeightMap, settings: &MeshSettings) -> Result<Self, MesherError> {
        Self::watched(mesh, map, settings, &Watch::NOBODY)
    }

    /// The same as [`new`](Self::new), watched.
    ///
    /// # Errors
    ///
    /// The same, and when it is cancelled.
    pub fn watched(
        mesh: &Mesh,
        map: &HeightMap,
        settings: &MeshSettings,
        watch: &Watch,
    ) -> Result<Self, MesherError> {
        Self::of_at_most(mesh, map, settings, MOST, watch)
    }

    /// The same for a view, with coarser levels of the height map, each half as wide and high as the one
    /// before: a point is displaced by the level whose texels are as wide as a voxel is there, and in between
    /// by two of them. See the filter levels of `relief-bake`.
    ///
    /// # Errors
    ///
    /// The same, and when the sides are not divided by voxels.
    pub fn with_levels(
        mesh: &Mesh,
        map: &HeightMap,
        coarser: &[HeightMap],
        settings: &MeshSettings,
        watch: &Watch,
    ) -> Result<Self, MesherError> {
        if !matches!(settings.edges.divides, Divides::Voxels(_)) {
            return Err(MesherError::LevelsOfNoView { edges: settings.edges.name });
        }
        let relief = Relief::new(map, settings.directions, settings.shading).with_levels(coarser);
        Self::of_relief(mesh, relief, settings, MOST, watch)
    }

    /// The mesh, with as many triangles at most.
    pub(crate) fn of_at_most(
        mesh: &Mesh,
        map: &HeightMap,
        settings: &MeshSettings,
        most: u64,
        watch: &Watch,
    ) -> Result<Self, MesherError> {
        let relief = Relief::new(map, settings.directions, settings.shading);
        Self::of_relief(mesh, relief, settings, most, watch)
    }

    fn of_relief(
        mesh: &Mesh,
        relief: Relief,
        settings: &MeshSettings,
        most: u64,
        watch: &Watch,
    ) -> Result<Self, MesherError> {
        check_pair(settings.edges, settings.interior)?;
        if settings.texels == 0 {
            return Err(MesherError::NoTexels);
        }
        if mesh.triangles().is_empty() {
            return Err(MesherError::Empty);
        }
        let rectangle = Rectangle::of_mesh(mesh);
        if rectangle.is_none() && settings.part != Part::WHOLE {
            return Err(MesherError::PartOfNoPlane);
        }
        if let Some(solid_m) = settings.solid_m.filter(|solid_m| !(*solid_m > 0.0 && solid_m.is_finite())) {
            return Err(MesherError::BadSolid { solid_m });
        }
        if rectangle.is_none() && settings.solid_m.is_some() {
            return Err(MesherError::SolidOfNoPlane);
        }
        if matches!(settings.edges.divides, Divides::Voxels(_)) && settings.solid_m.is_some() {
            return Err(MesherError::SolidOfView);
        }
        settings.weights.check()?;
        let interior = settings.interior;
        if settings.weights != Weights::NONE && !interior.takes.contains(&Spacing::Even) {
            return Err(MesherError::Weighted { interior: interior.name, why: interior.why });
        }
        let mut patches = mesh.triangles().len();
        let base = match (settings.interior.fills, settings.edges.divides, rectangle) {
            (Fills::Patch(pattern), Divides::Evenly(evenly), Some(rectangle)) => {
                Base::Grid(Grid::new(rectangle, &relief, &evenly, settings)?, pattern)
            }
            (Fills::Patch(pattern), Divides::Voxels(_), Some(rectangle)) => {
                let tiles = rectangle.tiles(&relief, settings.part)?;
                patches = tiles.triangles().len();
                Base::Triangles(Triangles::new(&tiles, &relief, settings)?, pattern)
            }
            (Fills::Patch(pattern), _, None) => {
                Base::Triangles(Triangles::new(mesh, &relief, settings)?, pattern)
            }
            (Fills::Ground(fill), Divides::Along(side), rectangle) => {
                if !(settings.error_m > 0.0 && settings.error_m.is_finite()) {
                    return Err(MesherError::BadTolerance { error_m: settings.error_m });
                }
                let filling = Filling { fill, side, most };
                match rectangle {
                    Some(plane) => Base::Adapted(Adapted::new(plane, &relief, settings, filling, watch)?),
                    None => Base::Filled(triangles::Adapted::new(mesh, &relief, settings, filling, watch)?),
                }
            }
            (Fills::Patch(_), Divides::Along(_), Some(_)) | (Fills::Ground(_), ..) => {
                // Pairs were checked, and their spacings are as they divide.
                let (edges, interior) = (settings.edges.name, settings.interior.name);
                return Err(MesherError::Pair { edges, interior, why: settings.interior.why });
            }
        };
        let solid = settings.solid_m.and_then(|solid_m| base.solid(&relief, solid_m));
        let mut plan = Plan::default();
        match &base {
            Base::Triangles(triangles, pattern) => plan.triangles(triangles, pattern)?,
            Base::Grid(grid, pattern) => plan.grid(grid, pattern)?,
            Base::Filled(filled) => plan.filled(filled),
            Base::Adapted(plane) => plan.adapted(plane),
        }
        if let Some(solid) = &solid {
            plan.solid(solid)?;
        }
        let Plan { blocks, vertices, triangles, largest } = plan;
        let at_hand = rayon::current_num_threads() * BLOCKS_PER_THREAD;
        let of_normals =
            if settings.shading == Shading::Mesh { vertices * smooth::BYTES_PER_VERTEX } else { 0 };
        let of_tiles = match &base {
            Base::Triangles(..) | Base::Grid(..) => 0,
            Base::Filled(filled) => filled.bytes(),
            Base::Adapted(plane) => plane.bytes(),
        };
        let bytes = patches as u64 * Self::BYTES_PER_TRIANGLE
            + (blocks.len() * size_of::<Work>()) as u64
            + of_normals
            + of_tiles
            + at_hand as u64 * largest * BYTES_IN_A_BLOCK;
        Ok(Self { base, solid, relief, shading: settings.shading, blocks, vertices, triangles, bytes })
    }

    /// Whether a mesh is a plane: two triangles that make a rectangle with straight texture.
    pub fn is_plane(mesh: &Mesh) -> bool {
        Rectangle::of_mesh(mesh).is_some()
    }

    /// How far the relief is from the triangles, if they were made to a tolerance.
    pub fn certificate(&self) -> Option<&Certificate> {
        match &self.base {
            Base::Triangles(..) | Base::Grid(..) => None,
            Base::Filled(filled) => Some(filled.certificate()),
            Base::Adapted(plane) => Some(plane.certificate()),
        }
    }

    /// The most memory that a triangle of the base takes, in bytes.
    pub const BYTES_PER_TRIANGLE: u64 = 480;

    /// Vertices of the mesh.
    pub fn vertices(&self) -> u64 {
        self.vertices
    }

    /// Triangles of the mesh.
    pub fn triangles(&self) -> u64 {
        self.triangles
    }

    /// The most memory that it takes to hand the mesh over, in bytes, besides the height map and whatever the
    /// blocks are made into. Looking for cracks takes some more, for the borders between blocks.
    pub fn bytes(&self) -> u64 {
        self.bytes
    }

    /// Hands the mesh over, block by block, in an order of its own that is always the same.
    ///
    /// # Errors
    ///
    /// When the sink fails, it is cancelled, or a vertex lies beyond what `f32` holds. What was handed over
    /// until then is worth nothing.
    pub fn stream<E>(
        &self,
        how: &Stream,
        mut sink: impl FnMut(&MeshBlock) -> Result<(), E>,
    ) -> Result<Streamed, StreamError<E>> {
        let mut normals = None;
        // With normals of triangles the mesh is made twice.
        let mut rounds = 1.0;
        if self.shading == Shading::Mesh {
            rounds = 2.0;
            let mut sums = Normals::new(self.vertices);
            let plain = Stream { check: false, grid: None, cache_order: false, ..*how };
            self.each_block(&plain, None, &|part| (how.watch.tell)(part / 2.0), |made| {
                sums.add(&made.block.points, &made.smooth);
                Ok(())
            })?;
            normals = Some(sums);
        }
        let mut test = how.check.then(CrackTest::default);
        let (mut bounds_m, mut folds, mut rounded) = (EMPTY, Folds::default(), Rounded::default());
        let tell = |part: f32| (how.watch.tell)(1.0 - (1.0 - part) / rounds);
        self.each_block(how, normals.as_ref(), &tell, |made| {
            if let (Some(test), Some(part)) = (&mut test, made.part) {
                test.add(part);
            }
            let [least, greatest] = made.bounds_m;
            bounds_m = [bounds_m[0].min(least), bounds_m[1].max(greatest)];
            for found in made.folds {
                folds.add(FoldedBase { middle_m: found.middle_m * how.size, ..found });
            }
            rounded = rounded.with(made.rounded);
            sink(&made.block).map_err(StreamError::Sink)
        })?;
        Ok(Streamed {
            bounds_m,
            cracks: test.map(CrackTest::finish),
            folds,
            rounded: how.grid.map(|_| rounded),
        })
    }

    /// The least and the greatest numbers of the vertices of the mesh, made larger by a factor. All of the
    /// mesh is made for that and thrown away.
    ///
    /// # Errors
    ///
    /// When it is cancelled, or a vertex lies beyond what `f32` holds.
    pub fn bounds(&self, size: f64, watch: &Watch) -> Result<Bounds, StreamError<Infallible>> {
        let how = Stream { size, check: false, grid: None, cache_order: false, watch: *watch };
        let mut bounds = Bounds { positions_m: EMPTY, uvs: [Vec2::INFINITY, Vec2::NEG_INFINITY] };
        self.each_block(&how, None, &watch.tell, |made| {
            let ([least, greatest], [low, high]) = (made.bounds_m, bounds.positions_m);
            bounds.positions_m = [low.min(least), high.max(greatest)];
            for vertex in &made.block.vertices {
                bounds.uvs = [bounds.uvs[0].min(vertex.uv), bounds.uvs[1].max(vertex.uv)];
            }
            Ok(())
        })?;
        Ok(bounds)
    }

    /// The whole mesh.
    ///
    /// # Errors
    ///
    /// When a vertex lies beyond what `f32` holds.
    pub fn mesh(&self) -> Result<Mesh, StreamError<Infallible>> {
        let watch = Watch::NOBODY;
        let how = Stream { size: 1.0, check: false, grid: None, cache_order: false, watch };
        let mut vertices = Vec::with_capacity(self.vertices as usize);
        let mut triangles = Vec::with_capacity(self.triangles as usize);
        self.stream(&how, |block| {
            vertices.extend_from_slice(&block.vertices);
            triangles.extend_from_slice(&block.triangles);
            Ok(())
        })?;
        Ok(Mesh::new(vertices, triangles)?)
    }

    /// Makes all blocks, some at a time, and takes them one after the other.
    fn each_block<E>(
        &self,
        how: &Stream,
        normals: Option<&Normals>,
        tell: &dyn Fn(f32),
        mut take: impl FnMut(Made) -> Result<(), StreamError<E>>,
    ) -> Result<(), StreamError<E>> {
        let at_hand = rayon::current_num_threads() * BLOCKS_PER_THREAD;
        let mut done = 0;
        for group in self.blocks.chunks(at_hand) {
            if how.watch.cancel.load(Ordering::Relaxed) {
                return Err(StreamError::Cancelled);
            }
            let made: Vec<Option<Made>> =
                group.par_iter().map(|work| self.made(work, how, normals)).collect();
            for made in made {
                take(made.ok_or(StreamError::NotFinite)?)?;
            }
            done += group.len();
            tell(done as f32 / self.blocks.len() as f32);
        }
        Ok(())
    }

    /// A block; none where a position is not finite.
    fn made(&self, work: &Work, how: &Stream, normals: Option<&Normals>) -> Option<Made> {
        let local = how.cache_order.then(Vec::new);
        let mut making = Making { normals, local, ..Making::default() };
        match (&self.base, work) {
            (Base::Triangles(base, pattern), Work::Patches { from, to, first_inner, first_vertex }) => {
                self.patches(base, pattern, [*from, *to], [*first_inner, *first_vertex], &mut making);
            }
            (Base::Grid(grid, pattern), Work::Tile(number)) => {
                self.tile(grid, pattern, &grid.tile(*number), &mut making);
            }
            (Base::Adapted(plane), Work::Corners(range)) => {
                for number in range.clone() {
                    making.vertex(plane.corner_vertex(&self.relief, number), Numbered::both(number));
                }
            }
            (Base::Adapted(plane), Work::Edges(range)) => {
                for side in range.clone() {
                    for at in 0..plane.points_of_side(side) {
                        let vertex = plane.side_vertex(&self.relief, side, at);
                        making.vertex(vertex, Numbered::both(plane.first_of_side(side) + at));
                    }
                }
            }
            (Base::Adapted(plane), Work::Tile(number)) => self.filled_tile(plane, *number, &mut making),
            (Base::Filled(filled), Work::Filled(range)) => {
                for patch in range.clone() {
                    self.filled_patch(filled, patch, &mut making);
                }
            }
            (base, Work::Solid(first)) => {
                if let (Some(solid), Some(rectangle)) = (&self.solid, base.rectangle()) {
                    making.faces(solid.faces(rectangle, &self.relief), *first, rectangle.is_turned);
                }
            }
            (base, Work::Corners(range)) => {
                if let Some(base) = base.triangles() {
                    for number in range.clone() {
                        making.vertex(base.corner_vertex(&self.relief, number), base.corner_numbered(number));
                    }
                }
            }
            (base, Work::Edges(range)) => {
                if let Some(base) = base.triangles() {
                    for edge in range.clone() {
                        for at in 1..=base.points_of_edge(edge) {
                            let vertex = base.edge_vertex(&self.relief, edge, at);
                            making.vertex(vertex, base.edge_numbered(edge, at));
                        }
                    }
                }
            }
            // The plan of one base has no work of the other.
            _ => {}
        }
        making.order();
        let Making { mut block, smooth, folds, .. } = making;
        scale(&mut block, how.size);
        let rounded = how.grid.map(|grid| round(&mut block, &grid)).unwrap_or_default();
        let positions = block.vertices.iter().map(|vertex| vertex.position);
        let bounds_m = positions.clone().fold(EMPTY, |[low, high], at| [low.min(at), high.max(at)]);
        if !positions.clone().all(|position| position.is_finite()) {
            return None;
        }
        let part = how.check.then(|| CrackPart::of(block.points.iter().copied()));
        Some(Made { block, part, smooth, bounds_m, folds, rounded })
    }

    fn patches(
        &self,
        base: &Triangles,
        pattern: &Pattern,
        [from, to]: [[u32; 2]; 2],
        first: [u32; 2],
        making: &mut Making,
    ) {
        let [mut first_inner, mut first_vertex] = first;
        let mut cut = Cut::default();
        let mut points: Vec<(Numbered, Vec3)> = Vec::new();
        for patch in from[0]..=to[0].min(base.count() - 1) {
            let shape = base.patch(patch);
            let begin = if patch == from[0] { from[1] } else { 0 };
            let end = if patch == to[0] { to[1] } else { (pattern.steps)(&shape) };
            if begin == end {
                first_inner = 0;
                continue;
            }
            cut.clear();
            points.clear();
            (pattern.cut)(&shape, begin..end, first_inner, &mut cut);
            let mut own = 0;
            for point in &cut.points {
                points.push(match *point {
                    PatchPoint::Border { side, at } => base.border(&self.relief, patch, side, at),
                    PatchPoint::Inner { number, weights } => {
                        let number_of = first_vertex.wrapping_add(number).wrapping_sub(first_inner);
                        let numbered = Numbered::both(number_of);
                        if number < first_inner {
                            (numbered, base.inner(&self.relief, patch, weights))
                        } else {
                            own += 1;
                            let vertex = base.inner_vertex(&self.relief, patch, weights);
                            (numbered, making.vertex(vertex, numbered))
                        }
                    }
                });
            }
            making.triangles(&cut.triangles, &points, false);
            making.folds.extend(self.folded(base, patch, &cut, &points));
            first_vertex += own;
            first_inner = 0;
        }
    }

    /// What of a patch is folded over.
    fn folded(
        &self,
        base: &Triangles,
        patch: u32,
        cut: &Cut,
        points: &[(Numbered, Vec3)],
    ) -> Option<FoldedBase> {
        if !base.can_fold() {
            return None;
        }
        let of_corners = base.directions(patch);
        let is_folded = |corners: &&[u32; 3]| {
            let positions = corners.map(|corner| points[corner as usize].1);
            // Directions between are sums of the corners'.
            folds::may_be_folded(positions, of_corners) && {
                let direction = |corner: u32| base.direction(patch, &cut.points[corner as usize]);
                folds::is_folded(positions, corners.map(|corner| self.relief.direction(direction(corner))))
            }
        };
        let pieces = cut.triangles.iter().filter(is_folded).count() as u64;
        (pieces > 0).then(|| FoldedBase { triangle: base.whole(patch), pieces, middle_m: base.middle(patch) })
    }

    fn filled_tile(&self, plane: &Adapted, tile: u32, making: &mut Making) {
        let border = plane.border_points(&self.relief, tile);
        let mut points: Vec<(Numbered, Vec3)> =
            border.into_iter().map(|(number, position)| (Numbered::both(number), position)).collect();
        for at in 0..plane.counts(tile)[0] {
            let numbered = Numbered::both(plane.first_of_tile(tile) + at);
            points.push((numbered, making.vertex(plane.inner_vertex(&self.relief, tile, at), numbered)));
        }
        // They turn from `u` to `v`, those of patterns from `v` to `u`.
        making.triangles(plane.triangles(tile), &points, !plane.is_turned());
    }

    fn filled_patch(&self, filled: &triangles::Adapted, patch: u32, making: &mut Making) {
        let cut = filled.cut(patch);
        let mut points = Vec::with_capacity(cut.points.len());
        for point in &cut.points {
            points.push(match *point {
                PatchPoint::Border { side, at } => filled.base().border(&self.relief, patch, side, at),
                PatchPoint::Inner { number, .. } => {
                    let numbered = Numbered::both(filled.first_of_patch(patch) + number);
                    let vertex = filled.inner_vertex(&self.relief, patch, number);
                    (numbered, making.vertex(vertex, numbered))
                }
            });
        }
        making.triangles(&cut.triangles, &points, false);
        making.folds.extend(self.folded(filled.base(), patch, &cut, &points));
    }

    fn tile(&self, plane: &Grid, pattern: &Pattern, tile: &Tile, making: &mut Making) {
        let shape = Patch::Tile(plane.lines(tile));
        let mut cut = Cut::default();
        (pattern.cut)(&shape, 0..(pattern.steps)(&shape), 0, &mut cut);
        let mut points = Vec::with_capacity(cut.points.len());
        for point in &cut.points {
            if let PatchPoint::Border { side, at } = *point {
                let lines = [tile.first[0] + side as usize, tile.first[1] + at as usize];
                let number = plane.number(lines);
                let numbered = Numbered::both(number);
                let position = if Grid::is_own(tile, lines) {
                    making.vertex(plane.vertex(&self.relief, lines), numbered)
                } else {
                    plane.position(&self.relief, lines)
                };
                points.push((numbered, position));
            }
        }
        making.triangles(&cut.triangles, &points, plane.is_turned());
    }
}

/// A block while it is made.
#[derive(Default)]
struct Making<'a> {
    block: MeshBlock,
    smooth: Vec<[u32; 3]>,
    normals: Option<&'a Normals>,
    folds: Vec<FoldedBase>,
    /// The triangles by their places in the points that they were made of, if they are to be ordered.
    local: Option<Vec<[u32; 3]>>,
    /// How many of these points there are.
    points: u32,
}

impl Making<'_> {
    /// Adds a vertex and gives its position.
    fn vertex(&mut self, mut vertex: Vertex, numbered: Numbered) -> Vec3 {
        if let Some(normals) = self.normals {
            vertex.normal = normals.of(numbered.smooth, vertex.normal);
        }
        self.block.vertices.push(vertex);
        vertex.position
    }

    /// Adds faces that have all of their vertices, of which the first has that number.
    fn faces(&mut self, faces: Faces, first: u32, is_turned: bool) {
        let points: Vec<(Numbered, Vec3)> = (first..)
            .map(Numbered::both)
            .zip(faces.vertices)
            .map(|(numbered, vertex)| (numbered, self.vertex(vertex, numbered)))
            .collect();
        self.triangles(&faces.triangles, &points, is_turned);
    }

    fn triangles(&mut self, triangles: &[[u32; 3]], points: &[(Numbered, Vec3)], is_turned: bool) {
        if let Some(local) = &mut self.local {
            local.extend(triangles.iter().map(|corners| corners.map(|corner| self.points + corner)));
            self.points += points.len() as u32;
        }
        for corners in triangles {
            let mut corners = corners.map(|corner| points[corner as usize]);
            if is_turned {
                corners.swap(1, 2);
            }
            self.block.triangles.push(corners.map(|(numbered, _)| numbered.number));
            self.block.points.push(corners.map(|(_, position)| position));
            self.smooth.push(corners.map(|(numbered, _)| numbered.smooth));
        }
    }

    /// Puts the triangles in order, if they are to be.
    fn order(&mut self) {
        let Some(local) = self.local.take() else { return };
        let Some(order) = cache_order(&local, self.points as usize) else { return };
        self.block.triangles = ordered(&self.block.triangles, &order);
        self.block.points = ordered(&self.block.points, &order);
        self.smooth = ordered(&self.smooth, &order);
    }
}

fn ordered<T: Copy>(list: &[T], order: &[u32]) -> Vec<T> {
    order.iter().map(|&at| list[at as usize]).collect()
}

/// Makes a block larger or smaller. Equal positions stay equal.
fn scale(block: &mut MeshBlock, size: f64) {
    if size == 1.0 {
        return;
    }
    let scaled = |vector: Vec3| -> Vec3 { (vector.as_dvec3() * DVec3::splat(size)).as_vec3() };
    for vertex in &mut block.vertices {
        vertex.position = scaled(vertex.position);
        vertex.tangent = scaled(vertex.tangent);
        vertex.bitangent = scaled(vertex.bitangent);
    }
    for point in block.points.as_flattened_mut() {
        *point = scaled(*point);
    }
}

/// Rounds the positions of a block to a lattice.
fn round(block: &mut MeshBlock, grid: &PositionGrid) -> Rounded {
    let mut rounded = Rounded::default();
    for vertex in &mut block.vertices {
        let position = grid.snapped(vertex.position);
        let moved_m = position.as_dvec3().distance(vertex.position.as_dvec3());
        rounded.greatest_m = rounded.greatest_m.max(moved_m);
        vertex.position = position;
    }
    for corners in &mut block.points {
        let had_area = has_area(corners);
        *corners = corners.map(|corner| grid.snapped(corner));
        rounded.without_area += u64::from(had_area && !has_area(corners));
    }
    rounded
}

fn has_area(corners: &[Vec3; 3]) -> bool {
    let [a, b, c] = corners.map(|corner| corner.as_dvec3());
    (b - a).cross(c - a) != DVec3::ZERO
}
