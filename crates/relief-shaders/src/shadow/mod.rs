//! Shadows: the part of a light that arrives at a hit. A new one is a `.wesl` and a `.rs` file here and its
//! name in the list below. One that sends rays asks the stage `shadow-search`; its entry says which ends of a
//! search it takes.

use relief_core::registry::Entry;

use crate::SURVEY;

mod none;
mod ray;

/// All of them.
pub const ENTRIES: &[Entry] = &[none::ENTRY, ray::ENTRY];
