//! Whether the tracers that are timed give the same answers.

use rayon::prelude::*;
use relief_core::HeightMap;
use relief_core::exact::{FastTracer, cell_walk};
use relief_testing::judge::judge;

use super::tracers::{Rays, Tracer, TracerSet};

/// Rays of a set that are compared.
const COMPARED: usize = 50_000;

/// Agreement of a tracer's answers with the truth.
pub struct Agreement {
    /// Share of its rays that hit.
    pub hits: f64,
    /// The same in truth.
    pub true_hits: f64,
    /// Where both have the same rays.
    pub rays: Option<Differences>,
}

/// Ray by ray.
pub struct Differences {
    /// Share of rays that hit in truth or for the tracer, but not both.
    pub other_answer: f64,
    /// Median and 99th percentile of the distance along the ray between the hits, in texels.
    pub texels: [f64; 2],
}

fn compared(count: usize) -> impl IndexedParallelIterator<Item = usize> {
    (0..count).into_par_iter().step_by(count.div_ceil(COMPARED).max(1))
}

/// Judges the fast tracer by the cell walk, to its own guarantee.
///
/// # Errors
///
/// The first answer that breaks it.
pub fn check_fast(tracer_set: &TracerSet, rays: &Rays) -> Result<(), String> {
    compared(rays.paths.len()).try_for_each(|at| {
        let path = &rays.paths[at];
        let truth = cell_walk(tracer_set.map, path);
        let fast = tracer_set.fast.trace(path);
        judge(tracer_set.map, path, &truth, &fast, FastTracer::ERROR).map_err(|wrong| wrong.to_string())?;
        if tracer_set.fast.is_blocked(path) != fast.hit.found {
            return Err(format!("the fast tracer's two answers differ for {path:?}"));
        }
        Ok(())
    })
}

/// Compares a tracer with the cell walk.
pub fn compare(tracer_set: &TracerSet, rays: &Rays, tracer: &Tracer) -> Agreement {
    let walk = Tracer::Walk(tracer_set.map);
    let hits = |tracer: &Tracer| -> Vec<Option<f64>> {
        compared(tracer.count(rays)).map(|at| tracer.hit(rays, at)).collect()
    };
    let (truth, given) = (hits(&walk), hits(tracer));
    let same_rays = !(rays.shadow && matches!(tracer, Tracer::Parry(_)));
    Agreement {
        hits: share(&given),
        true_hits: share(&truth),
        rays: same_rays.then(|| differences(tracer_set.map, &truth, &given)),
    }
}

fn share(hits: &[Option<f64>]) -> f64 {
    hits.iter().flatten().count() as f64 / hits.len().max(1) as f64
}

fn differences(map: &HeightMap, truth: &[Option<f64>], given: &[Option<f64>]) -> Differences {
    let pairs = || truth.iter().zip(given);
    let other = pairs().filter(|(truth, given)| truth.is_some() != given.is_some()).count();
    let texels_a_metre = f64::from(map.width().max(map.height()));
    let mut distances: Vec<f64> =
        pairs().filter_map(|(truth, given)| Some(((*truth)? - (*given)?).abs() * texels_a_metre)).collect();
    distances.sort_by(f64::total_cmp);
    let rank = |share: f64| {
        let at = (distances.len() as f64 * share) as usize;
        distances.get(at).copied().unwrap_or_default()
    };
    Differences { other_answer: other as f64 / truth.len().max(1) as f64, texels: [rank(0.5), rank(0.99)] }
}

#[cfg(test)]
mod tests {
    use super::*;
    use relief_core::Wrap;

    #[test]
    fn differences_see_what_is_changed() {
        let map = HeightMap::from_fn(100, 10, Wrap::Clamp, |_, _| 0.5).expect("a valid size");
        let truth = [Some(0.5), None, Some(0.25), Some(1.0)];
        let same = differences(&map, &truth, &truth);
        assert_eq!((same.other_answer, same.texels), (0.0, [0.0; 2]));
        let given = [Some(0.5), Some(0.1), Some(0.26), None];
        let changed = differences(&map, &truth, &given);
        assert_eq!(changed.other_answer, 0.5);
        assert!((changed.texels[1] - 1.0).abs() < 1e-9);
        assert_eq!((share(&truth), share(&[])), (0.75, 0.0));
    }
}
