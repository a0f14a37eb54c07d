//! The cylinder: curved along one direction only.

use super::patch::{Builder, SurfacePoint, part, turn};
use super::{Mesh, MeshError, check_divisions};
use glam::{DVec2, DVec3};
use std::f64::consts::TAU;

const RADIUS_M: f64 = 0.5;

/// The upright cylinder of diameter 1 and height 1 around the origin.
///
/// * The side carries one tile. `u` runs once around, to the right seen from outside, with `u = ½`
///   at `+z`. `v` runs from the top edge to the bottom edge. The side consists of `around` x
///   `along` quads.
/// * Each cap shows the disc that it cuts out of one tile of the unit square, oriented as on the
///   [`cube`](super::cube()).
///
/// # Errors
///
/// When `around` is not in `3..=`[`MAX_DIVISIONS`](super::MAX_DIVISIONS) or `along` is not in
/// `1..=MAX_DIVISIONS`.
pub fn cylinder(around: u32, along: u32) -> Result<Mesh, MeshError> {
    check_divisions("around", around, 3)?;
    check_divisions("along", along, 1)?;
    let mut builder = Builder::default();
    builder.grid(around, along, |i, j| {
        let (sin, cos) = turn(i, around);
        let uv = DVec2::new(part(i, around), part(j, along));
        SurfacePoint {
            position: DVec3::new(RADIUS_M * sin, 0.5 - uv.y, RADIUS_M * cos),
            normal: DVec3::new(sin, 0.0, cos),
            du: DVec3::new(cos, 0.0, -sin) * (TAU * RADIUS_M),
            dv: DVec3::NEG_Y,
            uv,
        }
    });
    cap(&mut builder, around, DVec3::Z);
    cap(&mut builder, around, DVec3::NEG_Z);
    Ok(builder.finish())
}

/// Adds the cap whose `v` grows along `dv`: the top for `+z`, the bottom for `-z`.
fn cap(builder: &mut Builder, around: u32, dv: DVec3) {
    let (du, normal) = (DVec3::X, dv.cross(DVec3::X));
    let point = |position: DVec3| {
        let uv = DVec2::new(position.dot(du) + 0.5, position.dot(dv) + 0.5);
        SurfacePoint { position, normal, du, dv, uv }
    };
    let centre = builder.vertex(point(normal * 0.5));
    let rim: Vec<u32> = (0..around)
        .map(|i| {
            let (sin, cos) = turn(i, around);
            builder.vertex(point(DVec3::new(RADIUS_M * sin, normal.y * 0.5, RADIUS_M * cos)))
        })
        .collect();
    for (i, &corner) in rim.iter().enumerate() {
        let next = rim[(i + 1) % rim.len()];
        // Growing angles run counter-clockwise seen from above.
        builder.triangle(if normal.y > 0.0 { [centre, corner, next] } else { [centre, next, corner] });
    }
}
