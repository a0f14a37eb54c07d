//! Points of a side.

use std::ops::{Add, Div, Mul};

use glam::{DVec3, Vec3};

/// Point `k` of `n` between two ends: `(a (n - k) + b k) / n`.
///
/// Both products are rounded by themselves and the sum does not depend on the order of its parts, so that the
/// point is the same, bit by bit, as point `n - k` from the other end; the ends themselves are points 0 and
/// `n`. Adding up differences, as Gumhold and Hüttner 1999 do (section 3.4), gives other bits from either
/// end.
pub fn between<T>(a: T, b: T, k: u32, n: u32) -> T
where
    T: Mul<f64, Output = T> + Add<Output = T> + Div<f64, Output = T>,
{
    (a * f64::from(n - k) + b * f64::from(k)) / f64::from(n)
}

/// What positions are told apart and ordered by. -0 and 0 are one.
pub fn bits(position: Vec3) -> [u32; 3] {
    (position + Vec3::ZERO).to_array().map(f32::to_bits)
}

/// A position as it is stored: rounded once, and never -0.
pub fn stored(position: DVec3) -> Vec3 {
    position.as_vec3() + Vec3::ZERO
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_are_the_same_from_either_end() {
        let [a, b] = [Vec3::new(0.1, -7.3, 1e-3), Vec3::new(1e3, 0.7, -0.2)].map(|end| end.as_dvec3());
        for n in [1, 2, 3, 7, 64, 1000] {
            assert_eq!([between(a, b, 0, n), between(a, b, n, n)], [a, b]);
            for k in 0..=n {
                assert_eq!(between(a, b, k, n), between(b, a, n - k, n), "{k} of {n}");
            }
        }
        assert_eq!(bits(Vec3::new(-0.0, 0.0, 1.0)), bits(Vec3::new(0.0, -0.0, 1.0)));
    }
}
