//! Intersection of a path with one bilinear patch, in closed form.

/// The gap between a path and the patch of one dual cell, `g(τ) = c[0] + c[1] τ + c[2] τ²`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Gap {
    /// Coefficients in ascending order.
    pub c: [f64; 3],
}

impl Gap {
    /// Gap inside a cell with the corners `[h00, h10, h01, h11]`.
    ///
    /// At `τ = 0` the path is at `from`, in cell units from the corner `h00`. It moves by `step`
    /// per unit of `τ`, and its height is `h[0] + h[1] τ + h[2] τ²`.
    #[inline(always)]
    pub fn in_cell(corners: [f32; 4], from: [f64; 2], step: [f64; 2], h: [f64; 3]) -> Self {
        let [h00, h10, h01, h11] = corners;
        let [h00, h10, h01, h11] = [f64::from(h00), f64::from(h10), f64::from(h01), f64::from(h11)];
        let (bx, by, d) = (h10 - h00, h01 - h00, (h00 - h10) + (h11 - h01));
        let ([u, v], [du, dv]) = (from, step);
        let c0 = h[0] - (h00 + bx * u + (by + d * u) * v);
        let c1 = h[1] - ((bx + d * v) * du + (by + d * u) * dv);
        let c2 = h[2] - d * du * dv;
        Self { c: [c0, c1, c2] }
    }

    /// Gap at `τ`.
    #[inline(always)]
    pub fn at(&self, tau: f64) -> f64 {
        self.c[0] + tau * (self.c[1] + tau * self.c[2])
    }

    /// Derivative at `τ`.
    #[inline(always)]
    pub fn slope(&self, tau: f64) -> f64 {
        self.c[1] + 2.0 * tau * self.c[2]
    }

    /// Least gap over `[0, length]`.
    #[inline(always)]
    pub fn least(&self, length: f64) -> f64 {
        let ends = self.c[0].min(self.at(length));
        if self.turns_within(length) { ends.min(self.at(-self.c[1] / (2.0 * self.c[2]))) } else { ends }
    }

    /// Whether the gap has a minimum strictly inside `[0, length]`.
    #[inline(always)]
    fn turns_within(&self, length: f64) -> bool {
        let [_, c1, c2] = self.c;
        c1 < 0.0 && -c1 < 2.0 * c2 * length
    }

    /// First `τ` in `[0, length]` at which the gap is not positive.
    ///
    /// The two roots are `2 c0 / (-c1 ± √disc)`. The form whose denominator does not cancel is
    /// used. A change of sign between the ends is never lost to rounding.
    #[inline(always)]
    pub fn first_root(&self, length: f64) -> Option<f64> {
        let [c0, c1, c2] = self.c;
        if c0 <= 0.0 {
            return Some(0.0);
        }
        let crosses = self.at(length) <= 0.0;
        if !crosses && !self.turns_within(length) {
            return None;
        }
        let disc = c1 * c1 - 4.0 * c0 * c2;
        if disc < 0.0 {
            return crosses.then_some(length);
        }
        let root = if c1 <= 0.0 {
            2.0 * c0 / (disc.sqrt() - c1)
        } else {
            // The path rises at first and is below at the end: the parabola opens downward, c2 < 0.
            (c1 + disc.sqrt()) / (-2.0 * c2)
        };
        Some(if root < length { if root > 0.0 { root } else { 0.0 } } else { length })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_of_two_roots_is_found_and_only_inside() {
        let gap = Gap { c: [2.0, -3.0, 1.0] }; // (τ - 1)(τ - 2)
        assert_eq!(gap.first_root(3.0), Some(1.0));
        assert_eq!(gap.first_root(1.5), Some(1.0));
        assert_eq!(gap.first_root(0.9), None);
        assert_eq!(Gap { c: [2.0, 1.0, -1.0] }.first_root(3.0), Some(2.0));
        assert_eq!(Gap { c: [2.0, 1.0, -1.0] }.first_root(1.9), None);
        assert_eq!(Gap { c: [1.0, 0.0, 0.0] }.first_root(9.0), None);
        assert_eq!(Gap { c: [1.0, -1.0, 0.0] }.first_root(1.0), Some(1.0));
        assert_eq!(Gap { c: [0.0, 1.0, 0.0] }.first_root(0.0), Some(0.0));
        assert_eq!(Gap { c: [1.0, -2.0, 1.0] }.first_root(5.0), Some(1.0));
    }

    #[test]
    fn roots_keep_their_digits_when_the_quadratic_term_is_tiny() {
        let gap = Gap { c: [1e-9, -1.0, 1e-12] };
        let root = gap.first_root(1.0).expect("the gap changes its sign");
        assert!((root - 1e-9).abs() < 1e-24, "{root:e}");
    }

    #[test]
    fn the_least_gap_is_at_an_end_or_where_it_turns() {
        assert_eq!(Gap { c: [2.0, -2.0, 1.0] }.least(3.0), 1.0);
        assert_eq!(Gap { c: [2.0, -2.0, 1.0] }.least(0.5), 1.25);
        assert_eq!(Gap { c: [2.0, 1.0, -1.0] }.least(2.0), 0.0);
    }
}
