//! Rays traced in shells side by side: entries, hits, and the nearest of these.

use relief_core::Lanes;
use relief_shaders::cpu::{BLOCK, EnteredBlock, HitBlock, PathBlock, Row, Triangle, TriangleRays};
use relief_shaders::surface::FOLDED;

use super::super::block::{lanes_for, places, places_where};
use super::super::block_hits::RegionHits;
use super::super::prepared_surface::PreparedSurface;
use super::ShellRay;

/// Least number of a shell's rays that are searched by themselves. Fewer are batched with the rays
/// of other shells.
const NEARLY_ALL: u32 = 12;

/// Side of a shell and the rays to trace in it.
pub struct ShellRays {
    triangle: Triangle,
    side: f32,
    looks: Row<ShellRay>,
    /// Rays whose segments are not all searched, a bit for each, and rays that are searched now.
    rest: u16,
    searched: u16,
    /// Rays whose hit is the nearest so far.
    nearest: u16,
    /// Cost of all segments.
    costs: [Row<u32>; 3],
    points: [Row<f32>; 2],
    at: EnteredBlock,
    paths: PathBlock,
    hits: HitBlock,
    keys: Row<f32>,
}

/// Batch of paths through several shells, searched side by side, with their hits.
#[derive(Default)]
pub struct PathBatch {
    count: usize,
    /// Ray of each path, by the number of the shell and the place there.
    of: Row<(usize, usize)>,
    paths: PathBlock,
    hits: HitBlock,
}

impl ShellRays {
    /// Creates a side of a triangle's shell with at most a block of rays.
    pub fn new(surface: &PreparedSurface, side: f32, looks: &[ShellRay], seen: &mut RegionHits) -> Self {
        let mut points = [[0.0; BLOCK]; 2];
        for (at, ShellRay { block, place, .. }) in looks.iter().enumerate() {
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

    fn enter(&mut self, surface: &PreparedSurface, lanes: Lanes) {
        let Self { triangle, side, points, rest, at, paths, .. } = self;
        let rays = TriangleRays { triangle, side: *side, points };
        surface.program.enter_block(rays, *rest, lanes_for(*rest, lanes), at, paths);
    }

    /// Goes on to the segments with a number. Returns whether there are any.
    fn go_on(&mut self, surface: &PreparedSurface, number: u32, lanes: Lanes) -> bool {
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

    /// Stores the hits on these segments that are the nearest so far.
    fn store(&mut self, surface: &PreparedSurface, number: u32, lanes: Lanes, seen: &mut RegionHits) {
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
            let ShellRay { triangle, block, place } = looks[from];
            let rank = (*side < 0.0, triangle);
            if seen.of(block).store_from(place as usize, rank, *side, keys[from], (from, at, paths, hits)) {
                self.nearest |= 1 << from;
            }
        }
        if triangle.shell.order < FOLDED {
            self.rest &= !found;
        }
    }

    /// Stores the cost of all segments for rays whose hit is still the nearest. The other side of
    /// the shell may have given a nearer one since.
    fn store_costs(&self, seen: &mut RegionHits) {
        for from in places(self.nearest) {
            let ShellRay { triangle, block, place } = self.looks[from];
            let (seen, place) = (seen.of(block), place as usize);
            if seen.faces.rank[place] == (self.side < 0.0, triangle) {
                for (cost, costs) in seen.hits.cost.iter_mut().zip(&self.costs) {
                    cost[place] = costs[from];
                }
            }
        }
    }
}

impl PreparedSurface<'_> {
    /// Traces rays in several shells together and stores the hits that are the nearest so far.
    pub(super) fn trace_together(
        &self,
        shell_rays: &mut [ShellRays],
        batch: &mut PathBatch,
        lanes: Lanes,
        seen: &mut RegionHits,
    ) {
        for shell in shell_rays.iter_mut() {
            shell.enter(self, lanes);
        }
        for number in 0.. {
            let mut is_any_left = false;
            for shell in shell_rays.iter_mut() {
                is_any_left |= shell.go_on(self, number, lanes);
            }
            if !is_any_left {
                break;
            }
            self.search_together(shell_rays, batch, lanes);
            for shell in shell_rays.iter_mut() {
                shell.store(self, number, lanes, seen);
            }
        }
        // Tracers report the cost of finding the hit.
        if self.tracers.is_none() {
            shell_rays.iter().for_each(|shell| shell.store_costs(seen));
        }
    }

    /// Searches the segments of all rays that have one.
    fn search_together(&self, shell_rays: &mut [ShellRays], batch: &mut PathBatch, lanes: Lanes) {
        for number in 0..shell_rays.len() {
            let ShellRays { searched, paths, hits, .. } = &mut shell_rays[number];
            if searched.count_ones() >= NEARLY_ALL {
                self.trace_block(paths, *searched, lanes, hits);
                continue;
            }
            for place in places(*searched) {
                batch.paths.set(batch.count, &shell_rays[number].paths.get(place));
                batch.of[batch.count] = (number, place);
                batch.count += 1;
                if batch.count == BLOCK {
                    self.search_batch(shell_rays, batch, lanes);
                }
            }
        }
        if batch.count > 0 {
            self.search_batch(shell_rays, batch, lanes);
        }
    }

    fn search_batch(&self, shell_rays: &mut [ShellRays], batch: &mut PathBatch, lanes: Lanes) {
        let PathBatch { count, of, paths, hits } = batch;
        let which = u16::MAX >> (BLOCK - *count);
        self.trace_block(paths, which, lanes_for(which, lanes), hits);
        for (from, (number, place)) in of[..*count].iter().enumerate() {
            shell_rays[*number].hits.set(*place, &hits.get(from));
        }
        *count = 0;
    }
}
