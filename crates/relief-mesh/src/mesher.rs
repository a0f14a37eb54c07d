//! Mesher: counts a displaced mesh first, then makes it block by block.

mod block;
mod outline;
mod solid;

use std::collections::HashMap;
use std::convert::Infallible;

use glam::{Vec2, Vec3};
use rayon::prelude::*;
use relief_core::mesh::{Mesh, MeshBlock, Vertex};
use relief_core::{HeightMap, Watch};

use self::block::FinishedBlock;
pub use self::outline::Bottom;
use self::outline::{Outline, ShiftLimits, Sides};
use self::solid::Solid;
use crate::crack::CrackTest;
use crate::cull::{self, Cull, FullBounds, ViewVolume};
use crate::edge::Divides;
use crate::error::MOST;
use crate::filling::Filling;
use crate::folds::{FoldedBase, Folds};
use crate::interior::{Fills, Pattern};
use crate::plan::{Plan, Work};
use crate::plane::{Adapted, Grid, Rectangle};
use crate::smooth::{self, Normals};
use crate::surface::Relief;
use crate::triangles::{self, Triangles};
use crate::vertex_set::VertexSet;
use crate::{
    Bounds, Certificate, MeshSettings, MesherError, Part, Pose, Rounded, Shading, Spacing, Stream,
    StreamError, Streamed, Weights, check_pair,
};

/// Bytes of a vertex or triangle of a block, whichever takes more, while it is made and tested.
const BYTES_IN_A_BLOCK: u64 = 480;

/// Blocks that a thread makes while as many are consumed.
const BLOCKS_PER_THREAD: usize = 2;

/// Displaced mesh that is counted to the last vertex, and made when it is streamed.
#[derive(Debug)]
pub struct Mesher {
    base: Base,
    solid: Option<Solid>,
    relief: Relief,
    shading: Shading,
    pose: Pose,
    blocks: Vec<Work>,
    /// Culling of triangles that a camera does not see.
    unseen: Option<(ViewVolume, Cull)>,
    /// Remaining vertices; `None` if nothing is left out.
    used: Option<VertexSet>,
    /// Number of vertices before any is left out.
    all_vertices: u64,
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
    /// Returns the triangles of a base that is not a plane.
    fn triangles(&self) -> Option<&Triangles> {
        match self {
            Self::Triangles(base, _) => Some(base),
            Self::Filled(filled) => Some(filled.base()),
            Self::Grid(..) | Self::Adapted(_) => None,
        }
    }

    /// Returns the certificate of triangles that were made to a tolerance.
    fn certificate(&self) -> Option<&Certificate> {
        match self {
            Self::Triangles(..) | Self::Grid(..) => None,
            Self::Filled(filled) => Some(filled.certificate()),
            Self::Adapted(plane) => Some(plane.certificate()),
        }
    }

    /// Returns the rectangle of a plane.
    fn rectangle(&self) -> Option<&Rectangle> {
        match self {
            Self::Triangles(..) | Self::Filled(_) => None,
            Self::Grid(grid, _) => Some(grid.rectangle()),
            Self::Adapted(plane) => Some(plane.rectangle()),
        }
    }
}

/// Returns the relief of a height map with these settings.
fn relief_of(map: &HeightMap, settings: &MeshSettings) -> Relief {
    Relief::new(map, settings.directions, settings.shading).with_holes(settings.holes)
}

/// Bounding box of nothing.
const EMPTY: [Vec3; 2] = [Vec3::INFINITY, Vec3::NEG_INFINITY];

impl Mesher {
    /// Counts the displaced mesh of a base and a height map.
    ///
    /// A base point is displaced along its normal by the map's
    /// [`displacement_m`](HeightMap::displacement_m) of the bilinear height at its texture
    /// coordinates, by the formula of [`BasePoint`](relief_core::mesh::BasePoint).
    ///
    /// A mesh of two triangles that make a rectangle with straight texture is a plane. It is cut
    /// along the lines of texels: its vertices lie where lines of the edge rule, and the border,
    /// meet.
    ///
    /// The same input gives the same bits, whatever the number of threads.
    ///
    /// The interior `adapt` makes its triangles here and stores them, because there is no other way
    /// to count them. [`certificate`](Self::certificate) then gives the distance of the relief from
    /// them.
    ///
    /// # Errors
    ///
    /// Fails if
    /// - the edge rule and the interior do not go together, or not with this base,
    /// - a setting is out of range, or the tolerance cannot be reached,
    /// - the base has no triangles,
    /// - the mesh would have more vertices or triangles than 32-bit numbers count, or
    /// - the mesh would take more memory than is allowed.
    pub fn new(mesh: &Mesh, map: &HeightMap, settings: &MeshSettings) -> Result<Self, MesherError> {
        Self::watched(mesh, map, settings, &Watch::none())
    }

    /// Counts a mesh as [`new`](Self::new) does. `watch` shows the progress and can cancel.
    ///
    /// # Errors
    ///
    /// Fails as [`new`](Self::new) does, and when cancelled.
    pub fn watched(
        mesh: &Mesh,
        map: &HeightMap,
        settings: &MeshSettings,
        watch: &Watch,
    ) -> Result<Self, MesherError> {
        Self::of_at_most(mesh, map, settings, MOST, watch)
    }

    /// Counts the mesh of a view, with coarser levels of the height map.
    ///
    /// Each level is half as wide and high as the one before. A point is displaced by the level
    /// whose texels are as wide as a voxel is there, and in between by two of them. See the filter
    /// levels of `relief-bake`.
    ///
    /// # Errors
    ///
    /// Fails as [`watched`](Self::watched) does, and if the sides are not divided by voxels.
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
        let relief = relief_of(map, settings).with_levels(coarser);
        Self::of_relief(mesh, relief, settings, MOST, watch)
    }

    /// Counts a mesh of at most `most` triangles.
    pub(crate) fn of_at_most(
        mesh: &Mesh,
        map: &HeightMap,
        settings: &MeshSettings,
        most: u64,
        watch: &Watch,
    ) -> Result<Self, MesherError> {
        let relief = relief_of(map, settings);
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
        if matches!(settings.edges.divides, Divides::Voxels(_)) && settings.solid_m.is_some() {
            return Err(MesherError::SolidOfView);
        }
        if settings.solid_m.is_some() && relief.has_holes() && rectangle.is_none() {
            return Err(MesherError::SolidOfHoles);
        }
        cull::check(settings)?;
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
            (Fills::Patch(pattern), Divides::Voxels(_), rectangle) => {
                let tiles = rectangle.map(|plane| plane.tiles(&relief, settings.part)).transpose()?;
                let mesh = tiles.as_ref().unwrap_or(mesh);
                let base = Triangles::new(mesh, &relief, settings, most, watch)?;
                // Including triangles that are halved, or left out.
                patches = base.count() as usize;
                Base::Triangles(base.culled(&relief, settings, watch)?, pattern)
            }
            (Fills::Patch(pattern), _, None) => {
                Base::Triangles(Triangles::new(mesh, &relief, settings, most, watch)?, pattern)
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
                // Pairs were checked, and spacings agree with the methods that divide.
                let (edges, interior) = (settings.edges.name, settings.interior.name);
                return Err(MesherError::Pair { edges, interior, why: settings.interior.why });
            }
        };
        let mut plan = Plan::default();
        match &base {
            Base::Triangles(triangles, pattern) => plan.triangles(triangles, pattern)?,
            Base::Grid(grid, pattern) => plan.grid(grid, pattern)?,
            Base::Filled(filled) => plan.filled(filled),
            Base::Adapted(plane) => plan.adapted(plane),
        }
        let solid = Solid::planned(&base, &relief, settings, &mut plan)?;
        let Plan { blocks, vertices, triangles, largest } = plan;
        // Triangles of a solid were not counted while patches were filled.
        let is_outlined = settings.solid_m.is_some() && relief.has_holes();
        if triangles > most && !is_outlined {
            return Err(MesherError::MoreThan { most });
        }
        let at_hand = 2 * rayon::current_num_threads() * BLOCKS_PER_THREAD;
        let of_normals =
            if settings.shading == Shading::Mesh { vertices * smooth::BYTES_PER_VERTEX } else { 0 };
        let of_tiles = match &base {
            Base::Triangles(..) | Base::Grid(..) => 0,
            Base::Filled(filled) => filled.bytes(),
            Base::Adapted(plane) => plane.bytes(),
        };
        let cull = settings.cull.filter(|cull| cull.leaves_out());
        let unseen = settings.view.as_ref().map(ViewVolume::new).zip(cull);
        let is_left_out = relief.has_holes() || unseen.is_some();
        let bytes = patches as u64 * Self::BYTES_PER_TRIANGLE
            + (blocks.len() * size_of::<Work>()) as u64
            + of_normals
            + of_tiles
            + if is_left_out { VertexSet::bytes(vertices) } else { 0 }
            + if is_outlined { Sides::BYTES_PER_TRIANGLE * triangles } else { 0 }
            + solid.as_ref().map_or(0, Solid::bytes)
            + at_hand as u64 * largest * BYTES_IN_A_BLOCK;
        let all_vertices = vertices;
        let shading = settings.shading;
        let mesher = Self {
            base,
            solid,
            relief,
            shading,
            pose: settings.pose,
            blocks,
            unseen,
            used: None,
            all_vertices,
            vertices,
            triangles,
            bytes,
        };
        if !is_left_out {
            return Ok(mesher);
        }
        if is_outlined && bytes > settings.max_bytes {
            return Err(MesherError::NoMemory { limit: settings.max_bytes });
        }
        let mesher = mesher.without_hidden(watch)?;
        let outlined = settings.solid_m.filter(|_| is_outlined);
        match outlined {
            Some(solid_m) => mesher.outlined(solid_m, settings.error_m, most, watch),
            None => Ok(mesher),
        }
    }

    /// Leaves out triangles over holes and unseen ones. They follow from the positions of points,
    /// so all triangles are made for it and discarded.
    fn without_hidden(self, watch: &Watch) -> Result<Self, MesherError> {
        let mut used = VertexSet::empty(self.vertices);
        for group in self.blocks.chunks(rayon::current_num_threads() * BLOCKS_PER_THREAD) {
            watch.check()?;
            let remaining: Vec<Vec<[u32; 3]>> =
                group.par_iter().map(|work| self.remaining_triangles(work)).collect();
            for triangles in remaining {
                used.add(&triangles);
            }
        }
        if self.relief.has_holes() && used.triangles() == 0 {
            return Err(MesherError::AllHoles);
        }
        used.count();
        Ok(Self { vertices: used.vertices(), triangles: used.triangles(), used: Some(used), ..self })
    }

    /// Adds walls along the outline of a plane with holes, and a bottom.
    fn outlined(
        mut self,
        solid_m: f64,
        tolerance_m: f64,
        most: u64,
        watch: &Watch,
    ) -> Result<Self, MesherError> {
        let (Some(rectangle), Some(mut used)) = (self.base.rectangle(), self.used.take()) else {
            return Err(MesherError::SolidOfHoles);
        };
        if used.triangles() > u64::from(u32::MAX / 3) {
            return Err(MesherError::TooLarge { vertices: self.vertices, triangles: 2 * used.triangles() });
        }
        let depth_m = solid::lowest_m(&self.relief) - solid::error_m(&self.base) - solid_m;
        let bottom = rectangle.bottom(&self.relief, depth_m);
        let exact = self.base.certificate().is_none();
        let tolerance_m = if exact { f64::INFINITY } else { tolerance_m };
        let limits = ShiftLimits { texel_m: rectangle.texel_m(&self.relief), tolerance_m };
        let sides = {
            let mut triangles = Vec::with_capacity(used.triangles() as usize);
            for group in self.groups() {
                watch.check()?;
                let remaining: Vec<Vec<[u32; 3]>> =
                    group.par_iter().map(|work| self.remaining_triangles(work)).collect();
                triangles.extend(remaining.into_iter().flatten());
            }
            Sides::of(&triangles)
        };
        let wanted = sides.wanted();
        let mut found: HashMap<u32, Vertex> = HashMap::with_capacity(wanted.len());
        for group in self.groups() {
            watch.check()?;
            let vertices: Vec<Vec<(u32, Vertex)>> =
                group.par_iter().map(|work| self.find_vertices(work, &wanted)).collect();
            found.extend(vertices.into_iter().flatten());
        }
        let mut outline = Outline::new(sides, &found, self.all_vertices as u32, bottom, limits);
        used.add_vertices(self.all_vertices, outline.copy_count());
        used.count();
        let (above, walls) = (used.vertices(), u64::from(outline.wall_count()));
        let (vertices, triangles) = (2 * above, 2 * used.triangles() + 2 * walls);
        if vertices.max(triangles) > MOST {
            return Err(MesherError::TooLarge { vertices, triangles });
        }
        if triangles > most {
            return Err(MesherError::MoreThan { most });
        }
        outline.first_below = above as u32;
        let closing = Plan::closing(&self.blocks, outline.copy_count(), outline.wall_count());
        self.blocks.extend(closing);
        let bytes = self.bytes + outline.bytes();
        let solid = Some(Solid::Outline(outline));
        Ok(Self { vertices, triangles, used: Some(used), solid, bytes, ..self })
    }

    /// Returns the blocks in groups that are made at once.
    fn groups(&self) -> impl Iterator<Item = &[Work]> {
        self.blocks.chunks(rayon::current_num_threads() * BLOCKS_PER_THREAD)
    }

    /// Returns whether a mesh is a plane: two triangles that make a rectangle with straight
    /// texture.
    pub fn is_plane(mesh: &Mesh) -> bool {
        Rectangle::of_mesh(mesh).is_some()
    }

    /// Returns the certificate of triangles that were made to a tolerance.
    pub fn certificate(&self) -> Option<&Certificate> {
        self.base.certificate()
    }

    /// Greatest memory that a triangle of the base takes, in bytes.
    pub const BYTES_PER_TRIANGLE: u64 = 480;

    /// Returns the number of vertices.
    pub fn vertices(&self) -> u64 {
        self.vertices
    }

    /// Returns the number of triangles.
    pub fn triangles(&self) -> u64 {
        self.triangles
    }

    /// Returns the bounds of the whole mesh, including the parts left out. Returns `None` if there
    /// is no culling for a view.
    pub fn full_bounds(&self) -> Option<&FullBounds> {
        self.base.triangles().and_then(Triangles::full_bounds)
    }

    /// Returns the greatest memory that streaming takes, in bytes, without the height map and the
    /// memory of the sink. The test for cracks takes some more, for the borders between blocks.
    pub fn bytes(&self) -> u64 {
        self.bytes
    }

    /// Streams the mesh block by block. The order of blocks is always the same.
    ///
    /// # Errors
    ///
    /// Fails if the sink fails, when cancelled, or if a vertex lies beyond the range of `f32`. The
    /// blocks streamed until then are unusable.
    pub fn stream<E>(
        &self,
        how: &Stream,
        mut sink: impl FnMut(&MeshBlock) -> Result<(), E>,
    ) -> Result<Streamed, StreamError<E>> {
        let mut normals = None;
        // With normals of the triangles the mesh is made twice.
        let mut watch = how.watch;
        if self.shading == Shading::Mesh {
            watch = how.watch.piece(0.5, 1.0);
            let mut sums = Normals::new(self.all_vertices);
            let watch = how.watch.piece(0.0, 0.5);
            let plain = Stream { check: false, grid: None, cache_order: false, watch, ..*how };
            self.each_block(&plain, None, |finished| {
                sums.add(finished.block.positions(), &finished.smooth);
                Ok(())
            })?;
            normals = Some(sums);
        }
        let mut test = how.check.then(CrackTest::default);
        let (mut bounds_m, mut rounded) = (EMPTY, Rounded::default());
        let (mut folds, mut folds_below) = (Folds::default(), Folds::default());
        self.each_block(&Stream { watch, ..*how }, normals.as_ref(), |finished| {
            if let (Some(test), Some(part)) = (&mut test, finished.part.take()) {
                test.add(part);
            }
            let [least, greatest] = finished.bounds_m;
            bounds_m = [bounds_m[0].min(least), bounds_m[1].max(greatest)];
            for (folds, all) in [(&mut folds, &finished.folds), (&mut folds_below, &finished.folds_below)] {
                for found in all {
                    let middle_m = self.pose.position(found.middle_m, how.size);
                    folds.add(FoldedBase { middle_m, ..*found });
                }
            }
            rounded = rounded.with(finished.rounded);
            sink(&finished.block).map_err(StreamError::Sink)
        })?;
        Ok(Streamed {
            bounds_m,
            cracks: test.map(CrackTest::finish),
            folds,
            folds_below,
            rounded: how.grid.map(|_| rounded),
        })
    }

    /// Returns the bounds of the vertices, scaled by `size`. The whole mesh is made for it and
    /// discarded.
    ///
    /// # Errors
    ///
    /// Fails when cancelled, or if a vertex lies beyond the range of `f32`.
    pub fn bounds(&self, size: f64, watch: &Watch) -> Result<Bounds, StreamError<Infallible>> {
        let how = Stream { size, check: false, grid: None, cache_order: false, watch: *watch };
        let mut bounds = Bounds { positions_m: EMPTY, uvs: [Vec2::INFINITY, Vec2::NEG_INFINITY] };
        self.each_block(&how, None, |finished| {
            let ([least, greatest], [low, high]) = (finished.bounds_m, bounds.positions_m);
            bounds.positions_m = [low.min(least), high.max(greatest)];
            for vertex in &finished.block.vertices {
                bounds.uvs = [bounds.uvs[0].min(vertex.uv), bounds.uvs[1].max(vertex.uv)];
            }
            Ok(())
        })?;
        Ok(bounds)
    }

    /// Returns the whole mesh.
    ///
    /// # Errors
    ///
    /// Fails if a vertex lies beyond the range of `f32`, or if the mesh does not fit into memory.
    pub fn mesh(&self) -> Result<Mesh, StreamError<Infallible>> {
        let watch = Watch::none();
        let how = Stream { size: 1.0, check: false, grid: None, cache_order: false, watch };
        let mut vertices = reserved("vertices", self.vertices)?;
        let mut triangles = reserved("triangles", self.triangles)?;
        self.stream(&how, |block| {
            vertices.extend_from_slice(&block.vertices);
            triangles.extend_from_slice(&block.triangles);
            Ok(())
        })?;
        Ok(Mesh::new(vertices, triangles)?)
    }

    /// Makes a group of blocks in parallel. It does not depend on the sink's type, so that it is
    /// compiled here, once.
    fn finished_blocks(
        &self,
        group: &[Work],
        how: &Stream,
        normals: Option<&Normals>,
        into: Vec<MeshBlock>,
    ) -> Vec<Option<FinishedBlock>> {
        let each = group.par_iter().zip(into);
        each.map(|(work, block)| self.finished_block(work, how, normals, block)).collect()
    }

    /// Makes all blocks, a group at a time, and passes them to `take` one after the other.
    fn each_block<E>(
        &self,
        how: &Stream,
        normals: Option<&Normals>,
        mut take: impl FnMut(&mut FinishedBlock) -> Result<(), StreamError<E>>,
    ) -> Result<(), StreamError<E>> {
        let at_once = rayon::current_num_threads() * BLOCKS_PER_THREAD;
        let mut groups = self.blocks.chunks(at_once);
        let (mut done, mut ready) = (0, Vec::new());
        let mut spare: Vec<MeshBlock> = Vec::new();
        loop {
            how.watch.check()?;
            let group = groups.next().unwrap_or_default();
            let mut next: Vec<Option<FinishedBlock>> = Vec::new();
            spare.resize_with(group.len().max(spare.len()), MeshBlock::default);
            let into = spare.split_off(spare.len() - group.len());
            // Finished blocks are taken while the next ones are made.
            let taken: Result<(), StreamError<E>> = rayon::in_place_scope(|scope| {
                if !group.is_empty() {
                    scope.spawn(|_| next = self.finished_blocks(group, how, normals, into));
                }
                ready.drain(..).try_for_each(|finished: Option<FinishedBlock>| {
                    let mut finished = finished.ok_or(StreamError::NotFinite)?;
                    take(&mut finished)?;
                    done += 1;
                    spare.push(finished.block);
                    Ok(())
                })
            });
            taken?;
            // There may be none at all.
            how.watch.at(done as f32 / self.blocks.len().max(1) as f32)?;
            if group.is_empty() {
                return Ok(());
            }
            ready = next;
        }
    }
}

/// Returns an empty list with capacity for `count` items, if the memory can be had.
fn reserved<T>(what: &'static str, count: u64) -> Result<Vec<T>, StreamError<Infallible>> {
    let mut list = Vec::new();
    let result = usize::try_from(count).ok().and_then(|count| list.try_reserve_exact(count).ok());
    result.map(|()| list).ok_or(StreamError::OutOfMemory { count, what })
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::{AtomicBool, Ordering};
    use std::time::Instant;

    use super::*;
    use crate::Fit;

    /// Returns the seconds that one thread takes to count a mesh, cancelled after `seconds`, and
    /// the result.
    fn cancelled_after(mesh: &Mesh, settings: &MeshSettings, seconds: f64) -> (f64, Result<(), MesherError>) {
        let map = rough();
        let [cancel, done] = [false; 2].map(AtomicBool::new);
        let until = std::time::Duration::from_secs_f64(seconds);
        let started = Instant::now();
        let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("a thread");
        let made = std::thread::scope(|scope| {
            scope.spawn(|| {
                while started.elapsed() < until && !done.load(Ordering::Relaxed) {
                    std::thread::sleep(std::time::Duration::from_millis(2));
                }
                cancel.store(true, Ordering::Relaxed);
            });
            let watch = Watch::cancelled_by(&cancel);
            let made = pool.install(|| Mesher::watched(mesh, &map, settings, &watch).map(drop));
            done.store(true, Ordering::Relaxed);
            made
        });
        (started.elapsed().as_secs_f64(), made)
    }

    /// A map that needs many triangles everywhere.
    fn rough() -> HeightMap {
        let mut rng = relief_core::rng::Rng::new(7);
        let texels = (0..64 * 64).map(|_| rng.unit() as f32).collect();
        HeightMap::new(64, 64, texels, relief_core::Wrap::Clamp)
            .and_then(|map| map.with_displacement(0.05, -0.05))
            .expect("a map")
    }

    #[test]
    fn a_patch_that_is_being_filled_ends_when_it_is_cancelled() {
        let plane = relief_core::mesh::Builtin::Plane.build([1.0, 1.0]).expect("a mesh");
        let bent = relief_core::mesh::Builtin::Cube.build([1.0, 1.0]).expect("a mesh");
        for (mesh, fit) in [(&plane, Fit::Heights), (&plane, Fit::None), (&bent, Fit::Heights)] {
            let settings = MeshSettings { fit, ..MeshSettings::within(2e-3) };
            let (whole, made) = cancelled_after(mesh, &settings, 1e6);
            made.expect("a mesh");
            // The best of three, as the machine may be busy.
            let early = (0..3).map(|_| {
                let (seconds, made) = cancelled_after(mesh, &settings, whole / 8.0);
                assert!(matches!(made, Err(MesherError::Cancelled(_))), "{made:?}");
                seconds
            });
            let early = early.fold(f64::INFINITY, f64::min);
            assert!(early < whole / 2.0, "{early} of {whole} s");
        }
    }

    #[test]
    fn a_list_that_no_memory_holds_is_refused() {
        assert!(reserved::<u64>("vertices", 3).is_ok_and(|list| list.capacity() >= 3));
        let refused = reserved::<u64>("vertices", u64::MAX / 4).map(drop);
        assert!(matches!(refused, Err(StreamError::OutOfMemory { what: "vertices", .. })), "{refused:?}");
    }
}
