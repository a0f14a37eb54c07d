//! What the points of a block see of shells: each shell is looked at once for all rays that may meet it.

use relief_core::Lanes;
use relief_shaders::cpu::{BLOCK, EnteredBlock, HitBlock, PathBlock, Row, TriangleRays};
use relief_shaders::surface::FOLDED;

use super::block::{lanes_for, places, places_where};
use super::ready::Ready;
use super::seen::Seen;
use crate::raycast::Sides;
use crate::shellcast::{BlockRays, ShellCaster};

/// Where the rays of a block come into a shell, their segments of one number, and what these hit.
#[derive(Default)]
struct Looked {
    at: EnteredBlock,
    paths: PathBlock,
    hits: HitBlock,
    keys: Row<f32>,
}

impl Ready<'_> {
    /// What the points of a block that `which` has bits for see of the surface.
    pub(super) fn see_shells(&self, caster: &ShellCaster, which: u16, lanes: Lanes, seen: &mut Seen) {
        let aims: [_; BLOCK] = std::array::from_fn(|place| self.aim(seen.points.map(|row| row[place])));
        let rays = BlockRays::new(aims.map(|aim| aim.ray()), which);
        let mut looked = Looked::default();
        let mut look = |rank: (bool, u32), side: f32, which: u16, seen: &mut Seen| {
            if !self.is_object {
                return self.look_block(rank, side, which, lanes, &mut looked, seen);
            }
            // Segments of objects are not parts of one way.
            for place in places(which) {
                if let Some(met) = self.look(rank.1, side, aims[place]) {
                    seen.keep(place, rank, side, &met);
                }
            }
        };
        caster.each_of_block(&rays, lanes, |triangle, which, reach| {
            look((false, triangle), 1.0, which, seen);
            if self.sides == Sides::Both {
                look((true, triangle), -1.0, which, seen);
            }
            for place in places(which & seen.which) {
                reach[place] = self.reach(seen.keys[place]);
            }
        });
    }

    /// Keeps what the rays of a block see of a side of a triangle's shell where that is the nearest so far.
    fn look_block(
        &self,
        rank: (bool, u32),
        side: f32,
        which: u16,
        lanes: Lanes,
        looked: &mut Looked,
        seen: &mut Seen,
    ) {
        let (triangle, points) = (self.triangle(rank.1), seen.points);
        let lanes = lanes_for(which, lanes);
        let rays = TriangleRays { triangle: &triangle, side, points: &points };
        let Looked { at, paths, hits, keys } = looked;
        self.program.enter_block(rays, which, lanes, at, paths);
        let (mut rest, mut nearest) = (which, 0);
        let mut costs = [[0; BLOCK]; 3];
        for number in 0.. {
            rest &= places_where(|place| at.segments[place] > number);
            if rest == 0 {
                break;
            }
            if number > 0 {
                self.program.segment_block(rays, number, rest, lanes, at, paths);
            }
            let traced = rest & places_where(|place| paths.exit[place] > 0.0);
            if traced == 0 {
                continue;
            }
            self.trace_block(paths, traced, lanes, hits);
            for (sums, costs) in costs.iter_mut().zip(&hits.cost) {
                places(traced).for_each(|place| sums[place] += costs[place]);
            }
            let found = traced & places_where(|place| hits.found[place] == 1);
            if found == 0 {
                continue;
            }
            self.program.meet_block((rays, number), found, lanes, (at, paths), hits, keys);
            let found = found & places_where(|place| hits.found[place] == 1);
            for place in places(found) {
                if seen.keep_of(place, rank, side, keys[place], (at, paths, hits)) {
                    nearest |= 1 << place;
                }
            }
            if triangle.shell.order < FOLDED {
                rest &= !found;
            }
        }
        if self.tracers.is_none() {
            // What a search costs on all segments is told, of the tracers what it took to find the hit.
            for (told, costs) in seen.hits.cost.iter_mut().zip(&costs) {
                places(nearest).for_each(|place| told[place] = costs[place]);
            }
        }
    }
}
