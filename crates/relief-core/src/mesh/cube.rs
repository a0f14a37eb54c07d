//! The cube: flat faces that meet at hard edges.

use super::patch::{Builder, SurfacePoint, from_middle, part};
use super::{Mesh, MeshError, check_divisions};
use glam::{DVec2, DVec3};

/// Directions of growing `u` and `v` of each face, seen from outside with the sides upright.
pub(super) const FACES: [(DVec3, DVec3); 6] = [
    (DVec3::X, DVec3::NEG_Y),
    (DVec3::NEG_Z, DVec3::NEG_Y),
    (DVec3::NEG_X, DVec3::NEG_Y),
    (DVec3::Z, DVec3::NEG_Y),
    (DVec3::X, DVec3::Z),
    (DVec3::X, DVec3::NEG_Z),
];

/// The unit cube around the origin. Each face is one full tile in `divisions` x `divisions` quads.
/// The faces look along `+z`, `+x`, `-z`, `-x`, `+y` and `-y`, in this order.
///
/// # Errors
///
/// When `divisions` is not in `1..=`[`MAX_DIVISIONS`](super::MAX_DIVISIONS).
pub fn cube(divisions: u32) -> Result<Mesh, MeshError> {
    check_divisions("of a side", divisions, 1)?;
    let mut builder = Builder::default();
    for (du, dv) in FACES {
        let normal = dv.cross(du);
        builder.grid(divisions, divisions, |i, j| {
            let uv = DVec2::new(part(i, divisions), part(j, divisions));
            let position = normal * 0.5 + du * from_middle(i, divisions) + dv * from_middle(j, divisions);
            SurfacePoint { position, normal, du, dv, uv }
        });
    }
    Ok(builder.finish())
}
