//! How far a bake is, and whether it is still wanted.

use std::sync::atomic::{AtomicBool, Ordering};

/// What a bake reports to and asks.
#[derive(Clone, Copy)]
pub struct Progress<'a> {
    report: &'a (dyn Fn(f32) + Sync),
    cancel: &'a AtomicBool,
    /// The part of the whole that this work is.
    from: f32,
    to: f32,
}

/// The bake was cancelled.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the bake was cancelled")]
pub struct Cancelled;

/// Never set: the flag of bakes that nobody cancels.
static NEVER: AtomicBool = AtomicBool::new(false);

impl<'a> Progress<'a> {
    /// Reports parts from 0 to 1, from any thread; ends with [`Cancelled`] once the flag is set.
    pub fn new(report: &'a (dyn Fn(f32) + Sync), cancel: &'a AtomicBool) -> Self {
        Self { report, cancel, from: 0.0, to: 1.0 }
    }

    /// Reports to nobody and is never cancelled.
    pub fn none() -> Progress<'static> {
        Progress { report: &|_| {}, cancel: &NEVER, from: 0.0, to: 1.0 }
    }

    /// The progress of a piece of this work, from `from` to `to` of it.
    #[must_use]
    pub fn piece(&self, from: f32, to: f32) -> Progress<'a> {
        let span = self.to - self.from;
        Progress { from: self.from + from * span, to: self.from + to * span, ..*self }
    }

    /// Reports the finished part of this work, from 0 to 1. To be called every few milliseconds, so that a
    /// cancelled bake ends soon.
    ///
    /// # Errors
    ///
    /// When the bake was cancelled.
    pub fn at(&self, part: f32) -> Result<(), Cancelled> {
        if self.cancel.load(Ordering::Relaxed) {
            return Err(Cancelled);
        }
        (self.report)(self.from + part * (self.to - self.from));
        Ok(())
    }
}
