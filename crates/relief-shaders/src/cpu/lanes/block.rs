//! Paths and hits side by side: one row of numbers for each of theirs.

use crate::cpu::{Hit, Path};

/// How many paths a block has room for.
pub const BLOCK: usize = 16;

/// Sixteen paths, each number of theirs in a row.
#[derive(Clone, Copy, Debug, Default)]
pub struct PathBlock {
    /// Texture coordinates of the entry.
    pub uv: [[f32; BLOCK]; 2],
    /// Their change with `t`.
    pub duv: [[f32; BLOCK]; 2],
    /// The height as a polynomial of `t`.
    pub h: [[f32; BLOCK]; 3],
    /// Where the paths end.
    pub exit: [f32; BLOCK],
    /// Where they meet the base surface.
    pub base: [f32; BLOCK],
    /// From texture units and heights to metres.
    pub metric: [[f32; BLOCK]; 4],
    /// What the rays are for.
    pub ray: [u32; BLOCK],
    /// The levels of detail.
    pub level: [u32; BLOCK],
    /// Where the paths begin on their rays.
    pub start: [f32; BLOCK],
    /// Their shares of their rays.
    pub share: [f32; BLOCK],
}

impl PathBlock {
    /// Puts a path in a place.
    #[inline]
    pub fn set(&mut self, at: usize, path: &Path) {
        self.uv[0][at] = path.uv.x;
        self.uv[1][at] = path.uv.y;
        self.duv[0][at] = path.duv.x;
        self.duv[1][at] = path.duv.y;
        self.h[0][at] = path.h.x;
        self.h[1][at] = path.h.y;
        self.h[2][at] = path.h.z;
        self.exit[at] = path.exit;
        self.base[at] = path.base;
        self.metric[0][at] = path.metric.x;
        self.metric[1][at] = path.metric.y;
        self.metric[2][at] = path.metric.z;
        self.metric[3][at] = path.metric.w;
        self.ray[at] = path.ray;
        self.level[at] = path.level;
        self.start[at] = path.start;
        self.share[at] = path.share;
    }

    /// The path in a place.
    #[inline]
    pub fn get(&self, at: usize) -> Path {
        Path::new(
            self.uv.map(|row| row[at]),
            self.duv.map(|row| row[at]),
            self.h.map(|row| row[at]),
            self.exit[at],
            self.base[at],
            self.metric.map(|row| row[at]),
            self.ray[at],
            self.level[at],
            self.start[at],
            self.share[at],
        )
    }
}

/// Paths that are traced together: of one use and one level, side by side.
#[cfg(all(feature = "lanes", target_arch = "x86_64"))]
pub(super) struct Together {
    /// In which part of the block they are, of as many parts as lanes fit into it.
    pub part: usize,
    /// Which of the part's.
    pub which: u32,
    /// What the rays are for, and their level of detail.
    pub use_and_level: [u32; 2],
}

#[cfg(all(feature = "lanes", target_arch = "x86_64"))]
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

/// Sixteen hits, each number of theirs in a row.
#[derive(Clone, Copy, Debug, Default)]
pub struct HitBlock {
    /// 1 where something was hit.
    pub found: [u32; BLOCK],
    /// 1 where the steps did not suffice.
    pub exhausted: [u32; BLOCK],
    /// Texture coordinates.
    pub uv: [[f32; BLOCK]; 2],
    /// Heights.
    pub height: [f32; BLOCK],
    /// Where on the paths.
    pub t: [f32; BLOCK],
    /// Reads, steps and bytes.
    pub cost: [[u32; BLOCK]; 3],
}

impl HitBlock {
    /// Puts a hit in a place.
    #[inline]
    pub fn set(&mut self, at: usize, hit: &Hit) {
        self.found[at] = hit.found;
        self.exhausted[at] = hit.exhausted;
        self.uv[0][at] = hit.uv.x;
        self.uv[1][at] = hit.uv.y;
        self.height[at] = hit.height;
        self.t[at] = hit.t;
        self.cost[0][at] = hit.cost.x;
        self.cost[1][at] = hit.cost.y;
        self.cost[2][at] = hit.cost.z;
    }

    /// The hit in a place.
    #[inline]
    pub fn get(&self, at: usize) -> Hit {
        Hit::new(
            self.found[at],
            self.exhausted[at],
            self.uv.map(|row| row[at]),
            self.height[at],
            self.t[at],
            self.cost.map(|row| row[at]),
        )
    }
}
