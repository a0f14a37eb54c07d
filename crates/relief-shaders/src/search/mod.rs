//! Searches: what brackets the first hit. A new one is a `.wesl` and a `.rs` file here and its name in the list below.

use relief::registry::Entry;

use crate::SURVEY;

mod cells;
mod linear;
mod none;

/// All of them; the place of each is its number in the shaders.
pub const ENTRIES: &[Entry] = &[none::ENTRY, linear::ENTRY, cells::ENTRY];
