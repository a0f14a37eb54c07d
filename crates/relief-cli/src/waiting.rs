//! Waiting for another process that writes the same files.

use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use crate::say;

/// After which time a user is told.
const NOTE_AFTER: Duration = Duration::from_secs(1);

/// How long to wait: a process that was stopped must not stop everyone.
const PATIENCE: Duration = Duration::from_secs(600);

/// Whether to go on waiting, asked with the time that has passed; says once what for, unless `quiet`.
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
                "another process writes the same files into {folder}: waiting until it has ended"
            ));
            is_said = true;
        }
        waited < PATIENCE && !cancel.load(Ordering::Relaxed)
    }
}
