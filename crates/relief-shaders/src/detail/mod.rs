//! Detail: in which level of its maps a pixel is seen. A new one is a `.wesl` and a `.rs` file here and its
//! name in the list below.

use relief_core::registry::Entry;

mod footprint;
mod none;

/// All of them.
pub const ENTRIES: &[Entry] = &[none::ENTRY, footprint::ENTRY];

/// The one that sees everything in the finest level.
pub(crate) const NONE: &str = none::ENTRY.name;
