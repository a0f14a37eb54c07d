//! Squares of vertices in which all rows are alike, or all columns.
//!
//! Ground that is inclined along an axis falls only backward, seen from an apex. But a contour
//! leads through the apex, and the cells on it fall in part. All of them are equally high, as far
//! as the ground extends. No bound on heights or directions shows that they matter less the farther
//! away they are. Where rows or columns are alike, the cells of one of them bound all of them.

use rayon::prelude::*;
use relief_core::HeightMap;

use super::fall::ROUNDING;
use crate::cone_search::{Apexes, Field, LANE_BITS, LANES, Lanes, Region, RelativeCell, Search, bits_of};

/// Levels of the pyramid whose nodes are tested. Lower levels have few cells. The columns of higher
/// levels take long to visit.
const FIRST: u32 = 3;
const LAST: u32 = 6;

/// Places farther away are rounded.
const FAR: f32 = (1u32 << 22) as f32;

/// Relative factor that exceeds the rounding of a cell's bound.
const CAUTION: f64 = 1.0 + 1e-9;

/// For each node of a pyramid, the axes, a bit each, along which no cell around its vertices
/// changes its height.
pub(super) struct Extrusions {
    levels: Vec<Level>,
}

struct Level {
    level_along: Vec<u8>,
    width: usize,
}

/// Node relative to a group of texels.
pub(super) struct ExtrudedNode {
    /// Axis along which heights change.
    across: usize,
    /// First and last vertex along both axes, from the group's first texel.
    spans: [[i64; 2]; 2],
}

/// Apexes and best slopes of a group of texels.
pub(super) struct GroupSlopes<'a> {
    pub apexes: &'a [Apexes; LANES],
    /// Steepest squared slopes so far.
    pub best: &'a Lanes,
}

impl Extrusions {
    /// Finds the extrusions of a map.
    pub fn new(map: &HeightMap) -> Self {
        let (field, size) = (Field::new(map), [map.width(), map.height()]);
        let [width, height] = size.map(|side| side.div_ceil(1 << FIRST) as usize);
        let mut first = vec![0b11; width * height];
        first.par_chunks_mut(width).enumerate().for_each(|(row, nodes)| {
            let top = (row as u32) << FIRST;
            for row in top..(top + (1 << FIRST)).min(size[1]) {
                for column in 0..size[0] {
                    let around = field.around([i64::from(column), i64::from(row)]);
                    let cells = RelativeCell::around([0, 0], &around);
                    nodes[(column >> FIRST) as usize] &=
                        cells.into_iter().fold(0b11, |all, cell| all & of_cell(cell.heights));
                }
            }
        });
        let mut levels = vec![Level { level_along: first, width }];
        for _ in FIRST..LAST {
            levels.extend(levels.last().map(Level::halved));
        }
        Self { levels }
    }

    /// Creates extrusions of ground where nothing is alike.
    #[cfg(test)]
    pub fn none() -> Self {
        Self { levels: Vec::new() }
    }

    /// Returns a node in which rows or columns are alike, given its first and last vertices from a
    /// group's first texel; `None` where neither are.
    #[inline(always)]
    pub fn node(&self, level: u32, [column, row]: [u32; 2], spans: [[f32; 2]; 2]) -> Option<ExtrudedNode> {
        let nodes = self.levels.get(level.checked_sub(FIRST)? as usize)?;
        let level_along = *nodes.level_along.get(row as usize * nodes.width + column as usize)?;
        let is_near = spans.as_flattened().iter().all(|place| place.abs() < FAR);
        (level_along != 0 && is_near).then(|| ExtrudedNode {
            across: usize::from(level_along & 1 != 0),
            spans: spans.map(|span| span.map(|place| place as i64)),
        })
    }
}

impl Level {
    /// Builds the level of half the size, rounded up.
    fn halved(&self) -> Self {
        let width = self.width.div_ceil(2);
        let rows = self.level_along.chunks(2 * self.width);
        let mut level_along = vec![0b11; width * rows.len()];
        for (nodes, rows) in level_along.chunks_mut(width).zip(rows) {
            for row in rows.chunks(self.width) {
                for (node, pair) in nodes.iter_mut().zip(row.chunks(2)) {
                    *node = pair.iter().fold(*node, |all, one| all & one);
                }
            }
        }
        Self { level_along, width }
    }
}

/// Returns the axes along which a cell is level, a bit each.
fn of_cell([h00, h10, h01, h11]: [f64; 4]) -> u8 {
    u8::from(h00 == h10 && h01 == h11) | u8::from(h00 == h01 && h10 == h11) << 1
}

impl ExtrudedNode {
    /// Returns the lanes, a bit each, for which a cell of the node may be steeper than their best
    /// slope. For the other lanes no cell of it changes a bit.
    ///
    /// Such a cell has the slope `b` across and no twist. Let the cell fall from an apex `p`. Then
    /// `p` is at most as far below the cell as the cell, extended over `p`, is above `p`. This
    /// bound is the same in every row, so the cell matters less, the farther away it is.
    pub fn may_matter(&self, search: &Search, group: &GroupSlopes, lanes: u64) -> u64 {
        let Self { across, spans } = *self;
        let (along, first) = (1 - across, group.apexes[0].texel);
        let mut height_at = {
            let mut place = [first[0] + spans[0][0], first[1] + spans[1][0]];
            move |at: i64| {
                place[across] = first[across] + at;
                f64::from(search.field.map.texel(place[0], place[1]))
            }
        };
        let (mut rest, mut may) = (lanes, 0);
        // Cells begin one vertex before.
        let mut before = height_at(spans[across][0] - 1);
        for place in spans[across][0] - 1..=spans[across][1] {
            let behind = height_at(place + 1);
            if before != behind {
                for lane in bits_of(rest) {
                    let by = [lane as i64, 0];
                    let mut nearest = [0.0; 2];
                    nearest[across] = (place - by[across]) as f64;
                    let ends = [spans[along][0] - 1 - by[along], spans[along][1] - by[along]];
                    nearest[along] = 0.max(ends[0]).min(ends[1]) as f64;
                    let farthest = ends[0].abs().max(ends[1].abs()) as f64;
                    let heights = [before, behind];
                    if may_raise(
                        search,
                        &group.apexes[lane],
                        group.best[lane],
                        heights,
                        across,
                        nearest,
                        farthest,
                    ) {
                        may |= LANE_BITS[lane];
                    }
                }
                rest &= !may;
                if rest == 0 {
                    break;
                }
            }
            before = behind;
        }
        may
    }
}

/// Returns whether cells that are level along an axis may require a steeper slope. The cells are
/// those from the `nearest` one, in texels, to the `farthest` one along that axis. Their heights
/// change `across`.
fn may_raise(
    search: &Search,
    apexes: &Apexes,
    best: f64,
    [before, behind]: [f64; 2],
    across: usize,
    nearest: [f64; 2],
    farthest: f64,
) -> bool {
    let geometry = &search.geometry;
    let (half, by, from) = (geometry.region.half(), behind - before, nearest[across]);
    let falls = if by > 0.0 { from - half < 0.0 } else { from + 1.0 + half > 0.0 };
    if !falls {
        return false;
    }
    let distance2 = geometry.distance2(nearest, nearest.map(|at| at + 1.0));
    let rise = (before.max(behind) - apexes.low).max(0.0);
    if rise * rise <= best * distance2 {
        return false;
    }
    if geometry.region == Region::Centre {
        return true;
    }
    // This is the bound of a cell whose twist and other slope are 0. In each quarter of the square,
    // it takes the lesser of two rises: over apexes from which the cell falls, and over the lowest
    // apex.
    let grid = geometry.grid(apexes);
    let over = [0, 1, 2].map(|row: usize| {
        [0, 1, 2].map(|column: usize| {
            let at = ([column, row][across] as f64 - 1.0) * half - from;
            before + by * at - grid[row][column]
        })
    });
    let rounding = ROUNDING * (1.0 + from.abs() + farthest);
    let highest = before.max(behind);
    let mut rise = 0.0f64;
    for [row, column] in [[0, 0], [0, 1], [1, 0], [1, 1]] {
        let (mut extended, mut low) = (f64::NEG_INFINITY, f64::INFINITY);
        for [i, j] in [[0, 0], [1, 0], [0, 1], [1, 1]] {
            extended = extended.max(over[row + j][column + i]);
            low = low.min(grid[row + j][column + i]);
        }
        rise = rise.max((extended + rounding).min(highest - low));
    }
    rise *= CAUTION;
    rise * rise / distance2 > best
}

#[cfg(test)]
mod tests {
    use relief_core::Watch;

    use pulp::Scalar;
    use relief_core::Wrap;

    use super::super::search::{Relaxed, visits};
    use super::*;
    use crate::cone_search::{ConeType, Group, State};

    /// Name of ground that is alike along an axis, and its height by the place along the other
    /// axis.
    type Ground = (&'static str, fn(u32, u32) -> f32);

    /// Heights of 16 bits, which no `f32` holds exactly, in parts of the side.
    const GROUNDS: [Ground; 6] = [
        ("ramp", |at, side| (at * (65_535 / side)) as f32 / 65_535.0),
        ("exact ramp", |at, side| at as f32 / side as f32),
        ("ramp back", |at, side| ((side - 1 - at) * (65_535 / side)) as f32 / 65_535.0),
        ("staircase", |at, side| (at / 4 * 4 * (65_535 / side)) as f32 / 65_535.0),
        ("valley", |at, side| ((2 * at).abs_diff(side) * (65_535 / side)) as f32 / 65_535.0),
        ("bend", |at, side| (at as f32 / side as f32).powf(1.3)),
    ];

    fn ground((_, height): Ground, side: u32, axis: usize, wrap: Wrap) -> HeightMap {
        let map = HeightMap::from_fn(side, side, wrap, |i, j| height([i, j][axis], side));
        map.expect("heights from 0 to 1")
    }

    #[test]
    fn what_is_passed_over_changes_no_bit() {
        let texel_m = [1.0 / 64.0, 1.0 / 80.0];
        for named in GROUNDS {
            for (axis, wrap) in [0, 1].into_iter().flat_map(|axis| Wrap::ALL.map(|wrap| (axis, wrap))) {
                // A bump, so that ground is not alike everywhere.
                for bump in [0.0, 0.3] {
                    let flat = ground(named, 72, axis, wrap);
                    let map = HeightMap::from_fn(72, 72, wrap, |i, j| {
                        let is_bump = (40..44).contains(&i) && (50..53).contains(&j);
                        let height = flat.texel(i.into(), j.into());
                        if is_bump { (height + bump).min(1.0) } else { height }
                    });
                    let map = map.expect("heights from 0 to 1");
                    for region in [Region::Centre, Region::Footprint] {
                        let search = Search::new(&map, texel_m, region);
                        let [quick, whole] =
                            [Relaxed::new(&map, texel_m), Relaxed::without_extrusions(&map, texel_m)]
                                .map(|relaxed| search.ratios(&relaxed.expect("few images"), &Watch::none()));
                        let bits =
                            |ratios: &[f32]| ratios.iter().map(|ratio| ratio.to_bits()).collect::<Vec<_>>();
                        let name = named.0;
                        let same =
                            bits(&quick.expect("nobody stops it")) == bits(&whole.expect("nobody stops it"));
                        assert!(same, "{name} along {axis}, {wrap}, {region:?}, bump {bump}");
                    }
                }
            }
        }
    }

    /// Counts the vertices that are visited for some texels.
    fn visited(relaxed: &Relaxed, map: &HeightMap, texel_m: [f64; 2]) -> u64 {
        let search = Search::new(map, texel_m, Region::Footprint);
        let side = map.width();
        let mut state = State { group: Group::new(), seeds: vec![None; side as usize] };
        let before = visits();
        for row in (1..8).map(|part| part * side / 8) {
            for column in (0..side).step_by(side as usize / 8) {
                let texel = [i64::from(column), i64::from(row)];
                relaxed.slopes2(Scalar::new(), &search, texel, LANES, [0.0; LANES], &mut state);
            }
        }
        visits() - before
    }

    #[test]
    fn few_vertices_of_extruded_ground_are_visited_at_any_size() {
        for named in GROUNDS {
            for axis in [0, 1] {
                let counts = [256, 512].map(|side| {
                    let map = ground(named, side, axis, Wrap::Clamp);
                    let texel_m = [1.0 / f64::from(side); 2];
                    visited(&Relaxed::new(&map, texel_m).expect("few images"), &map, texel_m)
                });
                println!("{} along {axis}: {counts:?}", named.0);
                // Without extrusions they are several times as many, and twice as many at the
                // larger side.
                assert!(counts[1] < 2 * counts[0].max(1000) && counts[0] < 25_000, "{} {counts:?}", named.0);
            }
        }
    }
}
