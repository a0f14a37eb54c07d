//! Relaxed cones of single texels, from samples of every patch that falls.

use relief_core::HeightMap;

/// What rounding may make of a sum of two products that is 0, in parts of the sum of their sizes.
const ROUNDING: f64 = 1e-14;

/// The steepest slope, in heights a metre of `texel_m`, from an apex to a sampled point of the surface at
/// which it falls along the ray from there, and is not level: no cone of a smaller slope is left after one
/// entry at most, and the least that is lies above by what is between samples. Each patch has `samples + 1`
/// samples along either side, and `finer` times as many on its edges. The apex is the surface at the given
/// distance from the texel's centre, in texels. Cells are looked at ring by ring, up to `most` rings, until
/// even `highest`, the map's highest texel, would not be steeper.
pub fn slope(
    map: &HeightMap,
    texel_m: [f64; 2],
    texel: [i64; 2],
    apex: [f64; 2],
    [samples, finer]: [usize; 2],
    highest: f64,
    most: i64,
) -> f64 {
    let size = [f64::from(map.width()), f64::from(map.height())];
    let place = [0, 1].map(|axis| (texel[axis] as f64 + apex[axis] + 0.5) / size[axis]);
    let own = map.height_at(place[0], place[1]);
    let finest = texel_m[0].min(texel_m[1]);
    let apex = Apex { texel_m, texel, at: apex, height: own };
    let mut best = 0.0f64;
    for ring in 0..most {
        if highest - own <= best * finest * (ring - 1) as f64 {
            break;
        }
        // Cell -1 has the texel as its far corner, so that a ring is one cell longer to that side.
        for j in -ring - 1..=ring {
            let is_end = j == ring || j == -ring - 1;
            let step = if is_end { 1 } else { 2 * ring + 1 };
            for i in (-ring - 1..=ring).step_by(step as usize) {
                best = patch_slope(map, &apex, [i, j], [samples, finer], best);
            }
        }
    }
    best
}

/// Where slopes begin.
struct Apex {
    /// Metres of a texel.
    texel_m: [f64; 2],
    texel: [i64; 2],
    /// In texels from the texel's centre.
    at: [f64; 2],
    /// Of the surface there.
    height: f64,
}

/// The steepest slope to a sampled point of the cell at that offset at which the surface falls, or `best` if
/// that is steeper.
fn patch_slope(
    map: &HeightMap,
    &Apex { texel_m, texel, at: apex, height: own }: &Apex,
    offset: [i64; 2],
    [samples, finer]: [usize; 2],
    mut best: f64,
) -> f64 {
    let [h00, h10, h01, h11] = map.cell(texel[0] + offset[0], texel[1] + offset[1]).map(f64::from);
    let gap = |axis: usize| {
        let from = offset[axis] as f64 - apex[axis];
        from.max(-from - 1.0).max(0.0) * texel_m[axis]
    };
    if h00.max(h10).max(h01).max(h11) - own <= best * gap(0).hypot(gap(1)) {
        return best;
    }
    let last = finer * samples;
    for b in 0..=last {
        let step = if b % last == 0 {
            1
        } else if b % finer == 0 {
            finer
        } else {
            last
        };
        for a in (0..=last).step_by(step) {
            let [u, v] = [a, b].map(|k| k as f64 / last as f64);
            let [x, y] = [offset[0] as f64 + u - apex[0], offset[1] as f64 + v - apex[1]];
            let along_u = (h10 - h00) * (1.0 - v) + (h11 - h01) * v;
            let along_v = (h01 - h00) * (1.0 - u) + (h11 - h10) * u;
            let far = (x * texel_m[0]).hypot(y * texel_m[1]);
            // Level ground gives exactly 0. Elsewhere a rounded 0 is no fall.
            let (fall_u, fall_v) = (along_u * x, along_v * y);
            if far == 0.0 || fall_u + fall_v >= -ROUNDING * (fall_u.abs() + fall_v.abs()) {
                continue;
            }
            let height = (1.0 - v) * ((1.0 - u) * h00 + u * h10) + v * ((1.0 - u) * h01 + u * h11);
            best = best.max((height - own) / far);
        }
    }
    best
}
