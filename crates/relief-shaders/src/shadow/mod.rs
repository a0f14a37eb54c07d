//! Shadows: each gives the part of a light that arrives at a hit.
//!
//! A new shadow is a `.wesl` and a `.rs` file here and its name in the list below; the first is the
//! default. A shadow that sends rays by `shared/shadow_ray.wesl` uses the stage `shadow-search`;
//! its entry lists the search results that it takes.

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

/// All shadows, in the order of their numbers in the shaders. The first is the default.
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

/// The most cascades of a distant light's shadow map.
pub const MAX_CASCADES: usize = 4;

/// The shadows that read shadow maps.
pub fn of_light_views() -> Variants {
    Variants::of(SHADOW, |entry| matches!(entry.shadow(), Some(ShadowRole::LightViews { .. })))
}

/// The test that a shadow makes between a hit and a light.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ShadowRole {
    /// A look-up or an estimate of the part of a light's disc that the relief leaves free.
    Discs,
    /// A ray from where the light enters the relief, down to the hit.
    FromEntry,
    /// Rays from the hit through the relief of the same surface.
    ToLights {
        /// The parameter that counts rays to points of a light's disc; none: one ray goes to its
        /// centre.
        rays: Option<&'static str>,
    },
    /// A look-up in shadow maps.
    LightViews {
        /// The parameter with the greatest side of a shadow map, in texels.
        size: &'static str,
        /// The parameter with the number of cascades of a distant light.
        cascades: &'static str,
    },
    /// Rays through all surfaces of the scene, which need a CPU.
    ThroughScene {
        /// The parameter that counts rays to a light's disc.
        rays: &'static str,
    },
}

impl ShadowRole {
    /// Whether all surfaces cast shadows on each other.
    pub const fn sees_scene(self) -> bool {
        matches!(self, ShadowRole::LightViews { .. } | ShadowRole::ThroughScene { .. })
    }

    /// Whether the shadow's edges are as soft as the light's disc is wide.
    pub const fn knows_discs(self) -> bool {
        matches!(self, ShadowRole::Discs | ShadowRole::ToLights { rays: Some(_) })
    }
}
