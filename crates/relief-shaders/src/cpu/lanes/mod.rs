//! The shaders in SIMD lanes: the same functions once more, for many paths or pixels at once.
//!
//! The generated texts use the functions of a width, and are included once for each width. All of
//! them give the bits of the translation to single numbers, which serves machines without such
//! vectors.

// Each width includes the same texts.
#![allow(clippy::duplicate_mod)]

use relief_core::Lanes;

use super::generated::Resources;

mod block;
#[cfg(all(feature = "lanes", target_arch = "x86_64"))]
mod eight;
#[cfg(all(feature = "lanes", target_arch = "aarch64"))]
mod four;
#[cfg(all(feature = "lanes", target_arch = "wasm32"))]
#[path = "four_web/mod.rs"]
mod four;
mod one;
#[cfg(all(feature = "lanes", target_arch = "x86_64"))]
mod sixteen;
mod task;

pub use block::{BLOCK, EnteredBlock, HitBlock, PathBlock, PixelOutBlock, Row, places};
pub(in crate::cpu) use task::Task;
pub use task::{LightPoint, TriangleRays};

/// Returns that width, or one if the places of a map do not fit into the numbers of a lane.
#[cfg(all(feature = "lanes", any(target_arch = "aarch64", target_arch = "wasm32", target_arch = "x86_64")))]
fn fitting(r: &Resources<'_>, lanes: Lanes) -> Lanes {
    if r.has_places_of_32_bits() { lanes } else { Lanes::One }
}

/// Does a task for the places that `which` has bits for, in lanes of that width if the machine has
/// them.
pub(super) fn run(r: &Resources<'_>, lanes: Lanes, which: u16, task: Task<'_>) {
    #[cfg(all(
        feature = "lanes",
        any(target_arch = "aarch64", target_arch = "wasm32", target_arch = "x86_64")
    ))]
    match fitting(r, lanes) {
        #[cfg(any(target_arch = "aarch64", target_arch = "wasm32"))]
        Lanes::Four => {
            if let Some(four) = four::Four::new() {
                return four.run(r, which, task);
            }
        }
        #[cfg(target_arch = "x86_64")]
        Lanes::Eight => {
            if let Some(eight) = eight::Eight::new() {
                return eight.run(r, which, task);
            }
        }
        #[cfg(target_arch = "x86_64")]
        Lanes::Sixteen => {
            if let Some(sixteen) = sixteen::Sixteen::new() {
                return sixteen.run(r, which, task);
            }
        }
        _ => {}
    }
    #[cfg(not(all(
        feature = "lanes",
        any(target_arch = "aarch64", target_arch = "wasm32", target_arch = "x86_64")
    )))]
    let _ = lanes;
    one::run(r, which, task);
}
