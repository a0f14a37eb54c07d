//! Timing of frames.

use std::time::Duration;

use relief_shaders::wgsl::Sampling;
use web_time::Instant;

use super::super::pass_clock::{MAX_PASSES, PassClock};
use super::passes::{Passes, submit_band};
use super::{GpuError, GpuRenderer};
use crate::block_on;
use crate::frame_time::FrameTime;
use crate::job::Job;
use crate::samples::samples;

/// Time of the frames that are timed in a row. Submitting the first and waiting for the last take
/// some 0.2 ms, hardly a part of it.
const ROW: Duration = Duration::from_millis(25);

/// Most frames in a row.
const MOST_FRAMES: u32 = 32;

impl GpuRenderer {
    /// Measures the time of a frame, without compiling, uploading and reading back. A short frame
    /// is drawn several times in a row, as programs do it. So the GPU has the next frame when it is
    /// done with one, and does not wait for the CPU. The call waits for the GPU, which the web does
    /// not allow.
    ///
    /// # Errors
    ///
    /// See [`Self::render`].
    pub fn time(&mut self, job: &Job, sampling: Sampling) -> Result<FrameTime, GpuError> {
        block_on(self.time_async(job, sampling))
    }

    async fn time_async(&mut self, job: &Job, sampling: Sampling) -> Result<FrameTime, GpuError> {
        let gpu = self.gpu.clone();
        let clock = PassClock::new(&gpu);
        let ready = self.prepare(job, sampling, samples(job.samples, false), clock.as_ref()).await?;
        // All uploads have arrived, and all triangles are made, before the clock starts.
        gpu.flush()?;
        let mut time = self.time_frames(&ready, 1, clock).await?;
        let passes = self.targets()?.bands.iter().map(Vec::len).sum::<usize>() * ready.surfaces.len();
        let frames = frames_in_a_row(time.elapsed, passes);
        if frames > 1 {
            let make = time.passes.map(|passes| passes.make);
            time = self.time_frames(&ready, frames, PassClock::new(&gpu)).await?;
            if let Some((passes, make)) = time.passes.as_mut().zip(make) {
                passes.make = make;
            }
        }
        for surface in &self.surfaces {
            time.made_triangles += surface.made_triangles(&gpu).await?;
        }
        Ok(time)
    }

    /// Submits a number of frames one after the other, and waits until the last is done.
    async fn time_frames(
        &mut self,
        ready: &Passes,
        frames: u32,
        clock: Option<PassClock>,
    ) -> Result<FrameTime, GpuError> {
        let gpu = self.gpu.clone();
        let targets = self.targets()?;
        let started = Instant::now();
        gpu.guarded(|| {
            for _ in 0..frames {
                for passes in &targets.bands {
                    submit_band(&gpu, targets, ready, passes, clock.as_ref(), |_, _| {});
                }
            }
            Ok(())
        })
        .await?;
        gpu.wait()?;
        let elapsed = started.elapsed() / frames;
        let passes = match clock {
            Some(clock) => clock.read(&gpu, frames).await?,
            None => None,
        };
        Ok(FrameTime { elapsed, passes, made_triangles: 0 })
    }
}

/// Returns the number of frames that are timed together, from the time and the traces of one alone.
fn frames_in_a_row(alone: Duration, traces: usize) -> u32 {
    let frames = ROW.as_nanos() / alone.as_nanos().max(1);
    // A frame traces and shades.
    let timed = MAX_PASSES / (2 * traces).max(1);
    frames.min(timed as u128).clamp(1, u128::from(MOST_FRAMES)) as u32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn short_frames_are_timed_in_a_row_as_long_as_all_their_passes_are_timed() {
        let frames = |ms, traces| frames_in_a_row(Duration::from_millis(ms), traces);
        assert_eq!([frames(0, 1), frames(1, 1), frames(5, 1), frames(26, 1)], [MOST_FRAMES, 25, 5, 1]);
        assert_eq!([frames(1, MAX_PASSES / 8), frames(1, MAX_PASSES)], [4, 1]);
    }
}
