//! Collectors of hits during the traversal of the BVH.

use std::cmp::Ordering;

use super::{SurfaceHit, precedes};

/// Number of hits in the first batch.
const AT_A_TIME: usize = 16;

/// Factor between the sizes of two consecutive batches, and largest batch.
const MORE: usize = 4;
const MOST: usize = 1 << 14;

/// Collects the first hits of a ray.
pub trait HitCollector {
    /// Parameter beyond which no hit is wanted.
    fn reach(&self) -> f64;

    /// Accepts a hit if it is one of the first.
    fn offer(&mut self, hit: SurfaceHit);
}

/// Collects the first hit only.
#[derive(Default)]
pub struct Nearest {
    pub hit: Option<SurfaceHit>,
}

impl HitCollector for Nearest {
    #[inline]
    fn reach(&self) -> f64 {
        self.hit.map_or(f64::INFINITY, |hit| hit.t)
    }

    #[inline]
    fn offer(&mut self, hit: SurfaceHit) {
        if self.hit.is_none_or(|known| comes_before(&hit, &known)) {
            self.hit = Some(hit);
        }
    }
}

/// Collects a batch of first hits. Each batch is larger than the previous one. So a ray with many
/// hits traverses the BVH a few times, not once per hit.
pub struct HitBatch {
    /// Candidates for the first hits: unordered during the search, then from the last to the first.
    hits: Vec<SurfaceHit>,
    /// Size of the batch.
    wanted: usize,
    /// Last hit of the batch, once enough are found.
    last: Option<SurfaceHit>,
}

impl HitBatch {
    /// Creates the first batch.
    pub fn new() -> Self {
        Self { hits: Vec::new(), wanted: AT_A_TIME, last: None }
    }

    /// Creates a larger batch for the hits behind this one. `None` if there are no further hits.
    pub fn more(self) -> Option<Self> {
        self.last?;
        let Self { mut hits, wanted, .. } = self;
        hits.clear();
        Some(Self { hits, wanted: (MORE * wanted).min(MOST), last: None })
    }

    /// Ends the search: sorts the hits.
    pub fn sort(&mut self) {
        self.keep_wanted();
        self.hits.sort_unstable_by(|a, b| order(b, a));
    }

    /// Next hit, after sorting.
    pub fn next(&mut self) -> Option<SurfaceHit> {
        self.hits.pop()
    }

    /// Drops the hits behind the last one of the batch.
    fn keep_wanted(&mut self) {
        if self.hits.len() >= self.wanted {
            self.hits.select_nth_unstable_by(self.wanted - 1, order);
            self.hits.truncate(self.wanted);
            self.last = self.hits.last().copied();
        }
    }
}

impl HitCollector for HitBatch {
    #[inline]
    fn reach(&self) -> f64 {
        self.last.map_or(f64::INFINITY, |hit| hit.t)
    }

    #[inline]
    fn offer(&mut self, hit: SurfaceHit) {
        if self.last.is_none_or(|last| comes_before(&hit, &last)) {
            self.hits.push(hit);
            if self.hits.len() >= 2 * self.wanted {
                self.keep_wanted();
            }
        }
    }
}

/// Order of hits along a ray.
#[inline]
fn order(a: &SurfaceHit, b: &SurfaceHit) -> Ordering {
    // Hits at the eye have a `t` of 0, with either sign.
    a.t.partial_cmp(&b.t).unwrap_or(Ordering::Equal).then(a.triangle.cmp(&b.triangle))
}

#[inline]
fn comes_before(a: &SurfaceHit, b: &SurfaceHit) -> bool {
    precedes((a.t, a.triangle), (b.t, b.triangle))
}
