//! Shadings: each gives the light that a hit reflects.
//!
//! A new shading is a `.wesl` and a `.rs` file here and its name in the list below.

use crate::SURVEY;
use crate::entry::Entry;

mod blinn_phong;
mod metallic_roughness;

/// All shadings, in the order of their numbers in the shaders.
pub static ENTRIES: &[Entry] = &[blinn_phong::ENTRY, metallic_roughness::ENTRY];
