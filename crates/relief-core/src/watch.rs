//! How long work is watched.

use std::fmt;
use std::sync::atomic::AtomicBool;

/// Whoever watches long work.
#[derive(Clone, Copy)]
pub struct Watch<'a> {
    /// Is told which part is done, from 0 to 1.
    pub tell: &'a (dyn Fn(f32) + Sync),
    /// Set, it ends the work.
    pub cancel: &'a AtomicBool,
}

impl Watch<'_> {
    /// Nobody.
    pub const NOBODY: Watch<'static> = {
        static NEVER: AtomicBool = AtomicBool::new(false);
        Watch { tell: &|_| {}, cancel: &NEVER }
    };
}

impl fmt::Debug for Watch<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Watch").field("cancel", self.cancel).finish_non_exhaustive()
    }
}
