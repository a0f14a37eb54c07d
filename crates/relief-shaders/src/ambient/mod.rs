//! Light from all around: what of a uniform sky's light a hit reflects. A new one is a `.wesl` and a `.rs`
//! file here and its name in the list below; the first is what is run where nothing is said.

use relief_core::registry::Entry;

mod bent_normal;
mod bounce;
mod constant;
pub mod environment;
mod occlusion;

/// All of them.
pub const ENTRIES: &[Entry] =
    &[constant::ENTRY, occlusion::ENTRY, bent_normal::ENTRY, bounce::ENTRY, environment::ENTRY];
