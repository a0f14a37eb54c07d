//! Errors of a rendering.

use relief_core::Cancelled;
use relief_maps::MapsError;

use crate::cpu::CpuError;
#[cfg(feature = "gpu")]
use crate::gpu::GpuError;
use crate::job::Job;
use crate::prepare::GeometryError;

/// Reason why a scene could not be rendered.
#[derive(Debug, thiserror::Error)]
pub enum RenderError {
    /// A baked map that a method reads cannot be provided.
    #[error(transparent)]
    Maps(MapsError),
    /// The displaced triangles of a surface cannot be made.
    #[error("surface {}: {source}", surface + 1)]
    Geometry {
        /// The surface's number in the scene.
        surface: usize,
        /// Reason.
        source: GeometryError,
    },
    /// The CPU was asked for [`Sampling::Fast`](relief_shaders::wgsl::Sampling::Fast).
    #[error("sampling 'fast' uses a GPU's texture sampler, which the CPU backend does not have")]
    FastOnCpu {
        /// Whether the CPU was taken because no GPU was found.
        no_gpu: bool,
    },
    /// The images of an object are counted in a stencil buffer, which the CPU backend does not
    /// have.
    #[error(
        "surface {}: the CPU backend has no stencil buffer; set 'geometry.pass' to 'product', or choose a \
         GPU", surface + 1
    )]
    StencilOnCpu {
        /// The surface's number in the scene.
        surface: usize,
    },
    /// The rendering was cancelled.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// There is not enough memory for the picture.
    #[error("there is not enough memory for a picture of {width}x{height} pixels; render a smaller one")]
    OutOfMemory {
        /// Columns.
        width: u32,
        /// Rows.
        height: u32,
    },
    /// The GPU backend was asked for and is not in this build.
    #[error("this build has no GPU backend")]
    NoGpuBackend,
    /// The GPU failed.
    #[cfg(feature = "gpu")]
    #[error(transparent)]
    Gpu(GpuError),
}

impl From<MapsError> for RenderError {
    fn from(error: MapsError) -> Self {
        match error {
            MapsError::Cancelled(cancelled) => cancelled.into(),
            other => Self::Maps(other),
        }
    }
}

impl RenderError {
    /// Converts an error of the CPU backend while it renders `job`.
    pub(crate) fn of_cpu(error: CpuError, job: &Job) -> Self {
        match error {
            CpuError::OutOfMemory => Self::OutOfMemory { width: job.width, height: job.height },
            CpuError::Cancelled(cancelled) => cancelled.into(),
        }
    }
}

#[cfg(feature = "gpu")]
impl From<GpuError> for RenderError {
    fn from(error: GpuError) -> Self {
        match error {
            GpuError::Cancelled(cancelled) => cancelled.into(),
            other => Self::Gpu(other),
        }
    }
}
