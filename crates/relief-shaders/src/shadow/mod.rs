//! Shadows: the part of a light that arrives at a hit. A new one is a `.wesl` and a `.rs` file here and its
//! name in the list below; the first is what is run where nothing is said. One that sends rays by
//! `shared/shadow_ray.wesl` asks the stage `shadow-search`; its entry says which ends of a search it takes.

use crate::entry::Entry;
use crate::stages::SHADOW;
use crate::{SURVEY, Variants};

mod entry;
mod heuristic;
mod horizon;
mod map;
mod none;
mod ray;
mod scene;
mod soft;
mod visibility;

/// All of them.
pub static ENTRIES: &[Entry] = &[
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

/// The shadows that are looked up in what lights see.
pub fn of_light_views() -> Variants {
    Variants::of(SHADOW, |entry| matches!(entry.shadow(), Some(ShadowRole::LightViews { .. })))
}

/// How a shadow tests what is between a hit and a light.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ShadowRole {
    /// It looks up or estimates the part of a light's disc that the relief leaves free.
    Discs,
    /// A ray from where the light enters the relief, down to the hit.
    FromEntry,
    /// Rays from the hit through the relief of the same surface.
    ToLights {
        /// The parameter that counts rays to points of a light's disc; none: one ray goes to its centre.
        rays: Option<&'static str>,
    },
    /// Depths that lights see.
    LightViews {
        /// The parameter with the most texels of a view's side.
        size: &'static str,
        /// The parameter with the number of views of a light that is far away.
        cascades: &'static str,
    },
    /// Rays through all surfaces of the scene, which need a CPU.
    ThroughScene {
        /// The parameter that counts rays to a light's disc.
        rays: &'static str,
    },
}

impl ShadowRole {
    /// Whether all surfaces throw shadows on each other.
    pub const fn sees_scene(self) -> bool {
        matches!(self, ShadowRole::LightViews { .. } | ShadowRole::ThroughScene { .. })
    }

    /// Whether a light's disc makes it soft at its edges, as wide as it is.
    pub const fn knows_discs(self) -> bool {
        matches!(self, ShadowRole::Discs | ShadowRole::ToLights { rays: Some(_) })
    }
}
