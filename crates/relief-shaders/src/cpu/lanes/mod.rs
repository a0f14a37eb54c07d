//! The search and the refinement over lanes: the same shaders once more, for many paths at once.
//!
//! The generated text is written in the functions of a width, and included once for each. All of them give
//! the bits of the translation to single numbers, which serves machines without such vectors.

// Each width includes the same text.
#![allow(clippy::duplicate_mod)]

use relief_core::{FoundState, Lanes};

use super::generated::Resources;

mod block;
#[cfg(all(feature = "lanes", target_arch = "x86_64"))]
mod eight;
#[cfg(all(feature = "lanes", target_arch = "x86_64"))]
mod sixteen;

pub use block::{BLOCK, HitBlock, PathBlock};

/// That width, or one where the places of a map do not fit into the numbers of a lane.
#[cfg(all(feature = "lanes", target_arch = "x86_64"))]
fn fitting(r: &Resources<'_>, lanes: Lanes) -> Lanes {
    let fits = r.search_map.has_places_of_32_bits() && r.shadow_search_map.has_places_of_32_bits();
    if fits { lanes } else { Lanes::One }
}

/// Traces the paths of a block that `which` has bits for, in lanes of that width where the machine has them.
pub(super) fn trace(r: &Resources<'_>, lanes: Lanes, paths: &PathBlock, which: u16, hits: &mut HitBlock) {
    #[cfg(all(feature = "lanes", target_arch = "x86_64"))]
    match fitting(r, lanes) {
        Lanes::One => {}
        Lanes::Eight => {
            if let Some(eight) = eight::Eight::new() {
                return eight.trace(r, paths, which, hits);
            }
        }
        Lanes::Sixteen => {
            if let Some(sixteen) = sixteen::Sixteen::new() {
                return sixteen.trace(r, paths, which, hits);
            }
        }
    }
    #[cfg(not(all(feature = "lanes", target_arch = "x86_64")))]
    let _ = lanes;
    for at in (0..BLOCK).filter(|at| which >> at & 1 == 1) {
        hits.set(at, &r.trace(paths.get(at)));
    }
}

/// Of the paths of a block that `which` has bits for, those on which the search for shadows finds nothing.
pub(super) fn free(r: &Resources<'_>, lanes: Lanes, paths: &PathBlock, which: u16) -> u16 {
    #[cfg(all(feature = "lanes", target_arch = "x86_64"))]
    match fitting(r, lanes) {
        Lanes::One => {}
        Lanes::Eight => {
            if let Some(eight) = eight::Eight::new() {
                return eight.free(r, paths, which);
            }
        }
        Lanes::Sixteen => {
            if let Some(sixteen) = sixteen::Sixteen::new() {
                return sixteen.free(r, paths, which);
            }
        }
    }
    #[cfg(not(all(feature = "lanes", target_arch = "x86_64")))]
    let _ = lanes;
    let is_free = |at: &usize| r.shadow_search_stage(paths.get(*at)).status == FoundState::Miss as u32;
    let free = (0..BLOCK).filter(|at| which >> at & 1 == 1).filter(is_free);
    free.fold(0, |bits, at| bits | (1 << at))
}
