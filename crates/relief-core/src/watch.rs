//! Progress reports and cancellation of long work.

use std::fmt;
use std::sync::atomic::{AtomicBool, Ordering};

/// Receives the progress of long work, and may cancel it.
///
/// Functions that take long accept a `&Watch`. They call [`at`](Self::at) every few milliseconds
/// from any thread, and pass on its error.
///
/// ```
/// use std::sync::atomic::{AtomicBool, Ordering};
///
/// use relief_core::{Cancelled, Watch};
///
/// fn sum_of_squares(watch: &Watch) -> Result<u64, Cancelled> {
///     let mut sum = 0;
///     for n in 0..100 {
///         watch.at(n as f32 / 100.0)?;
///         sum += n * n;
///     }
///     Ok(sum)
/// }
///
/// // Nobody watches.
/// assert_eq!(sum_of_squares(&Watch::none()), Ok(328_350));
///
/// // Someone prints the progress, and cancels halfway.
/// let cancel = AtomicBool::new(false);
/// let tell = |task: &str, part: f32| {
///     println!("{task}: {:.0} %", 100.0 * part);
///     cancel.store(part >= 0.5, Ordering::Relaxed);
/// };
/// let watch = Watch::new(&tell, &cancel);
/// assert_eq!(sum_of_squares(&watch.task("squares")), Err(Cancelled));
/// ```
#[derive(Clone, Copy)]
pub struct Watch<'a> {
    tell: &'a (dyn Fn(&str, f32) + Sync),
    cancel: &'a AtomicBool,
    task: &'a str,
    /// The part of the whole work that this watch covers: its beginning and its end.
    from: f32,
    to: f32,
}

/// The error of work that was cancelled through its [`Watch`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the work was cancelled")]
pub struct Cancelled;

/// Flag of work that nobody cancels. It is never set.
static NEVER: AtomicBool = AtomicBool::new(false);

/// Callback of work whose progress is not reported.
const NOBODY: &(dyn Fn(&str, f32) + Sync) = &|_, _| {};

impl<'a> Watch<'a> {
    /// Creates a watch that calls `tell` with the task's name and the part done, and cancels the
    /// work once `cancel` is set.
    ///
    /// `tell` is called from any thread, with parts from 0 to 1. The name is empty unless the work
    /// names its [tasks](Self::task).
    pub fn new(tell: &'a (dyn Fn(&str, f32) + Sync), cancel: &'a AtomicBool) -> Self {
        Self { tell, cancel, task: "", from: 0.0, to: 1.0 }
    }

    /// Creates a watch without reports that never cancels.
    pub const fn none() -> Watch<'static> {
        Watch { tell: NOBODY, cancel: &NEVER, task: "", from: 0.0, to: 1.0 }
    }

    /// Creates a watch that calls `tell` and never cancels.
    pub fn telling(tell: &'a (dyn Fn(&str, f32) + Sync)) -> Self {
        Self { tell, ..Watch::none() }
    }

    /// Creates a watch without reports that cancels the work once `cancel` is set.
    pub fn cancelled_by(cancel: &'a AtomicBool) -> Self {
        Self { cancel, ..Watch::none() }
    }

    /// Returns the watch for a piece of this work: the parts between `from` and `to`, both in 0 to
    /// 1.
    #[must_use]
    pub fn piece(&self, from: f32, to: f32) -> Self {
        let span = self.to - self.from;
        Self { from: self.from + from * span, to: self.from + to * span, ..*self }
    }

    /// Returns the watch for a task with this name. Parts still refer to the same piece of work.
    #[must_use]
    pub fn task<'b>(&self, name: &'b str) -> Watch<'b>
    where
        'a: 'b,
    {
        Watch { task: name, ..*self }
    }

    /// Returns a watch without reports that cancels as this one does.
    #[must_use]
    pub fn quiet(&self) -> Self {
        Self { tell: NOBODY, ..*self }
    }

    /// Reports the part of this work that is done, from 0 to 1. Call it every few milliseconds, so
    /// that cancelled work ends soon.
    ///
    /// # Errors
    ///
    /// When the work is cancelled. Then nothing is reported.
    pub fn at(&self, part: f32) -> Result<(), Cancelled> {
        self.check()?;
        (self.tell)(self.task, self.from + part * (self.to - self.from));
        Ok(())
    }

    /// Returns an error if the work is cancelled. Reports nothing.
    ///
    /// # Errors
    ///
    /// When the work is cancelled.
    pub fn check(&self) -> Result<(), Cancelled> {
        if self.is_cancelled() { Err(Cancelled) } else { Ok(()) }
    }

    /// Whether the work is cancelled.
    pub fn is_cancelled(&self) -> bool {
        self.cancel.load(Ordering::Relaxed)
    }
}

impl fmt::Debug for Watch<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { cancel, task, from, to, .. } = self;
        let mut text = f.debug_struct("Watch");
        text.field("cancel", cancel).field("task", task).field("from", from).field("to", to);
        text.finish_non_exhaustive()
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Mutex;

    use super::*;

    /// Reports that a watch receives from some work.
    fn heard(work: impl Fn(&Watch) -> Result<(), Cancelled>) -> Vec<(String, f32)> {
        let heard = Mutex::new(Vec::new());
        let tell = |task: &str, part: f32| heard.lock().expect("a list").push((task.to_owned(), part));
        work(&Watch::telling(&tell)).expect("nobody cancels");
        heard.into_inner().expect("a list")
    }

    #[test]
    fn pieces_of_pieces_are_told_as_parts_of_the_whole() {
        let told = heard(|watch| {
            watch.at(0.0)?;
            let second = watch.piece(0.5, 1.0);
            second.at(0.5)?;
            second.piece(0.5, 1.0).at(0.5)?;
            watch.at(1.0)
        });
        assert_eq!(told.iter().map(|(_, part)| *part).collect::<Vec<_>>(), [0.0, 0.75, 0.875, 1.0]);
    }

    #[test]
    fn a_task_is_told_by_its_name_until_another_begins() {
        let told = heard(|watch| {
            watch.at(0.0)?;
            let task = watch.task("first").piece(0.0, 0.5);
            task.at(1.0)?;
            task.task("second").at(0.5)?;
            watch.at(1.0)
        });
        let told: Vec<(&str, f32)> = told.iter().map(|(task, part)| (task.as_str(), *part)).collect();
        assert_eq!(told, [("", 0.0), ("first", 0.5), ("second", 0.25), ("", 1.0)]);
    }

    #[test]
    fn all_watches_of_a_flag_cancel_and_tell_nothing_then() {
        let (cancel, calls) = (AtomicBool::new(false), Mutex::new(0));
        let tell = |_: &str, _: f32| *calls.lock().expect("a number") += 1;
        let watch = Watch::new(&tell, &cancel);
        let each = [watch, watch.piece(0.25, 0.5), watch.task("task"), watch.quiet()];
        let by_flag = Watch::cancelled_by(&cancel);
        assert!(each.iter().chain([&by_flag]).all(|watch| watch.at(0.5).is_ok() && watch.check().is_ok()));
        assert_eq!(*calls.lock().expect("a number"), 3, "a quiet watch tells nothing");
        cancel.store(true, Ordering::Relaxed);
        for watch in each.iter().chain([&by_flag]) {
            assert_eq!((watch.at(0.5), watch.check()), (Err(Cancelled), Err(Cancelled)));
            assert!(watch.is_cancelled());
        }
        assert_eq!(*calls.lock().expect("a number"), 3);
    }

    #[test]
    fn a_watch_without_a_flag_never_cancels() {
        let tell = |_: &str, _: f32| {};
        for watch in [Watch::none(), Watch::telling(&tell), Watch::none().quiet()] {
            assert_eq!((watch.at(1.0), watch.is_cancelled()), (Ok(()), false));
        }
    }
}
