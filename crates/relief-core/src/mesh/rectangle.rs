//! The plane: the mesh on which the assumptions of all methods hold exactly.

use super::patch::{Builder, SurfacePoint, from_middle, part};
use super::{Mesh, MeshError, check_divisions};
use glam::{DVec2, DVec3};

/// The unit square: a [`rectangle`] of 1 m by 1 m.
///
/// # Errors
///
/// When `divisions` is not in `1..=`[`MAX_DIVISIONS`](super::MAX_DIVISIONS).
pub fn square(divisions: u32) -> Result<Mesh, MeshError> {
    rectangle([1.0, 1.0], divisions)
}

/// A level rectangle around the origin with normal `+y`. `sides_m` are its lengths in metres along
/// `u`, which is `+x`, and along `v`, which is `+z`. One tile covers the whole, in `divisions` x
/// `divisions` quads.
///
/// # Errors
///
/// When `divisions` is not in `1..=`[`MAX_DIVISIONS`](super::MAX_DIVISIONS), or a side is not a
/// finite positive number of metres in `f32`.
pub fn rectangle(sides_m: [f64; 2], divisions: u32) -> Result<Mesh, MeshError> {
    check_divisions("of a side", divisions, 1)?;
    if !sides_m.iter().all(|&side| (side as f32).is_normal() && side > 0.0) {
        return Err(MeshError::BadSides(sides_m[0], sides_m[1]));
    }
    let [across, down] = sides_m;
    let mut builder = Builder::default();
    builder.grid(divisions, divisions, |i, j| {
        let uv = DVec2::new(part(i, divisions), part(j, divisions));
        SurfacePoint {
            position: DVec3::new(across * from_middle(i, divisions), 0.0, down * from_middle(j, divisions)),
            normal: DVec3::Y,
            du: DVec3::X * across,
            dv: DVec3::Z * down,
            uv,
        }
    });
    Ok(builder.finish())
}
