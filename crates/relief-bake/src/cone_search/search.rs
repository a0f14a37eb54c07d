//! The search, row by row, and its parts that all types of cone need.

use std::sync::atomic::{AtomicUsize, Ordering};

use pulp::{Simd, WithSimd};
use rayon::prelude::*;
use relief_core::{Cancelled, HeightMap, Watch};

use super::apexes::{APEXES, ApexGeometry, Apexes, PerApex, Region, most};
use super::encoding::ratio;
use super::field::{Field, RelativeCell};
use super::lanes::{LANES, Lanes, bits_of};
use super::near::{Near, NearRow};
use super::tie::MARGIN;
use super::walk::{Group, Walk};

/// Rows that one task goes down. The vertex steepest for a texel is mostly steepest, or nearly, for
/// the texel below.
const ROWS: usize = 32;

/// Map with the data of its search.
pub(crate) struct Search<'a> {
    pub field: Field<'a>,
    pub geometry: ApexGeometry,
    pub near: Near,
    pub walk: Walk<'a>,
}

/// State that is passed from row to row.
pub(crate) struct State {
    pub group: Group,
    /// Vertex that was steepest for each texel of the row above.
    pub seeds: Vec<Option<[i64; 2]>>,
}

/// Type of cone. Its methods must be `inline(always)`, so that they are compiled for the machine's
/// vectors.
pub(crate) trait ConeType: Sync {
    /// Whether the slopes to the blocks are needed.
    const NEAR: bool;

    /// Returns squared slopes of the cones of `count` texels from `texel` on. `near` has the slopes
    /// to their blocks, where they are needed.
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
            geometry: ApexGeometry::new(region, texel_m),
            near: Near::new(texel_m, region),
            walk: Walk::new(map, texel_m, region),
        }
    }

    /// Returns the ratio of every texel for a type of cone.
    pub fn ratios<K: ConeType>(&self, cone_type: &K, watch: &Watch) -> Result<Vec<f32>, Cancelled> {
        let width = self.field.map.width() as usize;
        let mut ratios = vec![0.0f32; self.field.map.texels().len()];
        let (total, done) = (ratios.len() as f32, AtomicUsize::new(0));
        // Wider vectors are of no use: eight texels are searched together.
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
                    cone_type,
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

    /// Returns the greatest squared slope to a cell, or `least` if this is more.
    #[inline(always)]
    pub fn to_cell<S: Simd>(&self, simd: S, apexes: &Apexes, cell: &RelativeCell, least: f64) -> f64 {
        let (geometry, [h00, h10, h01, h11]) = (&self.geometry, cell.heights);
        let [x, y] = cell.offset;
        let mut best = least;
        for (vertex, height) in [([x, y], h00), ([x + 1, y], h10), ([x, y + 1], h01), ([x + 1, y + 1], h11)] {
            let slopes = geometry.to_vertex(simd, apexes, vertex, height);
            best = most(&slopes).max(best);
            self.raise_to_rim(apexes, vertex, height, &slopes, &mut best);
        }
        for (from, axis, heights) in [
            ([x, y], 0, [h00, h10]),
            ([x, y + 1], 0, [h01, h11]),
            ([x, y], 1, [h00, h01]),
            ([x + 1, y], 1, [h10, h11]),
        ] {
            best = most(&geometry.to_edge(simd, apexes, from, axis, heights)).max(best);
        }
        for apex in bits_of(geometry.may_peak_inside(simd, apexes, cell, best)) {
            if apex < geometry.region.count() {
                best = geometry.patch(apexes, apex, cell).inside(best).max(best);
            }
        }
        best
    }

    /// Raises `best` to the squared slopes from the rim to a vertex. `slopes` are the slopes from
    /// the apexes.
    #[inline(always)]
    pub fn raise_to_rim(&self, apexes: &Apexes, by: [i64; 2], height: f64, slopes: &PerApex, best: &mut f64) {
        let geometry = &self.geometry;
        let turn = geometry.turn(by, 0.0, 0.5 * self.walk.side_m());
        if geometry.region == Region::Centre || most(slopes) * MARGIN < *best * turn {
            return;
        }
        for apex in 0..APEXES {
            if slopes[apex].max(slopes[(apex + 1) % APEXES]) * MARGIN >= *best * turn {
                *best = geometry.rim_slope2(apexes, apex, by, height).max(*best);
            }
        }
    }
}

/// The row above a band. Only its slopes to the nearest cells are needed.
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

/// Row to be searched with the vectors of the machine.
pub(super) struct Row<'a, 'b, K> {
    pub search: &'b Search<'a>,
    pub cone_type: &'b K,
    pub row: i64,
    /// Slopes of the row above and of this row.
    pub near: &'b mut [NearRow; 2],
    pub state: &'b mut State,
    pub ratios: &'b mut [f32],
}

impl<K: ConeType> WithSimd for Row<'_, '_, K> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let Self { search, cone_type, row, near: [above, near], state, ratios } = self;
        if K::NEAR {
            near.fill(simd, &search.near, &search.field, row);
        }
        for (group, ratios) in ratios.chunks_mut(LANES).enumerate() {
            let first = group * LANES;
            let texel = [first as i64, row];
            let slopes2 = if K::NEAR { near.of_texels(above, first, ratios.len()) } else { [0.0; LANES] };
            let slopes2 = cone_type.slopes2(simd, search, texel, ratios.len(), slopes2, state);
            for (slot, slope2) in ratios.iter_mut().zip(slopes2) {
                *slot = ratio(slope2, search.geometry.texel_m);
            }
        }
    }
}
