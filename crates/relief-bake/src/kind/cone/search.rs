//! Texels side by side, from the cells around them outward.

use std::sync::atomic::{AtomicUsize, Ordering};

use pulp::{Arch, Simd, WithSimd};
use rayon::prelude::*;
use relief_core::{HeightMap, Wrap};

use super::apexes::{APEXES, Apexes, PerApex, Places, Region};
use super::block::{Block, Lanes, is_in_block};
use super::encoding::ratio;
use super::field::{Field, Seen};
use super::near::{Near, NearRow};
use super::walk::{Group, LANES, Look, Walk};
use crate::{Cancelled, Progress};

/// Rows that go on from one to the next: what was steepest for a texel is mostly steepest, or nearly, for the one below.
const ROWS: usize = 32;

/// A bound is trusted to prune only when it is below by more than rounding.
const MARGIN: f64 = 1.0 + 1e-9;

/// A map and all that its texels are searched with.
pub(in crate::kind) struct Search<'a> {
    pub field: Field<'a>,
    pub places: Places,
    pub near: Near,
    pub walk: Walk<'a>,
}

/// What goes on from row to row.
pub(in crate::kind) struct State {
    pub group: Group,
    /// The vertex that was steepest for each texel of the row above.
    pub seeds: Vec<Option<[i64; 2]>>,
}

/// A sort of cone. What it does is to be inlined always, so that it is compiled for the vectors that the machine has.
pub(in crate::kind) trait Sort: Sync {
    /// Whether the slopes to the blocks are needed.
    const NEAR: bool;

    /// Squared slopes of the cones of `count` texels from the one given, and those to their blocks, when they are needed.
    fn slopes2<S: Simd>(
        &self,
        simd: S,
        search: &Search,
        texel: [i64; 2],
        count: usize,
        near: Lanes,
        state: &mut State,
    ) -> Lanes;
}

impl<'a> Search<'a> {
    pub fn new(map: &'a HeightMap, texel_m: [f64; 2], region: Region) -> Self {
        Self {
            field: Field::new(map),
            places: Places::new(region, texel_m),
            near: Near::new(texel_m, region),
            walk: Walk::new(map, texel_m, region.half()),
        }
    }

    /// The ratio of every texel for a sort of cone.
    pub fn ratios<K: Sort>(&self, sort: &K, progress: &Progress) -> Result<Vec<f32>, Cancelled> {
        let width = self.field.map.width() as usize;
        let mut ratios = vec![0.0f32; self.field.map.texels().len()];
        let (total, done) = (ratios.len() as f32, AtomicUsize::new(0));
        let arch = Arch::new();
        ratios.par_chunks_mut(width * ROWS).enumerate().try_for_each(|(band, ratios)| {
            let mut state = State { group: Group::new(), seeds: vec![None; width] };
            let columns = if K::NEAR { width } else { 0 };
            let mut near = [NearRow::new(columns), NearRow::new(columns)];
            let top = (band * ROWS) as i64;
            if K::NEAR {
                arch.dispatch(Above { search: self, row: top - 1, near: &mut near[1] });
            }
            for (row, ratios) in ratios.chunks_mut(width).enumerate() {
                near.swap(0, 1);
                let row = top + row as i64;
                arch.dispatch(Row { search: self, sort, row, near: &mut near, state: &mut state, ratios });
                let before = done.fetch_add(width, Ordering::Relaxed);
                progress.at((before + width) as f32 / total)?;
            }
            Ok(())
        })?;
        Ok(ratios)
    }

    /// Squared slopes to everything: the least that a cone that holds no surface must have.
    #[inline(always)]
    pub fn slopes2<S: Simd>(
        &self,
        simd: S,
        texel: [i64; 2],
        count: usize,
        near: Lanes,
        state: &mut State,
    ) -> Lanes {
        let apexes = Block::new(&self.field, texel).apexes(texel, self.places.region);
        let mut best = near;
        let (group, seeds) = (&mut state.group, &mut state.seeds[texel[0] as usize..]);
        group.begin(texel);
        for lane in 0..count {
            let (apexes, best) = (&apexes[lane], &mut best[lane]);
            if let Some(seed) = seeds[lane] {
                let by = [0, 1].map(|axis| seed[axis] - apexes.texel[axis]);
                let height = f64::from(self.field.map.texel(seed[0], seed[1]));
                *best = most(&self.places.to_vertex(simd, apexes, by, height)).max(*best);
            }
            self.walk.lower(group, lane, apexes.low);
            self.walk.raise_bar(group, lane, *best);
        }
        // Distances along the axes are independent, so the nearest image of a point is in a tile beside the apex's.
        let tiles = if self.field.map.wrap() == Wrap::Repeat { [1; 2] } else { [0; 2] };
        self.walk.walk(
            simd,
            group,
            tiles,
            &mut Steepest { search: self, apexes: &apexes, best: &mut best, seeds },
        );
        best
    }

    /// The greatest squared slope to a cell; or less, when it is not above `least`.
    #[inline(always)]
    pub fn to_cell<S: Simd>(&self, simd: S, apexes: &Apexes, seen: &Seen, least: f64) -> f64 {
        let (places, [h00, h10, h01, h11]) = (&self.places, seen.heights);
        let [x, y] = seen.offset;
        let mut best = least;
        for (vertex, height) in [([x, y], h00), ([x + 1, y], h10), ([x, y + 1], h01), ([x + 1, y + 1], h11)] {
            let slopes = places.to_vertex(simd, apexes, vertex, height);
            best = most(&slopes).max(best);
            self.raise_to_rim(apexes, vertex, height, &slopes, &mut best);
        }
        for (from, axis, heights) in [
            ([x, y], 0, [h00, h10]),
            ([x, y + 1], 0, [h01, h11]),
            ([x, y], 1, [h00, h01]),
            ([x + 1, y], 1, [h10, h11]),
        ] {
            best = most(&places.to_edge(simd, apexes, from, axis, heights)).max(best);
        }
        for apex in bits_of(places.may_peak_inside(simd, apexes, seen, best)) {
            if apex < places.region.count() {
                best = places.patch(apexes, apex, seen).inside(best).max(best);
            }
        }
        best
    }

    /// Raises `best` to the squared slopes from the rim to a vertex, when those from the apexes are given.
    #[inline(always)]
    fn raise_to_rim(&self, apexes: &Apexes, by: [i64; 2], height: f64, slopes: &PerApex, best: &mut f64) {
        let places = &self.places;
        let turn = places.turn(by, 0.0, 0.5 * self.walk.side_m());
        if places.region == Region::Centre || most(slopes) * MARGIN < *best * turn {
            return;
        }
        for apex in 0..APEXES {
            if slopes[apex].max(slopes[(apex + 1) % APEXES]) * MARGIN >= *best * turn {
                *best = places.rim_slope2(apexes, apex, by, height).max(*best);
            }
        }
    }

    /// Whether anything around a vertex with that squared slope may be steeper than `best`: see [`super::walk`].
    #[inline(always)]
    pub fn may_be_steeper_around(&self, by: [i64; 2], slope2: f64, best: f64) -> bool {
        let turn = self.places.turn(by, 1.0, self.walk.side_m());
        turn <= 0.0 || slope2 * MARGIN >= best * turn * turn
    }

    /// Raises `best` to the squared slopes to the edges and the insides of cells around a vertex, outside of the block, and to the
    /// vertex from the rim, when the squared slopes to the vertex itself are given.
    #[inline(always)]
    fn raise_around<S: Simd>(
        &self,
        simd: S,
        apexes: &Apexes,
        by: [i64; 2],
        height: f64,
        slopes: &PerApex,
        best: &mut f64,
    ) {
        let (places, side) = (&self.places, self.walk.side_m());
        self.raise_to_rim(apexes, by, height, slopes, best);
        let turn = places.turn(by, 1.0, side);
        let around = self.field.around([apexes.texel[0] + by[0], apexes.texel[1] + by[1]]);
        if most(slopes) * MARGIN >= *best * turn {
            for (from, axis, heights) in [
                ([by[0] - 1, by[1]], 0, [around[1][0], height]),
                (by, 0, [height, around[1][2]]),
                ([by[0], by[1] - 1], 1, [around[0][1], height]),
                (by, 1, [height, around[2][1]]),
            ] {
                *best = most(&places.to_edge(simd, apexes, from, axis, heights)).max(*best);
            }
        }
        let least = if turn > 0.0 { *best * turn * turn / MARGIN } else { 0.0 };
        for seen in Seen::around(by, &around) {
            if is_in_block(seen.offset) {
                continue;
            }
            for apex in bits_of(places.may_peak_inside(simd, apexes, &seen, *best)) {
                if slopes[apex % APEXES] >= least && apex < places.region.count() {
                    *best = places.patch(apexes, apex, &seen).inside(*best).max(*best);
                }
            }
        }
    }
}

/// Looks for what is steepest for each lane.
struct Steepest<'a, 'b> {
    search: &'b Search<'a>,
    apexes: &'b [Apexes; LANES],
    best: &'b mut Lanes,
    seeds: &'b mut [Option<[i64; 2]>],
}

impl Look for Steepest<'_, '_> {
    const HIGHEST_CORNERS: bool = false;

    #[inline(always)]
    fn may_matter(&self, _: u32, _: [u32; 2], _: [f32; 2], _: [f32; 2]) -> bool {
        true
    }

    #[inline(always)]
    fn look<S: Simd>(
        &mut self,
        simd: S,
        group: &mut Group,
        excess: &[f32; LANES],
        vertex: [i64; 2],
        height: f64,
    ) {
        for lane in (0..LANES).filter(|lane| excess[*lane] > 0.0) {
            let (search, apexes, best) = (self.search, &self.apexes[lane], &mut self.best[lane]);
            let by = [0, 1].map(|axis| vertex[axis] - apexes.texel[axis]);
            let before = *best;
            let slopes = search.places.to_vertex(simd, apexes, by, height);
            *best = most(&slopes).max(*best);
            if search.may_be_steeper_around(by, most(&slopes), *best) {
                search.raise_around(simd, apexes, by, height, &slopes, best);
            }
            if *best > before {
                self.seeds[lane] = Some(vertex);
                search.walk.raise_bar(group, lane, *best);
            }
        }
    }
}

/// The numbers of the bits that are set.
#[inline(always)]
pub(in crate::kind) fn bits_of(mut set: u64) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let bit = (set != 0).then_some(set.trailing_zeros() as usize);
        set &= set.wrapping_sub(1);
        bit
    })
}

/// The greatest of squared slopes.
#[inline(always)]
pub(in crate::kind) fn most(slopes: &PerApex) -> f64 {
    slopes.iter().fold(0.0, |most, &slope2| if slope2 > most { slope2 } else { most })
}

/// The row above a band, of which only what is near to points is needed.
struct Above<'a, 'b> {
    search: &'b Search<'a>,
    row: i64,
    near: &'b mut NearRow,
}

impl WithSimd for Above<'_, '_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let Self { search, row, near } = self;
        near.fill(simd, &search.near, &search.field, row);
    }
}

/// A row, to be searched with the vectors that the machine has.
struct Row<'a, 'b, K> {
    search: &'b Search<'a>,
    sort: &'b K,
    row: i64,
    /// Of the row above and of this one.
    near: &'b mut [NearRow; 2],
    state: &'b mut State,
    ratios: &'b mut [f32],
}

impl<K: Sort> WithSimd for Row<'_, '_, K> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let Self { search, sort, row, near: [above, near], state, ratios } = self;
        if K::NEAR {
            near.fill(simd, &search.near, &search.field, row);
        }
        for (group, ratios) in ratios.chunks_mut(LANES).enumerate() {
            let first = group * LANES;
            let texel = [first as i64, row];
            let slopes2 = if K::NEAR { near.of_texels(above, first, ratios.len()) } else { [0.0; LANES] };
            let slopes2 = sort.slopes2(simd, search, texel, ratios.len(), slopes2, state);
            for (slot, slope2) in ratios.iter_mut().zip(slopes2) {
                *slot = ratio(slope2, search.places.texel_m);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use pulp::Scalar;
    use relief_tests::maps;

    use super::super::Empty;
    use super::*;

    /// The ratios without any vectors.
    fn scalar_ratios(search: &Search) -> Vec<f32> {
        let (width, height) = (search.field.map.width() as usize, i64::from(search.field.map.height()));
        let mut near = [NearRow::new(width), NearRow::new(width)];
        let mut ratios = vec![0.0; width * height as usize];
        for (row, ratios) in ratios.chunks_mut(width).enumerate() {
            let mut state = State { group: Group::new(), seeds: vec![None; width] };
            let row = row as i64;
            Above { search, row: row - 1, near: &mut near[0] }.with_simd(Scalar::new());
            Row { search, sort: &Empty, row, near: &mut near, state: &mut state, ratios }
                .with_simd(Scalar::new());
        }
        ratios
    }

    #[test]
    fn every_machine_finds_the_same() {
        for (k, map) in maps::ALL.iter().enumerate() {
            let map = map.build(Wrap::ALL[k % Wrap::ALL.len()]);
            for region in [Region::Centre, Region::Footprint] {
                let search = Search::new(&map, [0.02, 0.03], region);
                let ratios = search.ratios(&Empty, &Progress::none()).expect("nobody cancels");
                assert_eq!(ratios, scalar_ratios(&search), "{}", maps::ALL[k].name);
            }
        }
    }
}
