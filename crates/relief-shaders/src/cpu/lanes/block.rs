//! Blocks of structs as a structure of arrays: one row of numbers for each member.

use crate::cpu::generated::{Entered, Hit, Path, PixelOut};
use crate::cpu::{Vec2, Vec3, Vec4};

#[path = "../../../generated/blocks.rs"]
#[rustfmt::skip]
#[allow(missing_docs)]
mod generated;

pub use generated::{EnteredBlock, HitBlock, PathBlock, PixelOutBlock};

/// The number of structs that a block holds.
pub const BLOCK: usize = 16;

/// One number for each struct of a block.
pub type Row<T> = [T; BLOCK];

/// Returns the places in a block whose bits are set in `which`; the lowest bit is the first place.
pub fn places(which: u16) -> impl Iterator<Item = usize> {
    (0..BLOCK).filter(move |at| which >> at & 1 == 1)
}

/// Paths of one purpose and one level, traced in SIMD lanes at once.
#[cfg(all(feature = "lanes", any(target_arch = "aarch64", target_arch = "wasm32", target_arch = "x86_64")))]
pub(super) struct LaneGroup {
    /// The part of the block that holds them; a part is as wide as the lanes.
    pub part: usize,
    /// Bits of the lanes in that part.
    pub which: u32,
    /// The purpose of the rays, and their level of detail.
    pub use_and_level: [u32; 2],
}

#[cfg(all(feature = "lanes", any(target_arch = "aarch64", target_arch = "wasm32", target_arch = "x86_64")))]
impl PathBlock {
    /// Takes the next group of paths out of `rest` that can be traced at once in `lanes` lanes.
    pub(super) fn next_group(&self, lanes: usize, rest: &mut u16) -> Option<LaneGroup> {
        if *rest == 0 {
            return None;
        }
        let first = rest.trailing_zeros() as usize;
        let part = first / lanes;
        let use_and_level = [self.ray[first], self.level[first]];
        let is_same = |at: &usize| [self.ray[*at], self.level[*at]] == use_and_level;
        let places = (part * lanes..(part + 1) * lanes).filter(is_same);
        let group = places.fold(0u16, |bits, at| bits | (1 << at)) & *rest;
        *rest &= !group;
        Some(LaneGroup { part, which: u32::from(group) >> (part * lanes), use_and_level })
    }
}
