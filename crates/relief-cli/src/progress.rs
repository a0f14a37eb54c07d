//! Progress bars: shown on a terminal, not in a pipe.

use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::say::{self, Verbosity};

/// Steps of a bar: more than any terminal is wide.
const STEPS: u64 = 1000;

/// Interval between updates.
const TICK: Duration = Duration::from_millis(200);

/// Progress bar of one piece of work, shown until it is dropped.
pub struct Progress {
    bar: ProgressBar,
    what: String,
    started: Instant,
}

impl Progress {
    /// Creates a bar for the work `what`. It is hidden with `quiet`, or if standard error is no
    /// terminal.
    pub fn bar(what: &str, quiet: bool) -> Self {
        Self::styled(what, quiet, Some(STEPS), "{msg} {wide_bar} {percent:>3} % {eta} left")
    }

    /// Creates a spinner, for work whose progress is unknown.
    pub fn spinner(what: &str, quiet: bool) -> Self {
        Self::styled(what, quiet, None, "{msg} {spinner} {elapsed}")
    }

    fn styled(what: &str, quiet: bool, steps: Option<u64>, template: &str) -> Self {
        let quiet = quiet || say::verbosity() == Verbosity::Quiet;
        let target = if quiet { ProgressDrawTarget::hidden() } else { ProgressDrawTarget::stderr() };
        let bar = ProgressBar::with_draw_target(steps, target).with_message(what.to_owned());
        if let Ok(style) = ProgressStyle::with_template(template) {
            bar.set_style(style);
        }
        bar.enable_steady_tick(TICK);
        Self { bar, what: what.to_owned(), started: Instant::now() }
    }

    /// Shows the finished part, from 0 to 1; the bar never goes back.
    pub fn show(&self, part: f32) {
        let step = (part.clamp(0.0, 1.0) * STEPS as f32) as u64;
        if step > self.bar.position() {
            self.bar.set_position(step);
        }
    }

    /// Runs `say`, for whose output the bar makes room.
    pub fn aside<T>(&self, say: impl FnOnce() -> T) -> T {
        self.bar.suspend(say)
    }
}

/// Progress bars of a renderer's tasks, one after the other.
pub struct TaskProgress {
    quiet: bool,
    shown: Mutex<Option<Progress>>,
}

impl TaskProgress {
    /// Creates it without a bar, until there is a task. With `quiet`, or if standard error is no
    /// terminal, no bar is shown.
    pub fn new(quiet: bool) -> Self {
        Self { quiet, shown: Mutex::new(None) }
    }

    /// Shows the finished part of a task, in place of the task before.
    pub fn show(&self, task: &str, part: f32) {
        let mut shown = self.shown.lock().unwrap_or_else(PoisonError::into_inner);
        if shown.as_ref().is_none_or(|before| before.what != task) {
            // Dropping the bar of the task before removes it.
            *shown = None;
            *shown = Some(Progress::bar(task, self.quiet));
        }
        if let Some(bar) = &*shown {
            bar.show(part);
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
        say::detail(format_args!("{}: {:.2} s", self.what, self.started.elapsed().as_secs_f64()));
    }
}
