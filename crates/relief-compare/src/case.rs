//! Rays with their true hits, and how far a method's hits are from these.

use rayon::prelude::*;
use relief_core::exact::{ExactHit, cell_walk};
use relief_core::metrics::{CostReport, ErrorReport, compare};
use relief_core::{HeightMap, Hit, Lanes, Path};
use relief_shaders::cpu::MethodTracer;

use crate::rays::view_paths;

/// Paths that a thread traces at once.
const CHUNK: usize = 1024;

/// Rays with their true hits.
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
    /// The map.
    pub map: &'a HeightMap,
    /// The rays.
    pub paths: Vec<Path>,
    /// Where they truly hit, by the cell walk in `f64`.
    pub truth: Vec<ExactHit>,
}

impl<'a> Case<'a> {
    /// So many [view rays](view_paths) at so many degrees from the normal, the same on every call, where a
    /// tile of the texture is so many metres large.
    pub fn new(map: &'a HeightMap, tile_m: [f64; 2], degrees: f64, count: usize) -> Self {
        Self::of(map, view_paths(map, tile_m, degrees, count, degrees.to_bits()))
    }

    /// These rays.
    pub fn of(map: &'a HeightMap, paths: Vec<Path>) -> Self {
        let truth = paths.par_iter().map(|path| cell_walk(map, path)).collect();
        Self { map, paths, truth }
    }

    /// How wrong a method is, with the maps that it reads.
    pub fn report(&self, tracer: &MethodTracer, lanes: Lanes) -> ErrorReport {
        self.judge(&hits(tracer, &self.paths, lanes))
    }

    /// How wrong these hits of the rays are; see [`judged`].
    ///
    /// # Panics
    ///
    /// When there are not as many as rays.
    pub fn judge(&self, hits: &[Hit]) -> ErrorReport {
        judged(&self.truth, hits, self.map)
    }
}

/// How wrong hits are. Where a method ran out of steps it is judged by the last point that it reached, which
/// is what a picture shows.
///
/// # Panics
///
/// When there are not as many as true ones.
pub fn judged(truth: &[ExactHit], hits: &[Hit], map: &HeightMap) -> ErrorReport {
    let shown: Vec<Hit> = hits.iter().map(|hit| Hit { exhausted: false, ..*hit }).collect();
    let report = compare(truth, &shown, map).unwrap_or_else(|error| panic!("{error}"));
    let exhausted = hits.iter().filter(|hit| hit.exhausted).count();
    ErrorReport { exhausted: exhausted as f64 / hits.len().max(1) as f64, ..report }
}

/// The hits of a method.
pub fn hits(tracer: &MethodTracer, paths: &[Path], lanes: Lanes) -> Vec<Hit> {
    let mut hits = vec![Hit::miss(Default::default()); paths.len()];
    hits.par_chunks_mut(CHUNK)
        .zip(paths.par_chunks(CHUNK))
        .for_each(|(hits, paths)| tracer.first_hits(paths, lanes, hits));
    hits
}

/// What a method pays for the rays of a picture of so many columns.
pub fn cost(tracer: &MethodTracer, paths: &[Path], columns: usize, lanes: Lanes) -> CostReport {
    CostReport::of(&hits(tracer, paths, lanes), columns)
}
