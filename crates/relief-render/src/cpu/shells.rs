//! What the points of a region see of shells.
//!
//! A block of neighbouring points goes down the hierarchy together. Then each ray takes the nearest shell
//! that it may meet, and the rays of all blocks that took the same one look into it side by side: a block's
//! own rays are spread over several shells, and would leave most of the lanes empty.

mod looked;

use relief_core::Lanes;
use relief_shaders::cpu::{BLOCK, Row};

use self::looked::{Gathered, Looked};
use super::ready::{Base, Ready};
use super::seen::SeenOfSurface;
use super::tiled::Points;
use crate::shellcast::{BlockRays, ShellCaster};
use relief_core::raycast::Sides;

/// How many blocks of rays look into shells at a time, so that their paths can be searched together.
const TOGETHER: usize = 16;

/// How many shells a block goes ahead before its rays look into the first: enough for all of its rays, and
/// few enough that hardly one of them is behind what they hit.
const AHEAD: usize = 8;

/// What looking into the shells of a region works with.
#[derive(Default)]
pub struct Shells {
    blocks: Vec<Block>,
    /// The shells that rays look into next.
    next: Vec<Look>,
    looked: Vec<Looked>,
    gathered: Gathered,
}

/// A ray that looks into a triangle's shell: its block, and its place there.
#[derive(Clone, Copy)]
struct Look {
    triangle: u32,
    block: u32,
    place: u32,
}

impl Look {
    /// In this order rays of the same shell follow each other, and of these neighbours.
    fn order(&self) -> u64 {
        u64::from(self.triangle) << 32 | u64::from(self.block) << 4 | u64::from(self.place)
    }
}

/// A block on its way down the hierarchy.
#[derive(Default)]
struct Block {
    rays: BlockRays,
    /// Triangles whose shells are ahead, and where each ray comes near to them: infinite where it does not,
    /// or has looked already.
    ahead: Vec<(u32, Row<f32>)>,
}

impl Block {
    /// Goes ahead until enough shells are known. Says whether there is any.
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

    /// The nearest shell ahead of each ray that has one within its reach, which it then has looked into.
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

impl Ready<'_> {
    /// What the points of a region's blocks see of the surface, if it has shells.
    pub(super) fn see_shells(
        &self,
        points: &[Points],
        lanes: Lanes,
        shells: &mut Shells,
        seen: &mut SeenOfSurface,
    ) {
        let Base::Shells(caster) = &self.base else { return };
        let Shells { blocks, next, looked, gathered } = shells;
        blocks.resize_with(points.len(), Block::default);
        for (block, points) in blocks.iter_mut().zip(points) {
            let rays = |place| self.aim(points.points.map(|row| row[place])).ray();
            let before = std::mem::take(&mut block.rays);
            block.rays = caster.block(&std::array::from_fn(rays), points.which, before);
        }
        while blocks.iter_mut().fold(false, |any, block| block.go_ahead(caster, lanes) | any) {
            loop {
                next.clear();
                for (number, block) in blocks.iter_mut().enumerate() {
                    block.take(|triangle, place| next.push(Look { triangle, block: number as u32, place }));
                }
                if next.is_empty() {
                    break;
                }
                next.sort_unstable_by_key(Look::order);
                let groups = next.chunk_by(|one, other| one.triangle == other.triangle);
                let mut groups = groups.flat_map(|looks| looks.chunks(BLOCK)).peekable();
                while groups.peek().is_some() {
                    let together = groups.by_ref().take(TOGETHER);
                    if self.is_object {
                        // Segments of objects are not parts of one way.
                        together.flatten().for_each(|look| self.look_alone(*look, seen));
                        continue;
                    }
                    looked.clear();
                    for looks in together {
                        for side in self.sides_of_shells() {
                            looked.push(Looked::new(self, *side, looks, seen));
                        }
                    }
                    self.look_together(looked, gathered, lanes, seen);
                }
                for Look { block, place, .. } in next.iter() {
                    let (seen, place) = (seen.of(*block), *place as usize);
                    if seen.which >> place & 1 == 1 {
                        let reach = self.reach(seen.keys[place]) as f32;
                        blocks[*block as usize].rays.reach[place] = reach.next_up();
                    }
                }
            }
        }
    }

    /// The sides from which shells are looked into.
    fn sides_of_shells(&self) -> &'static [f32] {
        if self.sides == Sides::Both { &[1.0, -1.0] } else { &[1.0] }
    }

    /// Keeps what a ray sees of a shell where that is the nearest so far.
    fn look_alone(&self, Look { triangle, block, place }: Look, seen: &mut SeenOfSurface) {
        let (seen, place) = (seen.of(block), place as usize);
        let aim = self.aim(seen.points.map(|row| row[place]));
        for side in self.sides_of_shells() {
            if let Some(met) = self.look(triangle, *side, aim) {
                seen.keep(place, (*side < 0.0, triangle), *side, &met);
            }
        }
    }
}
