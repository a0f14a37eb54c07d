//! Views and their scene: one geometry for every program.
//!
//! The relief stands on the built-in plane, `y` from 0 to [`SCALE_M`]. Other programs span their height
//! fields between the first and the last texel, so everything here ends at the centres of the outermost
//! texels, half a texel inside of the plane.

use glam::DVec3;
use relief_core::camera::{Camera, CameraError};
use relief_core::{HeightMap, Path, PathMetric};

/// Depth of the relief, in tiles.
pub const SCALE_M: f64 = 0.1;

/// Columns and rows of the picture.
pub const SIZE: [u32; 2] = [1000, 750];

/// The eye is above the relief, so that no ray comes in from a side, where this program's relief is solid and
/// others' is not.
const EYE: DVec3 = DVec3::new(0.0, 0.3, 0.4);
const TARGET: DVec3 = DVec3::new(0.0, 0.0, -0.05);
const FOV_DEGREES: f64 = 40.0;

/// Where the sun is: 15 degrees above the horizon, so that there are shadows.
const TOWARDS_SUN: DVec3 = DVec3::new(0.8, 0.25, -0.5);

/// Distance above a hit at which its shadow ray begins, in metres: more than an `f32` rounds a place by, so
/// that no program finds the surface that it starts from, and less than a tenth of a texel of the finest map.
pub const SHADOW_LIFT_M: f64 = 1e-5;

/// How far below the lowest level paths end, in metres, so that rounding does not end one above it.
const BELOW_M: f64 = 1e-6;

/// The camera of all pictures.
pub fn camera() -> Result<Camera, CameraError> {
    Camera::new(EYE, TARGET, FOV_DEGREES)
}

/// Unit vector towards the sun.
pub fn sun() -> DVec3 {
    TOWARDS_SUN.normalize()
}

/// The box of a map's relief in the world.
#[derive(Clone, Copy, Debug)]
pub struct Ground {
    /// Sides along `x` and `z`, in metres.
    pub sides: [f64; 2],
    low: DVec3,
    high: DVec3,
}

impl Ground {
    /// The box of a map.
    pub fn of(map: &HeightMap) -> Self {
        let sides = [map.width(), map.height()].map(|side| f64::from(side - 1) / f64::from(side));
        let half = DVec3::new(sides[0] / 2.0, 0.0, sides[1] / 2.0);
        Self { sides, low: -half - DVec3::Y * BELOW_M, high: half + DVec3::Y * SCALE_M }
    }

    /// The part of a ray inside the box as a path; `None` when it passes by. The path's parameter is the
    /// ray's, less what lies before the box.
    #[inline]
    pub fn path(&self, origin: DVec3, direction: DVec3) -> Option<Path> {
        let inverse = direction.recip();
        let (one, other) = ((self.low - origin) * inverse, (self.high - origin) * inverse);
        let from = one.min(other).max_element().max(0.0);
        let to = one.max(other).min_element();
        if from >= to {
            return None;
        }
        let start = origin + direction * from;
        let h = [start.y / SCALE_M, direction.y / SCALE_M, 0.0];
        let exit = to - from;
        Some(Path {
            uv: [start.x + 0.5, start.z + 0.5],
            duv: [direction.x, direction.z],
            h,
            exit,
            base: (-h[0] / h[1]).clamp(0.0, exit),
            metric: PathMetric::unit(SCALE_M),
        })
    }

    /// The world point of texture coordinates and a height.
    #[inline]
    pub fn point(uv: [f64; 2], height: f64) -> DVec3 {
        DVec3::new(uv[0] - 0.5, height * SCALE_M, uv[1] - 0.5)
    }

    /// The shadow ray's path from a surface point.
    #[inline]
    pub fn path_to_sun(&self, surface: DVec3, sun: DVec3) -> Option<Path> {
        self.path(surface + DVec3::Y * SHADOW_LIFT_M, sun)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use relief_core::Wrap;

    #[test]
    fn paths_lie_on_their_rays_and_inside_the_cells_between_texels() {
        let map = HeightMap::from_fn(5, 9, Wrap::Clamp, |_, _| 0.5).expect("a valid size");
        let ground = Ground::of(&map);
        let camera = camera().expect("a proper camera");
        let mut met = 0;
        for (x, y) in [(0, 0), (500, 300), (999, 749), (20, 700), (500, 0)] {
            let ray = camera.ray(x, y, SIZE[0], SIZE[1]);
            let Some(path) = ground.path(ray.origin, ray.direction) else { continue };
            met += 1;
            for t in [0.0, path.exit] {
                let [u, v, h] = path.at(t);
                assert!(
                    (0.1 - 1e-12..=0.9 + 1e-12).contains(&u)
                        && (0.5 / 9.0 - 1e-12..=8.5 / 9.0 + 1e-12).contains(&v)
                );
                assert!((-2e-5..=1.0 + 1e-12).contains(&h));
                let offset = Ground::point([u, v], h) - ray.origin;
                assert!(offset.cross(ray.direction).length() < 1e-12, "pixel {x}, {y}");
            }
        }
        assert!(met >= 3);
        assert!(ground.path(DVec3::new(0.0, 1.0, 0.0), DVec3::new(1.0, -0.1, 0.0)).is_none());
    }

    #[test]
    fn the_eye_is_above_every_ground() {
        assert!(EYE.y > SCALE_M && EYE.x.abs() < 0.4 && EYE.z.abs() <= 0.4);
    }
}
