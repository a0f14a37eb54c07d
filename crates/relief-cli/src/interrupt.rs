//! Ctrl-C, and being asked to end: the work in hand is dropped in order.

use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, Ordering};

use relief_core::Cancelled;

use crate::failure::Failure;

/// Set while there is something to clean up.
static CANCEL: AtomicBool = AtomicBool::new(false);

/// Whether the handler is in place; a program has one.
static CAUGHT: OnceLock<Result<(), String>> = OnceLock::new();

/// From here on Ctrl-C ends the work in order.
pub fn catch() -> Result<&'static AtomicBool, Failure> {
    let caught = CAUGHT.get_or_init(|| {
        ctrlc::set_handler(|| CANCEL.store(true, Ordering::Relaxed)).map_err(|error| error.to_string())
    });
    caught.as_ref().map_err(Failure::work)?;
    Ok(&CANCEL)
}

/// What is said of work that was ended.
pub fn cancelled() -> Failure {
    Failure::Work("cancelled: no file was written".to_owned())
}

impl From<Cancelled> for Failure {
    fn from(_: Cancelled) -> Self {
        cancelled()
    }
}
