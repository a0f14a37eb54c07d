//! Relaxed cones of single texels, from samples of every patch that falls.

use relief::HeightMap;

/// Samples along either side of a patch.
const SAMPLES: i32 = 4;

/// The steepest slope, in heights a metre of `texel_m`, from the centre of a texel to a sampled point of the surface over
/// which it falls along the ray from the centre: no cone of a smaller slope is left after one entry at most, and the least
/// that is lies above by what is between samples. Cells are looked at ring by ring, up to `most` rings, until even `highest`,
/// the map's highest texel, would not be steeper.
pub fn slope(map: &HeightMap, texel_m: [f64; 2], texel: [i64; 2], highest: f64, most: i64) -> f64 {
    let own = f64::from(map.texel(texel[0], texel[1]));
    let finest = texel_m[0].min(texel_m[1]);
    let mut best = 0.0f64;
    for ring in 0..most {
        if highest - own <= best * finest * ring as f64 {
            break;
        }
        // Cell -1 has the texel as its far corner, so that a ring is one cell longer to that side.
        for j in -ring - 1..=ring {
            let is_end = j == ring || j == -ring - 1;
            let step = if is_end { 1 } else { 2 * ring + 1 };
            for i in (-ring - 1..=ring).step_by(step as usize) {
                best = best.max(patch_slope(map, texel_m, texel, [i, j], own));
            }
        }
    }
    best
}

/// The steepest slope to a sampled point of the cell at that offset at which the surface falls.
fn patch_slope(map: &HeightMap, texel_m: [f64; 2], texel: [i64; 2], offset: [i64; 2], own: f64) -> f64 {
    let [h00, h10, h01, h11] = map.cell(texel[0] + offset[0], texel[1] + offset[1]).map(f64::from);
    let mut best = 0.0f64;
    for b in 0..=SAMPLES {
        for a in 0..=SAMPLES {
            let [u, v] = [a, b].map(|k| f64::from(k) / f64::from(SAMPLES));
            let [x, y] = [offset[0] as f64 + u, offset[1] as f64 + v];
            let along_u = (h10 - h00) * (1.0 - v) + (h11 - h01) * v;
            let along_v = (h01 - h00) * (1.0 - u) + (h11 - h10) * u;
            let far = (x * texel_m[0]).hypot(y * texel_m[1]);
            if far == 0.0 || along_u * x + along_v * y > 0.0 {
                continue;
            }
            let height = (1.0 - v) * ((1.0 - u) * h00 + u * h10) + v * ((1.0 - u) * h01 + u * h11);
            best = best.max((height - own) / far);
        }
    }
    best
}
