//! Least slopes of frusta, ring of texels by ring of texels.

use rayon::prelude::*;
use relief_core::HeightMap;

use crate::probes::place::Place;

/// Least slope of a cell in a quadrant, and the point where the surface touches it:
/// `None` where the slope is 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LeastSlope {
    /// The slope in heights a texel.
    pub slope: f64,
    /// A place where the surface touches the frustum, or all but touches it.
    pub touches: Option<Place>,
}

/// Where a diagonal that touches its frustum where it begins is probed: so near to there that it is passed if
/// the slope is lowered by a hundred times that share.
const NEAR: f64 = 1e-7;

/// The highest texel of a map.
pub fn highest(map: &HeightMap) -> f64 {
    f64::from(map.texels().iter().copied().fold(0.0, f32::max))
}

/// The least slope of a cell in a quadrant, from every texel up to `most` texels ahead and every cell on the
/// diagonal; stops where nothing farther can matter.
pub fn least_slope(
    map: &HeightMap,
    highest: f64,
    cell: [i64; 2],
    forward: [bool; 2],
    most: i64,
) -> LeastSlope {
    let top = f64::from(map.cell(cell[0], cell[1]).into_iter().fold(0.0, f32::max));
    let texel = |ahead: [i64; 2]| {
        [0, 1].map(|axis| if forward[axis] { cell[axis] + ahead[axis] } else { cell[axis] + 1 - ahead[axis] })
    };
    let rise = |u: i64, v: i64| {
        let [column, row] = texel([u, v]);
        f64::from(map.texel(column, row)) - top
    };
    let mut best = LeastSlope { slope: 0.0, touches: None };
    for distance in 1..most {
        if highest - top <= best.slope * (distance as f64 - 0.5) {
            break;
        }
        let ring = distance + 1;
        for (u, v) in (0..=ring).map(|v| (ring, v)).chain((0..ring).map(|u| (u, ring))) {
            let slope = rise(u, v) / distance as f64;
            if slope > best.slope {
                best = LeastSlope { slope, touches: Some(Place { cell: texel([u, v]), within: [0.0; 2] }) };
            }
        }
        // The diagonal of cell k: f = a + b s + c s² over the distance κ + s.
        let k = distance;
        let (near, far) = (rise(k, k), rise(k + 1, k + 1));
        let mean = 0.5 * (rise(k + 1, k) + rise(k, k + 1));
        let (b, c, before) = (2.0 * (mean - near), near - 2.0 * mean + far, (k - 1) as f64);
        let turn = -before + (before * before - (b * before - near) / c).sqrt();
        for s in [turn, NEAR] {
            if s > 0.0 && s < 1.0 {
                let limit = if s == NEAR && before == 0.0 && near == 0.0 {
                    b
                } else {
                    (near + s * (b + s * c)) / (before + s)
                };
                if limit > best.slope {
                    let within = forward.map(|forward| if forward { s } else { 1.0 - s });
                    let corner = texel([k, k]);
                    let cell = [0, 1].map(|axis| if forward[axis] { corner[axis] } else { corner[axis] - 1 });
                    best = LeastSlope { slope: limit, touches: Some(Place { cell, within }) };
                }
            }
        }
    }
    best
}

/// The least slopes of all cells in a quadrant, in parallel; `f32` to the nearest.
pub fn least_slopes(map: &HeightMap, forward: [bool; 2]) -> Vec<f32> {
    let (highest, width) = (highest(map), i64::from(map.width()));
    let most = 2 * i64::from(map.width().max(map.height())) + 2;
    (0..width * i64::from(map.height()))
        .into_par_iter()
        .map(|at| least_slope(map, highest, [at % width, at / width], forward, most).slope as f32)
        .collect()
}
