//! Cones that hold no surface: the steepest slope to the whole surface.

use pulp::Simd;
use relief_core::Wrap;

use super::apexes::{APEXES, Apexes, PerApex, most};
use super::block::{Block, is_in_block};
use super::field::RelativeCell;
use super::lanes::{LANES, Lanes, bits_of};
use super::search::{ConeType, Search, State};
use super::tie::{MARGIN, is_nearly_flat};
use super::walk::{Group, VertexVisitor};

/// Cones that hold no surface.
pub(crate) struct Empty;

impl ConeType for Empty {
    const NEAR: bool = true;

    #[inline(always)]
    fn slopes2<S: Simd>(
        &self,
        simd: S,
        search: &Search,
        texel: [i64; 2],
        count: usize,
        near: Lanes,
        state: &mut State,
    ) -> Lanes {
        let apexes = Block::new(&search.field, texel).apexes(texel, search.geometry.region);
        let mut best = near;
        let (group, seeds) = (&mut state.group, &mut state.seeds[texel[0] as usize..]);
        group.begin(texel);
        for lane in 0..count {
            let (apexes, best) = (&apexes[lane], &mut best[lane]);
            if let Some(seed) = seeds[lane] {
                let by = [0, 1].map(|axis| seed[axis] - apexes.texel[axis]);
                let height = f64::from(search.field.map.texel(seed[0], seed[1]));
                *best = most(&search.geometry.to_vertex(simd, apexes, by, height)).max(*best);
            }
            search.walk.lower(group, lane, apexes);
            search.walk.raise_bar(group, lane, *best);
        }
        // Distances along the axes are independent: the nearest image is in a tile beside the
        // apex's.
        let tiles = if search.field.map.wrap() == Wrap::Repeat { [1; 2] } else { [0; 2] };
        search.walk.walk(
            simd,
            group,
            tiles,
            &mut Steepest { search, apexes: &apexes, best: &mut best, seeds },
        );
        best
    }
}

/// Visitor that finds the steepest slope for each lane.
struct Steepest<'a, 'b> {
    search: &'b Search<'a>,
    apexes: &'b [Apexes; LANES],
    best: &'b mut Lanes,
    seeds: &'b mut [Option<[i64; 2]>],
}

impl VertexVisitor for Steepest<'_, '_> {
    const HIGHEST_CORNERS: bool = false;

    #[inline(always)]
    fn may_matter(&self, _: u32, _: [u32; 2], _: [f32; 2], _: [f32; 2]) -> bool {
        true
    }

    #[inline(always)]
    fn visit<S: Simd>(
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
            let slopes = search.geometry.to_vertex(simd, apexes, by, height);
            *best = most(&slopes).max(*best);
            if may_be_steeper_around(search, by, most(&slopes), *best) {
                raise_around(simd, search, apexes, by, height, &slopes, best);
            }
            if *best > before {
                self.seeds[lane] = Some(vertex);
                search.walk.raise_bar(group, lane, *best);
            }
        }
    }
}

/// Returns whether a point around a vertex with that squared slope may be steeper than `best`: see
/// [`super::walk`].
#[inline(always)]
fn may_be_steeper_around(search: &Search, by: [i64; 2], slope2: f64, best: f64) -> bool {
    let turn = search.geometry.turn(by, 1.0, search.walk.side_m());
    turn <= 0.0 || slope2 * MARGIN >= best * turn * turn
}

/// Raises `best` to the squared slopes around a vertex: to it from the rim, to its edges, and to
/// the insides of its cells outside of the block. `slopes` are the squared slopes from the apexes
/// to the vertex itself.
#[inline(always)]
fn raise_around<S: Simd>(
    simd: S,
    search: &Search,
    apexes: &Apexes,
    by: [i64; 2],
    height: f64,
    slopes: &PerApex,
    best: &mut f64,
) {
    let (geometry, side) = (&search.geometry, search.walk.side_m());
    search.raise_to_rim(apexes, by, height, slopes, best);
    let turn = geometry.turn(by, 1.0, side);
    let around = search.field.around([apexes.texel[0] + by[0], apexes.texel[1] + by[1]]);
    if most(slopes) * MARGIN >= *best * turn {
        for (from, axis, heights) in [
            ([by[0] - 1, by[1]], 0, [around[1][0], height]),
            (by, 0, [height, around[1][2]]),
            ([by[0], by[1] - 1], 1, [around[0][1], height]),
            (by, 1, [height, around[2][1]]),
        ] {
            *best = most(&geometry.to_edge(simd, apexes, from, axis, heights)).max(*best);
        }
    }
    let least = if turn > 0.0 { *best * turn * turn / MARGIN } else { 0.0 };
    for cell in RelativeCell::around(by, &around) {
        if is_in_block(cell.offset) || is_flat(search, &cell, *best) {
            continue;
        }
        for apex in bits_of(geometry.may_peak_inside(simd, apexes, &cell, *best)) {
            if slopes[apex % APEXES] >= least && apex < geometry.region.count() {
                *best = geometry.patch(apexes, apex, &cell).inside(*best).max(*best);
            }
        }
    }
}

/// Returns whether the inside of a cell may be left out.
#[inline(always)]
fn is_flat(search: &Search, cell: &RelativeCell, best: f64) -> bool {
    let from = cell.offset.map(|offset| offset as f64);
    let distance2 = search.geometry.distance2(from, [from[0] + 1.0, from[1] + 1.0]);
    is_nearly_flat(cell.heights, distance2, best, search.geometry.texel_m)
}

#[cfg(test)]
mod tests {
    use relief_core::Watch;

    use pulp::{Scalar, WithSimd};
    use relief_testing::maps;

    use super::super::apexes::Region;
    use super::super::near::NearRow;
    use super::super::search::{Above, Row};
    use super::*;

    /// Returns the ratios without any vectors.
    fn scalar_ratios(search: &Search) -> Vec<f32> {
        let (width, height) = (search.field.map.width() as usize, i64::from(search.field.map.height()));
        let mut near = [NearRow::new(width), NearRow::new(width)];
        let mut ratios = vec![0.0; width * height as usize];
        for (row, ratios) in ratios.chunks_mut(width).enumerate() {
            let mut state = State { group: Group::new(), seeds: vec![None; width] };
            let row = row as i64;
            Above { search, row: row - 1, near: &mut near[0] }.with_simd(Scalar::new());
            Row { search, cone_type: &Empty, row, near: &mut near, state: &mut state, ratios }
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
                let ratios = search.ratios(&Empty, &Watch::none()).expect("nobody cancels");
                assert_eq!(ratios, scalar_ratios(&search), "{}", maps::ALL[k].name);
            }
        }
    }
}
