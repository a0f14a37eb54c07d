//! Crossings of vertical lines with triangles, by exact tests.
//!
//! Corners lie on a lattice and lines at the centres of voxels. So all numbers of the test are
//! integers, and its signs are exact. A line through an edge or a corner is moved by less than any
//! number along `u`; the two triangles of an edge then see it on the same side. So a closed mesh is
//! always left as often as it is entered.

use super::faces::{Corner, STEPS};

/// A crossing of a line with a triangle: its height in lattice steps, and 1 or -1 by the triangle's
/// side that is above.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Crossing {
    pub height: f64,
    pub side: i32,
}

/// A vertical line through voxel `(column, row)` of a grid, moved by whole `tiles`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Line {
    at: [i128; 2],
    /// Twice the columns and rows: factors that make the line's place whole.
    factor: [i128; 2],
}

impl Line {
    pub fn new(voxel: [u32; 2], size: [u32; 2], tiles: [i64; 2]) -> Self {
        let at = [0, 1].map(|axis| {
            let centre =
                2 * i128::from(voxel[axis]) + 1 - 2 * i128::from(tiles[axis]) * i128::from(size[axis]);
            centre * i128::from(STEPS)
        });
        Self { at, factor: size.map(|side| 2 * i128::from(side)) }
    }

    /// Twice the signed area of the line's place and an edge.
    fn area(&self, from: [i128; 2], to: [i128; 2]) -> i128 {
        (to[0] - from[0]) * (self.at[1] - from[1]) - (to[1] - from[1]) * (self.at[0] - from[0])
    }

    pub fn crossing(&self, triangle: &[Corner; 3]) -> Option<Crossing> {
        let corner = |corner: Corner| [0, 1].map(|axis| i128::from(corner[axis]) * self.factor[axis]);
        let [a, b, c] = triangle.map(corner);
        let areas = [self.area(b, c), self.area(c, a), self.area(a, b)];
        let mut side = 0;
        for (area, from, to) in [(areas[0], b, c), (areas[1], c, a), (areas[2], a, b)] {
            // The half-line from the place along u meets the edge.
            if from[1] <= self.at[1] && to[1] > self.at[1] {
                side += i32::from(area > 0);
            } else if to[1] <= self.at[1] && from[1] > self.at[1] {
                side -= i32::from(area < 0);
            }
        }
        if side == 0 {
            return None;
        }
        let whole = areas.iter().sum::<i128>() as f64;
        let heights = triangle.map(|corner| corner[2] as f64);
        let height = (0..3).map(|at| areas[at] as f64 / whole * heights[at]).sum::<f64>();
        let [least, greatest] = [
            heights.iter().copied().fold(f64::MAX, f64::min),
            heights.iter().copied().fold(f64::MIN, f64::max),
        ];
        Some(Crossing { height: height.clamp(least, greatest), side })
    }
}
