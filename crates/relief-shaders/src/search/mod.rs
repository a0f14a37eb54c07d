//! Searches: what brackets the first hit. A new one is a `.wesl` and a `.rs` file here and its name in the
//! list below; one that reads a baked map names it in its entry, and finds it bound.

use relief_core::registry::Entry;

use crate::SURVEY;

mod cells;
mod cone;
mod frustum;
mod linear;
mod none;

/// All of them.
pub const ENTRIES: &[Entry] = &[none::ENTRY, linear::ENTRY, cells::ENTRY, frustum::ENTRY, cone::ENTRY];
