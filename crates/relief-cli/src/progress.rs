//! A bar on a terminal, nothing in a pipe.

use std::time::Duration;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// Steps of a bar: finer than any terminal is wide.
const STEPS: u64 = 1000;

/// How often what is shown moves on.
const TICK: Duration = Duration::from_millis(200);

/// What is shown of one piece of work, until it is dropped.
pub struct Progress(ProgressBar);

impl Progress {
    /// A bar that says what is done; hidden with `quiet`, and where the standard error is no terminal.
    pub fn bar(what: &'static str, quiet: bool) -> Self {
        Self::styled(what, quiet, Some(STEPS), "{msg} {wide_bar} {percent:>3} % {eta} left")
    }

    /// The same for work of which nobody knows how much is done.
    pub fn spinner(what: &'static str, quiet: bool) -> Self {
        Self::styled(what, quiet, None, "{msg} {spinner} {elapsed}")
    }

    fn styled(what: &'static str, quiet: bool, steps: Option<u64>, template: &str) -> Self {
        let target = if quiet { ProgressDrawTarget::hidden() } else { ProgressDrawTarget::stderr() };
        let bar = ProgressBar::with_draw_target(steps, target).with_message(what);
        if let Ok(style) = ProgressStyle::with_template(template) {
            bar.set_style(style);
        }
        bar.enable_steady_tick(TICK);
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
