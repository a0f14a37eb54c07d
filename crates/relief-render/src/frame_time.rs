//! Times of a frame.

use std::time::Duration;

/// Time of a frame, without what is done once for many frames: baking, compiling, uploading, making
/// displaced triangles and reading back.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct FrameTime {
    /// Wall-clock time from the frame's beginning to its end. Short frames of a GPU are timed
    /// several in a row, and this is their mean.
    pub elapsed: Duration,
    /// Times of the passes by the clock of the GPU. `None` on the CPU, and where a GPU's clock is
    /// missing or stands still.
    pub passes: Option<PassTimes>,
    /// Number of displaced triangles that the GPU tessellated and drew, over all surfaces.
    pub made_triangles: u64,
}

/// Times of a frame's passes on a GPU.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PassTimes {
    /// Making displaced triangles for the view; zero where they were cached. It is no part of the
    /// frame.
    pub make: Duration,
    /// Rasterising and tracing.
    pub trace: Duration,
    /// Shading, with shadow rays.
    pub shade: Duration,
}
