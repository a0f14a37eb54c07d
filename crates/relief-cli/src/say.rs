//! Messages on standard error besides results and errors.

use std::sync::OnceLock;

use crate::cut::cut;
use crate::streams;

/// Amount of messages.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Verbosity {
    /// Only results and errors.
    Quiet,
    /// Also progress, and notes on what was not asked for.
    #[default]
    Usual,
    /// Also each part of the work, and its time.
    Verbose,
}

static VERBOSITY: OnceLock<Verbosity> = OnceLock::new();

/// Sets the amount of messages; only the first call counts.
pub fn set(verbosity: Verbosity) {
    VERBOSITY.get_or_init(|| verbosity);
}

/// Returns the amount of messages.
pub fn verbosity() -> Verbosity {
    VERBOSITY.get().copied().unwrap_or_default()
}

/// Prints a note on what a user may not expect, unless messages are off.
pub fn note(text: impl std::fmt::Display) {
    if verbosity() != Verbosity::Quiet {
        eprintln!("note: {}", cut(&streams::named(&text.to_string())));
    }
}

/// Prints what was done, if verbose.
pub fn detail(text: impl std::fmt::Display) {
    if verbosity() == Verbosity::Verbose {
        eprintln!("{text}");
    }
}
