//! What a walk through the hierarchy keeps of the hits that it finds.

use std::cmp::Ordering;

use super::{SurfaceHit, precedes};

/// How many hits are found at a time at first, where more than one is looked at.
const AT_A_TIME: usize = 16;

/// How many times as many the next batch finds, and the most of a batch.
const MORE: usize = 4;
const MOST: usize = 1 << 14;

/// Keeps the first hits of a ray.
pub trait Found {
    /// The parameter beyond which nothing is wanted.
    fn reach(&self) -> f64;

    /// Takes a hit, where it is one of the first.
    fn offer(&mut self, hit: SurfaceHit);
}

/// The first hit alone.
#[derive(Default)]
pub struct Nearest {
    pub hit: Option<SurfaceHit>,
}

impl Found for Nearest {
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

/// Some of the first hits. Each batch wants more than the one before, so that a ray with many hits walks
/// through the hierarchy a few times, and not as often as it hits something.
pub struct Several {
    /// Those that may be among the first, in no order while they are looked for, then from the last to the
    /// first.
    hits: Vec<SurfaceHit>,
    /// How many are wanted.
    wanted: usize,
    /// The last of the wanted ones, once all of them are found.
    last: Option<SurfaceHit>,
}

impl Several {
    /// Some first ones.
    pub fn new() -> Self {
        Self { hits: Vec::new(), wanted: AT_A_TIME, last: None }
    }

    /// More, for a walk that goes on after these; none if there are no others than these.
    pub fn more(self) -> Option<Self> {
        self.last?;
        let Self { mut hits, wanted, .. } = self;
        hits.clear();
        Some(Self { hits, wanted: (MORE * wanted).min(MOST), last: None })
    }

    /// Ends the search.
    pub fn sort(&mut self) {
        self.keep_wanted();
        self.hits.sort_unstable_by(|a, b| order(b, a));
    }

    /// The next one, once they are sorted.
    pub fn next(&mut self) -> Option<SurfaceHit> {
        self.hits.pop()
    }

    /// Drops what comes after the wanted ones, if there are more.
    fn keep_wanted(&mut self) {
        if self.hits.len() >= self.wanted {
            self.hits.select_nth_unstable_by(self.wanted - 1, order);
            self.hits.truncate(self.wanted);
            self.last = self.hits.last().copied();
        }
    }
}

impl Found for Several {
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

/// The order of hits along a ray.
#[inline]
fn order(a: &SurfaceHit, b: &SurfaceHit) -> Ordering {
    // Those at the eye have a `t` of 0, of either sign.
    a.t.partial_cmp(&b.t).unwrap_or(Ordering::Equal).then(a.triangle.cmp(&b.triangle))
}

#[inline]
fn comes_before(a: &SurfaceHit, b: &SurfaceHit) -> bool {
    precedes((a.t, a.triangle), (b.t, b.triangle))
}
