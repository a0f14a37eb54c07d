//! Slopes of a height map at its texel centres.

use relief_core::{HeightMap, Metric, Wrap};

/// Limit of slopes, so that their squares fit `f32` in any metric.
const STEEPEST: f64 = 1e18;

/// Rule for the slope at a texel centre, from the heights around it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Derivative {
    /// Half of the difference between the neighbours on both sides, as in the shader of eq. 9. It
    /// is the mean of the slopes of the four patches that meet there.
    #[default]
    Central,
    /// Slope of the mean of the four unit normals that the bilinear surface has there, one of each
    /// patch. Steep patches count less.
    Patches,
}

/// Slopes of a map: metres up for a metre along `u`, and along `v`, which points down in the
/// picture.
///
/// At the edge of a clamped map they are one-sided, from the edge's texel to the one inside: the
/// ground beyond is unknown. So an even slope has one normal everywhere, and tiles of a terrain
/// have no rim.
#[derive(Clone, Copy, Debug)]
pub struct Slopes<'a> {
    map: &'a HeightMap,
    derivative: Derivative,
    /// Slope for a difference of 1 between neighbours, along `u` and `v`.
    steepness: [f32; 2],
}

impl<'a> Slopes<'a> {
    /// Prepares the slopes of a map.
    pub fn new(map: &'a HeightMap, metric: Metric, derivative: Derivative) -> Self {
        let steepness = metric.texel_m(map).map(|texel| (metric.scale_m / texel).min(STEEPEST) as f32);
        Self { map, derivative, steepness }
    }

    /// Computes the slopes along a row, which must be one of the map: each slice takes one value a
    /// column.
    pub fn row(&self, row: usize, along_u: &mut [f32], along_v: &mut [f32]) {
        let (width, height, wrap) = (self.map.width(), self.map.height(), self.map.wrap());
        let line = |row: i64| {
            let first = wrap.index(row, height) as usize * width as usize;
            &self.map.texels()[first..first + width as usize]
        };
        let (above, here, below) = (line(row as i64 - 1), line(row as i64), line(row as i64 + 1));
        let last = width as usize - 1;
        let of_row = Edge::at(row, height, wrap);
        // Inside nothing wraps, and with the choice outside of the loop several texels are computed
        // at once.
        if last > 1 {
            let around = here[..last - 1].iter().zip(&here[2..]).zip(&here[1..]);
            let lines = around.zip(above[1..].iter().zip(&below[1..]));
            let slopes = along_u[1..].iter_mut().zip(&mut along_v[1..]).zip(lines);
            let edges = [Edge::Inside, of_row];
            match self.derivative {
                Derivative::Central => {
                    let rates = self.rates(edges);
                    for ((u, v), (((left, right), _), (above, below))) in slopes {
                        [*u, *v] = central(rates, [*left, *right], [*above, *below]);
                    }
                }
                Derivative::Patches => {
                    for ((u, v), (((left, right), here), (above, below))) in slopes {
                        [*u, *v] = self.patches(edges, [*left, *right], [*above, *below], *here);
                    }
                }
            }
        }
        for i in [0, last] {
            let before = wrap.index(i as i64 - 1, width) as usize;
            let after = wrap.index(i as i64 + 1, width) as usize;
            let (beside, lines) = ([here[before], here[after]], [above[i], below[i]]);
            let edges = [Edge::at(i, width, wrap), of_row];
            [along_u[i], along_v[i]] = match self.derivative {
                Derivative::Central => central(self.rates(edges), beside, lines),
                Derivative::Patches => self.patches(edges, beside, lines, here[i]),
            };
        }
    }

    /// Returns the slope for a difference of 1 between the texels before and behind, along `u` and
    /// `v`.
    fn rates(&self, edges: [Edge; 2]) -> [f32; 2] {
        [0, 1].map(|axis| match edges[axis] {
            Edge::Inside => 0.5 * self.steepness[axis],
            // The texel before or behind is the texel itself: the difference is over one texel.
            Edge::First | Edge::Last => self.steepness[axis],
        })
    }

    /// Returns the slope of the mean of the normals of the four patches around a texel.
    #[inline(always)]
    fn patches(
        &self,
        edges: [Edge; 2],
        [left, right]: [f32; 2],
        [above, below]: [f32; 2],
        here: f32,
    ) -> [f32; 2] {
        let [along_u, along_v] = self.steepness;
        let u = edges[0].of_patches([along_u * (here - left), along_u * (right - here)]);
        let v = edges[1].of_patches([along_v * (here - above), along_v * (below - here)]);
        let mut sum = [0.0; 3];
        for (u, v) in [(u[0], v[0]), (u[1], v[0]), (u[0], v[1]), (u[1], v[1])] {
            let upright = 1.0 / (1.0 + u * u + v * v).sqrt();
            sum = [sum[0] + upright * u, sum[1] + upright * v, sum[2] + upright];
        }
        [sum[0] / sum[2], sum[1] / sum[2]]
    }
}

/// Returns the differences over the neighbours before and behind, times the slope of a difference
/// of 1.
#[inline(always)]
fn central(rates: [f32; 2], [left, right]: [f32; 2], [above, below]: [f32; 2]) -> [f32; 2] {
    [rates[0] * (right - left), rates[1] * (below - above)]
}

/// Position of a texel along an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Edge {
    /// Neighbours on both sides, if need be by the map's wrap.
    Inside,
    /// First texel of a clamped map: the ground before it is unknown.
    First,
    /// Last texel of a clamped map.
    Last,
}

impl Edge {
    fn at(place: usize, side: u32, wrap: Wrap) -> Self {
        match place {
            _ if wrap != Wrap::Clamp => Edge::Inside,
            0 => Edge::First,
            _ if place + 1 == side as usize => Edge::Last,
            _ => Edge::Inside,
        }
    }

    /// Returns the slopes of the patches before and behind. Beyond an edge the patch inside
    /// continues.
    #[inline(always)]
    fn of_patches(self, [before, behind]: [f32; 2]) -> [f32; 2] {
        match self {
            Edge::Inside => [before, behind],
            Edge::First => [behind; 2],
            Edge::Last => [before; 2],
        }
    }
}
