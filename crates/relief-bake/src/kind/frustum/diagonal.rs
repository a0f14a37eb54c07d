//! Cells on a quadrant's diagonal, over which the distance is not linear.

/// Error of a height less a product of slope and distance, of at most 2 in all: four roundings.
const ERROR: f64 = 1.0 / (1u64 << 49) as f64;

/// Share of a correction that is surely less than the true one, after eight roundings.
const SHARE: f64 = 1.0 - 1.0 / (1u64 << 48) as f64;

/// Returns the least slope with which the frustum stays above the diagonal of the `k`-th diagonal
/// cell, from 1.
///
/// `near` and `far` are the heights of the corners `(k, k)` and `(k + 1, k + 1)` above the top.
/// `mean` is the mean height of the other two, and must be positive. Along the diagonal, at `s`
/// from 0 to 1, the surface is `(1-s)² near + 2s(1-s) mean + s² far` above the top. The distance
/// `k - 1 + s` is `(1-s)² (k-1) + 2s(1-s) (k-½) + s² k`. With slope `S` the gap therefore has the
/// Bernstein coefficients
///
/// ```text
/// a = S (k-1) - near,   m = S (k-½) - mean,   c = S k - far
/// ```
///
/// Where `a` or `c` is negative, a corner demands more. Otherwise the gap is nowhere negative just
/// when `m ≥ -√(a c)`. At `S₀ = mean / (k-½)`, `m` is 0. Below it, at `S₀ - δ`, equality is
/// `δ² (k-½)² = (a₀ - δ (k-1)) (c₀ - δ k)`, that is `δ²/4 + B δ - a₀ c₀ = 0` with
/// `B = a₀ k + c₀ (k-1)`. Its positive root is `δ = 2 a₀ c₀ / (B + √(B² + a₀ c₀))`. Nothing cancels
/// in it but `a₀` and `c₀`. Both are lowered by more than their error, which lowers `δ`, for it
/// grows with either. So the returned slope is never too small, and never more than `S₀`.
pub fn slope(k: i64, near: f64, mean: f64, far: f64) -> f64 {
    let k = k as f64;
    let steepest = mean / (k - 0.5);
    // In the first cell the distance begins at 0, and `a₀` is rounded once, relative to itself.
    let a = if k == 1.0 { -near } else { steepest * (k - 1.0) - near - ERROR };
    let c = steepest * k - far - ERROR;
    if a <= 0.0 || c <= 0.0 {
        return steepest;
    }
    let b = a * k + c * (k - 1.0);
    let less = 2.0 * a * c / (b + (b * b + a * c).sqrt());
    steepest - less * SHARE
}

#[cfg(test)]
mod tests {
    use super::*;
    use relief_core::rng::Rng;

    /// Returns the greatest gap by which the diagonal exceeds a frustum, and where.
    fn excess(slope: f64, k: i64, near: f64, mean: f64, far: f64) -> f64 {
        let at = |s: f64| {
            let surface = (1.0 - s) * (1.0 - s) * near + 2.0 * s * (1.0 - s) * mean + s * s * far;
            surface - slope * ((k - 1) as f64 + s)
        };
        let (linear, square) = (2.0 * (mean - near) - slope, near - 2.0 * mean + far);
        let turn = (-linear / (2.0 * square)).clamp(0.0, 1.0);
        at(if turn.is_nan() { 0.0 } else { turn }).max(at(0.0)).max(at(1.0))
    }

    #[test]
    fn the_slope_is_enough_and_no_more() {
        let mut rng = Rng::new(11);
        for _ in 0..200_000 {
            let k = 1 + i64::from(rng.below(rng.clone().pick(&[1, 3, 300])));
            let top = rng.unit();
            let near = if k == 1 { rng.pick(&[0.0, -top * rng.clone().unit()]) } else { rng.unit() - top };
            let (mean, far) = (rng.unit() * (1.0 - top) + 1e-3, rng.unit() - top);
            let corners = (near / (k as f64 - 1.0).max(1e-300)).max(far / k as f64).max(0.0);
            let found = slope(k, near, mean, far).max(corners);
            assert!(excess(found, k, near, mean, far) < 2e-15, "{k} {near} {mean} {far}: {found}");
            // Lowered by a millionth it is exceeded, unless a corner decides.
            if found > corners * 1.001 {
                let lower = found * (1.0 - 1e-6);
                assert!(excess(lower, k, near, mean, far) > 0.0, "{k} {near} {mean} {far}: {found}");
            }
        }
    }
}
