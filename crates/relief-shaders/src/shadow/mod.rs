//! Shadows: the part of a light that arrives at a hit.

use relief_core::registry::Entry;

mod horizon;
mod march;
mod none;

/// All of them.
pub const ENTRIES: &[Entry] = &[none::ENTRY, march::ENTRY, horizon::ENTRY];
