//! The search and the refinement over lanes: the same shaders once more, for many paths at once.
//!
//! The generated text is written in the functions of a width, and included once for each. All of them give
//! the bits of the translation to single numbers, which serves machines without such vectors.

use relief_core::Lanes;

use super::generated::Resources;

mod block;
#[cfg(all(feature = "lanes", target_arch = "x86_64"))]
mod eight;
#[cfg(all(feature = "lanes", target_arch = "x86_64"))]
mod sixteen;

pub use block::{BLOCK, HitBlock, PathBlock};

/// Traces the paths of a block that `which` has bits for, in lanes of that width where the machine has them.
pub(super) fn trace(r: &Resources<'_>, lanes: Lanes, paths: &PathBlock, which: u16, hits: &mut HitBlock) {
    #[cfg(all(feature = "lanes", target_arch = "x86_64"))]
    match lanes {
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
