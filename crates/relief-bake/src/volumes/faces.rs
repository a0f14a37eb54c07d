//! Triangles on a lattice: those that meet their opposite are taken out, and open edges are counted.

use std::collections::HashMap;

use glam::DVec3;

/// Steps of the lattice along a tile and along its height. Corners lie on it, so that all tests of
/// inside and outside are exact.
pub(super) const STEPS: i64 = 1 << 24;

/// Corner on the lattice: `u`, `v` and height.
pub(super) type Corner = [i64; 3];

/// Triangles on the lattice, and the counts of their edges.
pub(super) struct Faces {
    pub triangles: Vec<[Corner; 3]>,
    /// Triangles taken out, as they lie on another one that looks the other way.
    pub doubled: u64,
    /// Edges with an odd number of triangles.
    pub open_edges: u64,
    /// Edges whose triangles do not run along it in turns.
    pub turned_edges: u64,
}

impl Faces {
    /// Rounds corners to the lattice. In a tile that `repeats`, places a whole number of tiles apart
    /// are the same: a face at the tile's edge that meets its opposite in the next tile is inside the
    /// solid, and no surface.
    pub fn new(triangles: &[[DVec3; 3]], repeats: bool) -> Self {
        let lattice = |at: DVec3| (at * STEPS as f64).round().to_array().map(|part| part as i64);
        let triangles: Vec<[Corner; 3]> = triangles.iter().map(|corners| corners.map(lattice)).collect();
        let (triangles, doubled) = without_doubled(triangles, repeats);
        let [open_edges, turned_edges] = edges(&triangles, repeats);
        Self { triangles, doubled, open_edges, turned_edges }
    }
}

/// Moves points by whole tiles, so that the least `u` and `v` lie in the first tile.
fn in_first_tile<const N: usize>(mut points: [Corner; N], repeats: bool) -> [Corner; N] {
    if repeats {
        for axis in 0..2 {
            let least = points.iter().map(|point| point[axis]).min().unwrap_or_default();
            points.iter_mut().for_each(|point| point[axis] -= least.div_euclid(STEPS) * STEPS);
        }
    }
    points
}

/// Sorts the corners of a triangle. True if their order was turned over.
fn sorted(mut corners: [Corner; 3]) -> ([Corner; 3], bool) {
    let mut turned = false;
    for (a, b) in [(0, 1), (1, 2), (0, 1)] {
        if corners[b] < corners[a] {
            corners.swap(a, b);
            turned = !turned;
        }
    }
    (corners, turned)
}

/// Takes out pairs of triangles with the same corners that look opposite ways.
fn without_doubled(triangles: Vec<[Corner; 3]>, repeats: bool) -> (Vec<[Corner; 3]>, u64) {
    let mut waiting: HashMap<[Corner; 3], [Vec<u32>; 2]> = HashMap::new();
    let mut is_out = vec![false; triangles.len()];
    for (number, corners) in triangles.iter().enumerate() {
        let (place, turned) = sorted(in_first_tile(*corners, repeats));
        let sides = waiting.entry(place).or_default();
        match sides[usize::from(!turned)].pop() {
            Some(opposite) => (is_out[opposite as usize], is_out[number]) = (true, true),
            // Meshes have at most 2^32 triangles.
            None => sides[usize::from(turned)].push(number as u32),
        }
    }
    let doubled = is_out.iter().filter(|is_out| **is_out).count() as u64;
    let left = triangles.into_iter().zip(is_out).filter(|(_, is_out)| !is_out).map(|(corners, _)| corners);
    (left.collect(), doubled)
}

/// Counts the edges with an odd number of triangles, and other edges along which not as many
/// triangles run one way as the other.
fn edges(triangles: &[[Corner; 3]], repeats: bool) -> [u64; 2] {
    // Triangles along the edge, and how many more run forward than back.
    let mut counts: HashMap<[Corner; 2], (u32, i32)> = HashMap::new();
    for [a, b, c] in triangles {
        for edge in [[a, b], [b, c], [c, a]].map(|ends| ends.map(|end| *end)) {
            let [from, to] = in_first_tile(edge, repeats);
            if from == to {
                continue;
            }
            let (count, forward) = counts.entry([from.min(to), from.max(to)]).or_default();
            *count += 1;
            *forward += if from < to { 1 } else { -1 };
        }
    }
    let open = counts.values().filter(|(count, _)| count % 2 == 1).count();
    let turned = counts.values().filter(|(count, forward)| count % 2 == 0 && *forward != 0).count();
    [open as u64, turned as u64]
}
