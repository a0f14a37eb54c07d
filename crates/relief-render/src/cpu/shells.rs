//! Nearest hits of a region's rays in shells.
//!
//! The rays of a block traverse the BVH together. Then each ray takes the nearest shell that it may
//! hit. The rays of all blocks that took the same shell are traced in it side by side, in SIMD
//! lanes. A block's own rays are spread over several shells, and would leave most of the lanes
//! empty.

mod shell_rays;

use relief_core::Lanes;
use relief_shaders::cpu::{BLOCK, Row};

use self::shell_rays::{PathBatch, ShellRays};
use super::block_hits::RegionHits;
use super::prepared_surface::{Base, PreparedSurface};
use super::tiled::Points;
use crate::shellcast::{BlockRays, ShellCaster};
use relief_core::raycast::Sides;

/// Number of blocks of shell rays at a time, whose paths are searched together.
const TOGETHER: usize = 16;

/// Number of shells that a block collects before its rays are traced in the first. They are enough
/// for all of its rays, and few enough that hardly a shell lies behind the hits.
const AHEAD: usize = 8;

/// Scratch memory for the shells of a region.
#[derive(Default)]
pub struct Shells {
    blocks: Vec<Block>,
    /// Rays to trace next, each with its shell.
    next: Vec<ShellRay>,
    shell_rays: Vec<ShellRays>,
    batch: PathBatch,
}

/// Ray to trace in a triangle's shell: its block, and its place there.
#[derive(Clone, Copy)]
struct ShellRay {
    triangle: u32,
    block: u32,
    place: u32,
}

impl ShellRay {
    /// Returns the sort key by which rays of the same shell follow each other, neighbours first.
    fn order(&self) -> u64 {
        u64::from(self.triangle) << 32 | u64::from(self.block) << 4 | u64::from(self.place)
    }
}

/// Block of rays that traverses the BVH.
#[derive(Default)]
struct Block {
    rays: BlockRays,
    /// Triangles whose shells are ahead, and the parameter at which each ray reaches them. It is
    /// infinite where a ray does not, or was traced in the shell already.
    ahead: Vec<(u32, Row<f32>)>,
}

impl Block {
    /// Traverses the BVH until enough shells are known. Returns whether there is any.
    fn go_ahead(&mut self, caster: &ShellCaster, lanes: Lanes) -> bool {
        self.ahead.clear();
        let mut at = [0.0; BLOCK];
        while self.ahead.len() < AHEAD
            && let Some(triangle) = caster.next_of_block(&mut self.rays, lanes, &mut at)
        {
            self.ahead.push((triangle, at));
        }
        !self.ahead.is_empty()
    }

    /// Calls `take` with the nearest shell ahead of each ray that has one within its reach, and
    /// removes that shell for the ray.
    fn take(&mut self, mut take: impl FnMut(u32, u32)) {
        let mut nearest = [f32::INFINITY; BLOCK];
        let mut which = [0; BLOCK];
        for (number, (_, at)) in self.ahead.iter().enumerate() {
            for place in 0..BLOCK {
                let is_nearer = at[place] < nearest[place];
                nearest[place] = if is_nearer { at[place] } else { nearest[place] };
                which[place] = if is_nearer { number } else { which[place] };
            }
        }
        for place in 0..BLOCK {
            if nearest[place] < f32::INFINITY && nearest[place] <= self.rays.reach[place] {
                let (triangle, at) = &mut self.ahead[which[place]];
                at[place] = f32::INFINITY;
                take(*triangle, place as u32);
            }
        }
    }
}

impl PreparedSurface<'_> {
    /// Finds the nearest hits of a region's rays on the surface, if it has shells.
    pub(super) fn trace_shells(
        &self,
        points: &[Points],
        lanes: Lanes,
        shells: &mut Shells,
        seen: &mut RegionHits,
    ) {
        let Base::Shells(caster) = &self.base else { return };
        let Shells { blocks, next, shell_rays, batch } = shells;
        blocks.resize_with(points.len(), Block::default);
        for (block, points) in blocks.iter_mut().zip(points) {
            let rays = |place| self.ray_through(points.points.map(|row| row[place])).ray();
            let before = std::mem::take(&mut block.rays);
            block.rays = caster.block(&std::array::from_fn(rays), points.which, before);
        }
        while blocks.iter_mut().fold(false, |any, block| block.go_ahead(caster, lanes) | any) {
            loop {
                next.clear();
                for (number, block) in blocks.iter_mut().enumerate() {
                    block.take(|triangle, place| {
                        next.push(ShellRay { triangle, block: number as u32, place });
                    });
                }
                if next.is_empty() {
                    break;
                }
                next.sort_unstable_by_key(ShellRay::order);
                let groups = next.chunk_by(|one, other| one.triangle == other.triangle);
                let mut groups = groups.flat_map(|looks| looks.chunks(BLOCK)).peekable();
                while groups.peek().is_some() {
                    let together = groups.by_ref().take(TOGETHER);
                    if self.is_object {
                        // Segments of objects are not parts of one path.
                        together.flatten().for_each(|look| self.trace_alone(*look, seen));
                        continue;
                    }
                    shell_rays.clear();
                    for looks in together {
                        for side in self.sides_of_shells() {
                            shell_rays.push(ShellRays::new(self, *side, looks, seen));
                        }
                    }
                    self.trace_together(shell_rays, batch, lanes, seen);
                }
                for ShellRay { block, place, .. } in next.iter() {
                    let (seen, place) = (seen.of(*block), *place as usize);
                    if seen.which >> place & 1 == 1 {
                        let reach = self.reach(seen.keys[place]) as f32;
                        blocks[*block as usize].rays.reach[place] = reach.next_up();
                    }
                }
            }
        }
    }

    /// Returns the sides of triangles whose shells are traced.
    fn sides_of_shells(&self) -> &'static [f32] {
        if self.sides == Sides::Both { &[1.0, -1.0] } else { &[1.0] }
    }

    /// Traces one ray in a shell and stores its hit if it is the nearest so far.
    fn trace_alone(&self, ShellRay { triangle, block, place }: ShellRay, seen: &mut RegionHits) {
        let (seen, place) = (seen.of(block), place as usize);
        let aim = self.ray_through(seen.points.map(|row| row[place]));
        for side in self.sides_of_shells() {
            if let Some(met) = self.trace_triangle(triangle, *side, aim) {
                seen.store(place, (*side < 0.0, triangle), *side, &met);
            }
        }
    }
}
