//! A bar on a terminal, nothing in a pipe.

use std::time::Duration;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// Steps of a bar: finer than any terminal is wide.
const STEPS: u64 = 1000;

/// A progress bar for one piece of work.
pub struct Progress(ProgressBar);

impl Progress {
    /// A bar that says what is done; hidden with `quiet`, and where the standard error is no terminal.
    pub fn new(what: &'static str, quiet: bool) -> Self {
        let target = if quiet { ProgressDrawTarget::hidden() } else { ProgressDrawTarget::stderr() };
        let bar = ProgressBar::with_draw_target(Some(STEPS), target).with_message(what);
        if let Ok(style) = ProgressStyle::with_template("{msg} {wide_bar} {percent:>3} % {eta} left") {
            bar.set_style(style);
        }
        bar.enable_steady_tick(Duration::from_millis(200));
        Self(bar)
    }

    /// Shows the finished part, from 0 to 1; it never goes back.
    pub fn show(&self, part: f32) {
        let step = (part.clamp(0.0, 1.0) * STEPS as f32) as u64;
        if step > self.0.position() {
            self.0.set_position(step);
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.0.finish_and_clear();
    }
}
