//! Shadows: the part of a light that arrives at a hit. A new one is a `.wesl` and a `.rs` file here and its
//! name in the list below; the first is what is run where nothing is said. One that sends rays by
//! `shared/shadow_ray.wesl` asks the stage `shadow-search`; its entry says which ends of a search it takes.

use relief_core::registry::Entry;

use crate::SURVEY;

mod entry;
mod heuristic;
mod horizon;
mod map;
pub mod none;
mod ray;
mod scene;
mod soft;
mod visibility;

/// All of them.
pub const ENTRIES: &[Entry] = &[
    ray::ENTRY,
    none::ENTRY,
    entry::ENTRY,
    soft::ENTRY,
    heuristic::ENTRY,
    horizon::ENTRY,
    visibility::ENTRY,
    map::ENTRY,
    scene::ENTRY,
];

/// The most pictures of what a light that is far away sees.
pub const MAX_CASCADES: usize = 4;
