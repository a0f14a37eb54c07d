//! How long a frame takes.

use std::time::Duration;

/// How long a frame takes, without what is done once for many: baking, compiling, uploading, making displaced
/// triangles, reading back.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct FrameTime {
    /// Time from its beginning until it is done, by the machine's clock. If a GPU ends a frame sooner than it
    /// is handed over and waited for, the time of one among several in a row.
    pub elapsed: Duration,
    /// How long its passes took by the clock of the GPU; nothing on the CPU, and where a GPU has no such
    /// clock, or one that stands still.
    pub passes: Option<PassTimes>,
    /// Displaced triangles that a GPU made itself and drew, of all surfaces.
    pub made_triangles: u64,
}

/// How long the passes of a frame took on a GPU.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PassTimes {
    /// Making displaced triangles for the view; nothing where they were there. It is no part of the frame.
    pub make: Duration,
    /// Rasterising and tracing.
    pub trace: Duration,
    /// Shading, with rays to lights.
    pub shade: Duration,
}
