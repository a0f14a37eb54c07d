//! Slices through a box, for objects that are defined by images.
//!
//! Source: Kautz and Seidel 2001, section 4.1. The slices go through the space that all images look
//! at, and are drawn where each image shows the object. The images themselves are not used here.

use glam::DVec3;
use relief_core::Watch;
use relief_core::camera::Camera;

use super::{SliceAnchor, SliceDirection, SliceError};

/// Corners of a convex slice through a box, in their order around it: 3 to 6.
pub type BoxSlice = Vec<DVec3>;

/// Slices of a box along the axes of the world.
///
/// The directions `Surface`, `AcrossU` and `AcrossV` are slices at equal `x`, `y` and `z`.
///
/// ```
/// use glam::DVec3;
/// use relief_core::Watch;
/// use relief_mesh::{BoxSlicer, SliceDirection};
///
/// let bounds = [DVec3::ZERO, DVec3::new(1.0, 2.0, 0.5)];
/// let slicer = BoxSlicer::new(bounds, 0.1, SliceDirection::AcrossU)?;
/// let mut slices = 0;
/// slicer.each(&Watch::none(), |corners| slices += usize::from(corners.len() == 4))?;
/// assert_eq!((slices, slicer.slices()), (20, 20));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct BoxSlicer {
    bounds: [DVec3; 2],
    /// Unit normal of all slices.
    normal: DVec3,
    /// Place of the first slice along it, and the distance between slices, in metres.
    first_m: f64,
    spacing_m: f64,
    count: u64,
}

impl BoxSlicer {
    /// Creates slices through the box between the least and the greatest coordinates, `spacing_m`
    /// metres apart.
    ///
    /// Slices along two axes of the world lie evenly in the box, however thin it is, at most half
    /// of the spacing from its sides. Slices at equal depths lie before the eye, at multiples of
    /// the spacing from their anchor.
    ///
    /// # Errors
    ///
    /// Fails if the box has no volume, or if the spacing is not positive or not finite.
    pub fn new(bounds: [DVec3; 2], spacing_m: f64, direction: SliceDirection) -> Result<Self, SliceError> {
        let [low, high] = bounds;
        let is_length = |length: f64| length > 0.0 && length.is_finite();
        if !(is_length(spacing_m) && (high - low).to_array().into_iter().all(is_length)) {
            return Err(SliceError::NoSpacing);
        }
        let axis = match direction {
            SliceDirection::Surface => 0,
            SliceDirection::AcrossU => 1,
            SliceDirection::AcrossV => 2,
            SliceDirection::Facing(camera) => facing_axis(bounds, &camera),
            SliceDirection::Quads(..) => return Err(SliceError::NoBorder),
            SliceDirection::Screen(camera, anchor) => {
                return Ok(Self::facing(bounds, spacing_m, &camera, anchor));
            }
        };
        let extent = high[axis] - low[axis];
        let count = (extent / spacing_m - super::ROUNDING).ceil().max(1.0) as u64;
        let first_m = low[axis] + 0.5 * (extent - (count - 1) as f64 * spacing_m);
        Ok(Self { bounds, normal: DVec3::AXES[axis], first_m, spacing_m, count })
    }

    /// Creates slices at equal depths from a camera.
    fn facing(bounds: [DVec3; 2], spacing_m: f64, camera: &Camera, anchor: SliceAnchor) -> Self {
        let normal = camera.forward();
        let eye_m = normal.dot(camera.eye());
        let start_m = match anchor {
            SliceAnchor::Eye => eye_m,
            SliceAnchor::Object => 0.0,
        };
        let along = corners_of(bounds).map(|corner| normal.dot(corner));
        let [low, high] = [f64::min, f64::max].map(|of| along.into_iter().fold(along[0], of));
        let [before, last] = [low.max(eye_m), high].map(|at| ((at - start_m) / spacing_m).floor());
        let first_m = start_m + (before + 1.0) * spacing_m;
        Self { bounds, normal, first_m, spacing_m, count: (last - before).max(0.0) as u64 }
    }

    /// Returns the number of slices.
    pub fn slices(&self) -> u64 {
        self.count
    }

    /// Returns the distance of the slice with that corner from a camera's eye, or from the camera's
    /// plane where rays are parallel. A ray meets nearer slices before farther ones.
    pub fn distance_m(&self, corner: &DVec3, camera: &Camera) -> f64 {
        if camera.is_orthographic() {
            return self.normal.dot(*corner) * self.normal.dot(camera.forward()).signum();
        }
        self.normal.dot(*corner - camera.eye()).abs()
    }

    /// Calls `take` with all slices, in the order of their places along the normal.
    ///
    /// # Errors
    ///
    /// Fails when cancelled, or if a corner lies beyond the range of `f32`.
    pub fn each(&self, watch: &Watch, mut take: impl FnMut(&BoxSlice)) -> Result<(), SliceError> {
        for number in 0..self.count {
            watch.check()?;
            let slice = self.slice(self.first_m + number as f64 * self.spacing_m);
            if !slice.iter().all(|corner| corner.as_vec3().is_finite()) {
                return Err(SliceError::NotFinite);
            }
            // A box that is only touched shows nothing.
            if slice.len() >= 3 {
                take(&slice);
            }
            watch.at((number + 1) as f32 / self.count as f32)?;
        }
        Ok(())
    }

    /// Returns the cut of the box by a plane at a place along the normal.
    fn slice(&self, at_m: f64) -> BoxSlice {
        let corners = corners_of(self.bounds);
        let off = corners.map(|corner| self.normal.dot(corner) - at_m);
        let mut points = Vec::with_capacity(6);
        for one in 0..8 {
            for axis in [1, 2, 4] {
                let other = one | axis;
                if other != one && (off[one] > 0.0) != (off[other] > 0.0) {
                    points.push(corners[one].lerp(corners[other], off[one] / (off[one] - off[other])));
                }
            }
        }
        let middle = points.iter().sum::<DVec3>() / points.len() as f64;
        let (right, up) = self.normal.any_orthonormal_pair();
        let angle = |point: &DVec3| (*point - middle).dot(up).atan2((*point - middle).dot(right));
        points.sort_by(|one, other| angle(one).total_cmp(&angle(other)));
        points
    }
}

/// Returns the corners of a box. The bits of a corner's number say on which side of each axis it
/// is.
fn corners_of([low, high]: [DVec3; 2]) -> [DVec3; 8] {
    std::array::from_fn(|number| {
        let side = |axis: usize| if number >> axis & 1 == 0 { low[axis] } else { high[axis] };
        DVec3::new(side(0), side(1), side(2))
    })
}

/// Returns the axis whose planes face a camera most.
fn facing_axis([low, high]: [DVec3; 2], camera: &Camera) -> usize {
    let view = if camera.is_orthographic() { camera.forward() } else { 0.5 * (low + high) - camera.eye() };
    let [x, y, z] = view.abs().to_array();
    if x >= y.max(z) {
        0
    } else if y >= z {
        1
    } else {
        2
    }
}

#[cfg(test)]
mod tests {
    use relief_core::Cancelled;

    use super::*;

    const BOUNDS: [DVec3; 2] = [DVec3::new(-1.0, -0.5, 0.25), DVec3::new(1.0, 0.75, 0.5)];

    fn slices(spacing_m: f64, direction: SliceDirection) -> Vec<BoxSlice> {
        let slicer = BoxSlicer::new(BOUNDS, spacing_m, direction).expect("a box");
        let mut all = Vec::new();
        slicer.each(&Watch::none(), |slice| all.push(slice.clone())).expect("slices");
        assert!(all.len() as u64 <= slicer.slices());
        all
    }

    /// Returns the area of a convex polygon that turns one way all around.
    fn area(slice: &BoxSlice, normal: DVec3) -> f64 {
        let turns =
            (2..slice.len()).map(|k| 0.5 * (slice[k - 1] - slice[0]).cross(slice[k] - slice[0]).dot(normal));
        let turns: Vec<f64> = turns.collect();
        let all: f64 = turns.iter().sum();
        assert!(turns.iter().all(|turn| turn * all >= 0.0), "{slice:?}");
        all.abs()
    }

    #[test]
    fn slices_fill_the_box_that_they_cut() {
        let (low, high) = (BOUNDS[0], BOUNDS[1]);
        let volume = (high - low).element_product();
        let camera = |eye| Camera::new(eye, DVec3::new(0.2, 0.1, 0.4), 40.0).expect("a camera");
        let near = camera(DVec3::new(3.0, 4.0, 5.0));
        for (direction, normal) in [
            (SliceDirection::Surface, DVec3::X),
            (SliceDirection::AcrossU, DVec3::Y),
            (SliceDirection::AcrossV, DVec3::Z),
            (SliceDirection::Facing(near), DVec3::Z),
            (SliceDirection::Screen(near, SliceAnchor::Eye), near.forward()),
            (SliceDirection::Screen(near, SliceAnchor::Object), near.forward()),
        ] {
            let all = slices(0.003, direction);
            let filled: f64 = all.iter().map(|slice| area(slice, normal) * 0.003).sum();
            assert!((filled / volume - 1.0).abs() < 0.02, "{direction:?}: {filled} of {volume}");
            for corner in all.iter().flatten() {
                let inside = corner.cmpge(low - 1e-12).all() && corner.cmple(high + 1e-12).all();
                assert!(inside, "{direction:?}: {corner:?}");
            }
        }
        // Where most of the box lies behind the eye, the part before it is sliced.
        let within = camera(DVec3::new(0.9, 0.6, 0.4));
        let direction = SliceDirection::Screen(within, SliceAnchor::Eye);
        for corner in slices(0.01, direction).iter().flatten() {
            assert!((*corner - within.eye()).dot(within.forward()) > 0.0);
        }
    }

    #[test]
    fn thin_boxes_have_a_slice_and_others_as_many_as_fit() {
        let z =
            |spacing_m| slices(spacing_m, SliceDirection::AcrossV).iter().map(|slice| slice[0].z).collect();
        let (one, two): (Vec<f64>, Vec<f64>) = (z(10.0), z(0.125));
        assert_eq!((one, two), (vec![0.375], vec![0.3125, 0.4375]));
    }

    #[test]
    fn eyes_that_stand_still_beside_the_object_cut_it_where_the_object_says() {
        let places = |eye: DVec3, anchor| {
            let camera = Camera::new(eye, eye - DVec3::Z, 40.0).expect("a camera");
            let all = slices(0.01, SliceDirection::Screen(camera, anchor));
            all.iter().map(|slice| (slice[0].z * 1e9).round() as i64).max()
        };
        let [near, far] = [5.0, 5.003].map(|z| DVec3::new(0.1, 0.2, z));
        assert_eq!(places(near, SliceAnchor::Object), places(far, SliceAnchor::Object));
        assert_ne!(places(near, SliceAnchor::Eye), places(far, SliceAnchor::Eye));
    }

    #[test]
    fn what_has_no_slices_is_said() {
        for (bounds, spacing_m) in
            [(BOUNDS, 0.0), (BOUNDS, f64::NAN), ([BOUNDS[0], BOUNDS[0]], 0.1), ([BOUNDS[1], BOUNDS[0]], 0.1)]
        {
            let slicer = BoxSlicer::new(bounds, spacing_m, SliceDirection::Surface);
            assert!(matches!(slicer, Err(SliceError::NoSpacing)), "{bounds:?} {spacing_m}");
        }
        let slicer = BoxSlicer::new(BOUNDS, 0.1, SliceDirection::Surface).expect("a box");
        let cancel = std::sync::atomic::AtomicBool::new(true);
        let stopped = slicer.each(&Watch::cancelled_by(&cancel), |_| panic!("none is taken"));
        assert_eq!(stopped, Err(SliceError::Cancelled(Cancelled)));
    }
}
