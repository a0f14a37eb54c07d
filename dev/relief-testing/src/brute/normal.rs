//! Slopes and normals in `f64`, texel by texel.

use rayon::prelude::*;
use relief_core::{HeightMap, Wrap};

/// A slope along `u` and along `v`, metres up for a metre along.
pub type Slope = [f64; 2];

/// The slopes of the four patches that meet at a texel centre, left above, right above, left below, right
/// below. Beyond the edges of a clamped map the patches inside go on.
pub fn patch_slopes(map: &HeightMap, tile_m: [f64; 2], scale_m: f64, [i, j]: [i64; 2]) -> [Slope; 4] {
    let texel = [tile_m[0] / f64::from(map.width()), tile_m[1] / f64::from(map.height())];
    let height = |i, j| f64::from(map.texel(i, j)) * scale_m;
    let here = height(i, j);
    let along_u = [(here - height(i - 1, j)) / texel[0], (height(i + 1, j) - here) / texel[0]];
    let along_v = [(here - height(i, j - 1)) / texel[1], (height(i, j + 1) - here) / texel[1]];
    let [along_u, along_v] =
        [(along_u, i, map.width()), (along_v, j, map.height())].map(|([before, behind], place, side)| {
            match place {
                _ if map.wrap() != Wrap::Clamp => [before, behind],
                0 => [behind; 2],
                _ if place + 1 == i64::from(side) => [before; 2],
                _ => [before, behind],
            }
        });
    [[0, 0], [1, 0], [0, 1], [1, 1]].map(|[a, b]| [along_u[a], along_v[b]])
}

/// The mean of slopes.
pub fn mean(slopes: &[Slope]) -> Slope {
    [0, 1].map(|axis| slopes.iter().map(|slope| slope[axis]).sum::<f64>() / slopes.len() as f64)
}

/// The unit normal of a slope along the tangent, up in the picture and outward.
pub fn normal([u, v]: Slope) -> [f64; 3] {
    let length = (1.0 + u * u + v * v).sqrt();
    [-u / length, v / length, 1.0 / length]
}

/// The unit vector along the sum of the normals of slopes.
pub fn mean_normal(slopes: &[Slope]) -> [f64; 3] {
    let sum = slopes
        .iter()
        .map(|&slope| normal(slope))
        .fold([0.0; 3], |sum, normal| [sum[0] + normal[0], sum[1] + normal[1], sum[2] + normal[2]]);
    let length = sum.iter().map(|x| x * x).sum::<f64>().sqrt();
    sum.map(|x| x / length)
}

/// The angle between two vectors in radians, precise for small ones too.
pub fn angle(a: [f64; 3], b: [f64; 3]) -> f64 {
    let cross = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
    let dot: f64 = a.iter().zip(b).map(|(a, b)| a * b).sum();
    cross.iter().map(|x| x * x).sum::<f64>().sqrt().atan2(dot)
}

/// The mean slope and its central second moments `uu`, `uv`, `vv` over the texels of each node of a mip level
/// of a map whose sides are powers of two, row by row, from all of the texels.
pub fn level(map: &HeightMap, tile_m: [f64; 2], scale_m: f64, level: u32) -> Vec<(Slope, [f64; 3])> {
    let size = [map.width(), map.height()].map(|side| i64::from((side >> level).max(1)));
    let covered = [i64::from(map.width()) / size[0], i64::from(map.height()) / size[1]];
    (0..size[0] * size[1])
        .into_par_iter()
        .map(|node| {
            let [left, top] = [node % size[0] * covered[0], node / size[0] * covered[1]];
            let texels = (top..top + covered[1]).flat_map(|j| (left..left + covered[0]).map(move |i| [i, j]));
            let slopes: Vec<Slope> =
                texels.map(|texel| mean(&patch_slopes(map, tile_m, scale_m, texel))).collect();
            let [u, v] = mean(&slopes);
            let moment = |f: fn(f64, f64) -> f64| {
                slopes.iter().map(|slope| f(slope[0] - u, slope[1] - v)).sum::<f64>() / slopes.len() as f64
            };
            ([u, v], [moment(|u, _| u * u), moment(|u, v| u * v), moment(|_, v| v * v)])
        })
        .collect()
}
