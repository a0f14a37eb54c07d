//! A camera and a sun that show a mesh whole.

use glam::Vec3;
use relief_core::mesh::Mesh;

/// The sphere around a mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Around {
    pub center: Vec3,
    pub radius: f32,
    /// From the lowest to the highest vertex.
    pub height: f32,
}

impl Around {
    pub fn of(mesh: &Mesh) -> Self {
        let positions = || mesh.vertices().iter().map(|vertex| vertex.position);
        let least = positions().fold(Vec3::INFINITY, Vec3::min);
        let greatest = positions().fold(Vec3::NEG_INFINITY, Vec3::max);
        let center = 0.5 * (least + greatest);
        let radius = positions().map(|at| at.distance(center)).fold(1e-6, f32::max);
        Self { center, radius, height: greatest.y - least.y }
    }

    /// The columns of a frame that looks from a direction to the middle along its negative third
    /// axis, and its origin, at a distance in radii.
    pub fn seen_from(&self, direction: Vec3, radii: f32) -> [Vec3; 4] {
        let back = direction.normalize();
        let right = Vec3::Y.cross(back).normalize();
        [right, back.cross(right), back, self.center + back * (radii * self.radius)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_middle_lies_straight_ahead() -> Result<(), relief_core::mesh::MeshError> {
        let around = Around::of(&relief_core::mesh::sphere(32, 16)?);
        assert!((around.radius - 0.5).abs() < 1e-5 && around.center.length() < 1e-5);
        let [right, up, back, origin] = around.seen_from(Vec3::new(1.0, 2.0, 3.0), 4.0);
        assert!((origin - back * 2.0).length() < 1e-5);
        assert!((right.cross(up) - back).length() < 1e-5 && up.y > 0.0);
        Ok(())
    }
}
