//! In which directions the surface falls, so that ground that only rises away from an apex is passed over.
//!
//! Directions are told apart by octants, in texels. The gradients of a patch lie in a box; their product with
//! a direction of an octant is least at a corner of the box and on one of the two rays that bound the octant.
//! So the patch falls in the octant if it does along one of these rays.

use rayon::prelude::*;
use relief_core::HeightMap;

use crate::cone_search::{Field, Seen};

/// What may be lost to rounding, in parts of the gradient.
const ROUNDING: f64 = 1e-12;

/// For each vertex the octants, a bit each, in which a cell falls whose highest corner it is; and level by
/// level the same for squares of vertices.
pub(super) struct Directions {
    levels: Vec<OctantLevel>,
}

struct OctantLevel {
    octants: Vec<u8>,
    width: usize,
}

impl Directions {
    /// Those of a map.
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
        Self { levels }
    }

    /// Whether something may fall around the vertices of a node, from `from` to `to` texels away.
    #[inline(always)]
    pub fn may_fall(&self, level: u32, [column, row]: [u32; 2], from: [f32; 2], to: [f32; 2]) -> bool {
        let level = &self.levels[level as usize];
        level.octants[row as usize * level.width + column as usize] & octants_of(from, to) != 0
    }
}

impl OctantLevel {
    /// The level of half the size, rounded up; `None` above a single node.
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

/// The octants in which a cell falls of which the middle one of 3 by 3 vertices is the highest corner.
fn of_vertex(around: &[[f64; 3]; 3]) -> u8 {
    let highest = around[1][1];
    let cells = Seen::around([0, 0], around);
    let cells = cells.iter().filter(|seen| seen.heights.iter().all(|&height| height <= highest));
    cells.map(|seen| of_cell(seen.heights)).fold(0, |all, one| all | one)
}

/// The octants in which a cell falls, or is level, at some point.
fn of_cell([h00, h10, h01, h11]: [f64; 4]) -> u8 {
    let (above, below, left, right) = (h10 - h00, h11 - h01, h01 - h00, h11 - h10);
    let (x0, x1) = (above.min(below), above.max(below));
    let (y0, y1) = (left.min(right), left.max(right));
    let level = ROUNDING * (x0.abs().max(x1.abs()) + y0.abs().max(y1.abs()));
    // Along the rays from that of the first axis on, towards the second one.
    let least = [x0, x0 + y0, y0, y0 - x1, -x1, -x1 - y1, -y1, x0 - y1];
    let rays = (0..8).fold(0u8, |rays, ray| rays | u8::from(least[ray] <= level) << ray);
    rays | rays.rotate_right(1)
}

/// The octants that hold something of a box.
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
    use relief_tests::rng::Rng;

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
                if along_x * x + along_y * y <= 0.0 {
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
    fn level_ground_counts_as_falling_and_a_ramp_falls_only_back() {
        assert_eq!(of_cell([0.5; 4]), 0xff);
        // It rises along the first axis.
        assert_eq!(of_cell([0.0, 1.0, 0.0, 1.0]), 0b0111_1110);
    }
}
