//! Results of probes.

/// Number of probes that broke a bound, and the one that came nearest to breaking it, or broke it most.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Found<T> {
    /// Probes that broke the bound.
    pub violations: usize,
    /// The least room that was left, and where; negative room, or for ratios room below 1, is a violation.
    /// `None` before the first probe.
    pub tightest: Option<(f64, T)>,
}

impl<T> Default for Found<T> {
    fn default() -> Self {
        Self { violations: 0, tightest: None }
    }
}

impl<T: Copy> Found<T> {
    /// Adds a probe that found so much room.
    #[inline]
    pub fn add(&mut self, is_violation: bool, room: f64, place: T) {
        self.violations += usize::from(is_violation);
        if self.tightest.is_none_or(|(least, _)| room < least) {
            self.tightest = Some((room, place));
        }
    }

    /// Joins the results of two attacks.
    #[must_use]
    pub fn and(self, other: Self) -> Self {
        let tightest = match (self.tightest, other.tightest) {
            (Some(a), Some(b)) => Some(if b.0 < a.0 { b } else { a }),
            (a, b) => a.or(b),
        };
        Self { violations: self.violations + other.violations, tightest }
    }
}
