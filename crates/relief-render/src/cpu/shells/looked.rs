//! Rays that look into shells side by side: where they come in, what they hit there, and what of that is the
//! nearest.

use relief_core::Lanes;
use relief_shaders::cpu::{BLOCK, EnteredBlock, HitBlock, PathBlock, Row, Triangle, TriangleRays};
use relief_shaders::surface::FOLDED;

use super::super::block::{lanes_for, places, places_where};
use super::super::ready::Ready;
use super::super::seen::SeenOfSurface;
use super::Look;

/// Number of rays of a shell from which they are searched as they are. Fewer are gathered with other shells'.
const NEARLY_ALL: u32 = 12;

/// A side of a shell and the rays that look into it.
pub struct Looked {
    triangle: Triangle,
    side: f32,
    looks: Row<Look>,
    /// Those rays whose segments are not all searched, a bit for each, and those that are searched now.
    rest: u16,
    searched: u16,
    /// Those whose hit is the nearest so far.
    nearest: u16,
    /// What all segments cost.
    costs: [Row<u32>; 3],
    points: [Row<f32>; 2],
    at: EnteredBlock,
    paths: PathBlock,
    hits: HitBlock,
    keys: Row<f32>,
}

/// Paths through several shells, searched side by side, and what they hit.
#[derive(Default)]
pub struct Gathered {
    count: usize,
    /// Which rays they are of, by the number of the shell and the place there.
    of: Row<(usize, usize)>,
    paths: PathBlock,
    hits: HitBlock,
}

impl Looked {
    /// A side of a triangle's shell, and at most a block of rays.
    pub fn new(surface: &Ready, side: f32, looks: &[Look], seen: &mut SeenOfSurface) -> Self {
        let mut points = [[0.0; BLOCK]; 2];
        for (at, Look { block, place, .. }) in looks.iter().enumerate() {
            for (to, from) in points.iter_mut().zip(&seen.of(*block).points) {
                to[at] = from[*place as usize];
            }
        }
        Self {
            triangle: surface.triangle(looks[0].triangle),
            side,
            looks: std::array::from_fn(|at| looks[at.min(looks.len() - 1)]),
            rest: u16::MAX >> (BLOCK - looks.len()),
            searched: 0,
            nearest: 0,
            costs: [[0; BLOCK]; 3],
            points,
            at: EnteredBlock::default(),
            paths: PathBlock::default(),
            hits: HitBlock::default(),
            keys: [0.0; BLOCK],
        }
    }

    fn enter(&mut self, surface: &Ready, lanes: Lanes) {
        let Self { triangle, side, points, rest, at, paths, .. } = self;
        let rays = TriangleRays { triangle, side: *side, points };
        surface.program.enter_block(rays, *rest, lanes_for(*rest, lanes), at, paths);
    }

    /// Goes on to the segments of a number. Says whether there are any.
    fn go_on(&mut self, surface: &Ready, number: u32, lanes: Lanes) -> bool {
        let Self { triangle, side, points, rest, searched, at, paths, .. } = self;
        *rest &= places_where(|place| at.segments[place] > number);
        *searched = 0;
        if *rest == 0 {
            return false;
        }
        if number > 0 {
            let rays = TriangleRays { triangle, side: *side, points };
            surface.program.segment_block(rays, number, *rest, lanes_for(*rest, lanes), at, paths);
        }
        *searched = *rest & places_where(|place| paths.exit[place] > 0.0);
        true
    }

    /// Keeps what was hit on these segments where that is the nearest so far.
    fn keep(&mut self, surface: &Ready, number: u32, lanes: Lanes, seen: &mut SeenOfSurface) {
        let Self { triangle, side, looks, searched, points, at, paths, hits, keys, .. } = self;
        for (sums, costs) in self.costs.iter_mut().zip(&hits.cost) {
            places(*searched).for_each(|place| sums[place] += costs[place]);
        }
        let found = *searched & places_where(|place| hits.found[place] == 1);
        if found == 0 {
            return;
        }
        let rays = (TriangleRays { triangle, side: *side, points }, number);
        surface.program.meet_block(rays, found, lanes_for(found, lanes), (at, paths), hits, keys);
        let found = found & places_where(|place| hits.found[place] == 1);
        for from in places(found) {
            let Look { triangle, block, place } = looks[from];
            let rank = (*side < 0.0, triangle);
            if seen.of(block).keep_of(place as usize, rank, *side, keys[from], (from, at, paths, hits)) {
                self.nearest |= 1 << from;
            }
        }
        if triangle.shell.order < FOLDED {
            self.rest &= !found;
        }
    }

    /// Tells what the search cost on all segments of those rays whose hit was kept, and is still: the other
    /// side of the shell may have shown a nearer one since.
    fn tell_costs(&self, seen: &mut SeenOfSurface) {
        for from in places(self.nearest) {
            let Look { triangle, block, place } = self.looks[from];
            let (seen, place) = (seen.of(block), place as usize);
            if seen.faces.rank[place] == (self.side < 0.0, triangle) {
                for (told, costs) in seen.hits.cost.iter_mut().zip(&self.costs) {
                    told[place] = costs[from];
                }
            }
        }
    }
}

impl Ready<'_> {
    /// Keeps what rays see of shells where that is the nearest so far.
    pub(super) fn look_together(
        &self,
        looked: &mut [Looked],
        gathered: &mut Gathered,
        lanes: Lanes,
        seen: &mut SeenOfSurface,
    ) {
        for shell in looked.iter_mut() {
            shell.enter(self, lanes);
        }
        for number in 0.. {
            let mut is_any_left = false;
            for shell in looked.iter_mut() {
                is_any_left |= shell.go_on(self, number, lanes);
            }
            if !is_any_left {
                break;
            }
            self.search_together(looked, gathered, lanes);
            for shell in looked.iter_mut() {
                shell.keep(self, number, lanes, seen);
            }
        }
        // Tracers report the cost of finding the hit.
        if self.tracers.is_none() {
            looked.iter().for_each(|shell| shell.tell_costs(seen));
        }
    }

    /// Searches the segments of all rays that have one.
    fn search_together(&self, looked: &mut [Looked], gathered: &mut Gathered, lanes: Lanes) {
        for number in 0..looked.len() {
            let Looked { searched, paths, hits, .. } = &mut looked[number];
            if searched.count_ones() >= NEARLY_ALL {
                self.trace_block(paths, *searched, lanes, hits);
                continue;
            }
            for place in places(*searched) {
                gathered.paths.set(gathered.count, &looked[number].paths.get(place));
                gathered.of[gathered.count] = (number, place);
                gathered.count += 1;
                if gathered.count == BLOCK {
                    self.search_gathered(looked, gathered, lanes);
                }
            }
        }
        if gathered.count > 0 {
            self.search_gathered(looked, gathered, lanes);
        }
    }

    fn search_gathered(&self, looked: &mut [Looked], gathered: &mut Gathered, lanes: Lanes) {
        let Gathered { count, of, paths, hits } = gathered;
        let which = u16::MAX >> (BLOCK - *count);
        self.trace_block(paths, which, lanes_for(which, lanes), hits);
        for (from, (number, place)) in of[..*count].iter().enumerate() {
            looked[*number].hits.set(*place, &hits.get(from));
        }
        *count = 0;
    }
}
