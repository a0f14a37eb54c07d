//! Surfaces: what turns a fragment into path segments. A new one is a `.wesl` and a `.rs` file here and its
//! name in the list below.

use relief_core::registry::Entry;

use crate::SURVEY;

mod plane;

/// All of them.
pub const ENTRIES: &[Entry] = &[plane::ENTRY];
