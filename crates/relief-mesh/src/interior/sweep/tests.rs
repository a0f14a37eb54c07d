//! Tests of the sweep: pieces tile their triangles.

use super::*;
use std::collections::HashMap;

type Triangle = [[i32; 3]; 3];

/// Totals over all pieces of the tested triangles.
#[derive(Debug, Default)]
struct Totals {
    pieces: u64,
    without_area: u64,
}

/// Test of the pieces of triangles, with reused buffers.
#[derive(Default)]
struct Checker {
    totals: Totals,
    cut: Cut,
    edges: HashMap<[u32; 2], u32>,
}

fn parts(voxels: Triangle) -> [u32; 3] {
    [0, 1, 2].map(|k| {
        let [a, b] = [voxels[k], voxels[(k + 1) % 3]];
        (0..3).map(|axis| a[axis].abs_diff(b[axis])).fold(1, u32::max)
    })
}

/// Returns the barycentric weights of a point.
fn weights(point: PatchPoint, parts: [u32; 3]) -> [f64; 3] {
    match point {
        PatchPoint::Border { side, at } => {
            let part = f64::from(at) / f64::from(parts[side as usize]);
            let mut weights = [0.0; 3];
            weights[side as usize] = 1.0 - part;
            weights[(side as usize + 1) % 3] = part;
            weights
        }
        PatchPoint::Inner { weights: [b, c], .. } => [1.0 - b - c, b, c],
    }
}

/// Returns the sides on which a point lies, as bits.
fn sides(point: PatchPoint) -> u32 {
    match point {
        PatchPoint::Border { side, at: 0 } => 1 << side | 1 << ((side + 2) % 3),
        PatchPoint::Border { side, .. } => 1 << side,
        PatchPoint::Inner { .. } => 0,
    }
}

impl Checker {
    /// Checks that the pieces tile the triangle, none is turned over or has three corners on a
    /// side, every point of the border is used, and all counts are right.
    fn check(&mut self, voxels: Triangle) {
        let parts = parts(voxels);
        let patch = Patch::Triangle { parts, voxels };
        let count = steps(&patch);
        self.cut.clear();
        cut(&patch, 0..count, 0, &mut self.cut);
        let Cut { points, triangles } = &self.cut;
        let border: u32 = parts.iter().sum();
        let number = |point: PatchPoint| match point {
            PatchPoint::Border { side, at } => parts[..side as usize].iter().sum::<u32>() + at,
            PatchPoint::Inner { number, .. } => border + number,
        };
        self.edges.clear();
        let (mut area, mut highest) = (0.0, 0);
        for corners in triangles {
            let corners = corners.map(|corner| points[corner as usize]);
            let [a, b, c] = corners.map(|corner| weights(corner, parts));
            let twice = (b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1]);
            assert!(twice >= -1e-12, "{voxels:?}: a piece of area {twice}");
            self.totals.without_area += u64::from(twice <= 1e-12);
            area += twice;
            let [a, b, c] = corners.map(sides);
            assert_eq!(a & b & c, 0, "{voxels:?}: three corners on a side");
            for k in 0..3 {
                let edge = [number(corners[k]), number(corners[(k + 1) % 3])];
                *self.edges.entry(edge).or_default() += 1;
                highest = highest.max(edge[0] + 1);
            }
        }
        self.totals.pieces += triangles.len() as u64;
        assert!((area - 1.0).abs() < 1e-9, "{voxels:?}: {area}");
        assert!(self.edges.values().all(|&count| count == 1), "{voxels:?}");
        let mut open: Vec<[u32; 2]> =
            self.edges.keys().filter(|[a, b]| !self.edges.contains_key(&[*b, *a])).copied().collect();
        open.sort_unstable();
        let around: Vec<[u32; 2]> = (0..border).map(|at| [at, (at + 1) % border]).collect();
        assert_eq!(open, around, "{voxels:?}");
        let mut counted = PatchCounts::default();
        for step in 0..count {
            let PatchCounts { points, triangles } = counts(&patch, step);
            counted.points += points;
            counted.triangles += triangles;
        }
        assert_eq!(counted.triangles, triangles.len() as u64, "{voxels:?}");
        assert_eq!(counted.points, u64::from(highest - border), "{voxels:?}");
    }
}

#[test]
fn all_triangles_of_a_small_lattice_are_tiled() {
    let mut checker = Checker::default();
    let corner = |code: i32| [code % 5, code / 5 % 5, code / 25];
    for code in 0..125 * 125 * 125 {
        let voxels = [corner(code % 125), corner(code / 125 % 125), corner(code / (125 * 125))];
        // Moved copies of a triangle are cut alike.
        let is_first = (0..3).all(|axis| voxels.iter().any(|corner| corner[axis] == 0));
        if is_first {
            checker.check(voxels);
        }
    }
    println!("{:?}", checker.totals);
    assert!(checker.totals.pieces > 1_000_000);
}

#[test]
fn a_million_triangles_are_tiled() {
    let mut state = 1_u64;
    let mut random = |below: u64| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((state >> 33) % below) as i32
    };
    let mut checker = Checker::default();
    for made in 0..1_000_000_usize {
        // Flat triangles, narrow ones, and a few large ones.
        let size = if made % 5000 == 0 { 300 } else { [3, 7, 12][made % 3] };
        let flat = [1, 2, size][made / 3 % 3];
        let mut corner = || [random(size), random(flat), random(size)];
        let mut voxels = [corner(), corner(), corner()];
        voxels.iter_mut().for_each(|corner| corner.rotate_left(made / 9 % 3));
        checker.check(voxels);
    }
    println!("{:?}", checker.totals);
    assert!(checker.totals.pieces > 10_000_000);
}

#[test]
fn steps_by_themselves_make_what_they_make_together() {
    for voxels in [[[0, 0, 0], [40, 3, 9], [12, 30, -20]], [[0, 0, 0], [2, 50, 1], [-9, 20, 3]]] {
        let patch = Patch::Triangle { parts: parts(voxels), voxels };
        let shown = |cut: &Cut| -> Vec<[PatchPoint; 3]> {
            cut.triangles.iter().map(|corners| corners.map(|at| cut.points[at as usize])).collect()
        };
        let (mut apart, mut first) = (Vec::new(), 0);
        for step in 0..steps(&patch) {
            let mut part = Cut::default();
            cut(&patch, step..step + 1, first, &mut part);
            first += counts(&patch, step).points as u32;
            apart.extend(shown(&part));
        }
        let mut whole = Cut::default();
        cut(&patch, 0..steps(&patch), 0, &mut whole);
        assert_eq!(apart, shown(&whole));
    }
}
