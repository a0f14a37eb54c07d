//! The camera: it turns pixels into rays and points into pixels.

use glam::{DMat4, DVec3};

pub use crate::raycast::Ray;

/// Largest cosine between the view axis and `±y` at which `+y` still defines "up". With a larger
/// limit the picture spins when the camera looks almost straight down. With a smaller one the
/// directions lose precision.
const VERTICAL: f64 = 1.0 - 1e-9;

/// Projection of space onto the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Projection {
    /// All rays come from the eye.
    Perspective {
        /// Vertical field of view in degrees.
        fov_degrees: f64,
    },
    /// All rays are parallel: size does not depend on distance, as on a map.
    Orthographic {
        /// Metres from the lower to the upper edge of the picture.
        height_m: f64,
    },
}

/// A camera.
///
/// `+y` points up in the picture. If the camera looks straight down, `-z` points up, so that the
/// built-in plane's texture stands upright. If it looks straight up, `+z` does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    eye: DVec3,
    target: DVec3,
    projection: Projection,
    forward: DVec3,
    right: DVec3,
    up: DVec3,
    half_height: f64,
}

/// Why there is no such camera.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum CameraError {
    /// A coordinate is NaN or infinite, or so large that the distance overflows.
    #[error("the eye {eye} and the target {target} must be finite")]
    NotFinite {
        /// Position of the eye.
        eye: DVec3,
        /// The point looked at.
        target: DVec3,
    },
    /// Eye and target coincide, so there is no direction of view.
    #[error("the eye is at the target, {0}: there is no direction to look in")]
    EyeAtTarget(DVec3),
    /// The field of view is not between 0 and 180 degrees.
    #[error("the field of view is {0} degrees: it must be more than 0 and less than 180")]
    BadFov(f64),
    /// The height of an orthographic view is not positive and finite.
    #[error("the view is {0} m high: it must be more than 0 and finite")]
    BadHeight(f64),
    /// The aspect is not positive, or the planes are not `0 < near < far`.
    #[error("aspect {aspect}, near {near}, far {far}: aspect must be positive and 0 < near < far")]
    BadFrustum {
        /// Width over height of the picture.
        aspect: f64,
        /// Distance of the near plane along the view axis.
        near: f64,
        /// Distance of the far plane along the view axis.
        far: f64,
    },
}

impl Camera {
    /// A camera at `eye` that looks at `target`, both in metres, with a vertical field of view in
    /// degrees.
    ///
    /// # Errors
    ///
    /// When a number is not finite, when eye and target coincide, or when the field of view is not
    /// in `(0, 180)`.
    pub fn new(eye: DVec3, target: DVec3, fov_degrees: f64) -> Result<Self, CameraError> {
        Self::with(eye, target, Projection::Perspective { fov_degrees })
    }

    /// A camera at `eye` that looks at `target`, both in metres. Nothing behind the eye is visible,
    /// with parallel rays either.
    ///
    /// # Errors
    ///
    /// As [`Self::new`], and when the height of an orthographic view is not positive.
    pub fn with(eye: DVec3, target: DVec3, projection: Projection) -> Result<Self, CameraError> {
        let toward = target - eye;
        if !(eye.is_finite() && target.is_finite() && toward.length_squared().is_finite()) {
            return Err(CameraError::NotFinite { eye, target });
        }
        let forward = toward.try_normalize().ok_or(CameraError::EyeAtTarget(eye))?;
        let half_height = match projection {
            Projection::Perspective { fov_degrees } => {
                let tan_half_fov = (fov_degrees.to_radians() / 2.0).tan();
                if !(fov_degrees > 0.0 && fov_degrees < 180.0 && tan_half_fov > 0.0) {
                    return Err(CameraError::BadFov(fov_degrees));
                }
                tan_half_fov
            }
            Projection::Orthographic { height_m } if height_m > 0.0 && height_m.is_finite() => height_m / 2.0,
            Projection::Orthographic { height_m } => return Err(CameraError::BadHeight(height_m)),
        };
        let upward = if forward.y.abs() < VERTICAL { DVec3::Y } else { DVec3::Z * forward.y.signum() };
        let right = forward.cross(upward).normalize();
        let up = right.cross(forward);
        Ok(Self { eye, target, projection, forward, right, up, half_height })
    }

    /// Position of the eye.
    pub fn eye(&self) -> DVec3 {
        self.eye
    }

    /// The point looked at, in the middle of the picture.
    pub fn target(&self) -> DVec3 {
        self.target
    }

    /// Returns this camera at another position, with the same projection.
    ///
    /// # Errors
    ///
    /// When a number is not finite, or eye and target coincide.
    pub fn moved(&self, eye: DVec3, target: DVec3) -> Result<Self, CameraError> {
        Self::with(eye, target, self.projection)
    }

    /// Projection of the camera.
    pub fn projection(&self) -> Projection {
        self.projection
    }

    /// Half the height of the picture in metres. In perspective it is measured at a depth of 1 m;
    /// in an orthographic view it is the same at any depth.
    pub fn half_height(&self) -> f64 {
        self.half_height
    }

    /// Whether all rays are parallel.
    pub fn is_orthographic(&self) -> bool {
        matches!(self.projection, Projection::Orthographic { .. })
    }

    /// Unit vector along the view axis.
    pub fn forward(&self) -> DVec3 {
        self.forward
    }

    /// Unit vector that points to the right in the picture.
    pub fn right(&self) -> DVec3 {
        self.right
    }

    /// Unit vector that points up in the picture.
    pub fn up(&self) -> DVec3 {
        self.up
    }

    /// The ray through the centre of pixel `(x, y)` of a picture of `width` x `height` pixels, row
    /// 0 on top.
    ///
    /// The direction's component along the view axis is 1. So the parameter of a point on the ray
    /// is its depth along that axis, in metres.
    pub fn ray(&self, x: u32, y: u32, width: u32, height: u32) -> Ray {
        let (width, height) = (f64::from(width), f64::from(height));
        let across = (2.0 * f64::from(x) + 1.0 - width) / height * self.half_height;
        let down = (2.0 * f64::from(y) + 1.0 - height) / height * self.half_height;
        let aside = self.right * across - self.up * down;
        if self.is_orthographic() {
            Ray { origin: self.eye + aside, direction: self.forward }
        } else {
            Ray { origin: self.eye, direction: self.forward + aside }
        }
    }

    /// Returns the matrix from world space to clip space, with depth in `[0, 1]` between the
    /// planes, as wgpu expects it. For a picture of aspect `width / height` it is the inverse of
    /// [`Self::ray`].
    ///
    /// # Errors
    ///
    /// When `aspect` is not positive, or the planes, in metres along the view axis, are not
    /// `0 < near < far`. The near plane of an orthographic view may be anywhere before the far one.
    pub fn view_projection(&self, aspect: f64, near: f64, far: f64) -> Result<DMat4, CameraError> {
        let is_near = self.is_orthographic() || near > 0.0;
        if !(aspect > 0.0 && aspect.is_finite() && is_near && far > near && (far - near).is_finite()) {
            return Err(CameraError::BadFrustum { aspect, near, far });
        }
        // Columns of a projection that looks along +z: x right, y up; w is the depth along the
        // axis, or 1.
        let (across, along) = (1.0 / (aspect * self.half_height), 1.0 / self.half_height);
        let depth = if self.is_orthographic() { 1.0 / (far - near) } else { far / (far - near) };
        let (by_depth, always) = if self.is_orthographic() { (0.0, 1.0) } else { (1.0, 0.0) };
        let projection = DMat4::from_cols_array_2d(&[
            [across, 0.0, 0.0, 0.0],
            [0.0, along, 0.0, 0.0],
            [0.0, 0.0, depth, by_depth],
            [0.0, 0.0, -near * depth, always],
        ]);
        let (r, u, f) = (self.right, self.up, self.forward);
        let view = DMat4::from_cols_array_2d(&[
            [r.x, u.x, f.x, 0.0],
            [r.y, u.y, f.y, 0.0],
            [r.z, u.z, f.z, 0.0],
            [-r.dot(self.eye), -u.dot(self.eye), -f.dot(self.eye), 1.0],
        ]);
        Ok(projection * view)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn the_picture_is_upright() {
        let camera = Camera::new(DVec3::new(0.0, 0.0, 3.0), DVec3::ZERO, 90.0).expect("a proper camera");
        let (top, right) = (camera.ray(2, 0, 5, 5), camera.ray(4, 2, 5, 5));
        assert!((top.direction - DVec3::new(0.0, 0.8, -1.0)).length() < 1e-15);
        assert!((right.direction - DVec3::new(0.8, 0.0, -1.0)).length() < 1e-15);
        // Straight down on the plane, u (+x) points right and v (+z) down.
        let camera = Camera::new(DVec3::Y, DVec3::ZERO, 40.0).expect("a proper camera");
        assert_eq!((camera.right(), camera.up()), (DVec3::X, DVec3::NEG_Z));
        let camera = Camera::new(DVec3::ZERO, DVec3::Y, 40.0).expect("a proper camera");
        assert_eq!((camera.right(), camera.up()), (DVec3::X, DVec3::Z));
    }

    #[test]
    fn degenerate_cameras_are_refused() {
        let new = |eye, target, fov| Camera::new(eye, target, fov).expect_err("a degenerate camera");
        assert!(matches!(new(DVec3::ONE, DVec3::ONE, 40.0), CameraError::EyeAtTarget(_)));
        assert!(matches!(new(DVec3::NAN, DVec3::ONE, 40.0), CameraError::NotFinite { .. }));
        assert!(matches!(new(DVec3::splat(1e200), DVec3::ONE, 40.0), CameraError::NotFinite { .. }));
        for fov in [0.0, -40.0, 180.0, f64::NAN, f64::INFINITY] {
            assert!(matches!(new(DVec3::ONE, DVec3::ZERO, fov), CameraError::BadFov(_)), "{fov}");
        }
        let camera = Camera::new(DVec3::ONE, DVec3::ZERO, 40.0).expect("a proper camera");
        for (aspect, near, far) in [(0.0, 0.1, 1.0), (1.0, 0.0, 1.0), (1.0, 2.0, 1.0), (1.0, 0.1, f64::NAN)] {
            assert!(camera.view_projection(aspect, near, far).is_err());
        }
    }

    proptest! {
        #[test]
        fn projecting_a_point_of_a_ray_gives_back_its_pixel(
            eye in prop::array::uniform3(-5.0..5.0),
            target in prop::array::uniform3(-5.0..5.0),
            fov in 1.0..170.0,
            (width, height) in (1u32..2000, 1u32..2000),
            (x, y) in (0.0..1.0, 0.0..1.0),
            depth in 0.2..50.0,
        ) {
            let (eye, target) = (DVec3::from(eye), DVec3::from(target));
            prop_assume!(eye.distance(target) > 1e-3);
            let camera = Camera::new(eye, target, fov).expect("a proper camera");
            let (x, y) = ((x * f64::from(width)) as u32, (y * f64::from(height)) as u32);
            let ray = camera.ray(x, y, width, height);
            prop_assert!((ray.direction.dot(camera.forward()) - 1.0).abs() < 1e-12);

            let (near, far) = (0.1, 100.0);
            let matrix = camera.view_projection(f64::from(width) / f64::from(height), near, far);
            let clip = matrix.expect("a proper frustum") * ray.at(depth).extend(1.0);
            prop_assert!((clip.w - depth).abs() < 1e-9);
            let ndc = clip / clip.w;
            prop_assert!(((ndc.x + 1.0) / 2.0 * f64::from(width) - 0.5 - f64::from(x)).abs() < 1e-6);
            prop_assert!(((1.0 - ndc.y) / 2.0 * f64::from(height) - 0.5 - f64::from(y)).abs() < 1e-6);
            prop_assert!((ndc.z - far * (depth - near) / (depth * (far - near))).abs() < 1e-9);
        }

        #[test]
        fn axes_are_orthonormal_however_the_camera_looks(
            direction in prop::array::uniform3(-1.0f64..1.0),
            tilt in prop::sample::select(vec![0.0, 1e-3, 1e-5, 1e-7, 1e-12]),
        ) {
            // From any direction, and as near to straight down as possible.
            let target = DVec3::from(direction) * DVec3::new(tilt, 1.0, tilt);
            prop_assume!(target.length() > 1e-3);
            let camera = Camera::new(DVec3::ZERO, target, 40.0).expect("a proper camera");
            let (f, r, u) = (camera.forward(), camera.right(), camera.up());
            for (length, across) in [(f, r), (r, u), (u, f)] {
                prop_assert!((length.length() - 1.0).abs() < 1e-9 && length.dot(across).abs() < 1e-9);
            }
            prop_assert!((r.cross(f) - u).length() < 1e-9);
        }
    }
}
