//! Upper hulls of the falling cells in squares of vertices. A node of the pyramid has only its
//! highest vertex. It does not show that only the rim of level ground in the node falls.
//!
//! The profile of a node along an axis holds, for each column (or row), the highest corner of the
//! cells that fall anywhere. Seen from aside it is as high as its upper hull.

use rayon::prelude::*;
use relief_core::HeightMap;

use super::directions::of_cell;
use crate::cone_search::{Field, ProfileVertex};
use crate::upper_hulls::{HullLevel, push_to_hull};

/// First level of the pyramid that has hulls: on lower levels they would take as much memory as the
/// map.
const FIRST: u32 = 5;

/// Upper hulls, along both axes, of the falling cells around the vertices of a pyramid's nodes.
pub(super) struct FallingHulls {
    levels: Vec<[HullLevel<ProfileVertex>; 2]>,
}

impl FallingHulls {
    /// Builds the hulls of a map.
    pub fn new(map: &HeightMap) -> Self {
        let (field, size) = (Field::new(map), [map.width(), map.height()]);
        let mut levels = Vec::new();
        for level in FIRST..=size[0].max(size[1]).next_power_of_two().ilog2() {
            let nodes = size.map(|side| side.div_ceil(1 << level) as usize);
            let hulls: Vec<[Vec<ProfileVertex>; 2]> = (0..nodes[0] * nodes[1])
                .into_par_iter()
                .map_init(Default::default, |profiles: &mut [Vec<f32>; 2], node| {
                    let first = [node % nodes[0], node / nodes[0]].map(|at| at << level);
                    let last = [0, 1].map(|axis| (first[axis] + (1 << level)).min(size[axis] as usize));
                    for axis in 0..2 {
                        profiles[axis].clear();
                        profiles[axis].resize(last[axis] - first[axis] + 2, f32::NEG_INFINITY);
                    }
                    // Begins with the cells before the node's first column and row.
                    for row in first[1]..=last[1] {
                        for column in first[0]..=last[0] {
                            let heights = cell(&field, [column as i64 - 1, row as i64 - 1]);
                            if of_cell(heights) == 0 {
                                continue;
                            }
                            for (corner, height) in heights.into_iter().enumerate() {
                                let at = [column - first[0] + corner % 2, row - first[1] + corner / 2];
                                for axis in 0..2 {
                                    let highest = &mut profiles[axis][at[axis]];
                                    *highest = highest.max(height as f32);
                                }
                            }
                        }
                    }
                    profiles.each_ref().map(|profile| upper_hull(profile))
                })
                .collect();
            let along = |axis: usize| HullLevel::new(nodes[0], hulls.iter().map(move |hull| &hull[axis]));
            levels.push([along(0), along(1)]);
        }
        Self { levels }
    }

    /// Returns the hull along an axis of the falling cells around a node's vertices; `None` on low
    /// levels.
    #[inline(always)]
    pub fn hull(&self, level: u32, at: [u32; 2], axis: usize) -> Option<&[ProfileVertex]> {
        self.levels.get(level.checked_sub(FIRST)? as usize)?[axis].hull(at)
    }
}

/// Returns the heights `h00 h10 h01 h11` of a cell, inside of the map or not.
fn cell(field: &Field, [i, j]: [i64; 2]) -> [f64; 4] {
    let ([h00, h10], [h01, h11]) = (field.row([i, j]), field.row([i, j + 1]));
    [h00, h10, h01, h11]
}

/// Returns the vertices of the upper hull of heights one apart, starting at -1. The hull is empty
/// where nothing falls.
fn upper_hull(profile: &[f32]) -> Vec<ProfileVertex> {
    let mut hull = Vec::new();
    for (place, &height) in profile.iter().enumerate().filter(|(_, height)| **height >= 0.0) {
        let next = ProfileVertex { place: place as i32 - 1, height };
        push_to_hull(&mut hull, next, 0.0, |vertex| [vertex.place.into(), vertex.height.into()]);
    }
    hull
}

#[cfg(test)]
mod tests {
    use relief_core::Wrap;
    use relief_testing::maps;

    use super::*;

    /// Height of a hull at a place; none beside it.
    fn height(hull: &[ProfileVertex], place: i32) -> Option<f64> {
        let pair = hull.windows(2).find(|pair| (pair[0].place..=pair[1].place).contains(&place));
        let only = hull.iter().find(|vertex| vertex.place == place).map(|vertex| f64::from(vertex.height));
        only.or_else(|| {
            let [a, b] = *pair? else { return None };
            let part = f64::from(place - a.place) / f64::from(b.place - a.place);
            Some(f64::from(a.height) + f64::from(b.height - a.height) * part)
        })
    }

    #[test]
    fn what_falls_is_nowhere_above_the_hulls_of_its_node() {
        for named in maps::ALL {
            for wrap in Wrap::ALL {
                let map = named.build(wrap);
                let (hulls, field) = (FallingHulls::new(&map), Field::new(&map));
                for (j, i) in (0..map.height()).flat_map(|j| (0..map.width()).map(move |i| (j, i))) {
                    let cells =
                        crate::cone_search::RelativeCell::around([0, 0], &field.around([i.into(), j.into()]));
                    for cell in cells.iter().filter(|cell| of_cell(cell.heights) != 0) {
                        for level in FIRST..=map.width().max(map.height()).ilog2() {
                            let at = [i >> level, j >> level];
                            for (corner, axis) in (0..4).flat_map(|corner| [(corner, 0), (corner, 1)]) {
                                let by = [corner as i64 % 2, corner as i64 / 2][axis] + cell.offset[axis];
                                let place = i64::from([i, j][axis]) + by - i64::from(at[axis] << level);
                                let hull = hulls.hull(level, at, axis).expect("a level with hulls");
                                let highest = height(hull, place as i32).expect("a place of the hull");
                                let found = cell.heights[corner];
                                assert!(highest >= found - 1e-15, "{} {wrap} {level} {at:?}", named.name);
                            }
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn of_level_ground_only_the_rim_is_in_a_hull() {
        let shelf = |i: u32, _| if (32..84).contains(&i) { 0.75 } else { 0.0 };
        let map = HeightMap::from_fn(128, 128, Wrap::Clamp, shelf).expect("a valid map");
        let hulls = FallingHulls::new(&map);
        let places = |at: [u32; 2]| -> Vec<(i32, f32)> {
            let hull = hulls.hull(5, at, 0).expect("a level with hulls");
            hull.iter().map(|vertex| (vertex.place, vertex.height)).collect()
        };
        assert_eq!(places([1, 1]), [(-1, 0.0), (0, 0.75)]);
        assert_eq!(places([2, 1]), [(19, 0.75), (20, 0.0)]);
        assert_eq!(places([3, 1]), []);
    }
}
