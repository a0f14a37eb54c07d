//! Steepest slope from an apex to a bilinear patch, in closed form.
//!
//! Places are in metres from an apex; heights are texel heights. Slopes are squared, and a slope
//! that does not rise counts as 0. Every value returned is the slope between two points of the
//! surface, or a limit of such slopes. Rounding therefore loses only a little of a supremum: tops
//! are flat.

use pulp::Simd;

/// Returns the squared slope of a rise over an offset.
#[inline]
pub(crate) fn to_point(rise: f64, offset: [f64; 2]) -> f64 {
    let rise = rise.max(0.0);
    let squared = offset[0] * offset[0] + offset[1] * offset[1];
    if squared > 0.0 { rise * rise / squared } else { 0.0 }
}

/// Returns the squared slope to the steepest point inside a segment with a linear rise; 0 when the
/// steepest point is at an end.
///
/// The segment runs along one axis from `from` to `to`, at distance `beside` along the other. The
/// rise is `α + βs`. Where it is positive, the slope `(α + βs) / sqrt(s² + beside²)` has one
/// maximum, at `s = β beside² / α`.
#[inline]
pub(crate) fn inside_segment(rise: [f64; 2], from: f64, to: f64, beside: f64) -> f64 {
    let beta = (rise[1] - rise[0]) / (to - from);
    let alpha = rise[0] - beta * from;
    let squared = beside * beside;
    // s between the ends, times α > 0. On the segment's own line the slope is greatest at an end.
    let scaled = beta * squared;
    if !(squared > 0.0 && alpha > 0.0 && from * alpha < scaled && scaled < to * alpha) {
        return 0.0;
    }
    let s = scaled / alpha;
    let top = (rise[0] + beta * (s - from)).max(0.0);
    top * top / (s * s + squared)
}

/// Returns the greatest squared slope of a patch itself in the quarter at one of its corners.
/// `[h, aside, ahead, beyond]` are the heights at that corner, beside it along `x`, along `y`, and
/// opposite. `per_side` is one over the sides.
#[inline(always)]
pub(crate) fn steepest_in_quarter([h, aside, ahead, beyond]: [f64; 4], per_side: [f64; 2]) -> f64 {
    // The slopes along an axis are linear along the other: greatest at the corner or half a side
    // away.
    let (along_x, along_y) = ((aside - h) * per_side[0], (ahead - h) * per_side[1]);
    let half_x = 0.5 * (along_x + (beyond - ahead) * per_side[0]);
    let half_y = 0.5 * (along_y + (beyond - aside) * per_side[1]);
    (along_x * along_x).max(half_x * half_x) + (along_y * along_y).max(half_y * half_y)
}

/// Returns the squared slope of the steepest way up from a corner, with the parameters of
/// [`steepest_in_quarter`]. It is 0 where that way leaves the patch, whose edges then count.
#[inline(always)]
pub(super) fn steepest_into([h, aside, ahead, _]: [f64; 4], per_side: [f64; 2]) -> f64 {
    let (along_x, along_y) = ((aside - h) * per_side[0], (ahead - h) * per_side[1]);
    if along_x > 0.0 && along_y > 0.0 { along_x * along_x + along_y * along_y } else { 0.0 }
}

/// Bilinear patch relative to an apex.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Patch {
    /// Corner `h00`, in metres from the apex.
    pub corner: [f64; 2],
    /// Size in metres.
    pub size: [f64; 2],
    /// Rises of the corners `h00 h10 h01 h11` above the apex.
    pub rise: [f64; 4],
}

impl Patch {
    /// Returns the squared distance from the apex, in square metres.
    pub fn distance2(&self) -> f64 {
        let gap = |axis: usize| self.corner[axis].max(-self.corner[axis] - self.size[axis]).max(0.0);
        gap(0).powi(2) + gap(1).powi(2)
    }

    /// Returns the squared slope to the steepest critical point strictly inside the patch; 0 where
    /// there is none.
    ///
    /// With the rise `A + Bx + Cy + Dxy`, the steepest point of the line `x = const` has the
    /// squared slope `(C + Dx)² + (B + A/x)²`. Its derivative vanishes where
    /// `D²x⁴ + CDx³ - ABx - A² = 0`, and there `y = A / (Dx)`. Along the ray from the apex the
    /// slope is `A/r + g + Dr sin cos`, which has a maximum only for `A < 0`. Then, for `x > 0`,
    /// the quartic `P` is negative at 0 and positive far out, and the slope has a maximum only at a
    /// root at which `P` falls. `P` is concave up to the point of inflection `x = -C / 2D` and
    /// convex behind it. So there is at most one such root, and Newton's iteration from the point
    /// of inflection tends to it from one side.
    ///
    /// The squared slope of a line `x = const`, and likewise of `y = const`, is a sum of two
    /// squares. Neither has a maximum inside of an interval, so the sum is bounded by their
    /// greatest values at the ends. Where that bound is not above `least`, 0 is returned.
    pub fn inside(&self, least: f64) -> f64 {
        let [h00, h10, h01, h11] = self.rise;
        let ([x0, y0], [ax, ay]) = (self.corner, self.size);
        let twist = (h00 - h10) + (h11 - h01);
        let d = twist / (ax * ay);
        let (bx, by) = ((h10 - h00) / ax, (h01 - h00) / ay);
        let a = h00 - bx * x0 - by * y0 + d * x0 * y0;
        if a >= 0.0 || d == 0.0 {
            return 0.0;
        }
        // Critical points lie on the hyperbola D x y = A: it must cross the patch.
        let (x1, y1) = (x0 + ax, y0 + ay);
        let products = [x0 * y0, x1 * y0, x0 * y1, x1 * y1].map(|product| d * product);
        if products.iter().all(|&product| product > a) || products.iter().all(|&product| product < a) {
            return 0.0;
        }
        let (b, c) = (bx - d * y0, by - d * x0);
        let (upper, lower) =
            (most_on_lines([a, c, b, d], [y0, y1]), most_on_lines([a, -c, b, -d], [-y1, -y0]));
        let most = if y0 >= 0.0 {
            upper
        } else if y1 <= 0.0 {
            lower
        } else {
            f64::INFINITY
        };
        if most <= least {
            return 0.0;
        }
        let mut best = 0.0f64;
        for sign in [1.0, -1.0] {
            let (from, to) = if sign > 0.0 { (x0, x1) } else { (-x1, -x0) };
            let ends = [from.max(0.0), to];
            if to <= 0.0 || most_on_lines([a, sign * b, c, sign * d], ends) <= least {
                continue;
            }
            let Some(x) = falling_root(a, sign * b, c, sign * d) else { continue };
            let y = a / (sign * d * x);
            if x > from && x < to && y > y0 && y < y1 {
                let (u, v) = ((sign * x - x0) / ax, (y - y0) / ay);
                let rise = h00 + (h10 - h00) * u + ((h01 - h00) + twist * u) * v;
                best = best.max(to_point(rise, [x, y]));
            }
        }
        best
    }
}

/// Returns a bound of the squared slope to a point, with `x` between two numbers that are not
/// negative.
#[inline]
fn most_on_lines([a, b, c, d]: [f64; 4], [from, to]: [f64; 2]) -> f64 {
    let along_y = (c + d * from).abs().max((c + d * to).abs());
    let along_x = (b + a / from).abs().max((b + a / to).abs());
    along_x * along_x + along_y * along_y
}

/// Returns whether patches may have a critical point inside that is steeper than `best`, for as
/// many patches as a vector has lanes. Where they may not, [`Patch::inside`] finds none. The arrays
/// are the heights of the corners, the place of corner `h00` in metres from the apexes, and one
/// over the sides of a texel. `apex` are the heights of the apexes, `gap2` the squared distances
/// from them, and `best` the best squared slopes.
#[inline(always)]
pub(super) fn may_peak_inside<S: Simd>(
    simd: S,
    [h00, h10, h01, h11]: [S::f64s; 4],
    apex: S::f64s,
    [x, y]: [S::f64s; 2],
    per_side: [f64; 2],
    gap2: S::f64s,
    best: S::f64s,
) -> S::m64s {
    // The hyperbola crosses the patch in texels if and only if it does so in metres.
    let x = simd.mul_f64s(x, simd.splat_f64s(per_side[0]));
    let y = simd.mul_f64s(y, simd.splat_f64s(per_side[1]));
    let one = simd.splat_f64s(1.0);
    let (right, down) = (simd.add_f64s(x, one), simd.add_f64s(y, one));
    let (along_x, along_y) = (simd.sub_f64s(h10, h00), simd.sub_f64s(h01, h00));
    let twist = simd.sub_f64s(simd.sub_f64s(h11, h01), along_x);
    // The patch extended over the apex, above it: A of A + Bx + Cy + Dxy.
    let bent = simd.mul_f64s(twist, simd.mul_f64s(x, y));
    let a = simd.add_f64s(
        simd.sub_f64s(simd.sub_f64s(h00, apex), simd.mul_f64s(along_x, x)),
        simd.sub_f64s(bent, simd.mul_f64s(along_y, y)),
    );
    // Critical points lie on the hyperbola D x y = A, which must cross the patch; maxima only for A
    // < 0.
    let p = simd.mul_f64s(twist, simd.mul_f64s(right, y));
    let q = simd.mul_f64s(twist, simd.mul_f64s(x, down));
    let r = simd.mul_f64s(twist, simd.mul_f64s(right, down));
    let least = simd.min_f64s(simd.min_f64s(bent, p), simd.min_f64s(q, r));
    let greatest = simd.max_f64s(simd.max_f64s(bent, p), simd.max_f64s(q, r));
    let zero = simd.splat_f64s(0.0);
    let crosses =
        simd.and_m64s(simd.less_than_f64s(least, a), simd.less_than_f64s(a, simd.min_f64s(greatest, zero)));
    let highest = simd.max_f64s(simd.max_f64s(h00, h10), simd.max_f64s(h01, h11));
    let rise = simd.max_f64s(simd.sub_f64s(highest, apex), zero);
    let is_steep = simd.less_than_f64s(simd.mul_f64s(best, gap2), simd.mul_f64s(rise, rise));
    simd.and_m64s(crosses, is_steep)
}

/// Returns the root `x > 0` of `D²x⁴ + CDx³ - ABx - A²` at which it falls, for `A < 0`.
fn falling_root(a: f64, b: f64, c: f64, d: f64) -> Option<f64> {
    let inflection = -c / (2.0 * d);
    let value = |x: f64| ((d * d * x + c * d) * x * x - a * b) * x - a * a;
    let slope = |x: f64| (4.0 * d * d * x + 3.0 * c * d) * x * x - a * b;
    if !(inflection > 0.0 && slope(inflection) < 0.0) {
        return None;
    }
    // Convergence is quadratic. A root short of it by 1e-5 changes the slope by 1e-10, for the top
    // is flat.
    const STEPS: usize = 24;
    // On nearly level patches the inflection is far from the root, which the two middle terms give
    // nearly. From either side of the root the next place is behind it.
    let middle = (a * b / (c * d)).sqrt();
    let is_near = middle < inflection && slope(middle) < 0.0 && value(inflection) < 0.0;
    let mut x = if is_near { (middle - value(middle) / slope(middle)).min(inflection) } else { inflection };
    for _ in 0..STEPS {
        let fall = slope(x);
        if fall >= 0.0 {
            return None;
        }
        let step = value(x) / fall;
        x -= step;
        if x <= 0.0 {
            return None;
        }
        if step.abs() <= 1e-9 * x {
            break;
        }
    }
    Some(x)
}

#[cfg(test)]
mod tests {
    use relief_core::rng::Rng;

    use super::*;

    #[test]
    fn the_closed_forms_find_what_sampling_finds() {
        // Deterministic patches around an apex, some of them with a critical point inside.
        let mut inside = 0;
        let mut rng = Rng::new(1);
        for _ in 0..20_000 {
            // A patch that touches a cone around the apex at a point of its inside.
            let corner = [rng.between(-3.5, 2.5), rng.between(-3.5, 2.5)];
            let size = [1.0, rng.between(0.5, 1.5)];
            let touch = [0, 1].map(|axis: usize| corner[axis] + size[axis] * rng.unit());
            let (far, slope) = (touch[0].hypot(touch[1]), rng.between(0.1, 1.0));
            let lean = touch[0] * touch[1] / (far * far);
            let d = -rng.between(0.0, 4.0) * slope / far * lean;
            let rise = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]].map(|share: [f64; 2]| {
                let by = [0, 1].map(|axis: usize| corner[axis] + size[axis] * share[axis] - touch[axis]);
                slope * (far + (touch[0] * by[0] + touch[1] * by[1]) / far) + d * by[0] * by[1]
            });
            let patch = Patch { corner, size, rise };
            let found = patch.inside(0.0);
            inside += u32::from(found > 0.0);
            let at = |u: f64, v: f64| {
                let [h00, h10, h01, h11] = patch.rise;
                let rise = (h00 * (1.0 - u) + h10 * u) * (1.0 - v) + (h01 * (1.0 - u) + h11 * u) * v;
                let place = [patch.corner[0] + u * patch.size[0], patch.corner[1] + v * patch.size[1]];
                if place[0].hypot(place[1]) < 1e-3 { 0.0 } else { to_point(rise, place) }
            };
            let surrounds_apex = patch.corner[0] < 0.0
                && patch.corner[0] + patch.size[0] > 0.0
                && patch.corner[1] < 0.0
                && patch.corner[1] + patch.size[1] > 0.0;
            if surrounds_apex {
                continue;
            }
            const SIDE: usize = 24;
            let line = |k: usize| k as f64 / SIDE as f64;
            let (mut rim, mut core) = (0.0f64, 0.0f64);
            for i in 0..=SIDE {
                for side in [0.0, 1.0] {
                    rim = rim.max(at(line(i), side)).max(at(side, line(i)));
                }
                for j in 1..SIDE {
                    if i > 0 && i < SIDE {
                        core = core.max(at(line(i), line(j)));
                    }
                }
            }
            assert!(
                core <= rim.max(found) * 1.002 + 1e-12,
                "{patch:?}: {core} inside, {rim} on the rim, {found}"
            );
        }
        println!("{inside} patches have a critical point");
        assert!(inside > 20, "only {inside} patches have a critical point");
    }
}
