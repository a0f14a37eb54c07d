//! Position, rotation and size of a mesh in the world.

use super::{Mesh, MeshError, Vertex};
use glam::{DMat3, DVec3, EulerRot};

/// Position, rotation and size of a mesh in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    /// Position of its origin, in metres.
    pub position_m: DVec3,
    /// Rotation in degrees about the world's `x`, then about `y`, then about `z`.
    pub rotation_degrees: DVec3,
    /// Scale factor.
    pub size: f64,
}

impl Default for Placement {
    /// Returns the placement that changes nothing.
    fn default() -> Self {
        Self { position_m: DVec3::ZERO, rotation_degrees: DVec3::ZERO, size: 1.0 }
    }
}

impl Placement {
    /// Returns the rotation as a matrix.
    ///
    /// # Errors
    ///
    /// When a number is not finite or the size is not positive.
    pub fn turn(&self) -> Result<DMat3, MeshError> {
        let Placement { position_m, rotation_degrees, size } = *self;
        if !(position_m.is_finite() && rotation_degrees.is_finite() && size.is_finite() && size > 0.0) {
            return Err(MeshError::BadPlacement);
        }
        let [x, y, z] = rotation_degrees.to_array().map(f64::to_radians);
        Ok(DMat3::from_euler(EulerRot::ZYX, z, y, x))
    }
}

impl Mesh {
    /// Returns the mesh at this placement. Tiles scale with it: tangents and bitangents stay as
    /// long as one tile.
    ///
    /// # Errors
    ///
    /// When a number is not finite, the size is not positive, the placed mesh is not finite, or its
    /// tiles are too short or long for `f32`.
    pub fn placed(self, placement: &Placement) -> Result<Self, MeshError> {
        let Placement { position_m, size, .. } = *placement;
        if *placement == Placement::default() {
            return Ok(self);
        }
        let turn = placement.turn()?;
        let larger = turn * size;
        let place = |vertex: &Vertex| Vertex {
            position: (larger * vertex.position.as_dvec3() + position_m).as_vec3(),
            normal: (turn * vertex.normal.as_dvec3()).as_vec3(),
            tangent: (larger * vertex.tangent.as_dvec3()).as_vec3(),
            bitangent: (larger * vertex.bitangent.as_dvec3()).as_vec3(),
            uv: vertex.uv,
        };
        let vertices: Vec<Vertex> = self.vertices.iter().map(place).collect();
        let keeps_lengths =
            |(after, before): (&Vertex, &Vertex)| after.has_lengths() || !before.has_lengths();
        if vertices.iter().all(Vertex::is_finite) && vertices.iter().zip(&self.vertices).all(keeps_lengths) {
            Ok(Self { vertices, triangles: self.triangles })
        } else {
            Err(MeshError::BadPlacement)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::square;
    use glam::Vec3;

    fn placed(rotation: [f64; 3], size: f64) -> Mesh {
        let placement =
            Placement { position_m: DVec3::new(1.0, 2.0, 3.0), rotation_degrees: rotation.into(), size };
        square(1).and_then(|mesh| mesh.placed(&placement)).expect("a proper placement")
    }

    #[test]
    fn turns_come_in_the_order_x_y_z() {
        // The plane's normal is +y. About x it turns to +z, and from there about y to +x. About z
        // that turns to +y.
        for (rotation, normal) in [
            ([0.0, 0.0, 0.0], Vec3::Y),
            ([90.0, 0.0, 0.0], Vec3::Z),
            ([90.0, 90.0, 0.0], Vec3::X),
            ([90.0, 90.0, 90.0], Vec3::Y),
        ] {
            let mesh = placed(rotation, 1.0);
            assert!(
                mesh.vertices().iter().all(|vertex| (vertex.normal - normal).length() < 1e-6),
                "{rotation:?}"
            );
        }
    }

    #[test]
    fn frames_and_tiles_go_with_the_mesh() {
        let mesh = placed([20.0, 30.0, 40.0], 2.5);
        assert!(mesh.tile_m().iter().all(|length| (length - 2.5).abs() < 1e-6));
        for vertex in mesh.vertices() {
            let across = vertex.bitangent.cross(vertex.tangent).normalize();
            assert!((across - vertex.normal).length() < 1e-5);
            assert!((vertex.position - Vec3::new(1.0, 2.0, 3.0)).length() < 2.5);
        }
        assert_eq!(square(1).and_then(|mesh| mesh.placed(&Placement::default())), square(1));
    }

    #[test]
    fn impossible_placements_are_refused() {
        let impossible = [
            Placement { size: 0.0, ..Placement::default() },
            Placement { size: -1.0, ..Placement::default() },
            Placement { size: f64::NAN, ..Placement::default() },
            Placement { size: 1e300, ..Placement::default() },
            Placement { size: 1e25, ..Placement::default() },
            Placement { size: 1e-25, ..Placement::default() },
            Placement { size: 1e-41, ..Placement::default() },
            Placement { position_m: DVec3::INFINITY, ..Placement::default() },
            Placement { rotation_degrees: DVec3::NAN, ..Placement::default() },
        ];
        for placement in impossible {
            assert_eq!(square(1).and_then(|mesh| mesh.placed(&placement)), Err(MeshError::BadPlacement));
        }
    }
}
