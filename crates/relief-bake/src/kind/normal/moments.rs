//! Slopes filtered for minification: mean and central second moments.
//!
//! Olano and Baker 2010, *LEAN Mapping*, and Dupuy et al. 2013, *Linear Efficient Antialiased
//! Displacement and Reflectance Mapping* (LEADR), store the raw second moments and subtract the
//! squared mean when shading. Here moments are centred at every level already, because in 16 bits
//! that subtraction cancels.

use rayon::prelude::*;
use relief_core::{Cancelled, Watch};

use super::slopes::Slopes;

/// Rows that a thread filters together.
const ROWS: usize = 8;

/// Mip level of slopes.
#[derive(Clone, Debug, PartialEq)]
pub struct Moments {
    /// Columns and rows.
    pub size: [usize; 2],
    /// Mean slope along `u` and `v` over each texel.
    pub mean: [Vec<f32>; 2],
    /// Central second moments of the slope over each texel: `uu`, `uv` and `vv`.
    pub second: [Vec<f32>; 3],
}

/// Returns columns and rows of the next mip level.
pub(super) fn next_size(size: [usize; 2]) -> [usize; 2] {
    size.map(|side| (side / 2).max(1))
}

impl Moments {
    /// Computes mip level 1 of a map of `size`: the slopes at its texel centres, averaged.
    ///
    /// # Errors
    ///
    /// When the bake is cancelled.
    pub fn of_slopes(slopes: &Slopes, size: [usize; 2], watch: &Watch) -> Result<Self, Cancelled> {
        reduced(size, watch, |row, [u, v, ..]| slopes.row(row, u, v))
    }

    /// Computes the next mip level: half the size, rounded down, at least 1. Where a side is odd,
    /// texels of this level are shared between two of the next in proportion to the area. Means and
    /// moments over the map thus stay the same.
    ///
    /// # Errors
    ///
    /// When the bake is cancelled.
    pub fn halved(&self, watch: &Watch) -> Result<Self, Cancelled> {
        let planes = [&self.mean[0], &self.mean[1], &self.second[0], &self.second[1], &self.second[2]];
        reduced(self.size, watch, |row, lines| {
            let first = row * self.size[0];
            for (line, plane) in lines.into_iter().zip(planes) {
                line.copy_from_slice(&plane[first..first + self.size[0]]);
            }
        })
    }
}

/// Shares of a level's texels along a side.
struct Shares {
    /// Texels, from the first, that a texel of the next level covers.
    count: usize,
    /// First texel that each texel of the next level covers, and the shares of the covered texels.
    of: Vec<(usize, [f32; 3])>,
}

impl Shares {
    /// Computes the shares from a side of `from` texels to the next level's.
    fn new(from: usize, to: usize) -> Self {
        if from == 1 {
            return Self { count: 1, of: vec![(0, [1.0, 0.0, 0.0])] };
        }
        let covered = from as f32 / to as f32;
        // With an odd side a texel covers 2 + 1/to, beginning `at / to` into its first.
        let odd = (from % 2) as f32 / to as f32;
        let of = |at: usize| {
            (2 * at, [(1.0 - at as f32 * odd) / covered, 1.0 / covered, (at + 1) as f32 * odd / covered])
        };
        Self { count: 2 + from % 2, of: (0..to).map(of).collect() }
    }
}

/// Computes the level after one of size `from` whose rows `row_of` fills in: mean `u`, `v`, and
/// moments `uu`, `uv`, `vv`, which are 0 unless it sets them.
fn reduced(
    from: [usize; 2],
    watch: &Watch,
    row_of: impl Fn(usize, [&mut [f32]; 5]) + Sync,
) -> Result<Moments, Cancelled> {
    let size = next_size(from);
    let plane = || vec![0.0f32; size[0] * size[1]];
    let (mut mean, mut second) = ([plane(), plane()], [plane(), plane(), plane()]);
    let chunk = size[0] * ROWS;
    let blocks = size[1].div_ceil(ROWS) as f32;
    let [across, down] = [0, 1].map(|axis| Shares::new(from[axis], size[axis]));
    let [mean_u, mean_v] = &mut mean;
    let [uu, uv, vv] = &mut second;
    let means = mean_u.par_chunks_mut(chunk).zip(mean_v.par_chunks_mut(chunk));
    let seconds = uu.par_chunks_mut(chunk).zip(uv.par_chunks_mut(chunk)).zip(vv.par_chunks_mut(chunk));
    means.zip(seconds).enumerate().try_for_each_init(
        || vec![0.0f32; 15 * from[0]],
        |lines, (block, ((mean_u, mean_v), ((uu, uv), vv)))| {
            watch.at(block as f32 / blocks)?;
            for row in 0..mean_u.len() / size[0] {
                let (first, down_shares) = down.of[block * ROWS + row];
                for (tap, lines) in lines.chunks_mut(5 * from[0]).take(down.count).enumerate() {
                    let (u, lines) = lines.split_at_mut(from[0]);
                    let (v, lines) = lines.split_at_mut(from[0]);
                    let (uu, lines) = lines.split_at_mut(from[0]);
                    let (uv, vv) = lines.split_at_mut(from[0]);
                    row_of(first + tap, [u, v, uu, uv, vv]);
                }
                let line = |tap: usize, part: usize| &lines[(5 * tap + part) * from[0]..][..from[0]];
                let places = || across.of.iter().zip(row * size[0]..);
                for (tap, down) in down_shares.iter().take(down.count).enumerate() {
                    let (u, v) = (line(tap, 0), line(tap, 1));
                    for ((first, shares), at) in places() {
                        for (i, share) in shares.iter().take(across.count).enumerate() {
                            mean_u[at] += down * share * u[first + i];
                            mean_v[at] += down * share * v[first + i];
                        }
                    }
                }
                for (tap, down) in down_shares.iter().take(down.count).enumerate() {
                    let [u, v, finer_uu, finer_uv, finer_vv] = [0, 1, 2, 3, 4].map(|part| line(tap, part));
                    for ((first, shares), at) in places() {
                        let [mut sum_uu, mut sum_uv, mut sum_vv] = [uu[at], uv[at], vv[at]];
                        for (i, share) in shares.iter().take(across.count).enumerate() {
                            let (share, texel) = (down * share, first + i);
                            let (du, dv) = (u[texel] - mean_u[at], v[texel] - mean_v[at]);
                            sum_uu += share * (finer_uu[texel] + du * du);
                            sum_uv += share * (finer_uv[texel] + du * dv);
                            sum_vv += share * (finer_vv[texel] + dv * dv);
                        }
                        [uu[at], uv[at], vv[at]] = [sum_uu, sum_uv, sum_vv];
                    }
                }
            }
            Ok(())
        },
    )?;
    Ok(Moments { size, mean, second })
}
