//! Planes above squares of texels, for searches on inclined ground.
//!
//! A search skips a node of the maximum pyramid by placing the node's highest texel at its nearest
//! one. On inclined ground that bound is never low enough: the slope to every texel uphill is the
//! same. No texel matters, but all are visited. A plane above the node has an inclination, too.
//! From a place below the plane, no point below the plane is seen under a steeper slope than the
//! plane's own.
//!
//! Any inclination will do, as the plane is raised until it is above all texels. It is taken from
//! the upper hulls of the highest texels of the node's columns, and of its rows. The slope of each
//! hull's longest edge is used. On a plane this is its own slope. On terraces it is the slope of
//! the plane through their edges.

use rayon::prelude::*;
use relief_core::{HeightMap, Wrap};

use crate::fixed_point::{EXACT, GRID, floor};
use crate::upper_hulls::push_to_hull;

/// First level of the pyramid that has planes. On lower levels a search meets few nodes, and planes
/// would take more memory than the map.
pub const FIRST: u32 = 3;

/// Plane above a node.
#[derive(Clone, Copy, Debug)]
pub struct UpperPlane {
    /// Height at the first texel of the node.
    pub height: f64,
    /// Slopes along both axes, in heights a texel.
    pub along: [f32; 2],
}

/// Planes above the nodes of a maximum pyramid of texels, from level [`FIRST`] on.
///
/// Each plane is above all texels of its node and above the texels beside them. Over all cells
/// around the node's texels, the bilinear surface is nowhere above the plane. Of clamped and
/// mirrored maps, texels beyond the edges do not count. The surface there is as high as at the
/// edge, and in one direction nearer.
pub struct UpperPlanes {
    levels: Vec<PlaneLevel>,
}

struct PlaneLevel {
    planes: Vec<UpperPlane>,
    width: usize,
}

impl UpperPlanes {
    /// Builds the planes of a map.
    pub fn new(map: &HeightMap) -> Self {
        let is_fine = map.texels().par_iter().all(|&texel| floor(f64::from(texel)) == f64::from(texel));
        let mut levels = Vec::new();
        // There are as many levels as in the pyramid: the last one is a single node.
        let top = map.width().max(map.height()).next_power_of_two().ilog2();
        for level in FIRST..=top {
            let [width, height] = [map.width(), map.height()].map(|side| side.div_ceil(1 << level) as usize);
            let plane = |scratch: &mut Scratch, node: usize| {
                let at = [node % width, node / width].map(|place| place as u32);
                scratch.plane(map, level, at, is_fine)
            };
            let nodes = (0..width * height).into_par_iter();
            levels.push(PlaneLevel { planes: nodes.map_init(Scratch::default, plane).collect(), width });
        }
        Self { levels }
    }

    /// Returns the plane above a node; `None` below [`FIRST`].
    #[inline(always)]
    pub fn plane(&self, level: u32, [column, row]: [u32; 2]) -> Option<&UpperPlane> {
        let level = &self.levels.get(level.checked_sub(FIRST)? as usize)?;
        level.planes.get(row as usize * level.width + column as usize)
    }
}

/// Buffers of a task.
#[derive(Default)]
struct Scratch {
    /// Highest texels of a node's columns and rows.
    highest: [Vec<f32>; 2],
    hull: Vec<usize>,
}

impl Scratch {
    /// Returns the plane above a node. `is_fine` says that all texels are multiples of one over
    /// [`GRID`].
    fn plane(&mut self, map: &HeightMap, level: u32, at: [u32; 2], is_fine: bool) -> UpperPlane {
        let size = [map.width(), map.height()].map(i64::from);
        let first = at.map(|at| i64::from(at) << level);
        let spans = [0, 1].map(|axis| {
            let (from, to) = (first[axis] - 1, (first[axis] + (1 << level)).min(size[axis]));
            if map.wrap() == Wrap::Repeat { [from, to] } else { [from.max(0), to.min(size[axis] - 1)] }
        });
        for (highest, [from, to]) in self.highest.iter_mut().zip(spans) {
            highest.clear();
            highest.resize((to - from) as usize + 1, 0.0);
        }
        let [columns, rows] = &mut self.highest;
        for (row, highest) in rows.iter_mut().enumerate() {
            each_texel(map, spans[0], spans[1][0] + row as i64, |column, texel| {
                columns[column] = if texel > columns[column] { texel } else { columns[column] };
                *highest = if texel > *highest { texel } else { *highest };
            });
        }
        let along = [0, 1].map(|axis| {
            let slope = longest_edge(&self.highest[axis], &mut self.hull);
            // The sum of all products stays exact.
            let slope =
                if slope.abs() * self.highest[axis].len() as f64 > 0.25 * EXACT { 0.0 } else { slope };
            ((f64::from(slope as f32) * GRID).round() / GRID) as f32
        });
        let [u, v] = along.map(f64::from);
        let mut height = f64::NEG_INFINITY;
        for row in spans[1][0]..=spans[1][1] {
            let beside = v * (row - first[1]) as f64;
            let zero = (spans[0][0] - first[0]) as f64;
            let mut highest = f64::NEG_INFINITY;
            each_texel(map, spans[0], row, |column, texel| {
                let above = f64::from(texel) - u * (zero + column as f64);
                highest = if above > highest { above } else { highest };
            });
            height = height.max(highest - beside);
        }
        let height = if is_fine { height } else { floor(height) + 2.0 / GRID };
        UpperPlane { height, along }
    }
}

/// Visits the texels of a row between two columns, which may be one beyond the map's edges.
#[inline(always)]
fn each_texel(map: &HeightMap, [from, to]: [i64; 2], row: i64, mut each: impl FnMut(usize, f32)) {
    let width = i64::from(map.width());
    let start = map.wrap().index(row, map.height()) as usize * width as usize;
    let line = &map.texels()[start..start + width as usize];
    let (inner, outer) = (from.max(0), to.min(width - 1));
    if from < inner {
        each(0, line[map.wrap().index(from, map.width()) as usize]);
    }
    let before = (inner - from) as usize;
    for (column, &texel) in line[inner as usize..=outer as usize].iter().enumerate() {
        each(before + column, texel);
    }
    if to > outer {
        each((to - from) as usize, line[map.wrap().index(to, map.width()) as usize]);
    }
}

/// Slope of the longest edge of the upper hull of heights one apart; 0 for a single height.
fn longest_edge(heights: &[f32], hull: &mut Vec<usize>) -> f64 {
    let height = |place: usize| f64::from(heights[place]);
    hull.clear();
    for place in 0..heights.len() {
        push_to_hull(hull, place, 0.0, |&place| [place as f64, height(place)]);
    }
    let mut longest = (0, 0.0);
    for edge in hull.windows(2) {
        let length = edge[1] - edge[0];
        if length > longest.0 {
            longest = (length, (height(edge[1]) - height(edge[0])) / length as f64);
        }
    }
    longest.1
}

#[cfg(test)]
mod tests {
    use relief_testing::maps;

    use super::*;

    #[test]
    fn planes_are_above_the_surface_around_their_texels_and_touch_it() {
        for named in maps::ALL {
            for wrap in Wrap::ALL {
                let map = named.build(wrap);
                let planes = UpperPlanes::new(&map);
                let size = [map.width(), map.height()].map(i64::from);
                for level in FIRST..=size[0].max(size[1]).ilog2() {
                    let nodes = size.map(|side| (side as u32).div_ceil(1 << level));
                    for at in (0..nodes[1]).flat_map(|row| (0..nodes[0]).map(move |column| [column, row])) {
                        let plane = planes.plane(level, at).expect("a level with planes");
                        let first = at.map(|at| i64::from(at) << level);
                        let mut room = f64::INFINITY;
                        for j in first[1] - 1..=(first[1] + (1 << level)).min(size[1]) {
                            for i in first[0] - 1..=(first[0] + (1 << level)).min(size[0]) {
                                let is_inside = (0..size[0]).contains(&i) && (0..size[1]).contains(&j);
                                if wrap == Wrap::Repeat || is_inside {
                                    let [x, y] = [i - first[0], j - first[1]].map(|by| by as f64);
                                    let [u, v] = plane.along.map(f64::from);
                                    room =
                                        room.min(plane.height + u * x + v * y - f64::from(map.texel(i, j)));
                                }
                            }
                        }
                        assert!((0.0..3e-12).contains(&room), "{} {wrap} {level} {at:?}: {room}", named.name);
                    }
                }
            }
        }
    }

    #[test]
    fn the_plane_of_a_plane_and_of_terraces_is_that_of_their_edges() {
        let plane = HeightMap::from_fn(64, 64, Wrap::Clamp, |i, j| (3 * i + 2 * j) as f32 / 512.0);
        let planes = UpperPlanes::new(&plane.expect("a valid map"));
        assert_eq!(planes.plane(4, [1, 2]).map(|plane| plane.along), Some([3.0 / 512.0, 2.0 / 512.0]));
        let terraces = HeightMap::from_fn(64, 64, Wrap::Clamp, |i, _| (i / 5) as f32 / 16.0);
        let planes = UpperPlanes::new(&terraces.expect("a valid map"));
        assert_eq!(planes.plane(5, [0, 0]).map(|plane| plane.along), Some([1.0f32 / 80.0, 0.0]));
        assert!(planes.plane(2, [0, 0]).is_none());
    }

    #[test]
    fn the_longest_edge_of_the_hull_is_found() {
        let mut hull = Vec::new();
        assert_eq!(longest_edge(&[0.5], &mut hull), 0.0);
        assert_eq!(longest_edge(&[0.0, 0.0, 1.0, 0.5, 0.0, 0.5], &mut hull), -1.0 / 6.0);
        assert_eq!(longest_edge(&[0.0, 0.25, 0.5, 0.75, 0.5], &mut hull), 0.25);
    }
}
