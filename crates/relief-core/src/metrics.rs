//! Errors of hits, compared with the true hits, and costs of tracing.

use crate::exact::ExactHit;
use crate::{Cost, HeightMap, Hit};

/// Distance in texels beyond which a hit behind the true one counts as late, and one before it as
/// early.
pub const LATE_TEXELS: f64 = 0.5;

/// Errors of a set of hits, as [`compare`] finds them. Shares are of all rays, from 0 to 1.
/// Statistics over no hits are 0.
///
/// Hits that ran out of steps count only in `exhausted`. They are neither hits nor misses for the
/// other figures.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ErrorReport {
    /// Number of rays compared.
    pub rays: usize,
    /// Number of rays that hit both in truth and in the set. The distances are measured over these
    /// rays.
    pub both_hit: usize,
    /// Share of rays that truly hit but were given as misses.
    pub missed: f64,
    /// Share of rays that truly miss but were given as hits.
    pub false_hits: f64,
    /// Share of rays that were given a hit more than [`LATE_TEXELS`] behind the true one.
    pub late: f64,
    /// Share of rays that were given a hit more than [`LATE_TEXELS`] before the true one.
    pub early: f64,
    /// Share of rays that ran out of steps.
    pub exhausted: f64,
    /// Distance between the given and the true hit, in texels.
    pub distance_texels: Spread,
    /// Difference of the heights without sign, in texel values.
    pub height: Spread,
    /// Difference of the path parameters without sign: the depth error in the path's unit, usually
    /// metres.
    pub depth: Spread,
    /// Mean number of height reads over all rays.
    pub mean_reads: f64,
}

/// Distribution of an error without sign.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Spread {
    /// Mean of all rays.
    pub mean: f64,
    /// Half of the rays are at most this wrong.
    pub median: f64,
    /// 99 of 100 rays are at most this wrong.
    pub p99: f64,
    /// The worst ray.
    pub max: f64,
}

/// The two sets of hits belong to different rays.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("there are {truth} true hits and {hits} hits to compare with them")]
pub struct LengthMismatch {
    /// Number of true hits.
    pub truth: usize,
    /// Number of hits to be compared.
    pub hits: usize,
}

/// Returns the distance of two places along the texture of a map, in its texels:
/// `√((Δu W)² + (Δv H)²)`.
pub fn distance_texels(a: [f64; 2], b: [f64; 2], map: &HeightMap) -> f64 {
    ((a[0] - b[0]) * f64::from(map.width())).hypot((a[1] - b[1]) * f64::from(map.height()))
}

/// Compares hits with the true hits of the same rays, in the same order, on `map`.
///
/// Distances are along the texture ([`distance_texels`]). A hit is late or
/// early if this distance is large and its `t` is greater or less than the true one. A hit with
/// equal `t` that lies beside the ray is neither.
///
/// # Errors
///
/// When the numbers of hits differ.
pub fn compare(truth: &[ExactHit], hits: &[Hit], map: &HeightMap) -> Result<ErrorReport, LengthMismatch> {
    if truth.len() != hits.len() {
        return Err(LengthMismatch { truth: truth.len(), hits: hits.len() });
    }
    let mut count = Counts::default();
    let (mut distances, mut heights, mut depths) = (Vec::new(), Vec::new(), Vec::new());
    let mut reads = 0u64;
    for (truth, hit) in truth.iter().map(|truth| &truth.hit).zip(hits) {
        reads += u64::from(hit.cost.reads);
        if truth.exhausted || hit.exhausted {
            count.exhausted += usize::from(hit.exhausted);
            continue;
        }
        match (truth.found, hit.found) {
            (false, false) => {}
            (true, false) => count.missed += 1,
            (false, true) => count.false_hits += 1,
            (true, true) => {
                let distance = distance_texels(hit.uv, truth.uv, map);
                count.late += usize::from(distance > LATE_TEXELS && hit.t > truth.t);
                count.early += usize::from(distance > LATE_TEXELS && hit.t < truth.t);
                distances.push(distance);
                heights.push((hit.height - truth.height).abs());
                depths.push((hit.t - truth.t).abs());
            }
        }
    }
    let rays = truth.len();
    let share = |count: usize| {
        if rays == 0 { 0.0 } else { count as f64 / rays as f64 }
    };
    Ok(ErrorReport {
        rays,
        both_hit: distances.len(),
        missed: share(count.missed),
        false_hits: share(count.false_hits),
        late: share(count.late),
        early: share(count.early),
        exhausted: share(count.exhausted),
        distance_texels: Spread::of(distances),
        height: Spread::of(heights),
        depth: Spread::of(depths),
        mean_reads: if rays == 0 { 0.0 } else { reads as f64 / rays as f64 },
    })
}

/// Columns and rows of the pixels that [`CostReport`] assumes to be traced together. They are the
/// 32 lanes of a wave on most GPUs, in the shape in which rasterisers fill them.
pub const WAVE: [usize; 2] = [8, 4];

/// Costs of the rays of a picture; see [`Cost`].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CostReport {
    /// Reads per ray.
    pub reads: CostSpread,
    /// Steps per ray.
    pub steps: CostSpread,
    /// Bytes per ray.
    pub bytes: CostSpread,
}

/// Distribution of a cost over the rays of a picture. All values are 0 without rays.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CostSpread {
    /// Mean of all rays.
    pub mean: f64,
    /// 99 of 100 rays cost at most this much.
    pub p99: f64,
    /// Mean over all tiles of [`WAVE`] pixels of the tile's greatest cost: the lanes of a wave wait
    /// for the slowest.
    pub wave: f64,
}

impl CostReport {
    /// Computes the costs of the hits of a picture, row by row, with `columns` columns. Hits after
    /// the last whole row form a row of their own. Tiles at the right and lower edges may be
    /// smaller.
    pub fn of(hits: &[Hit], columns: usize) -> Self {
        let spread = |cost: fn(&Cost) -> u32| {
            let costs: Vec<f64> = hits.iter().map(|hit| f64::from(cost(&hit.cost))).collect();
            let mut slowest = Vec::new();
            for rows in costs.chunks((columns * WAVE[1]).max(1)) {
                for left in (0..columns).step_by(WAVE[0]) {
                    let right = columns.min(left + WAVE[0]);
                    let of_tile = rows.chunks(columns).filter_map(|row| row.get(left..right.min(row.len())));
                    slowest.extend(of_tile.flatten().copied().reduce(f64::max));
                }
            }
            let Spread { mean, p99, .. } = Spread::of(costs);
            CostSpread { mean, p99, wave: Spread::of(slowest).mean }
        };
        Self {
            reads: spread(|cost| cost.reads),
            steps: spread(|cost| cost.steps),
            bytes: spread(|cost| cost.bytes),
        }
    }
}

#[derive(Default)]
struct Counts {
    missed: usize,
    false_hits: usize,
    late: usize,
    early: usize,
    exhausted: usize,
}

impl Spread {
    /// Computes the distribution of some errors. The rank of a share `p` of `n` values is `⌈p n⌉`.
    /// NaN counts as the worst.
    fn of(mut errors: Vec<f64>) -> Self {
        errors.sort_unstable_by(f64::total_cmp);
        let rank = |per_cent: usize| errors.get((errors.len() * per_cent).div_ceil(100).saturating_sub(1));
        let [median, p99, max] = [50, 99, 100].map(|per_cent| rank(per_cent).copied().unwrap_or(0.0));
        // Summed in order of size, so that the mean does not depend on the order of the hits.
        let mean = if errors.is_empty() { 0.0 } else { errors.iter().sum::<f64>() / errors.len() as f64 };
        Self { mean, median, p99, max }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::cell_walk;
    use crate::{Path, Wrap};

    /// 200 rays at 45 degrees down onto a level map at half height, and their true hits.
    fn rays_on_a_plain() -> (HeightMap, Vec<ExactHit>) {
        let map = HeightMap::from_fn(16, 8, Wrap::Repeat, |_, _| 0.5).expect("a valid map");
        let truth = (0..200).map(|k| {
            let u = f64::from(k) / 200.0;
            cell_walk(&map, &Path::between([u, 0.3, 1.0], [u + 1.0, 0.3, 0.0]))
        });
        let truth = truth.collect();
        (map, truth)
    }

    fn hits(truth: &[ExactHit]) -> Vec<Hit> {
        truth.iter().map(|truth| truth.hit).collect()
    }

    #[test]
    fn the_truth_has_no_error() {
        let (map, truth) = rays_on_a_plain();
        let report = compare(&truth, &hits(&truth), &map).expect("as many");
        assert_eq!((report.rays, report.both_hit), (200, 200));
        assert_eq!((report.missed, report.false_hits, report.late, report.early), (0.0, 0.0, 0.0, 0.0));
        assert_eq!((report.distance_texels, report.depth), (Spread::default(), Spread::default()));
        assert!(report.mean_reads >= 1.0);
    }

    #[test]
    fn shifted_hits_are_late_or_early() {
        let (map, truth) = rays_on_a_plain();
        let mut shifted = hits(&truth);
        // A tenth of the rays each: 2 texels behind, 1 texel before, and a quarter of a texel
        // behind, which is tolerated.
        for (hits, texels) in shifted.chunks_mut(20).zip([2.0, -1.0, 0.25]) {
            for hit in hits {
                hit.t += texels / 16.0;
                hit.uv[0] += texels / 16.0;
                hit.height -= texels / 16.0;
            }
        }
        let report = compare(&truth, &shifted, &map).expect("as many");
        assert_eq!((report.late, report.early, report.missed, report.false_hits), (0.1, 0.1, 0.0, 0.0));
        assert_eq!(report.distance_texels.median, 0.0);
        assert!((report.distance_texels.p99 - 2.0).abs() < 1e-12);
        assert!((report.distance_texels.max - 2.0).abs() < 1e-12);
        assert!((report.height.max - 0.125).abs() < 1e-12 && (report.depth.max - 0.125).abs() < 1e-12);
    }

    #[test]
    fn dropped_and_invented_hits_and_exhaustion_are_counted() {
        let (map, truth) = rays_on_a_plain();
        let mut dropped = hits(&truth);
        for hit in &mut dropped[..30] {
            *hit = Hit::miss(Cost::default());
        }
        for hit in &mut dropped[30..40] {
            hit.exhausted = true;
        }
        let report = compare(&truth, &dropped, &map).expect("as many");
        assert_eq!((report.missed, report.exhausted, report.both_hit), (0.15, 0.05, 160));

        let mut missing = truth.clone();
        for truth in &mut missing[..50] {
            *truth = ExactHit::miss(Cost::default(), 0.1);
        }
        let report = compare(&missing, &hits(&truth), &map).expect("as many");
        assert_eq!((report.false_hits, report.both_hit), (0.25, 150));
    }

    #[test]
    fn a_wave_waits_for_its_slowest_ray() {
        // 11 columns and 6 rows: tiles of 8 x 4, 3 x 4, 8 x 2 and 3 x 2. One ray in each is slow.
        let (columns, slow) = (11, [(7, 3, 40), (8, 0, 30), (0, 4, 20), (10, 5, 60)]);
        let mut hits = vec![Hit::miss(Cost { reads: 2, steps: 1, bytes: 32 }); columns * 6];
        for (column, row, reads) in slow {
            hits[row * columns + column].cost.reads = reads;
        }
        let report = CostReport::of(&hits, columns);
        let mean = (62.0 * 2.0 + 150.0) / 66.0;
        assert_eq!((report.reads.p99, report.reads.wave), (60.0, 37.5));
        assert!((report.reads.mean - mean).abs() < 1e-12);
        assert_eq!(report.steps, CostSpread { mean: 1.0, p99: 1.0, wave: 1.0 });
        assert_eq!(report.bytes, CostSpread { mean: 32.0, p99: 32.0, wave: 32.0 });
        assert_eq!(CostReport::of(&[], columns), CostReport::default());
        assert_eq!(CostReport::of(&hits[..15], columns).reads.wave, 2.0 * 0.5 + 30.0 * 0.5);
    }

    #[test]
    fn no_rays_and_unequal_numbers() {
        let (map, truth) = rays_on_a_plain();
        assert_eq!(compare(&[], &[], &map), Ok(ErrorReport::default()));
        assert_eq!(compare(&truth, &[], &map), Err(LengthMismatch { truth: 200, hits: 0 }));
    }

    #[test]
    fn ranks_are_those_of_the_nearest_rank_method() {
        let spread = Spread::of((1..=200).rev().map(f64::from).collect());
        assert_eq!(spread, Spread { mean: 100.5, median: 100.0, p99: 198.0, max: 200.0 });
        assert_eq!(Spread::of(vec![3.0]), Spread { mean: 3.0, median: 3.0, p99: 3.0, max: 3.0 });
    }
}
