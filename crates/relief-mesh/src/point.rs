//! Points of a side.

use std::ops::{Add, Div, Mul};

use glam::{DVec3, Vec3};

/// Barycentric weights of a triangle's corners.
pub const CORNERS: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// Returns point `k` of `n` between two ends, as weights of the ends: `[n - k, k]`, each times the
/// end's share. Shares of 1 give equal distances. Inverse depths give equal distances in
/// perspective.
pub fn weights([a, b]: [f64; 2], k: u32, n: u32) -> [f64; 2] {
    [a * f64::from(n - k), b * f64::from(k)]
}

/// Returns the point between two ends by their weights: `(a (n - k) + b k) / n` where both shares
/// are 1.
///
/// Products are rounded one by one, and the sums do not depend on the order of their terms. So the
/// point has the same bits as point `n - k` from the other end. Where shares are 1, points 0 and
/// `n` are the ends themselves. The accumulated differences of Gumhold and Hüttner 1999 (section
/// 3.4) give other bits from either end.
pub fn between<T>(a: T, b: T, [of_a, of_b]: [f64; 2]) -> T
where
    T: Mul<f64, Output = T> + Add<Output = T> + Div<f64, Output = T>,
{
    (a * of_a + b * of_b) / (of_a + of_b)
}

/// Returns the bits by which positions are compared and ordered. -0 and 0 are the same.
pub fn bits(position: Vec3) -> [u32; 3] {
    (position + Vec3::ZERO).to_array().map(f32::to_bits)
}

/// Returns a position as it is stored: rounded once, and never -0.
pub fn stored(position: DVec3) -> Vec3 {
    position.as_vec3() + Vec3::ZERO
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_are_the_same_from_either_end() {
        let [a, b] = [Vec3::new(0.1, -7.3, 1e-3), Vec3::new(1e3, 0.7, -0.2)].map(|end| end.as_dvec3());
        let at = |shares, k, n| between(a, b, weights(shares, k, n));
        for n in [1, 2, 3, 7, 64, 1000] {
            assert_eq!([at([1.0, 1.0], 0, n), at([1.0, 1.0], n, n)], [a, b]);
            for k in 0..=n {
                for shares in [[1.0, 1.0], [0.1, 0.7], [3.3, 1e-4]] {
                    let back = between(b, a, weights([shares[1], shares[0]], n - k, n));
                    assert_eq!(at(shares, k, n), back, "{k} of {n}");
                }
            }
        }
        assert_eq!(bits(Vec3::new(-0.0, 0.0, 1.0)), bits(Vec3::new(0.0, -0.0, 1.0)));
    }
}
