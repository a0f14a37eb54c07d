//! Shadings: what light makes of a hit. A new one is a `.wesl` and a `.rs` file here and its name in the list
//! below.

use crate::SURVEY;
use crate::entry::Entry;

mod blinn_phong;

/// All of them.
pub static ENTRIES: &[Entry] = &[blinn_phong::ENTRY];
