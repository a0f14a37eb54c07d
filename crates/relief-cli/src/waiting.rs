//! Waiting for another process that writes the same files.

use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use crate::say;

/// Time after which a note is printed.
const NOTE_AFTER: Duration = Duration::from_secs(1);

/// Longest time to wait: a stopped process must not stop everyone.
const PATIENCE: Duration = Duration::from_secs(600);

/// Returns a function that takes the time waited so far and decides whether to go on waiting. It
/// prints a note once, unless `quiet`.
pub fn waiting<'a>(
    folder: &'a Path,
    quiet: bool,
    cancel: &'a AtomicBool,
) -> impl FnMut(Duration) -> bool + 'a {
    let mut is_said = quiet;
    move |waited| {
        if !is_said && waited >= NOTE_AFTER {
            let folder = folder.display();
            say::note(format_args!(
                "another process writes the same files into {folder}: waiting until it ends"
            ));
            is_said = true;
        }
        waited < PATIENCE && !cancel.load(Ordering::Relaxed)
    }
}
