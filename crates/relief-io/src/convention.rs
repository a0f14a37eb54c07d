//! Height or depth, green up or down: what a height map and the normal map that belongs to it say of each
//! other.

use relief_core::HeightMap;

use crate::{Convention, GreenSign, NormalMap};

/// The conventions under which a pair of maps agrees best.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Detection {
    /// Whether white is high or deep in the height map as it was read.
    pub convention: Convention,
    /// How sure that is: the size of the correlation along `u`, from 0 (nothing to see) to 1.
    pub convention_confidence: f64,
    /// Which way green pointed in the normal map's file, if it was read as [`GreenSign::PlusY`].
    pub green: GreenSign,
    /// How sure that is: the lesser of the correlations along `u` and `v`, from 0 to 1, since both signs
    /// decide it.
    pub green_confidence: f64,
}

/// Compares the slopes of a normal map, read as [`GreenSign::PlusY`], with the gradient of a height map, read
/// as [`Convention::Height`].
///
/// The normal of a height field leans against its slope: `x` falls with `∂h/∂u`, and `y`, which points along
/// falling `v`, rises with `∂h/∂v`. The correlation of `-x` with `∂h/∂u` is positive for heights and negative
/// for depths; that of `y` with `∂h/∂v` has the same sign if green points up and the other if it points down.
/// The sizes of the maps may differ: heights are taken at the normals' texel centres.
pub fn detect(height: &HeightMap, normals: &NormalMap) -> Detection {
    let (mut along_u, mut along_v) = (Correlation::default(), Correlation::default());
    let (du, dv) = (1.0 / f64::from(normals.width), 1.0 / f64::from(normals.height));
    let width = normals.width as usize;
    for (row, normals) in normals.normals.chunks_exact(width.max(1)).enumerate() {
        let v = (row as f64 + 0.5) * dv;
        for (column, &[x, y, _]) in normals.iter().enumerate() {
            let u = (column as f64 + 0.5) * du;
            along_u.add(-f64::from(x), height.height_at(u + du, v) - height.height_at(u - du, v));
            along_v.add(f64::from(y), height.height_at(u, v + dv) - height.height_at(u, v - dv));
        }
    }
    let (u, v) = (along_u.value(), along_v.value());
    Detection {
        convention: if u < 0.0 { Convention::Depth } else { Convention::Height },
        convention_confidence: u.abs(),
        green: if u * v < 0.0 { GreenSign::MinusY } else { GreenSign::PlusY },
        green_confidence: u.abs().min(v.abs()),
    }
}

/// Pearson's correlation, from sums of values whose means are near 0.
#[derive(Default)]
struct Correlation {
    count: f64,
    sum: [f64; 2],
    squares: [f64; 2],
    product: f64,
}

impl Correlation {
    fn add(&mut self, a: f64, b: f64) {
        self.count += 1.0;
        self.sum = [self.sum[0] + a, self.sum[1] + b];
        self.squares = [self.squares[0] + a * a, self.squares[1] + b * b];
        self.product += a * b;
    }

    /// In `[-1, 1]`; 0 where one of both is constant.
    fn value(&self) -> f64 {
        let mean = self.sum.map(|sum| sum / self.count);
        let variance = [0, 1].map(|i| self.squares[i] / self.count - mean[i] * mean[i]);
        let covariance = self.product / self.count - mean[0] * mean[1];
        // Below this a variance is rounding of constant slopes.
        const LEAST: f64 = 1e-20;
        if variance.iter().all(|&variance| variance > LEAST) {
            (covariance / (variance[0] * variance[1]).sqrt()).clamp(-1.0, 1.0)
        } else {
            0.0
        }
    }
}
