//! Upper hulls of the profiles of squares of texels, for searches on inclined ground.
//!
//! The profile of a square along an axis holds, for each column (or row), its highest texel. A
//! place before the first of them sees the profile under a greatest slope, with distances along the
//! axis alone. A vertex of the upper hull has this slope: a point on or below an edge is nowhere
//! steeper than both ends of the edge. Hulls have few vertices: some ten for hundreds of columns of
//! natural ground, and two on a plane.

use rayon::prelude::*;
use relief_core::HeightMap;

use crate::fixed_point::GRID;

/// First level of the pyramid that has hulls: on lower levels there are as few texels as vertices.
pub const FIRST: u32 = 3;

/// Largest side of a square with exact hulls: whole numbers of texels times multiples of one over
/// [`GRID`] are exact in `f64`.
const EXACT_SIDE: u32 = 1 << 12;

/// Distance by which a texel must be below an edge to be dropped where edges are rounded. It
/// exceeds the rounding of the slopes to the texel and to an end. No texel that may be steepest is
/// lost.
const SLACK: f64 = 1.0 / (1u64 << 48) as f64;

/// Vertex of a hull.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HullVertex {
    /// Highest texel of a column, or row, of the node.
    pub texel: [u32; 2],
    /// Height of the texel.
    pub height: f32,
}

/// Upper hulls of the nodes of a maximum pyramid of texels, from level [`FIRST`] on.
pub struct UpperHulls {
    levels: Vec<[HullLevel<HullVertex>; 2]>,
}

/// Hulls of a level's nodes, row by row.
pub struct HullLevel<V> {
    /// Vertices of all nodes, from the first column or row to the last.
    vertices: Vec<V>,
    /// Index of each node's first vertex; one more at the end.
    begins: Vec<usize>,
    width: usize,
}

impl<V: Copy> HullLevel<V> {
    /// Collects the hulls of nodes, `width` nodes a row.
    pub fn new<'a>(width: usize, hulls: impl Iterator<Item = &'a Vec<V>> + Clone) -> Self
    where
        V: 'a,
    {
        let mut vertices = Vec::with_capacity(hulls.clone().map(Vec::len).sum());
        let mut begins = vec![0];
        for hull in hulls {
            vertices.extend_from_slice(hull);
            begins.push(vertices.len());
        }
        Self { vertices, begins, width }
    }

    /// Returns the hull of a node.
    #[inline(always)]
    pub fn hull(&self, [column, row]: [u32; 2]) -> Option<&[V]> {
        let node = row as usize * self.width + column as usize;
        self.vertices.get(*self.begins.get(node)?..*self.begins.get(node + 1)?)
    }
}

/// Adds a vertex behind all others to an upper hull. `place` returns a vertex's position and
/// height. Vertices within `slack` below an edge stay.
pub fn push_to_hull<V: Copy>(hull: &mut Vec<V>, next: V, slack: f64, place: impl Fn(&V) -> [f64; 2]) {
    while let [.., before, last] = &hull[..] {
        let ([from, low], [middle, high], [to, height]) = (place(before), place(last), place(&next));
        if (high - low + slack) * (to - from) > (height - low) * (middle - from) {
            break;
        }
        hull.pop();
    }
    hull.push(next);
}

impl UpperHulls {
    /// Builds the hulls of a map.
    pub fn new(map: &HeightMap) -> Self {
        let is_fine = map.texels().par_iter().all(|&texel| (f64::from(texel) * GRID).fract() == 0.0);
        let size = [map.width(), map.height()];
        let top = size[0].max(size[1]).next_power_of_two().ilog2();
        let mut levels = Vec::new();
        let mut profiles = Profiles::new(map);
        for level in FIRST..=top {
            if level > FIRST {
                profiles = profiles.above();
            }
            let slack = if is_fine && 1 << level <= EXACT_SIDE { 0.0 } else { SLACK };
            levels.push([0, 1].map(|axis| profiles.hulls(axis, slack)));
        }
        Self { levels }
    }

    /// Returns the hull above a node along the columns (axis 0) or rows (1); `None` below
    /// [`FIRST`].
    #[inline(always)]
    pub fn hull(&self, level: u32, at: [u32; 2], axis: usize) -> Option<&[HullVertex]> {
        self.levels.get(level.checked_sub(FIRST)? as usize)?[axis].hull(at)
    }
}

/// Highest texel of a node's column or row.
#[derive(Clone, Copy)]
struct Highest {
    height: f32,
    /// Row in the map, or column.
    at: u32,
}

/// Profiles of all nodes of a level along both axes.
struct Profiles {
    /// Columns and rows of the map.
    size: [u32; 2],
    level: u32,
    /// Along the columns, a line of the map's width for each row of nodes. Along the rows, a line
    /// of the map's height for each column of nodes.
    lines: [Vec<Highest>; 2],
}

impl Profiles {
    /// Builds the profiles of the nodes of level [`FIRST`] of a map.
    fn new(map: &HeightMap) -> Self {
        let size = [map.width(), map.height()];
        let ([width, height], side) = (size.map(|side| side as usize), 1 << FIRST);
        let below = Highest { height: -1.0, at: 0 };
        let mut along_columns = vec![below; width * height.div_ceil(side)];
        let rows = map.texels().par_chunks(side * width);
        along_columns.par_chunks_mut(width).zip(rows).enumerate().for_each(|(node, (line, rows))| {
            for (row, texels) in rows.chunks_exact(width).enumerate() {
                let at = (node * side + row) as u32;
                for (highest, &height) in line.iter_mut().zip(texels) {
                    *highest = highest.or(Highest { height, at });
                }
            }
        });
        let mut along_rows = vec![below; width.div_ceil(side) * height];
        along_rows.par_chunks_mut(height).enumerate().for_each(|(node, line)| {
            let columns = side * node..(side * node + side).min(width);
            for (highest, row) in line.iter_mut().zip(map.texels().chunks_exact(width)) {
                for column in columns.clone() {
                    *highest = highest.or(Highest { height: row[column], at: column as u32 });
                }
            }
        });
        Self { size, level: FIRST, lines: [along_columns, along_rows] }
    }

    /// Builds the profiles of the next level: the higher texels of each pair of lines.
    fn above(&self) -> Self {
        let lines = [0, 1].map(|axis| {
            let length = self.size[axis] as usize;
            let halved = |lines: &[Highest]| -> Vec<Highest> {
                let (first, second) = lines.split_at(length);
                if second.is_empty() {
                    return first.to_vec();
                }
                first.iter().zip(second).map(|(one, other)| one.or(*other)).collect()
            };
            self.lines[axis].par_chunks(2 * length).flat_map_iter(halved).collect()
        });
        Self { size: self.size, level: self.level + 1, lines }
    }

    /// Builds the hulls of all nodes along an axis.
    fn hulls(&self, axis: usize, slack: f64) -> HullLevel<HullVertex> {
        let [width, height] = self.size.map(|side| side.div_ceil(1 << self.level) as usize);
        let (length, side) = (self.size[axis] as usize, 1usize << self.level);
        let rows: Vec<Vec<Vec<HullVertex>>> = (0..height)
            .into_par_iter()
            .map(|row| {
                let hull = |column: usize| {
                    let [line, along] = if axis == 0 { [row, column] } else { [column, row] };
                    let places = along * side..(along * side + side).min(length);
                    upper_hull(&self.lines[axis][line * length..][places.clone()], places.start, axis, slack)
                };
                (0..width).map(hull).collect()
            })
            .collect();
        HullLevel::new(width, rows.iter().flatten())
    }
}

/// Returns the vertices of the upper hull of a profile that begins at a column, or row. Vertices
/// within `slack` below an edge stay.
fn upper_hull(profile: &[Highest], begin: usize, axis: usize, slack: f64) -> Vec<HullVertex> {
    let mut hull = Vec::new();
    for (place, highest) in profile.iter().enumerate() {
        let place = (begin + place) as u32;
        let texel = if axis == 0 { [place, highest.at] } else { [highest.at, place] };
        let next = HullVertex { texel, height: highest.height };
        push_to_hull(&mut hull, next, slack, |vertex| [vertex.texel[axis].into(), vertex.height.into()]);
    }
    hull
}

impl Highest {
    /// Returns the higher texel; of equal ones `self`.
    #[inline(always)]
    fn or(self, other: Self) -> Self {
        if other.height > self.height { other } else { self }
    }
}

#[cfg(test)]
mod tests {
    use relief_core::Wrap;
    use relief_testing::maps;

    use super::*;

    #[test]
    fn what_is_steepest_of_a_profile_is_a_vertex_of_its_hull() {
        let mut fewer = 0;
        for named in maps::ALL {
            let map = named.build(Wrap::Clamp);
            let hulls = UpperHulls::new(&map);
            let size = [map.width(), map.height()];
            for level in FIRST..=size[0].max(size[1]).ilog2() {
                let nodes = size.map(|side| side.div_ceil(1 << level));
                for (row, column, axis) in
                    (0..nodes[1]).flat_map(|j| (0..nodes[0]).flat_map(move |i| [(j, i, 0), (j, i, 1)]))
                {
                    let hull = hulls.hull(level, [column, row], axis).expect("a level with hulls");
                    let at = [column, row].map(|at| at << level);
                    let to = [0, 1].map(|axis| (at[axis] + (1 << level)).min(size[axis]));
                    let texels = (at[1]..to[1]).flat_map(|j| (at[0]..to[0]).map(move |i| [i, j]));
                    let texels: Vec<_> = texels
                        .map(|texel| (texel[axis], map.texel(texel[0].into(), texel[1].into())))
                        .collect();
                    for vertex in hull {
                        let [i, j] = vertex.texel.map(i64::from);
                        assert_eq!(map.texel(i, j), vertex.height);
                    }
                    for (eye, low) in [(-1, 0.0), (-1, 0.5), (-40, 0.25), (1, 0.0), (1, 0.5), (40, 0.25)] {
                        let from = f64::from(if eye < 0 { at[axis] } else { to[axis] - 1 }) + f64::from(eye);
                        let slope = |place: u32, height: f32| {
                            (f64::from(height) - low) / (f64::from(place) - from).abs()
                        };
                        let steepest =
                            texels.iter().map(|&(place, height)| slope(place, height)).fold(-9.0, f64::max);
                        let found = hull
                            .iter()
                            .map(|vertex| slope(vertex.texel[axis], vertex.height))
                            .fold(-9.0, f64::max);
                        assert_eq!(found, steepest, "{} {level} {column} {row} {axis} {eye}", named.name);
                    }
                    fewer += usize::from(hull.len() < (to[axis] - at[axis]) as usize);
                }
            }
        }
        assert!(fewer > 1000, "{fewer} hulls have fewer vertices than their profiles places");
    }

    #[test]
    fn the_hull_of_a_plane_has_two_vertices_and_touches_the_higher_side() {
        let plane = HeightMap::from_fn(64, 64, Wrap::Clamp, |i, j| (3 * i + 2 * j) as f32 / 512.0);
        let hulls = UpperHulls::new(&plane.expect("a valid map"));
        let ends =
            |axis| hulls.hull(4, [1, 2], axis).map(|hull| hull.iter().map(|vertex| vertex.texel).collect());
        assert_eq!(ends(0), Some(vec![[16, 47], [31, 47]]));
        assert_eq!(ends(1), Some(vec![[31, 32], [31, 47]]));
        assert!(hulls.hull(2, [0, 0], 0).is_none());
    }
}
