//! Ctrl-C and other requests to end: the work in hand is dropped in order.

use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, Ordering};

use relief_core::Cancelled;

use crate::failure::Failure;

/// Set once the program is asked to end.
static CANCEL: AtomicBool = AtomicBool::new(false);

/// Result of installing the handler; a program has one.
static CAUGHT: OnceLock<Result<(), String>> = OnceLock::new();

/// Installs a handler, so that Ctrl-C ends the work in order. Returns the flag that it sets.
pub fn catch() -> Result<&'static AtomicBool, Failure> {
    let caught = CAUGHT.get_or_init(|| {
        ctrlc::set_handler(|| CANCEL.store(true, Ordering::Relaxed)).map_err(|error| error.to_string())
    });
    caught.as_ref().map_err(Failure::work)?;
    Ok(&CANCEL)
}

/// Returns the failure of work that was cancelled.
pub fn cancelled() -> Failure {
    Failure::Work("cancelled: no file was written".to_owned())
}

impl From<Cancelled> for Failure {
    fn from(_: Cancelled) -> Self {
        cancelled()
    }
}
