//! Filling of holes, smoothly from their surroundings.
//!
//! The fill solves Laplace's equation over the holes: each filled texel is the mean of its four
//! neighbours, with the valid texels around as boundary. It creates no new extremes and no creases.
//! The solver is cascadic multigrid (Bornemann and Deuflhard, "The cascadic multigrid method for
//! elliptic problems", 1996). It builds a pyramid of means of valid texels. From coarse to fine it
//! then interpolates bilinearly and applies Gauss-Seidel sweeps, more of them on levels where they
//! are cheap. The order of texels is fixed, so the result has the same bits every time. It takes
//! 2.7 bytes a texel besides the map.

use relief_core::Wrap;

/// Sweeps of the finest level. Each coarser level, of a quarter of the texels, has twice as many,
/// up to [`MOST_DOUBLINGS`]. Fewer leave the interpolation's grid visible in large holes; more cost
/// time.
const SWEEPS: usize = 8;

/// Greatest number of times that [`SWEEPS`] is doubled.
const MOST_DOUBLINGS: usize = 6;

struct FillLevel {
    width: u32,
    height: u32,
    values: Vec<f32>,
}

impl FillLevel {
    fn at(&self, column: i64, row: i64, wrap: Wrap) -> f32 {
        let (i, j) = (wrap.index(column, self.width), wrap.index(row, self.height));
        self.values[j as usize * self.width as usize + i as usize]
    }

    /// Returns the next coarser level: means of the valid texels of each 2x2, NaN if there are
    /// none.
    fn coarser(&self) -> FillLevel {
        let (width, height) = (self.width.div_ceil(2), self.height.div_ceil(2));
        let mut values = Vec::with_capacity(width as usize * height as usize);
        for row in 0..height {
            for column in 0..width {
                let (mut sum, mut count) = (0.0, 0.0f64);
                for (dx, dy) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
                    let (x, y) = (2 * column + dx, 2 * row + dy);
                    if x < self.width && y < self.height {
                        let value = self.values[y as usize * self.width as usize + x as usize];
                        if !value.is_nan() {
                            sum += f64::from(value);
                            count += 1.0;
                        }
                    }
                }
                values.push((sum / count) as f32);
            }
        }
        FillLevel { width, height, values }
    }

    fn holes(&self) -> bool {
        self.values.iter().any(|value| value.is_nan())
    }

    /// Fills the holes of this level from the coarser one, which has none.
    fn fill(&mut self, coarser: &FillLevel, sweeps: usize, wrap: Wrap) {
        let is_hole: Vec<bool> = self.values.iter().map(|value| value.is_nan()).collect();
        let row_start = |row: u32, width: u32| row as usize * width as usize;
        for row in 0..self.height {
            for column in 0..self.width {
                let at = row_start(row, self.width) + column as usize;
                if is_hole[at] {
                    self.values[at] = interpolate(coarser, column, row, wrap);
                }
            }
        }
        for sweep in 0..sweeps {
            for step in 0..self.height {
                // Every second sweep goes from bottom to top, so that values travel both ways.
                let row = if sweep % 2 == 0 { step } else { self.height - 1 - step };
                let start = row_start(row, self.width);
                if !is_hole[start..start + self.width as usize].contains(&true) {
                    continue;
                }
                for column in 0..self.width {
                    if is_hole[start + column as usize] {
                        let (x, y) = (i64::from(column), i64::from(row));
                        let neighbours = [(x - 1, y), (x + 1, y), (x, y - 1), (x, y + 1)];
                        // A quarter of each, not of the sum: the sum of the largest floats is infinite.
                        let mean = neighbours.iter().map(|&(x, y)| 0.25 * self.at(x, y, wrap)).sum();
                        self.values[start + column as usize] = mean;
                    }
                }
            }
        }
    }
}

/// Samples the coarser level bilinearly at the centre of a texel of the finer one.
fn interpolate(coarser: &FillLevel, column: u32, row: u32, wrap: Wrap) -> f32 {
    // The finer texel's centre lies a quarter of a coarse texel before or behind the centre of the coarse
    // texel over it.
    let near = [i64::from(column / 2), i64::from(row / 2)];
    let far = [near[0] + 2 * i64::from(column % 2) - 1, near[1] + 2 * i64::from(row % 2) - 1];
    0.5625 * coarser.at(near[0], near[1], wrap)
        + 0.1875 * coarser.at(far[0], near[1], wrap)
        + 0.1875 * coarser.at(near[0], far[1], wrap)
        + 0.0625 * coarser.at(far[0], far[1], wrap)
}

/// Fills the NaN of a map with at least one other value. `wrap` gives the neighbours across the
/// edges.
pub(crate) fn fill_holes(width: u32, height: u32, values: &mut Vec<f32>, wrap: Wrap) {
    let mut levels = vec![FillLevel { width, height, values: std::mem::take(values) }];
    while let Some(last) = levels.last()
        && last.holes()
        && last.values.len() > 1
    {
        let coarser = last.coarser();
        levels.push(coarser);
    }
    let mut filled = levels.pop();
    while let (Some(coarser), Some(mut finer)) = (filled.take(), levels.pop()) {
        finer.fill(&coarser, SWEEPS << levels.len().min(MOST_DOUBLINGS), wrap);
        filled = Some(finer);
        if levels.is_empty() {
            break;
        }
    }
    if let Some(finest) = filled {
        *values = finest.values;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn filled(width: u32, height: u32, wrap: Wrap, value: impl Fn(u32, u32) -> f32) -> Vec<f32> {
        let mut values =
            (0..height).flat_map(|j| (0..width).map(move |i| (i, j))).map(|(i, j)| value(i, j)).collect();
        fill_holes(width, height, &mut values, wrap);
        values
    }

    #[test]
    fn a_hole_in_a_plane_is_filled_with_the_plane() {
        let plane = |i: u32, j: u32| 0.25 * i as f32 + 0.5 * j as f32;
        let hole = |i: u32, j: u32| (20..41).contains(&i) && (11..37).contains(&j);
        let values = filled(61, 50, Wrap::Clamp, |i, j| if hole(i, j) { f32::NAN } else { plane(i, j) });
        for j in 0..50 {
            for i in 0..61 {
                let error = (values[(j * 61 + i) as usize] - plane(i, j)).abs();
                assert!(if hole(i, j) { error < 0.3 } else { error == 0.0 }, "({i}, {j}): {error}");
            }
        }
    }

    #[test]
    fn a_fill_has_no_new_extremes_and_is_the_same_every_time() {
        let value = |i: u32, j: u32| {
            let noise = (i * 2_654_435_761u32.wrapping_add(j * 40_503)) >> 16 & 0xff;
            if noise < 200 { f32::NAN } else { noise as f32 }
        };
        for wrap in Wrap::ALL {
            let values = filled(33, 17, wrap, value);
            assert!(values.iter().all(|value| (200.0..=255.0).contains(value)), "{wrap}");
            assert_eq!(values, filled(33, 17, wrap, value));
        }
    }

    #[test]
    fn a_single_value_fills_everything() {
        for (width, height) in [(1, 1), (1, 9), (16, 1), (7, 5)] {
            let values =
                filled(width, height, Wrap::Repeat, |i, j| if (i, j) == (0, 0) { 3.5 } else { f32::NAN });
            assert!(values.iter().all(|&value| value == 3.5), "{width}x{height}: {values:?}");
        }
    }

    #[test]
    fn neighbours_across_the_edge_count_where_the_map_is_tiled() {
        // The left half is unknown, but for the columns next to it: 0 on its right, 1 beyond the left edge.
        let value = |i: u32, _: u32| match i {
            0..16 => f32::NAN,
            31 => 1.0,
            _ => 0.0,
        };
        let tiled = filled(32, 8, Wrap::Repeat, value);
        let clamped = filled(32, 8, Wrap::Clamp, value);
        assert!(tiled[0] > 0.8 && tiled[15] < 0.2, "{} {}", tiled[0], tiled[15]);
        assert!(clamped[0] < 0.01);
    }
}
