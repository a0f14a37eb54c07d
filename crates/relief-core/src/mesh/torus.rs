//! The torus: curved both ways, convex outside and saddle-shaped inside, without poles.

use super::patch::{Builder, SurfacePoint, part, turn};
use super::{Mesh, MeshError, check_divisions};
use glam::{DVec2, DVec3};
use std::f64::consts::TAU;

/// Radius of the tube's centre line.
const RING_M: f64 = 0.35;
/// Radius of the tube. With [`RING_M`] it adds up to ½, so that the torus fits the unit cube.
const TUBE_M: f64 = 0.15;

/// The torus around the `y` axis with outer diameter 1 and a tube of diameter 0.3. One tile covers
/// the whole. `u` runs once along the ring, to the right seen from outside, with `u = ½` at `+z`.
/// `v` runs once around the tube: from the inner equator over the top to the outer equator at
/// `v = ½`, and back below. It consists of `around` x `tube` quads.
///
/// # Errors
///
/// When `around` or `tube` is not in `3..=`[`MAX_DIVISIONS`](super::MAX_DIVISIONS).
pub fn torus(around: u32, tube: u32) -> Result<Mesh, MeshError> {
    check_divisions("around", around, 3)?;
    check_divisions("around the tube", tube, 3)?;
    let mut builder = Builder::default();
    builder.grid(around, tube, |i, j| {
        let (sin_ring, cos_ring) = turn(i, around);
        // The tube runs downward at the outer equator, against the angle.
        let (sin_tube, cos_tube) = turn(tube - j, tube);
        let outward = DVec3::new(sin_ring, 0.0, cos_ring);
        let distance = RING_M + TUBE_M * cos_tube;
        SurfacePoint {
            position: outward * distance + DVec3::Y * (TUBE_M * sin_tube),
            normal: outward * cos_tube + DVec3::Y * sin_tube,
            du: DVec3::new(cos_ring, 0.0, -sin_ring) * (TAU * distance),
            dv: (outward * sin_tube - DVec3::Y * cos_tube) * (TAU * TUBE_M),
            uv: DVec2::new(part(i, around), part(j, tube)),
        }
    });
    Ok(builder.finish())
}
