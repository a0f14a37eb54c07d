//! What a walk through the hierarchy keeps of the hits that it finds.

use super::{SurfaceHit, precedes};

/// How many hits are found at a time, where more than one is looked at.
const AT_A_TIME: usize = 16;

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

/// Some of the first hits, in their order.
#[derive(Default)]
pub struct Several {
    hits: [Option<SurfaceHit>; AT_A_TIME],
    /// How many were found, and how many of these were taken.
    count: usize,
    taken: usize,
}

impl Several {
    /// The next one.
    pub fn next(&mut self) -> Option<SurfaceHit> {
        let hit = self.hits[..self.count].get(self.taken).copied().flatten();
        self.taken += usize::from(hit.is_some());
        hit
    }

    /// Whether there are no others than these.
    pub fn has_all(&self) -> bool {
        self.count < AT_A_TIME
    }
}

impl Found for Several {
    #[inline]
    fn reach(&self) -> f64 {
        self.hits[AT_A_TIME - 1].map_or(f64::INFINITY, |hit| hit.t)
    }

    #[inline]
    fn offer(&mut self, hit: SurfaceHit) {
        let follows = |known: &Option<SurfaceHit>| known.is_some_and(|known| comes_before(&known, &hit));
        let place = self.hits[..self.count].partition_point(follows);
        if place < AT_A_TIME {
            self.count = (self.count + 1).min(AT_A_TIME);
            self.hits[place..self.count].rotate_right(1);
            self.hits[place] = Some(hit);
        }
    }
}

#[inline]
fn comes_before(a: &SurfaceHit, b: &SurfaceHit) -> bool {
    precedes((a.t, a.triangle), (b.t, b.triangle))
}
