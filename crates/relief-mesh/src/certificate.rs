//! What is known of the error of a mesh.

use crate::{Judge, MesherError};

/// How far the relief is from the triangles of a mesh, at most, along the direction of displacement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Certificate {
    /// The greatest distance in metres. On a plane it is exact but for the rounding of positions to `f32`. On
    /// other meshes it is a bound: where directions turn over a triangle, what that can do at most counts as
    /// well, and all as if the longest direction of a base triangle were everywhere.
    pub error_m: f64,
    /// Where it is: texture coordinates.
    pub uv: [f64; 2],
    /// The mean of the distances at the centres of texels, in metres.
    pub mean_m: f64,
    /// The greatest difference, in metres, between what the two sides of a seam see of the map: 0 where all
    /// seams fit. A welded mesh has the heights of one side there, and triangles of the other side with a
    /// corner at the seam are off by as much more.
    pub seams_m: f64,
    /// Where distances were looked at.
    pub judge: Judge,
}

impl Certificate {
    /// That of triangles which are the relief.
    pub(crate) fn exact(judge: Judge) -> Self {
        Self { error_m: 0.0, uv: [0.0; 2], mean_m: 0.0, seams_m: 0.0, judge }
    }

    /// Whether the triangles are the relief.
    pub fn is_exact(&self) -> bool {
        self.error_m == 0.0
    }

    /// Whether a tolerance in metres was kept.
    pub(crate) fn check(&self, error_m: f64) -> Result<(), MesherError> {
        if self.error_m > error_m * (1.0 + 1e-9) {
            return Err(MesherError::NotReached { error_m, reached_m: self.error_m });
        }
        Ok(())
    }
}
