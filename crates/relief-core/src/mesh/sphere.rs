//! The sphere: curved along both directions, with a frame that shrinks towards the poles.

use super::patch::{Builder, SurfacePoint, part, turn};
use super::{Mesh, MeshError, check_divisions};
use glam::{DVec2, DVec3};
use std::f64::consts::{PI, TAU};

const RADIUS_M: f64 = 0.5;

/// The sphere of diameter 1 around the origin with one tile laid on it like a map of the world. `u`
/// runs once around, to the right seen from outside, with `u = ½` at `+z`. `v` runs from the north
/// pole `+y` to the south pole. It consists of `around` columns and `down` rows.
///
/// At a pole all directions of growing `u` meet and the true tangent is 0. Each column has its own
/// pole vertex, in the middle of the column. Its tangent is taken from the middle of its row, so
/// that the frame can be inverted everywhere.
///
/// # Errors
///
/// When `around` is not in `3..=`[`MAX_DIVISIONS`](super::MAX_DIVISIONS) or `down` is not in
/// `2..=MAX_DIVISIONS`.
pub fn sphere(around: u32, down: u32) -> Result<Mesh, MeshError> {
    check_divisions("around", around, 3)?;
    check_divisions("from pole to pole", down, 2)?;
    let mut builder = Builder::default();
    let ring_point = |i: u32, j: u32| {
        let uv = DVec2::new(part(i, around), part(j, down));
        point(turn(i, around), (uv.y * PI).sin_cos(), uv)
    };
    builder.grid(around, down - 2, |i, j| ring_point(i, j + 1));
    let last_ring = (down - 2) * (around + 1);
    for i in 0..around {
        let north = builder.vertex(pole(i, around, down, 1.0));
        builder.triangle([north, i, i + 1]);
        let south = builder.vertex(pole(i, around, down, -1.0));
        builder.triangle([south, last_ring + i + 1, last_ring + i]);
    }
    Ok(builder.finish())
}

/// Point at a longitude and a polar angle, each given by sine and cosine.
fn point((sin_lon, cos_lon): (f64, f64), (sin_polar, cos_polar): (f64, f64), uv: DVec2) -> SurfacePoint {
    let normal = DVec3::new(sin_polar * sin_lon, cos_polar, sin_polar * cos_lon);
    SurfacePoint {
        position: normal * RADIUS_M,
        normal,
        du: DVec3::new(cos_lon, 0.0, -sin_lon) * (TAU * RADIUS_M * sin_polar),
        dv: DVec3::new(cos_polar * sin_lon, -sin_polar, cos_polar * cos_lon) * (PI * RADIUS_M),
        uv,
    }
}

/// Pole vertex of column `i`; `up` is 1 at the north pole and -1 at the south pole.
fn pole(i: u32, around: u32, down: u32, up: f64) -> SurfacePoint {
    let middle = turn(2 * i + 1, 2 * around);
    let uv = DVec2::new(part(2 * i + 1, 2 * around), 0.5 - 0.5 * up);
    let mut at_pole = point(middle, (0.0, up), uv);
    at_pole.du = point(middle, (0.5 * PI / f64::from(down)).sin_cos(), uv).du;
    at_pole
}
