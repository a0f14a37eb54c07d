//! Certificate of a mesh's error.

use crate::{Judge, MesherError};

/// Bound on the distance between a mesh and the relief, along the direction of displacement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Certificate {
    /// Greatest distance in metres.
    ///
    /// On a plane it is exact but for the rounding of positions to `f32`. On other meshes it is a
    /// bound. It includes the most that turning directions can add over a triangle. It takes the
    /// longest direction of a base triangle for all its points.
    pub error_m: f64,
    /// Texture coordinates of the greatest distance.
    pub uv: [f64; 2],
    /// Mean distance at the centres of texels, in metres.
    pub mean_m: f64,
    /// Greatest difference in metres between the heights that the two sides of a seam read from the
    /// map; 0 where all seams fit.
    ///
    /// A welded mesh has the heights of one side at a seam. Triangles of the other side with a
    /// corner there are off by up to this much more.
    pub seams_m: f64,
    /// Places at which distances were measured.
    pub judge: Judge,
}

impl Certificate {
    /// Returns the certificate of triangles that are the relief itself.
    pub(crate) fn exact(judge: Judge) -> Self {
        Self { error_m: 0.0, uv: [0.0; 2], mean_m: 0.0, seams_m: 0.0, judge }
    }

    /// Returns whether the triangles are exactly the relief.
    pub fn is_exact(&self) -> bool {
        self.error_m == 0.0
    }

    /// Returns an error if the greatest distance exceeds `error_m` metres.
    pub(crate) fn check(&self, error_m: f64) -> Result<(), MesherError> {
        if self.error_m > error_m * (1.0 + 1e-9) {
            return Err(MesherError::NotReached { error_m, reached_m: self.error_m });
        }
        Ok(())
    }
}
