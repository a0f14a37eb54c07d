//! The plane: the mesh on which every method's assumptions hold exactly.

use super::patch::{Builder, SurfacePoint, from_middle, part};
use super::{Mesh, MeshError, check_divisions};
use glam::{DVec2, DVec3};

/// The unit square `x, z ∈ [-½, ½]` at `y = 0` with normal `+y`, `u` along `+x`, `v` along `+z`, one tile
/// over the whole, in `divisions` x `divisions` quads.
///
/// # Errors
///
/// When `divisions` is not in `1..=`[`MAX_DIVISIONS`](super::MAX_DIVISIONS).
pub fn plane(divisions: u32) -> Result<Mesh, MeshError> {
    check_divisions("of a side", divisions, 1)?;
    let mut builder = Builder::default();
    builder.grid(divisions, divisions, |i, j| {
        let uv = DVec2::new(part(i, divisions), part(j, divisions));
        SurfacePoint {
            position: DVec3::new(from_middle(i, divisions), 0.0, from_middle(j, divisions)),
            normal: DVec3::Y,
            du: DVec3::X,
            dv: DVec3::Z,
            uv,
        }
    });
    Ok(builder.finish())
}
