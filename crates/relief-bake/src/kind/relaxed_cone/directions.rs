//! Directions in which the surface falls. Ground that only rises away from an apex is skipped by
//! them.
//!
//! Directions are grouped into octants, in texels. The gradients of a patch lie in a box. Their
//! product with a direction of an octant is least at a corner of the box and on one of the two rays
//! that bound the octant. So the patch falls in the octant if it does along one of these rays.
//!
//! On an inclined plane octants are too coarse: half of an octant beside a contour rises, and
//! nothing in it falls. So squares of vertices have boxes of gradients, too, from the level at
//! which these take little memory.

use rayon::prelude::*;
use relief_core::HeightMap;

use crate::cone_search::{Field, RelativeCell};

/// Rounding, as a part of the gradient.
const ROUNDING: f64 = 1e-12;

/// Rounding in `f32`, as a part of the gradient.
const ROUNDING_F32: f32 = 1e-6;

/// First level that has boxes of gradients.
const FIRST: u32 = 3;

/// For each vertex, the octants, a bit each, in which a cell falls whose highest corner it is.
/// Coarser levels hold the same for squares of vertices.
pub(super) struct Directions {
    levels: Vec<OctantLevel>,
    /// Boxes of gradients of the same cells, from level [`FIRST`] on.
    boxes: Vec<BoxLevel>,
}

/// Least and greatest slopes along both axes, in heights a texel.
#[derive(Clone, Copy)]
struct Gradients {
    least: [f32; 2],
    most: [f32; 2],
}

struct BoxLevel {
    boxes: Vec<Gradients>,
    width: usize,
}

struct OctantLevel {
    octants: Vec<u8>,
    width: usize,
}

impl Directions {
    /// Builds the directions of a map.
    pub fn new(map: &HeightMap) -> Self {
        let (field, width) = (Field::new(map), map.width() as usize);
        let mut octants = vec![0; map.texels().len()];
        octants.par_chunks_mut(width).enumerate().for_each(|(row, octants)| {
            for (column, octants) in octants.iter_mut().enumerate() {
                *octants = of_vertex(&field.around([column as i64, row as i64]));
            }
        });
        let mut levels = vec![OctantLevel { octants, width }];
        while let Some(halved) = levels.last().and_then(OctantLevel::halved) {
            levels.push(halved);
        }
        let mut boxes: Vec<BoxLevel> = Vec::new();
        for level in FIRST..levels.len() as u32 {
            let halved = boxes.last().map(BoxLevel::halved);
            boxes.push(halved.unwrap_or_else(|| BoxLevel::new(&field, level)));
        }
        Self { levels, boxes }
    }

    /// Returns whether a cell may fall around the vertices of a node, from `from` to `to` texels
    /// away.
    #[inline(always)]
    pub fn may_fall(&self, level: u32, [column, row]: [u32; 2], from: [f32; 2], to: [f32; 2]) -> bool {
        let octants = &self.levels[level as usize];
        if octants.octants[row as usize * octants.width + column as usize] & octants_of(from, to) == 0 {
            return false;
        }
        let Some(boxes) = level.checked_sub(FIRST).map(|level| &self.boxes[level as usize]) else {
            return true;
        };
        boxes.boxes[row as usize * boxes.width + column as usize].may_fall(from, to)
    }
}

impl Gradients {
    const NONE: Self = Self { least: [f32::INFINITY; 2], most: [f32::NEG_INFINITY; 2] };

    /// Adds the gradients of a cell, rounded outward.
    fn with([h00, h10, h01, h11]: [f64; 4], mut all: Self) -> Self {
        for (axis, slopes) in [[h10 - h00, h11 - h01], [h01 - h00, h11 - h10]].into_iter().enumerate() {
            for slope in slopes {
                let near = slope as f32;
                let below = if f64::from(near) > slope { near.next_down() } else { near };
                let above = if f64::from(near) < slope { near.next_up() } else { near };
                all.least[axis] = if below < all.least[axis] { below } else { all.least[axis] };
                all.most[axis] = if above > all.most[axis] { above } else { all.most[axis] };
            }
        }
        all
    }

    fn and(self, other: Self) -> Self {
        Self {
            least: [0, 1].map(|axis| self.least[axis].min(other.least[axis])),
            most: [0, 1].map(|axis| self.most[axis].max(other.most[axis])),
        }
    }

    /// Returns whether the product with a place of a box may be negative. It is least at corners of
    /// both boxes.
    #[inline(always)]
    fn may_fall(&self, from: [f32; 2], to: [f32; 2]) -> bool {
        let least = |axis: usize| {
            let (least, most) = (self.least[axis], self.most[axis]);
            let (near, far) =
                (lesser(least * from[axis], most * from[axis]), lesser(least * to[axis], most * to[axis]));
            lesser(near, far)
        };
        let [x, y] = [least(0), least(1)];
        x + y < ROUNDING_F32 * (x.abs() + y.abs())
    }
}

/// Returns the lesser number, in the form that compiles to one instruction.
#[inline(always)]
fn lesser(x: f32, y: f32) -> f32 {
    if x < y { x } else { y }
}

impl BoxLevel {
    /// Builds the level of a map.
    fn new(field: &Field, level: u32) -> Self {
        let size = [field.map.width(), field.map.height()];
        let [width, height] = size.map(|side| side.div_ceil(1 << level) as usize);
        let mut boxes = vec![Gradients::NONE; width * height];
        boxes.par_chunks_mut(width).enumerate().for_each(|(row, boxes)| {
            let first = (row as u32) << level;
            for row in first..(first + (1 << level)).min(size[1]) {
                for column in 0..size[0] {
                    let around = field.around([i64::from(column), i64::from(row)]);
                    let gradients = &mut boxes[(column >> level) as usize];
                    *gradients =
                        highest_cells(&around).fold(*gradients, |all, cell| Gradients::with(cell, all));
                }
            }
        });
        Self { boxes, width }
    }

    /// Builds the level of half the size, rounded up.
    fn halved(&self) -> Self {
        let width = self.width.div_ceil(2);
        let rows = self.boxes.chunks(2 * self.width);
        let mut boxes = vec![Gradients::NONE; width * rows.len()];
        for (boxes, rows) in boxes.chunks_mut(width).zip(rows) {
            for row in rows.chunks(self.width) {
                for (node, pair) in boxes.iter_mut().zip(row.chunks(2)) {
                    *node = pair.iter().fold(*node, |all, one| all.and(*one));
                }
            }
        }
        Self { boxes, width }
    }
}

impl OctantLevel {
    /// Builds the level of half the size, rounded up; `None` above a single node.
    fn halved(&self) -> Option<Self> {
        if self.octants.len() == 1 {
            return None;
        }
        let width = self.width.div_ceil(2);
        let rows = self.octants.chunks(2 * self.width);
        let mut octants = vec![0; width * rows.len()];
        for (octants, rows) in octants.chunks_mut(width).zip(rows) {
            for row in rows.chunks(self.width) {
                for (node, pair) in octants.iter_mut().zip(row.chunks(2)) {
                    *node = pair.iter().fold(*node, |all, one| all | one);
                }
            }
        }
        Some(Self { octants, width })
    }
}

/// Returns the cells whose highest corner is the middle one of 3 by 3 vertices.
fn highest_cells(around: &[[f64; 3]; 3]) -> impl Iterator<Item = [f64; 4]> {
    let highest = around[1][1];
    let cells = RelativeCell::around([0, 0], around).map(|cell| cell.heights);
    cells.into_iter().filter(move |heights| heights.iter().all(|&height| height <= highest))
}

/// Returns the octants in which a cell falls whose highest corner is the middle one of 3 by 3
/// vertices.
fn of_vertex(around: &[[f64; 3]; 3]) -> u8 {
    highest_cells(around).map(of_cell).fold(0, |all, one| all | one)
}

/// Returns the octants in which a cell falls at some point. Where it is level it does not fall.
pub(super) fn of_cell([h00, h10, h01, h11]: [f64; 4]) -> u8 {
    let (above, below, left, right) = (h10 - h00, h11 - h01, h01 - h00, h11 - h10);
    let (x0, x1) = (above.min(below), above.max(below));
    let (y0, y1) = (left.min(right), left.max(right));
    // Along the rays from the first axis on, towards the second one.
    let least = [[x0, 0.0], [x0, y0], [0.0, y0], [-x1, y0], [-x1, 0.0], [-x1, -y1], [0.0, -y1], [x0, -y1]];
    let falls = |[x, y]: [f64; 2]| x + y < ROUNDING * (x.abs() + y.abs());
    let rays = (0..8).fold(0u8, |rays, ray| rays | u8::from(falls(least[ray])) << ray);
    rays | rays.rotate_right(1)
}

/// Returns the octants that hold something of a box.
#[inline(always)]
fn octants_of([x0, y0]: [f32; 2], [x1, y1]: [f32; 2]) -> u8 {
    let when = |is: bool, octants: u8| if is { octants } else { 0 };
    let axes = when(y1 >= 0.0, 0b0000_1001)
        | when(x1 >= 0.0, 0b0100_0010)
        | when(x0 <= 0.0, 0b0010_0100)
        | when(y0 <= 0.0, 0b1001_0000);
    let diagonals = when(x1 >= y0, 0b0010_0001)
        | when(y1 >= x0, 0b0001_0010)
        | when(x1 + y1 >= 0.0, 0b1000_0100)
        | when(x0 + y0 <= 0.0, 0b0100_1000);
    axes & diagonals
}

#[cfg(test)]
mod tests {
    use relief_core::Wrap;
    use relief_core::rng::Rng;

    use super::*;

    /// The octant of a direction, counted from the first axis towards the second.
    fn octant([x, y]: [f64; 2]) -> u32 {
        (y.atan2(x).rem_euclid(std::f64::consts::TAU) / std::f64::consts::FRAC_PI_4) as u32
    }

    #[test]
    fn octants_of_boxes_and_cells_are_those_that_sampling_finds() {
        let mut rng = Rng::new(8);
        let (mut of_cells, mut more) = (0, 0);
        for _ in 0..4000 {
            let heights = [0; 4].map(|_| rng.between(0.0, 1.0) + rng.pick(&[0.0, 3.0]));
            let [h00, h10, h01, h11] = heights;
            let found = of_cell(heights);
            let mut sampled = 0u8;
            for _ in 0..600 {
                let (u, v, angle) = (rng.unit(), rng.unit(), rng.between(0.0, std::f64::consts::TAU));
                let [x, y] = [angle.cos(), angle.sin()];
                let along_x = (h10 - h00) * (1.0 - v) + (h11 - h01) * v;
                let along_y = (h01 - h00) * (1.0 - u) + (h11 - h10) * u;
                if along_x * x + along_y * y < 0.0 {
                    sampled |= 1 << octant([x, y]);
                }
            }
            assert_eq!(sampled & !found, 0, "{heights:?}: {sampled:08b} sampled, {found:08b} found");
            of_cells += found.count_ones();
            more += (found & !sampled).count_ones();
        }
        assert!(more < of_cells / 20, "{more} of {of_cells} octants were not sampled");
        for _ in 0..4000 {
            let from = [rng.between(-4.0, 3.0), rng.between(-4.0, 3.0)];
            let to = from.map(|x| x + rng.between(0.0, 2.0));
            let found = octants_of(from.map(|x| x as f32), to.map(|x| x as f32));
            for _ in 0..40 {
                let place = [rng.between(from[0], to[0]), rng.between(from[1], to[1])];
                assert!(found >> octant(place) & 1 == 1, "{place:?} in {from:?} {to:?}: {found:08b}");
            }
        }
        assert_eq!(octants_of([2.0, 0.5], [3.0, 1.0]), 0b0000_0001);
        assert_eq!(octants_of([-3.0, -1.0], [-2.0, -0.5]), 0b0001_0000);
    }

    #[test]
    fn level_ground_does_not_fall_and_a_ramp_falls_only_back() {
        assert_eq!(of_cell([0.5; 4]), 0);
        // It rises along the first axis, and is level along the second.
        assert_eq!(of_cell([0.0, 1.0, 0.0, 1.0]), 0b0011_1100);
    }

    #[test]
    fn boxes_of_gradients_tell_rising_ground_beside_a_contour() {
        let plane = HeightMap::from_fn(64, 64, Wrap::Clamp, |i, j| (2 * i + j) as f32 / 256.0);
        let directions = Directions::new(&plane.expect("a valid map"));
        let may_fall = |from, to| directions.may_fall(FIRST, [3, 3], from, to);
        // The contour leads one column aside for two rows back.
        assert!(may_fall([8.0, -26.0], [16.0, -18.0]));
        assert!(!may_fall([18.0, -26.0], [26.0, -18.0]));
    }
}
