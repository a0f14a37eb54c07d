//! The search, row by row, and what every sort of cone needs from it.

use std::sync::atomic::{AtomicUsize, Ordering};

use pulp::{Simd, WithSimd};
use rayon::prelude::*;
use relief_core::{Cancelled, HeightMap, Watch};

use super::apexes::{APEXES, Apexes, PerApex, Places, Region, most};
use super::encoding::ratio;
use super::field::{Field, Seen};
use super::lanes::{LANES, Lanes, bits_of};
use super::near::{Near, NearRow};
use super::tie::MARGIN;
use super::walk::{Group, Walk};

/// Rows that one task goes down: what was steepest for a texel is mostly steepest, or nearly, below it.
const ROWS: usize = 32;

/// A map and all that its texels are searched with.
pub(crate) struct Search<'a> {
    pub field: Field<'a>,
    pub places: Places,
    pub near: Near,
    pub walk: Walk<'a>,
}

/// What goes on from row to row.
pub(crate) struct State {
    pub group: Group,
    /// The vertex that was steepest for each texel of the row above.
    pub seeds: Vec<Option<[i64; 2]>>,
}

/// A sort of cone. Its methods must be `inline(always)`, so that they are compiled for the machine's vectors.
pub(crate) trait Sort: Sync {
    /// Whether the slopes to the blocks are needed.
    const NEAR: bool;

    /// Squared slopes of the cones of `count` texels from `texel` on. `near` has those to their blocks, where
    /// they are needed.
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
            walk: Walk::new(map, texel_m, region),
        }
    }

    /// The ratio of every texel for a sort of cone.
    pub fn ratios<K: Sort>(&self, sort: &K, watch: &Watch) -> Result<Vec<f32>, Cancelled> {
        let width = self.field.map.width() as usize;
        let mut ratios = vec![0.0f32; self.field.map.texels().len()];
        let (total, done) = (ratios.len() as f32, AtomicUsize::new(0));
        // Not wider ones: eight texels are searched for together.
        let lanes = relief_core::Lanes::Eight;
        ratios.par_chunks_mut(width * ROWS).enumerate().try_for_each(|(band, ratios)| {
            let mut state = State { group: Group::new(), seeds: vec![None; width] };
            let columns = if K::NEAR { width } else { 0 };
            let mut near = [NearRow::new(columns), NearRow::new(columns)];
            let top = (band * ROWS) as i64;
            if K::NEAR {
                lanes.run_up_to_eight(Above { search: self, row: top - 1, near: &mut near[1] });
            }
            for (row, ratios) in ratios.chunks_mut(width).enumerate() {
                near.swap(0, 1);
                let row = top + row as i64;
                lanes.run_up_to_eight(Row {
                    search: self,
                    sort,
                    row,
                    near: &mut near,
                    state: &mut state,
                    ratios,
                });
                let before = done.fetch_add(width, Ordering::Relaxed);
                watch.at((before + width) as f32 / total)?;
            }
            Ok(())
        })?;
        Ok(ratios)
    }

    /// The greatest squared slope to a cell, or `least` where that is more.
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
    pub fn raise_to_rim(&self, apexes: &Apexes, by: [i64; 2], height: f64, slopes: &PerApex, best: &mut f64) {
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
}

/// The row above a band, of which only what is near to points is needed.
pub(super) struct Above<'a, 'b> {
    pub search: &'b Search<'a>,
    pub row: i64,
    pub near: &'b mut NearRow,
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
pub(super) struct Row<'a, 'b, K> {
    pub search: &'b Search<'a>,
    pub sort: &'b K,
    pub row: i64,
    /// Of the row above and of this one.
    pub near: &'b mut [NearRow; 2],
    pub state: &'b mut State,
    pub ratios: &'b mut [f32],
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
