//! Distances to a relief and to the boxes over its dual cells, by search.

use rayon::prelude::*;
use relief_core::HeightMap;

/// The distance from every texel centre at height `level` (1 is `scale_m` high) to the nearest box, in
/// metres, row by row; all in parallel.
pub fn boxes(map: &HeightMap, tile_m: [f64; 2], scale_m: f64, level: f64) -> Vec<f64> {
    let [width, height] = [i64::from(map.width()), i64::from(map.height())];
    (0..width * height)
        .into_par_iter()
        .map(|at| to_boxes(map, tile_m, scale_m, level, [at % width, at / width]))
        .collect()
}

/// The distance from the centre of one texel at height `level` (1 is `scale_m` high) to the nearest box, in
/// metres.
///
/// A box stands on each dual cell and reaches up to the highest of its four corners. The search goes outward
/// and ends where nothing nearer can be.
pub fn to_boxes(map: &HeightMap, tile_m: [f64; 2], scale_m: f64, level: f64, from: [i64; 2]) -> f64 {
    let texel = [tile_m[0] / f64::from(map.width()), tile_m[1] / f64::from(map.height())];
    let squared = |away: [i64; 2]| {
        let [i, j] = [from[0] + away[0], from[1] + away[1]];
        let corners = [(-1, -1), (0, -1), (-1, 0), (0, 0)].map(|(di, dj)| map.cell(i + di, j + dj));
        let top = corners.as_flattened().iter().fold(0.0f32, |top, &corner| top.max(corner));
        let gap = (level - f64::from(top)).max(0.0) * scale_m;
        let [x, y] = [away[0] as f64 * texel[0], away[1] as f64 * texel[1]];
        x * x + y * y + gap * gap
    };
    let mut best = squared([0, 0]);
    let mut dj = 0;
    while (dj as f64 * texel[1]).powi(2) <= best {
        let mut di = 0;
        while (di as f64 * texel[0]).powi(2) + (dj as f64 * texel[1]).powi(2) <= best {
            for away in [[di, dj], [-di, dj], [di, -dj], [-di, -dj]] {
                best = best.min(squared(away));
            }
            di += 1;
        }
        dj += 1;
    }
    best.sqrt()
}

/// A part of the surface over a rectangle of texture space, as tall as its corners.
struct Part {
    low: [f64; 2],
    high: [f64; 2],
}

/// The distance in metres from a point above the relief, in texture coordinates and height, to the bilinear
/// surface: too long by a thousandth at most.
///
/// Cells are searched outward and divided until none can hold a nearer point.
pub fn to_surface(map: &HeightMap, tile_m: [f64; 2], scale_m: f64, from: [f64; 3]) -> f64 {
    let size = [f64::from(map.width()), f64::from(map.height())];
    let unit = [tile_m[0], tile_m[1], scale_m];
    let away =
        |to: [f64; 3]| (0..3).map(|axis| ((to[axis] - from[axis]) * unit[axis]).powi(2)).sum::<f64>().sqrt();
    let straight_down = map.height_at(from[0], from[1]);
    let mut best = away([from[0], from[1], straight_down]);
    // Cells that reach into the square around the point.
    let cells = |axis: usize| {
        let reach = best / unit[axis];
        let cell = |at: f64| (at * size[axis] - 0.5).floor() as i64;
        cell(from[axis] - reach)..=cell(from[axis] + reach)
    };
    let mut parts: Vec<Part> = Vec::new();
    for j in cells(1) {
        for i in cells(0) {
            let corner =
                |step: i64| [((i + step) as f64 + 0.5) / size[0], ((j + step) as f64 + 0.5) / size[1]];
            parts.push(Part { low: corner(0), high: corner(1) });
        }
    }
    while let Some(Part { low, high }) = parts.pop() {
        // Just inside, so that rounding does not look into the next cell.
        let inside = [0, 1].map(|axis| 1e-12 * (high[axis] - low[axis]));
        let heights =
            [[low[0], low[1]], [high[0], low[1]], [low[0], high[1]], [high[0], high[1]]].map(|[u, v]| {
                let u = u.clamp(low[0] + inside[0], high[0] - inside[0]);
                let v = v.clamp(low[1] + inside[1], high[1] - inside[1]);
                map.height_at(u, v)
            });
        let (lowest, highest) = heights.iter().fold((f64::MAX, f64::MIN), |(a, b), &h| (a.min(h), b.max(h)));
        let near =
            [from[0].clamp(low[0], high[0]), from[1].clamp(low[1], high[1]), from[2].clamp(lowest, highest)];
        if away(near) >= 0.999 * best {
            continue;
        }
        let middle = [0, 1].map(|axis| 0.5 * (low[axis] + high[axis]));
        best = best.min(away([middle[0], middle[1], map.height_at(middle[0], middle[1])]));
        for (right, below) in [(false, false), (true, false), (false, true), (true, true)] {
            let side = |axis: usize, far: bool| {
                if far { [middle[axis], high[axis]] } else { [low[axis], middle[axis]] }
            };
            let ([u0, u1], [v0, v1]) = (side(0, right), side(1, below));
            parts.push(Part { low: [u0, v0], high: [u1, v1] });
        }
    }
    best
}
