//! Views, and the voxels of their grid space.
//!
//! Source: Gumhold and Hüttner 1999, section 3.1. Grid space has the pixels of the picture and,
//! along the view axis, voxels as deep as they are wide: in perspective that is the logarithm of
//! the depth (equation 4).

use glam::DVec3;
use relief_core::camera::Camera;

use crate::MesherError;

/// View for which a mesh is made. The edge rule `pixels` divides sides by it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// Camera.
    pub camera: Camera,
    /// Width and height of the picture, in pixels.
    pub size: [u32; 2],
    /// Width of a voxel in pixels. Default: 1.
    pub pixels: f64,
    /// Distance from the eye along the view axis at which grid space begins, in metres. Nearer
    /// points, and points behind the eye, are divided as if they were there. It has no effect for
    /// parallel rays. Default: a thousandth of the distance to the camera's target.
    pub near_m: f64,
}

/// Default of [`View::near_m`], as a part of the distance from the eye to the target.
const NEAR: f64 = 1e-3;

/// Greatest distance to the side in voxels, where corners are clamped. A picture is narrower.
const FARTHEST: f64 = (1 << 18) as f64;

/// Greatest distance along the view axis in voxels. All depths of a mesh are distinct within it.
const DEEPEST: f64 = (1 << 30) as f64;

impl View {
    /// Creates a view with voxels of one pixel, which begins at a thousandth of the way to the
    /// target.
    pub fn new(camera: Camera, size: [u32; 2]) -> Self {
        Self { camera, size, pixels: 1.0, near_m: camera.eye().distance(camera.target()) * NEAR }
    }

    /// Returns the parameters of its grid space.
    ///
    /// # Errors
    ///
    /// Fails if the view is empty or not finite, or if its picture has more voxels on a side than
    /// grid space.
    pub fn grid_space(&self) -> Result<GridSpace, MesherError> {
        let Voxels { middle, per_m, per_doubling, near_m, .. } = self.voxels()?;
        Ok(GridSpace { middle, per_m, per_doubling, near_m })
    }

    /// Returns its voxels.
    pub(crate) fn voxels(&self) -> Result<Voxels, MesherError> {
        let Self { camera, size: [width, height], pixels, near_m } = *self;
        let is_positive = |of: f64| of > 0.0 && of.is_finite();
        if width == 0 || height == 0 || !is_positive(pixels) || !is_positive(near_m) {
            return Err(MesherError::BadView { width, height, pixels, near_m });
        }
        let side = f64::from(width.max(height));
        if side / pixels > FARTHEST {
            return Err(MesherError::FineView { width, height, pixels, least: side / FARTHEST });
        }
        // Width of a voxel at depth 1: equation 3.
        let size = 2.0 * camera.half_height() / f64::from(height) * pixels;
        Ok(Voxels {
            camera,
            middle: [f64::from(width) / pixels / 2.0, f64::from(height) / pixels / 2.0],
            per_m: 1.0 / size,
            per_doubling: 1.0 / log2(1.0 + size),
            near_m,
        })
    }
}

/// Parameters of grid space, whose voxels are one or more pixels wide, and as deep as they are
/// wide.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GridSpace {
    /// Middle of the picture, in voxels.
    pub middle: [f64; 2],
    /// Voxels in a metre, in perspective at a depth of 1 m.
    pub per_m: f64,
    /// Voxels along the view axis from a depth to twice that depth, in perspective.
    pub per_doubling: f64,
    /// Depth at which grid space begins, in metres. Nearer points are divided as if they were
    /// there.
    pub near_m: f64,
}

/// Grid space of a camera, in voxels.
#[derive(Clone, Copy, Debug)]
pub struct Voxels {
    camera: Camera,
    middle: [f64; 2],
    /// Voxels in a metre, in perspective at a depth of 1 m.
    per_m: f64,
    /// Voxels along the view axis from a depth to twice that depth.
    per_doubling: f64,
    near_m: f64,
}

/// Point of the base in grid space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Voxel {
    /// Voxel that contains it: right, down and away from the eye.
    pub at: [i32; 3],
    /// Weight where points are divided in the picture: the inverse of the depth in perspective,
    /// else 1.
    pub share: f64,
}

impl Voxels {
    /// Returns the width of a voxel in metres, in perspective at a depth of 1 m.
    pub fn size_m(&self) -> f64 {
        1.0 / self.per_m
    }

    /// Returns whether a point is nearer to the eye than grid space, or behind the eye.
    pub fn is_before(&self, position: DVec3) -> bool {
        self.camera.forward().dot(position - self.camera.eye()) < self.near_m
    }

    pub fn of(&self, position: DVec3) -> Voxel {
        let Self { camera, middle, per_m, per_doubling, near_m } = self;
        let from_eye = position - camera.eye();
        let [right, up, depth] =
            [camera.right(), camera.up(), camera.forward()].map(|axis| axis.dot(from_eye));
        let (share, away) = if camera.is_orthographic() {
            (1.0, depth * per_m)
        } else {
            let depth = depth.max(*near_m);
            (1.0 / depth, log2(depth / near_m) * per_doubling)
        };
        let at = [right * per_m * share + middle[0], middle[1] - up * per_m * share, away];
        // NaN becomes 0.
        let farthest = [FARTHEST, FARTHEST, DEEPEST];
        let at = [0, 1, 2].map(|axis| at[axis].clamp(-farthest[axis], farthest[axis]).round() as i32);
        Voxel { at, share }
    }
}

/// Returns the binary logarithm of a number above 0, by additions, products and quotients alone, so
/// that it has the same bits on every machine.
pub fn log2(of: f64) -> f64 {
    // Halved or doubled until it lies between the roots of 1/2 and 2.
    let bits = of.to_bits();
    let mut exponent = (bits >> 52) as i32 - 1023;
    let mut rest = f64::from_bits((bits & ((1 << 52) - 1)) | (1023 << 52));
    if rest > std::f64::consts::SQRT_2 {
        rest /= 2.0;
        exponent += 1;
    }
    // ln x = 2 artanh((x - 1) / (x + 1)), and its argument is at most 0.172.
    let part = (rest - 1.0) / (rest + 1.0);
    let square = part * part;
    let sum = (0..12).rev().fold(0.0, |sum, k| sum * square + 1.0 / f64::from(2 * k + 1));
    f64::from(exponent) + 2.0 * std::f64::consts::LOG2_E * part * sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use relief_core::camera::Projection;

    #[test]
    fn logarithms_are_those_of_the_machine() {
        for k in 1..2000 {
            for of in
                [f64::from(k) / 97.0, f64::from(k) * 1e9, 1e-12 * f64::from(k), 1.0 + 1e-7 * f64::from(k)]
            {
                assert!((log2(of) - of.log2()).abs() <= 1e-15 * of.log2().abs().max(1.0), "{of}");
            }
        }
    }

    #[test]
    fn voxels_are_as_deep_as_they_are_wide() {
        // The camera of the paper's figure 7: near 1, far 100, 90 degrees, 300 pixels.
        let camera = Camera::new(DVec3::ZERO, DVec3::NEG_Z, 90.0).expect("a camera");
        let view = View { near_m: 1.0, ..View::new(camera, [300, 300]) };
        let voxels = view.voxels().expect("a view");
        let depth = |z: f64| {
            let from_near = log2(z) * voxels.per_doubling;
            from_near - log2(z - 2.0 * z / 300.0) * voxels.per_doubling
        };
        for z in [2.0, 10.0, 50.0, 100.0] {
            // Where the depth grows by the width of a pixel there, it is one voxel.
            assert!((depth(z) - 1.0).abs() < 0.01, "{z}: {}", depth(z));
        }
        // Equation 2: the planes between voxels, one after the other.
        let mut plane = 1.0;
        for k in 0..600 {
            assert_eq!(voxels.of(DVec3::new(0.0, 0.0, -plane)).at, [150, 150, k]);
            plane += plane * 2.0 / 300.0;
        }
    }

    #[test]
    fn pixels_are_those_of_the_camera() {
        let eye = DVec3::new(0.3, 2.0, 1.5);
        for projection in
            [Projection::Perspective { fov_degrees: 35.0 }, Projection::Orthographic { height_m: 0.7 }]
        {
            let camera = Camera::with(eye, DVec3::ZERO, projection).expect("a camera");
            let voxels = View::new(camera, [640, 480]).voxels().expect("a view");
            for [x, y] in [[0, 0], [639, 0], [320, 240], [17, 401]] {
                // Centres of pixels lie half a voxel beyond whole numbers, and are rounded up.
                let at = camera.ray(x, y, 640, 480).at(1.7 + 1e-9);
                let [column, row, _] = voxels.of(at).at;
                assert!((0..=1).contains(&(column - x as i32)) && (0..=1).contains(&(row - y as i32)));
            }
        }
    }

    #[test]
    fn distinct_voxels_stay_distinct_however_fine_they_are() {
        for projection in
            [Projection::Perspective { fov_degrees: 0.1 }, Projection::Orthographic { height_m: 0.1 }]
        {
            let camera = Camera::with(DVec3::Z * 100.0, DVec3::ZERO, projection).expect("a camera");
            for pixels in [1.0, 0.1, 0.004] {
                let voxels = View { pixels, ..View::new(camera, [1000, 800]) }.voxels().expect("a view");
                let deep = [0.0, -0.5].map(|z| voxels.of(DVec3::new(0.0, 0.0, z)).at[2]);
                let most = 0.5 / (voxels.size_m() * if camera.is_orthographic() { 1.0 } else { 100.0 });
                let found = f64::from(deep[1] - deep[0]);
                assert!((found - most).abs() < 0.01 * most + 2.0, "{found} of {most}");
            }
            // Finer grids are refused: corners at the picture's edges would be clamped.
            for (size, pixels) in [([1000, 800], 0.003), ([800, 1000], 1e-9), ([32768, 16], 0.06)] {
                let view = View { pixels, ..View::new(camera, size) };
                let refused = view.voxels();
                let Err(MesherError::FineView { least, .. }) = refused else { panic!("{refused:?}") };
                assert!(View { pixels: least, ..view }.voxels().is_ok());
            }
        }
    }

    #[test]
    fn views_that_see_nothing_are_refused() {
        let camera = Camera::new(DVec3::ONE, DVec3::ZERO, 40.0).expect("a camera");
        let view = View::new(camera, [100, 100]);
        for bad in [
            View { size: [0, 100], ..view },
            View { size: [100, 0], ..view },
            View { pixels: 0.0, ..view },
            View { pixels: f64::NAN, ..view },
            View { pixels: -1.0, ..view },
            View { near_m: 0.0, ..view },
            View { near_m: f64::INFINITY, ..view },
        ] {
            assert!(matches!(bad.voxels(), Err(MesherError::BadView { .. })), "{bad:?}");
        }
        // What is behind the eye, or far beside the picture, has voxels, too.
        let voxels = view.voxels().expect("a view");
        for position in [DVec3::ONE, DVec3::splat(3.0), DVec3::new(1e30, -1e30, 0.0)] {
            let voxel = voxels.of(position);
            assert!(voxel.share > 0.0 && voxel.at.iter().all(|at| at.abs() <= 1 << 18), "{voxel:?}");
        }
    }
}
