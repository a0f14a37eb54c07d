//! Test cases: rays with their true hits, and the errors of a method's hits.

use rayon::prelude::*;
use relief_core::exact::{ExactHit, cell_walk};
use relief_core::metrics::{CostReport, ErrorReport, compare};
use relief_core::{HeightMap, Hit, Lanes, Path};
use relief_shaders::cpu::MethodTracer;

use crate::rays::view_paths;

/// Number of paths that a thread traces at once.
const CHUNK: usize = 1024;

/// Rays through a height map with their true hits.
///
/// ```
/// use relief_compare::Case;
/// use relief_core::{HeightMap, Lanes, Metric, Wrap};
/// use relief_shaders::{Selection, cpu::MethodTracer};
///
/// let heights = HeightMap::from_fn(64, 64, Wrap::Repeat, |i, j| (i * j % 64) as f32 / 63.0)?;
/// let heights = heights.with_displacement(0.1, -0.1)?;
/// let case = Case::new(&heights, [1.0, 1.0], 60.0, 500);
/// let [bump, exact] = ["bump", "exact"].map(|name| -> Result<_, Box<dyn std::error::Error>> {
///     let tracer = MethodTracer::new(&heights, Metric::UNIT, &Selection::method(name)?, [])?;
///     Ok(case.report(&tracer, Lanes::widest()))
/// });
/// assert!(exact?.distance_texels.median < 1e-3 && bump?.distance_texels.median > 1.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Case<'a> {
    /// Height map.
    pub map: &'a HeightMap,
    /// Rays as paths in texture space.
    pub paths: Vec<Path>,
    /// True hits of the rays, by the cell walk in `f64`.
    pub truth: Vec<ExactHit>,
}

impl<'a> Case<'a> {
    /// Creates a case of `count` [view rays](view_paths) at `degrees` from the normal, the same on
    /// every call. `tile_m` is the size of a texture tile in metres.
    pub fn new(map: &'a HeightMap, tile_m: [f64; 2], degrees: f64, count: usize) -> Self {
        Self::of(map, view_paths(map, tile_m, degrees, count, degrees.to_bits()))
    }

    /// Creates a case from given rays.
    pub fn of(map: &'a HeightMap, paths: Vec<Path>) -> Self {
        let truth = paths.par_iter().map(|path| cell_walk(map, path)).collect();
        Self { map, paths, truth }
    }

    /// Traces the rays with a method, and returns its errors.
    pub fn report(&self, tracer: &MethodTracer, lanes: Lanes) -> ErrorReport {
        self.judge(&hits(tracer, &self.paths, lanes))
    }

    /// Returns the errors of given hits of the rays; see [`judged`].
    ///
    /// # Panics
    ///
    /// When the numbers of hits and rays differ.
    pub fn judge(&self, hits: &[Hit]) -> ErrorReport {
        judged(&self.truth, hits, self.map)
    }
}

/// Returns the errors of hits. If a method ran out of steps, the last point that it reached counts
/// as its hit, as in a picture.
///
/// # Panics
///
/// When the numbers of hits and true hits differ.
pub fn judged(truth: &[ExactHit], hits: &[Hit], map: &HeightMap) -> ErrorReport {
    let shown: Vec<Hit> = hits.iter().map(|hit| Hit { exhausted: false, ..*hit }).collect();
    let report = compare(truth, &shown, map).unwrap_or_else(|error| panic!("{error}"));
    let exhausted = hits.iter().filter(|hit| hit.exhausted).count();
    ErrorReport { exhausted: exhausted as f64 / hits.len().max(1) as f64, ..report }
}

/// Traces paths with a method, and returns its hits.
pub fn hits(tracer: &MethodTracer, paths: &[Path], lanes: Lanes) -> Vec<Hit> {
    let mut hits = vec![Hit::miss(Default::default()); paths.len()];
    hits.par_chunks_mut(CHUNK)
        .zip(paths.par_chunks(CHUNK))
        .for_each(|(hits, paths)| tracer.first_hits(paths, lanes, hits));
    hits
}

/// Returns the cost of a method for the rays of a picture with the given number of columns.
pub fn cost(tracer: &MethodTracer, paths: &[Path], columns: usize, lanes: Lanes) -> CostReport {
    CostReport::of(&hits(tracer, paths, lanes), columns)
}
