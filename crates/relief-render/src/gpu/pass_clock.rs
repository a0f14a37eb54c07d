//! GPU timestamps around the passes of a frame.

use std::cell::RefCell;
use std::time::Duration;

use wgpu::{
    BufferUsages, ComputePassDescriptor, ComputePassTimestampWrites, Features,
    QUERY_RESOLVE_BUFFER_ALIGNMENT, QuerySet, QuerySetDescriptor, QueryType,
};

use super::{Gpu, GpuError};
use crate::frame_time::PassTimes;

/// Greatest number of timed passes. A query set has two timestamps for each, and WebGPU allows
/// 4096.
pub const MAX_PASSES: usize = 2048;

/// Task of a pass.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PassKind {
    /// Making displaced triangles.
    Make,
    /// Rasterising and tracing.
    Trace,
    /// Shading.
    Shade,
}

/// Timestamp queries of a pass's beginning and end.
pub struct Timed<'a> {
    pub queries: &'a QuerySet,
    pub begin: u32,
    pub end: u32,
}

/// Returns the descriptor of a compute pass, with timestamps if it is timed.
pub fn timed_compute(timed: Option<Timed<'_>>) -> ComputePassDescriptor<'_> {
    let timestamp_writes = timed.map(|Timed { queries, begin, end }| ComputePassTimestampWrites {
        query_set: queries,
        beginning_of_pass_write_index: Some(begin),
        end_of_pass_write_index: Some(end),
    });
    ComputePassDescriptor { label: None, timestamp_writes }
}

/// Timestamps around the passes of one or more frames.
pub struct PassClock {
    queries: QuerySet,
    /// Passes so far, including those beyond [`MAX_PASSES`] that were not timed.
    passes: RefCell<Vec<PassKind>>,
}

impl PassClock {
    /// Creates a clock, or `None` if the device has no timestamps.
    pub fn new(gpu: &Gpu) -> Option<Self> {
        gpu.device().features().contains(Features::TIMESTAMP_QUERY).then(|| Self {
            queries: gpu.device().create_query_set(&QuerySetDescriptor {
                label: Some("pass times"),
                ty: QueryType::Timestamp,
                count: 2 * MAX_PASSES as u32,
            }),
            passes: RefCell::default(),
        })
    }

    /// Returns the timestamp queries of the next pass, or `None` beyond [`MAX_PASSES`].
    pub fn next(&self, kind: PassKind) -> Option<Timed<'_>> {
        let mut passes = self.passes.borrow_mut();
        passes.push(kind);
        let begin = 2 * (passes.len() as u32 - 1);
        (passes.len() <= MAX_PASSES).then_some(Timed { queries: &self.queries, begin, end: begin + 1 })
    }

    /// Waits for the GPU and returns the times of a frame, the mean of `frames`. Returns `None` if
    /// the times are not valid: some passes were not timed, the clock went backward, or it stood
    /// still.
    pub async fn read(self, gpu: &Gpu, frames: u32) -> Result<Option<PassTimes>, GpuError> {
        let passes = self.passes.into_inner();
        if passes.is_empty() || passes.len() > MAX_PASSES {
            return Ok(None);
        }
        let stamps = 2 * passes.len();
        let bytes = (8 * stamps as u64).next_multiple_of(QUERY_RESOLVE_BUFFER_ALIGNMENT);
        let readable = gpu
            .guarded(|| {
                let resolved =
                    gpu.buffer("resolved times", bytes, BufferUsages::QUERY_RESOLVE | BufferUsages::COPY_SRC);
                let readable = gpu.buffer("times", bytes, BufferUsages::MAP_READ | BufferUsages::COPY_DST);
                let mut encoder = gpu.device().create_command_encoder(&Default::default());
                encoder.resolve_query_set(&self.queries, 0..stamps as u32, &resolved, 0);
                encoder.copy_buffer_to_buffer(&resolved, 0, &readable, 0, bytes);
                gpu.queue().submit([encoder.finish()]);
                Ok(readable)
            })
            .await?;
        let mut times = Vec::with_capacity(stamps);
        let read = gpu.read(&readable, 8 * stamps as u64, |bytes| {
            times.extend(bytes.as_chunks::<8>().0.iter().map(|stamp| u64::from_le_bytes(*stamp)));
        });
        read.await?;
        let period_ns = f64::from(gpu.queue().get_timestamp_period());
        Ok(sums(&passes, &times, period_ns / f64::from(frames)))
    }
}

/// Adds up the times of the passes of each kind.
fn sums(passes: &[PassKind], times: &[u64], period_ns: f64) -> Option<PassTimes> {
    let mut sums = [0u64; 3];
    for (kind, stamps) in passes.iter().zip(times.as_chunks::<2>().0) {
        let [begin, end] = *stamps;
        sums[*kind as usize] += end.checked_sub(begin)?;
    }
    let [make, trace, shade] = sums.map(|ticks| Duration::from_nanos((ticks as f64 * period_ns) as u64));
    (!trace.is_zero() && !shade.is_zero()).then_some(PassTimes { make, trace, shade })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn passes_are_added_up_and_what_is_no_time_is_none() {
        use PassKind::{Make, Shade, Trace};
        let times = sums(&[Make, Trace, Shade, Trace], &[3, 5, 10, 20, 20, 25, 100, 101], 1000.0);
        let micros = Duration::from_micros;
        assert_eq!(times, Some(PassTimes { make: micros(2), trace: micros(11), shade: micros(5) }));
        assert_eq!(sums(&[Trace, Shade], &[10, 20, 20, 15], 1.0), None);
        assert_eq!(sums(&[Trace, Shade], &[7, 7, 7, 7], 1.0), None);
    }
}
