//! Ray space: coordinates in which the ray is the `z` axis.

use glam::{DMat3, DVec3};

use crate::exact::MAX_RATE;

/// Least length of a direction. For a shorter one, `t` could overflow.
const LEAST_DIRECTION: f64 = 1e-90;

/// A ray and right-handed orthonormal axes; the third axis is the ray.
///
/// A point in ray space has two lateral coordinates, both 0 on the ray, and a depth: the distance
/// from the origin along the ray, in metres.
#[derive(Clone, Copy, Debug)]
pub(super) struct RaySpace {
    pub origin: DVec3,
    /// Direction with length 1.
    pub unit: DVec3,
    /// Metres per unit of `t`.
    pub length: f64,
    /// Rotation from the world to ray space.
    turn: DMat3,
}

impl RaySpace {
    /// Creates the space of a ray. `None` if it has no direction or its numbers are out of range.
    pub fn new(origin: [f64; 3], direction: [f64; 3]) -> Option<Self> {
        let (origin, direction) = (DVec3::from(origin), DVec3::from(direction));
        let largest = direction.abs().max_element();
        // NaN is in no range.
        let fits = origin.to_array().iter().all(|number| number.abs() < MAX_RATE)
            && direction.to_array().iter().all(|number| number.abs() < MAX_RATE)
            && largest >= LEAST_DIRECTION;
        if !fits {
            return None;
        }
        let scaled = direction / largest;
        let unit = scaled.normalize();
        let (across, along) = unit.any_orthonormal_pair();
        let axes = DMat3::from_cols(across, along, unit);
        let right_handed =
            if axes.determinant() > 0.0 { axes } else { DMat3::from_cols(along, across, unit) };
        let length = largest * scaled.length();
        Some(Self { origin, unit, length, turn: right_handed.transpose() })
    }

    /// Converts a point from the world to ray space.
    pub fn point(&self, point: DVec3) -> DVec3 {
        self.turn * (point - self.origin)
    }

    /// Converts a direction from the world to ray space.
    pub fn direction(&self, direction: DVec3) -> DVec3 {
        self.turn * direction
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_on_the_ray_have_their_distance_as_depth() {
        for direction in [[0.0, 0.0, 2.0], [0.0, 0.0, -1e-80], [3.0, -4.0, 1e-9], [1e80, 1e80, -1e80]] {
            let ray = RaySpace::new([1.0, 2.0, 3.0], direction).expect("a direction");
            let point = ray.point(ray.origin + ray.unit * 5.0);
            assert!((point - DVec3::Z * 5.0).length() < 1e-14, "{point}");
            assert!((ray.turn.determinant() - 1.0).abs() < 1e-14);
            let error = (ray.unit * ray.length - DVec3::from(direction)).abs().max_element();
            assert!(error <= 1e-15 * ray.length);
        }
    }

    #[test]
    fn what_is_no_ray_is_refused() {
        let [origin, down] = [[0.0; 3], [0.0, -1.0, 0.0]];
        for bad in [f64::NAN, f64::INFINITY, 1e91] {
            assert!(RaySpace::new([0.0, bad, 0.0], down).is_none());
            assert!(RaySpace::new(origin, [1.0, bad, 0.0]).is_none());
        }
        assert!(RaySpace::new(origin, [0.0; 3]).is_none());
        assert!(RaySpace::new(origin, [1e-91, 0.0, 0.0]).is_none());
    }
}
