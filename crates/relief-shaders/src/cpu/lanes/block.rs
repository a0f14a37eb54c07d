//! Structs side by side: one row of numbers for each of theirs.

use crate::cpu::generated::{Entered, Hit, Path, PixelOut};
use crate::cpu::{Vec2, Vec3, Vec4};

#[path = "../../../generated/blocks.rs"]
#[rustfmt::skip]
#[allow(missing_docs)]
mod generated;

pub use generated::{EnteredBlock, HitBlock, PathBlock, PixelOutBlock};

/// How many a block has room for.
pub const BLOCK: usize = 16;

/// A number of each of a block.
pub type Row<T> = [T; BLOCK];

/// The places of a block that bits stand for, the lowest for the first.
pub fn places(which: u16) -> impl Iterator<Item = usize> {
    (0..BLOCK).filter(move |at| which >> at & 1 == 1)
}

/// Paths that are traced together: of one use and one level, side by side.
#[cfg(all(feature = "lanes", any(target_arch = "aarch64", target_arch = "x86_64")))]
pub(super) struct Together {
    /// In which part of the block they are, of as many parts as lanes fit into it.
    pub part: usize,
    /// Which of the part's.
    pub which: u32,
    /// What the rays are for, and their level of detail.
    pub use_and_level: [u32; 2],
}

#[cfg(all(feature = "lanes", any(target_arch = "aarch64", target_arch = "x86_64")))]
impl PathBlock {
    /// Takes those out of `rest` that go together next, in so many lanes.
    pub(super) fn next_together(&self, lanes: usize, rest: &mut u16) -> Option<Together> {
        if *rest == 0 {
            return None;
        }
        let first = rest.trailing_zeros() as usize;
        let part = first / lanes;
        let use_and_level = [self.ray[first], self.level[first]];
        let is_same = |at: &usize| [self.ray[*at], self.level[*at]] == use_and_level;
        let places = (part * lanes..(part + 1) * lanes).filter(is_same);
        let together = places.fold(0u16, |bits, at| bits | (1 << at)) & *rest;
        *rest &= !together;
        Some(Together { part, which: u32::from(together) >> (part * lanes), use_and_level })
    }
}
