//! Slopes of a height map at its texel centres.

use relief_core::{HeightMap, Metric};

/// Slopes are cut off here, so that their squares fit `f32` in any metric.
const STEEPEST: f64 = 1e18;

/// How the slope at a texel centre is taken from the heights around it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Derivative {
    /// Half of the difference between the neighbours on both sides, as the shader of eq. 9 has it. It is the
    /// mean of the slopes of the four patches that meet there.
    #[default]
    Central,
    /// The slope of the mean of the four unit normals that the bilinear surface has there, one of each patch:
    /// steep patches count less.
    Patches,
}

/// The slopes of a map: metres up for a metre along `u`, and along `v`, which points down in the picture.
#[derive(Clone, Copy, Debug)]
pub struct Slopes<'a> {
    map: &'a HeightMap,
    derivative: Derivative,
    /// Slope for a difference of 1 between neighbours, along `u` and `v`.
    steepness: [f32; 2],
}

impl<'a> Slopes<'a> {
    /// The slopes of a map.
    pub fn new(map: &'a HeightMap, metric: Metric, derivative: Derivative) -> Self {
        let steepness = metric.texel_m(map).map(|texel| (metric.scale_m / texel).min(STEEPEST) as f32);
        Self { map, derivative, steepness }
    }

    /// The slopes along a row, which must be one of the map: each slice takes one value a column.
    pub fn row(&self, row: usize, along_u: &mut [f32], along_v: &mut [f32]) {
        let (width, height, wrap) = (self.map.width(), self.map.height(), self.map.wrap());
        let line = |row: i64| {
            let first = wrap.index(row, height) as usize * width as usize;
            &self.map.texels()[first..first + width as usize]
        };
        let (above, here, below) = (line(row as i64 - 1), line(row as i64), line(row as i64 + 1));
        let last = width as usize - 1;
        // Inside nothing wraps, and with the choice outside of the loop several texels are taken at once.
        if last > 1 {
            let around = here[..last - 1].iter().zip(&here[2..]).zip(&here[1..]);
            let lines = around.zip(above[1..].iter().zip(&below[1..]));
            let slopes = along_u[1..].iter_mut().zip(&mut along_v[1..]).zip(lines);
            match self.derivative {
                Derivative::Central => {
                    for ((u, v), (((left, right), _), (above, below))) in slopes {
                        [*u, *v] = self.central([*left, *right], [*above, *below]);
                    }
                }
                Derivative::Patches => {
                    for ((u, v), (((left, right), here), (above, below))) in slopes {
                        [*u, *v] = self.patches([*left, *right], [*above, *below], *here);
                    }
                }
            }
        }
        for i in [0, last] {
            let before = wrap.index(i as i64 - 1, width) as usize;
            let after = wrap.index(i as i64 + 1, width) as usize;
            let (beside, lines) = ([here[before], here[after]], [above[i], below[i]]);
            [along_u[i], along_v[i]] = match self.derivative {
                Derivative::Central => self.central(beside, lines),
                Derivative::Patches => self.patches(beside, lines, here[i]),
            };
        }
    }

    /// Half of the difference of the neighbours before and after, along `u` and `v`.
    #[inline(always)]
    fn central(&self, [left, right]: [f32; 2], [above, below]: [f32; 2]) -> [f32; 2] {
        let [along_u, along_v] = self.steepness;
        [0.5 * along_u * (right - left), 0.5 * along_v * (below - above)]
    }

    /// The slope of the mean of the normals of the four patches around a texel.
    #[inline(always)]
    fn patches(&self, [left, right]: [f32; 2], [above, below]: [f32; 2], here: f32) -> [f32; 2] {
        let [along_u, along_v] = self.steepness;
        let u = [along_u * (here - left), along_u * (right - here)];
        let v = [along_v * (here - above), along_v * (below - here)];
        let mut sum = [0.0; 3];
        for (u, v) in [(u[0], v[0]), (u[1], v[0]), (u[0], v[1]), (u[1], v[1])] {
            let upright = 1.0 / (1.0 + u * u + v * v).sqrt();
            sum = [sum[0] + upright * u, sum[1] + upright * v, sum[2] + upright];
        }
        [sum[0] / sum[2], sum[1] / sum[2]]
    }
}
