//! Places of meshes, as three.js has them: a position, a turn and a scale along each axis.

use glam::{DMat4, DQuat, DVec3, EulerRot};
use serde_json::{Value, json};

/// A place of a mesh.
#[derive(Clone, Copy)]
pub struct Place {
    pub position: DVec3,
    pub turn: DQuat,
    pub scale: DVec3,
}

impl Place {
    /// A place with a turn about x, then y, then z, in degrees.
    pub fn new(position: [f64; 3], degrees: [f64; 3], scale: [f64; 3]) -> Self {
        let [x, y, z] = degrees.map(f64::to_radians);
        let turn = DQuat::from_euler(EulerRot::ZYX, z, y, x);
        Self { position: position.into(), turn, scale: scale.into() }
    }

    pub fn matrix(&self) -> DMat4 {
        DMat4::from_scale_rotation_translation(self.scale, self.turn, self.position)
    }

    /// The place in words of a page.
    pub fn json(&self) -> Value {
        json!({
            "position": self.position.to_array(),
            "quaternion": self.turn.to_array(),
            "scale": self.scale.to_array(),
        })
    }
}
