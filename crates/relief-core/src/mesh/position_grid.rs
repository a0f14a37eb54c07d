//! Lattices to which positions are rounded, so that they can be stored in few bits.

use std::ops::RangeInclusive;

use glam::{DVec3, Vec3};

/// Significant bits of a step. They are few enough for its multiples to be exact.
const STEP_BITS: i32 = 6;

/// Finest step, relative to the largest coordinate. With the bits of the step all points are exact
/// floats.
const FINEST: f64 = 1.0 / (1 << 18) as f64;

/// Finest step if all positions are at the origin.
const LEAST: f64 = f32::MIN_POSITIVE as f64;

/// A lattice to which positions are rounded, and the range of it that `bits` bits per axis can
/// address.
///
/// Its points are the multiples of one step, the same along all axes, so that angles do not change.
/// All of them are exact 32-bit floats. A stored [`code`](Self::code) is decoded to the last bit by
/// `code * step + origin`, in floats of 32 bits or more. Lattices with the same step have the same
/// points, wherever their range begins. So meshes that meet still do after both are rounded.
///
/// Equal positions stay equal. Different positions may become equal: triangles smaller than a step
/// lose their area.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PositionGrid {
    /// First point along each axis, in steps.
    first: [i32; 3],
    step_m: f64,
    bits: u32,
}

/// Why there is no lattice.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum GridError {
    /// The number of bits is out of range.
    #[error("positions cannot be stored in {0} bits: use 8 to 16")]
    Bits(u32),
    /// A corner of a box is not finite.
    #[error("positions that are not finite cannot be rounded to a lattice")]
    NotFinite,
}

impl PositionGrid {
    /// Possible bits per coordinate.
    pub const BITS: RangeInclusive<u32> = 8..=16;

    /// Creates lattices with one common step for meshes within these boxes, which are given by
    /// their least and greatest corners in metres. The longest side of all boxes uses all codes
    /// except a thirtieth. Far away from the origin a step is at least 2⁻¹⁸ of the largest
    /// coordinate.
    ///
    /// ```
    /// use glam::Vec3;
    /// use relief_core::mesh::PositionGrid;
    ///
    /// let grid = PositionGrid::around(&[[Vec3::ZERO, Vec3::new(1.0, 0.1, 0.5)]], 10)?[0];
    /// let at = grid.snapped(Vec3::new(0.7, 0.033, 0.5));
    /// assert!(grid.step_m() < 0.00102 && at.distance(Vec3::new(0.7, 0.033, 0.5)) < grid.step_m() as f32);
    /// assert_eq!(grid.snapped(at), at);
    /// # Ok::<(), relief_core::mesh::GridError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// When the bits are not in [`Self::BITS`], or a corner is not finite.
    pub fn around(boxes_m: &[[Vec3; 2]], bits: u32) -> Result<Vec<Self>, GridError> {
        if !Self::BITS.contains(&bits) {
            return Err(GridError::Bits(bits));
        }
        if !boxes_m.as_flattened().iter().all(|corner| corner.is_finite()) {
            return Err(GridError::NotFinite);
        }
        let boxes = boxes_m.iter().map(|corners| corners.map(|corner| corner.as_dvec3()));
        let (mut longest, mut largest) = (0.0_f64, 0.0_f64);
        for [least, greatest] in boxes.clone() {
            longest = longest.max((greatest - least).max_element());
            largest = largest.max(least.abs().max(greatest.abs()).max_element());
        }
        // Both ends lie between points of the lattice.
        let finest = longest / f64::from((1_u32 << bits) - 2);
        let step_m = rounded_up(finest.max(largest * FINEST).max(LEAST));
        let first = |least: DVec3| (least / step_m).floor().as_ivec3().to_array();
        Ok(boxes.map(|[least, _]| Self { first: first(least), step_m, bits }).collect())
    }

    /// Distance between neighbouring points along an axis, in metres.
    pub fn step_m(&self) -> f64 {
        self.step_m
    }

    /// Point with the code 0, in metres.
    pub fn origin_m(&self) -> DVec3 {
        self.first.map(|steps| f64::from(steps) * self.step_m).into()
    }

    /// Bits per coordinate.
    pub fn bits(&self) -> u32 {
        self.bits
    }

    /// Nearest point of the lattice. Ties go to the point farther from the origin.
    pub fn snapped(&self, position: Vec3) -> Vec3 {
        ((position.as_dvec3() / self.step_m).round() * self.step_m).as_vec3() + Vec3::ZERO
    }

    /// Code of the nearest point of the lattice. `None` if it is out of range.
    pub fn code(&self, position: Vec3) -> Option<[u16; 3]> {
        let steps = (position.as_dvec3() / self.step_m).round().to_array();
        let mut codes = [0; 3];
        for axis in 0..3 {
            let code = steps[axis] - f64::from(self.first[axis]);
            if !(0.0..=f64::from((1_u32 << self.bits) - 1)).contains(&code) {
                return None;
            }
            codes[axis] = code as u16;
        }
        Some(codes)
    }
}

/// Next larger number with at most [`STEP_BITS`] significant bits.
fn rounded_up(step: f64) -> f64 {
    let unit = step.log2().floor() as i32 - (STEP_BITS - 1);
    let unit = 2.0_f64.powi(unit);
    (step / unit).ceil() * unit
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn codes_give_the_very_floats_again() {
        let boxes = [
            [Vec3::new(-0.5, -0.01, -0.5), Vec3::new(0.5, 0.02, 0.5)],
            [Vec3::new(1e6, 3.0, -2e5), Vec3::new(1e6 + 500.0, 40.0, -2e5 + 77.0)],
            [Vec3::splat(3.7e-12), Vec3::splat(1e-10)],
            [Vec3::splat(-1e9), Vec3::splat(1e9)],
            [Vec3::ONE, Vec3::ONE],
            [Vec3::ZERO, Vec3::ZERO],
        ];
        for around in boxes {
            for bits in PositionGrid::BITS {
                let grid = PositionGrid::around(&[around], bits).expect("finite")[0];
                let [step, origin] = [DVec3::splat(grid.step_m()), grid.origin_m()].map(|at| at.as_vec3());
                assert_eq!(
                    (step.as_dvec3(), origin.as_dvec3()),
                    (DVec3::splat(grid.step_m()), grid.origin_m())
                );
                for k in 0..1000 {
                    let part = k as f32 / 999.0;
                    let position =
                        around[0] + (around[1] - around[0]) * Vec3::new(part, part * part, 1.0 - part);
                    let position = position.clamp(around[0], around[1]);
                    let snapped = grid.snapped(position);
                    let code = grid.code(position).unwrap_or_else(|| panic!("{position} in {grid:?}"));
                    let read = Vec3::from(code.map(f32::from)) * step + origin;
                    assert_eq!(read, snapped, "{grid:?}");
                    assert_eq!((grid.snapped(snapped), grid.code(snapped)), (snapped, Some(code)));
                    let off = (snapped.as_dvec3() - position.as_dvec3()).abs().max_element();
                    assert!(off <= 0.5 * grid.step_m() * (1.0 + 1e-9), "{off} {grid:?}");
                }
            }
        }
        let usual = PositionGrid::around(&boxes[..1], 16).expect("finite")[0];
        assert!(usual.step_m() < 1.04 / 65534.0 && usual.bits() == 16);
        assert_eq!(usual.code(Vec3::new(2.0, 0.0, 0.0)), None);
    }

    #[test]
    fn boxes_that_meet_have_the_same_points() {
        let boxes =
            [[Vec3::ZERO, Vec3::new(1.0, 0.5, 0.3)], [Vec3::new(1.0, -0.2, 0.1), Vec3::new(1.9, 0.4, 0.3)]];
        let grids = PositionGrid::around(&boxes, 9).expect("finite");
        for k in 0..100 {
            let at = Vec3::new(1.0, 0.004 * k as f32, 0.1 + 0.002 * k as f32);
            assert_eq!(grids[0].snapped(at), grids[1].snapped(at));
        }
    }

    #[test]
    fn what_cannot_be_is_refused() {
        assert_eq!(PositionGrid::around(&[], 7), Err(GridError::Bits(7)));
        assert_eq!(PositionGrid::around(&[], 17), Err(GridError::Bits(17)));
        assert_eq!(PositionGrid::around(&[[Vec3::ZERO, Vec3::NAN]], 16), Err(GridError::NotFinite));
        assert_eq!(PositionGrid::around(&[], 16), Ok(Vec::new()));
    }
}
