//! The numbers of variants that selections know, and what goes with them.

use crate::stages::{AMBIENT, OBJECT, REFINE, SEARCH, SHADOW, STAGES, SURFACE, entry_place};

/// The number of the search `cells`.
pub const CELLS: usize = entry_place(STAGES[SEARCH].entries, "cells");

/// The number of the surface `facets`.
pub const FACETS: usize = entry_place(STAGES[SURFACE].entries, "facets");

/// The number of the surface `slices`.
pub const SLICED: usize = entry_place(STAGES[SURFACE].entries, "slices");

/// Texels of a side of what lights see where an object is shown: about as fine as its images. More take long
/// on CPUs, since each texel is a ray through all images.
pub const OBJECT_SHADOW_SIZE: f32 = 512.0;

/// The number of the surface `object`.
pub const IMAGES: usize = entry_place(STAGES[SURFACE].entries, "object");

/// The number of the surface `object-slices`.
pub const SLICED_IMAGES: usize = entry_place(STAGES[SURFACE].entries, "object-slices");

/// The number of the surface `frames`.
pub const FRAMES: usize = entry_place(STAGES[SURFACE].entries, "frames");

/// The number of the search `pyramid`.
pub const PYRAMID: usize = entry_place(STAGES[SEARCH].entries, "pyramid");

/// The number of the object `depth`.
pub const OF_DEPTH: usize = entry_place(STAGES[OBJECT].entries, "depth");

/// The number of the search `none`.
pub const NO_SEARCH: usize = entry_place(STAGES[SEARCH].entries, "none");

/// The number of the refinement `none`.
pub const NO_REFINEMENT: usize = entry_place(STAGES[REFINE].entries, "none");

/// The number of the refinement `secant`.
pub const SECANT: usize = entry_place(STAGES[REFINE].entries, "secant");

/// The number of the shadow `none`.
pub const NO_SHADOW: usize = entry_place(STAGES[SHADOW].entries, "none");

/// The number of the ambient light of the surroundings.
pub const ENVIRONMENT: usize = entry_place(STAGES[AMBIENT].entries, "environment");

/// The number of the shadow `soft`.
pub const SOFT: usize = entry_place(STAGES[SHADOW].entries, "soft");

/// The number of the shadow `ray`.
pub const RAY: usize = entry_place(STAGES[SHADOW].entries, "ray");

/// The number of the shadow `map`.
pub const LIGHT_MAP: usize = entry_place(STAGES[SHADOW].entries, "map");

/// The number of the shadow `scene`.
pub const SCENE: usize = entry_place(STAGES[SHADOW].entries, "scene");

/// The number of the refinement `patch`.
pub const PATCH: usize = entry_place(STAGES[REFINE].entries, "patch");
