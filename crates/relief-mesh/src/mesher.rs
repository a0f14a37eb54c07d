//! Mesher: counts a displaced mesh first, then makes it block by block.

mod block;
mod counting;
mod outline;
mod solid;
mod streaming;

use glam::Vec3;
use relief_core::mesh::Mesh;
use relief_core::{HeightMap, Watch};

pub use self::outline::Bottom;
use self::solid::Solid;
use crate::cull::{Cull, FullBounds, ViewVolume};
use crate::edge::Divides;
use crate::error::MOST;
use crate::interior::Pattern;
use crate::plan::Work;
use crate::plane::{Adapted, Grid, Rectangle};
use crate::surface::Relief;
use crate::triangles::{self, Triangles};
use crate::vertex_set::VertexSet;
use crate::{Certificate, MeshSettings, MesherError, Pose, Shading};

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

    /// Counts the mesh of a view, with coarser levels of the height map. The mesh is made when it
    /// is streamed.
    ///
    /// The view is [`MeshSettings::view`], and the edge rule must be `pixels`.
    ///
    /// `coarser` has the levels above `map`, the finest first, without `map` itself. Each has half
    /// the sides of the one before, rounded down. Any number of levels is accepted. Where a coarser
    /// level is needed than there is, the last one is used.
    ///
    /// A point is displaced by the level whose texels are as wide as a voxel is there, and in
    /// between by two of them. All levels have the displacement of `map`. See the filter levels of
    /// `relief-bake`.
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
}
