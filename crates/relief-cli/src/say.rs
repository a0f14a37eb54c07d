//! What is said besides results and errors, on the standard error.

use std::sync::OnceLock;

use crate::cut::cut;
use crate::streams;

/// How much is said.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Loudness {
    /// Results and errors alone.
    Quiet,
    /// Progress, and notes on what was not asked for.
    #[default]
    Usual,
    /// Also what is done, and how long it takes.
    Verbose,
}

static LOUDNESS: OnceLock<Loudness> = OnceLock::new();

/// Decides it, once and for all.
pub fn set(loudness: Loudness) {
    LOUDNESS.get_or_init(|| loudness);
}

/// How much is said.
pub fn loudness() -> Loudness {
    LOUDNESS.get().copied().unwrap_or_default()
}

/// Says what a user may not expect, unless he wants to hear nothing.
pub fn note(text: impl std::fmt::Display) {
    if loudness() != Loudness::Quiet {
        eprintln!("note: {}", cut(&streams::named(&text.to_string())));
    }
}

/// Says what was done, where it is wanted.
pub fn detail(text: impl std::fmt::Display) {
    if loudness() == Loudness::Verbose {
        eprintln!("{text}");
    }
}
