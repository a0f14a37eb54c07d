//! Cone maps the slow and obvious way: every cell in growing rings, every supremum by numerical search.

use relief_core::{HeightMap, Wrap};

/// Steps of a golden-section search: the bracket shrinks to 1e-6 of its length.
const STEPS: usize = 30;

struct Apex {
    at: [f64; 2],
    height: f64,
}

/// The places in half texels from a texel's centre of the eight apexes that a safe cone has to do with.
const RIM: [[f64; 2]; 8] =
    [[-1.0, -1.0], [0.0, -1.0], [1.0, -1.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [-1.0, 1.0], [-1.0, 0.0]];

/// The centre of a texel, or the eight places on its rim.
fn apexes(footprint: bool, height: &dyn Fn([f64; 2]) -> f64) -> Vec<Apex> {
    let places = if footprint { RIM.map(|place| place.map(|x| 0.5 * x)).to_vec() } else { vec![[0.0; 2]] };
    places.into_iter().map(|at| Apex { at, height: height(at) }).collect()
}

/// The slope of the steepest rise to a texel's centre from the centre of a texel, or with `footprint` from
/// any of the eight apexes on its rim, in heights per metre of `texel_m`: without the edges and the insides
/// of cells, and so a little less than a safe cone needs, but quick. Texels are looked at ring by ring, up to
/// `most` rings, until even `highest`, the map's highest texel, would not be steeper.
pub fn vertex_slope(
    map: &HeightMap,
    texel_m: [f64; 2],
    footprint: bool,
    texel: [i64; 2],
    highest: f64,
    most: i64,
) -> f64 {
    let size = [f64::from(map.width()), f64::from(map.height())];
    let apexes = apexes(footprint, &|at| {
        let [u, v] = [0, 1].map(|axis| (texel[axis] as f64 + at[axis] + 0.5) / size[axis]);
        map.height_at(u, v)
    });
    let low = apexes.iter().map(|apex| apex.height).fold(1.0, f64::min);
    let finest = texel_m[0].min(texel_m[1]);
    let mut best2 = 0.0f64;
    for ring in 0..=most {
        let nearest = finest * (ring as f64 - 0.5).max(0.0);
        if (highest - low) * (highest - low) <= best2 * nearest * nearest {
            break;
        }
        for y in -ring..=ring {
            let step = if y.abs() == ring { 1 } else { 2 * ring };
            for x in (-ring..=ring).step_by(step.max(1) as usize) {
                let height = f64::from(map.texel(texel[0] + x, texel[1] + y));
                for apex in &apexes {
                    let rise = (height - apex.height).max(0.0);
                    let across = (x as f64 - apex.at[0]) * texel_m[0];
                    let down = (y as f64 - apex.at[1]) * texel_m[1];
                    let slope2 = rise * rise / (across * across + down * down).max(f64::MIN_POSITIVE);
                    best2 = if slope2 > best2 { slope2 } else { best2 };
                }
            }
        }
    }
    best2.sqrt()
}

/// The slope of the steepest rise of the bilinear surface from any apex of a texel, in heights per metre of
/// `texel_m`: from its square with `footprint`, else from its centre. Cells beyond the ring in which nothing
/// steeper can be, as `highest` is the map's highest texel, are left out.
///
/// Good to 1e-7 relatively (tops are flat). Uses no closed form but the gradient's; that apexes inside of the
/// square need not be looked at is checked by [`crate::probes::cone`].
pub fn slope(map: &HeightMap, texel_m: [f64; 2], footprint: bool, texel: [i64; 2], highest: f64) -> f64 {
    let centre = texel.map(|k| k as f64);
    let surface = |x: f64, y: f64| {
        let size = [f64::from(map.width()), f64::from(map.height())];
        map.height_at((centre[0] + x + 0.5) / size[0], (centre[1] + y + 0.5) / size[1])
    };
    let half = if footprint { 0.5 } else { 0.0 };
    let ends = apexes(footprint, &|[x, y]| surface(x, y));
    let low = ends.iter().map(|apex| apex.height).fold(surface(0.0, 0.0), f64::min);
    let mut best = own_gradient(map, texel_m, footprint, texel);
    let finest = texel_m[0].min(texel_m[1]);
    let (width, height) = (i64::from(map.width()), i64::from(map.height()));
    for ring in 0..=2 * (width + height) {
        if (highest - low) <= best * finest * (ring as f64 - 1.0 - half).max(0.0) {
            break;
        }
        let cells = (-ring..=ring).flat_map(|y| {
            let step = if y.abs() == ring { 1 } else { (2 * ring).max(1) };
            (-ring..=ring).step_by(step as usize).map(move |x| [x, y])
        });
        for offset in cells {
            let cell = [texel[0] + offset[0], texel[1] + offset[1]];
            let is_outside = cell[0] < 0 || cell[1] < 0 || cell[0] >= width || cell[1] >= height;
            if map.wrap() == Wrap::Clamp && is_outside {
                continue;
            }
            let heights = map.cell(cell[0], cell[1]).map(f64::from);
            let top = heights.iter().copied().fold(0.0, f64::max);
            let gap = |axis: usize| {
                let from = offset[axis] as f64;
                (from - half).max(-half - from - 1.0).max(0.0) * texel_m[axis]
            };
            if top - low <= best * gap(0).hypot(gap(1)) {
                continue;
            }
            best = cell_slope(offset, heights, texel_m, &ends, best);
        }
    }
    best
}

/// The steepest direction of the patches around the apexes.
fn own_gradient(map: &HeightMap, texel_m: [f64; 2], footprint: bool, texel: [i64; 2]) -> f64 {
    let mut best = 0.0f64;
    for (i, j) in [(-1, -1), (0, -1), (-1, 0), (0, 0)] {
        let [h00, h10, h01, h11] = map.cell(texel[0] + i, texel[1] + j).map(f64::from);
        let corner = [if i == 0 { 0.0 } else { 1.0 }, if j == 0 { 0.0 } else { 1.0 }];
        let gradient = |u: f64, v: f64| {
            let x = (h10 - h00) * (1.0 - v) + (h11 - h01) * v;
            let y = (h01 - h00) * (1.0 - u) + (h11 - h10) * u;
            [x / texel_m[0], y / texel_m[1]]
        };
        if footprint {
            for u in [corner[0], 0.5] {
                for v in [corner[1], 0.5] {
                    let [x, y] = gradient(u, v);
                    best = best.max(x.hypot(y));
                }
            }
        } else {
            let [x, y] = gradient(corner[0], corner[1]);
            let is_into = |slope: f64, corner: f64| if corner == 0.0 { slope > 0.0 } else { slope < 0.0 };
            if is_into(x, corner[0]) && is_into(y, corner[1]) {
                best = best.max(x.hypot(y));
            }
        }
    }
    best
}

/// The steepest slope from the ends of the rim to the cell, and from the rim between them to the cell's
/// corners.
fn cell_slope(offset: [i64; 2], heights: [f64; 4], texel_m: [f64; 2], ends: &[Apex], mut best: f64) -> f64 {
    let [h00, h10, h01, h11] = heights;
    let top = heights.iter().copied().fold(0.0, f64::max);
    let corner = offset.map(|k| k as f64);
    let rise = |apex: [f64; 2], height: f64, place: [f64; 2], top: f64| {
        let far = ((place[0] - apex[0]) * texel_m[0]).hypot((place[1] - apex[1]) * texel_m[1]);
        if far > 1e-9 * texel_m[0] { (top - height) / far } else { 0.0 }
    };
    for apex in ends {
        let gap = |axis: usize| {
            let from = corner[axis] - apex.at[axis];
            from.max(-from - 1.0).max(0.0) * texel_m[axis]
        };
        if top - apex.height <= best * gap(0).hypot(gap(1)) {
            continue;
        }
        let at = |u: f64, v: f64| {
            let top = h00 * (1.0 - u) * (1.0 - v) + h10 * u * (1.0 - v) + h01 * (1.0 - u) * v + h11 * u * v;
            rise(apex.at, apex.height, [corner[0] + u, corner[1] + v], top)
        };
        // On a line along `v` the slope has one maximum where it is positive; across the lines it may have
        // several.
        let is_around = |axis: usize| apex.at[axis] > corner[axis] && apex.at[axis] < corner[axis] + 1.0;
        if is_around(0) && is_around(1) {
            // The patch holds the apex: the steepest is the gradient, or on the rim.
            for side in [0.0, 1.0] {
                best = best.max(golden(|v| at(side, v), 0.0, 1.0)).max(golden(|u| at(u, side), 0.0, 1.0));
            }
            continue;
        }
        best = best.max(golden(|u| at(u, 0.0), 0.0, 1.0)).max(golden(|u| at(u, 1.0), 0.0, 1.0));
        best = best.max(golden(|v| at(0.0, v), 0.0, 1.0)).max(golden(|v| at(1.0, v), 0.0, 1.0));
        const LINES: usize = 6;
        let line = |k: usize| k as f64 / LINES as f64;
        let on_line = |u: f64| golden(|v| at(u, v), 0.0, 1.0);
        let tops: Vec<f64> = (0..=LINES).map(|k| on_line(line(k))).collect();
        let top = (0..=LINES).fold(0, |top, k| if tops[k] > tops[top] { k } else { top });
        let (from, to) = (line(top.saturating_sub(1)), line((top + 1).min(LINES)));
        // A top within the lines that could still be steeper than what is known.
        if tops[top] > 0.9 * best {
            best = best.max(tops[top]).max(golden(on_line, from, to));
        }
    }
    if ends.len() > 1 {
        for (place, top) in [([0.0, 0.0], h00), ([1.0, 0.0], h10), ([0.0, 1.0], h01), ([1.0, 1.0], h11)] {
            let place = [corner[0] + place[0], corner[1] + place[1]];
            if top <= ends.iter().map(|apex| apex.height).fold(f64::INFINITY, f64::min) {
                continue;
            }
            for (k, a) in ends.iter().enumerate() {
                let b = &ends[(k + 1) % ends.len()];
                let between = |s: f64| {
                    let at = [0, 1].map(|axis| a.at[axis] + (b.at[axis] - a.at[axis]) * s);
                    rise(at, a.height + (b.height - a.height) * s, place, top)
                };
                best = best.max(golden(between, 0.0, 1.0));
            }
        }
    }
    best
}

/// The greatest value of a function with one maximum between two places, ends included.
fn golden(value: impl Fn(f64) -> f64, mut from: f64, mut to: f64) -> f64 {
    let ends = value(from).max(value(to));
    let share = (5f64.sqrt() - 1.0) / 2.0;
    let (mut a, mut b) = (to - share * (to - from), from + share * (to - from));
    let (mut at_a, mut at_b) = (value(a), value(b));
    for _ in 0..STEPS {
        if at_a >= at_b {
            (to, b, at_b) = (b, a, at_a);
            a = to - share * (to - from);
            at_a = value(a);
        } else {
            (from, a, at_a) = (a, b, at_b);
            b = from + share * (to - from);
            at_b = value(b);
        }
    }
    ends.max(at_a).max(at_b)
}
