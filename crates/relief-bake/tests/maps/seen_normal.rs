//! Seen normals against rays of the exact tracer in `f64`, one for each texel of the map.

use rayon::prelude::*;
use relief_bake::kind::seen_normal::KIND;
use relief_core::exact::cell_walk;
use relief_core::{HeightMap, Metric, Path, PathMetric, Wrap};
use relief_testing::maps;
use relief_tests::probes::stored;

const AZIMUTHS: u32 = 5;
const ELEVATIONS: u32 = 3;

/// Returns the unit normal at a point, `y` along falling `v`.
fn normal(map: &HeightMap, metric: Metric, [u, v]: [f64; 2]) -> [f64; 3] {
    let [du, dv] = [1.0 / f64::from(map.width()), 1.0 / f64::from(map.height())];
    let slope_u = (map.height_at(u + du, v) - map.height_at(u - du, v)) * metric.scale_m;
    let slope_v = (map.height_at(u, v + dv) - map.height_at(u, v - dv)) * metric.scale_m;
    // In a clamped map, heights change between the outermost centres alone.
    let width = |at: f64, step: f64| {
        let inside =
            |at: f64| if map.wrap() == Wrap::Clamp { at.clamp(0.5 * step, 1.0 - 0.5 * step) } else { at };
        (inside(at + step) - inside(at - step)).max(0.5 * step)
    };
    let n = [-slope_u / (width(u, du) * metric.tile_m[0]), slope_v / (width(v, dv) * metric.tile_m[1]), 1.0];
    let length = n.iter().map(|part| part * part).sum::<f64>().sqrt();
    n.map(|part| part / length)
}

/// Returns the means that an eye sees through a point of the plane at the mean height. The point
/// lies over a texel's centre. The eye is at an azimuth in turns and a sine of the elevation.
fn seen(map: &HeightMap, metric: Metric, at: [u32; 2], turn: f64, sine: f64) -> [f64; 8] {
    let uv = [0, 1].map(|axis| (f64::from(at[axis]) + 0.5) / f64::from([map.width(), map.height()][axis]));
    let mean = map.texels().iter().map(|h| f64::from(*h)).sum::<f64>() / map.texels().len() as f64;
    let (sin, cos) = (turn * std::f64::consts::TAU).sin_cos();
    // Texture coordinates toward the eye, for a height of 1.
    let flat = (1.0 - sine * sine).sqrt() / sine * metric.scale_m;
    let toward = [cos * flat / metric.tile_m[0], sin * flat / metric.tile_m[1]];
    let over = |height: f64| [0, 1].map(|axis| uv[axis] + toward[axis] * (height - mean));
    let [high, low] = [over(1.0), over(0.0)];
    let path = Path {
        uv: high,
        duv: [low[0] - high[0], low[1] - high[1]],
        h: [1.0, -1.0, 0.0],
        exit: 1.0,
        base: 0.0,
        metric: PathMetric::unit(1.0),
    };
    let hit = cell_walk(map, &path).hit;
    let [x, y, z] = normal(map, metric, if hit.found { hit.uv } else { uv });
    [x, y, z, x * x, x * y, y * y, x * z, y * z]
}

/// Returns the texels that one texel covers when a row of `from` texels becomes a row of `to`
/// texels, and the share of each.
fn parts(texel: u32, from: u32, to: u32) -> Vec<(u32, f64)> {
    let [from_f, to_f] = [from, to].map(f64::from);
    let edge = |texel: u32| f64::from(texel) / to_f * from_f;
    let (start, end) = (edge(texel), edge(texel + 1));
    let part = |at: u32| (end.min(f64::from(at) + 1.0) - start.max(f64::from(at))).max(0.0) / (end - start);
    (0..from).map(|at| (at, part(at))).filter(|(_, part)| *part > 0.0).collect()
}

/// Returns the means over a level of half the sides, rounded down but at least 1, and its size.
fn halved(values: &[[f64; 8]], [width, height]: [u32; 2]) -> (Vec<[f64; 8]>, [u32; 2]) {
    let half = [width, height].map(|side| (side / 2).max(1));
    let mean = |texel: u32| {
        let mut mean = [0.0; 8];
        for (j, down) in parts(texel / half[0], height, half[1]) {
            for (i, across) in parts(texel % half[0], width, half[0]) {
                let value = values[(j * width + i) as usize];
                mean.iter_mut().zip(value).for_each(|(mean, value)| *mean += down * across * value);
            }
        }
        mean
    };
    ((0..half[0] * half[1]).map(mean).collect(), half)
}

/// Returns the part of a map's stored values that differ by more than rounding from the means of
/// rays. The rays come from azimuths `aside` turns away.
fn off(map: &HeightMap, aside: f64) -> f64 {
    let metric = Metric::new([2.0, 0.7], 0.25).expect("lengths");
    let settings = [("azimuths", f64::from(AZIMUTHS)), ("elevations", f64::from(ELEVATIONS))];
    let texture = stored::textures(&KIND, map, metric, &settings).expect("a bake").remove(0);
    let of_direction = |direction: u32| {
        let turn = f64::from(direction / ELEVATIONS) / f64::from(AZIMUTHS) + aside;
        let sine = f64::from(direction % ELEVATIONS + 1) / f64::from(ELEVATIONS);
        let mut size = [map.width(), map.height()];
        let texels = (0..size[1]).flat_map(|j| (0..size[0]).map(move |i| [i, j]));
        let mut means: Vec<[f64; 8]> = texels.map(|at| seen(map, metric, at, turn, sine)).collect();
        for _ in 0..2 {
            (means, size) = halved(&means, size);
        }
        let (mut wrong, mut all) = (0, 0);
        for (level, planes) in texture.levels.iter().enumerate() {
            assert_eq!(texture.texture.level_size(level), [size[0], size[1], 2 * AZIMUTHS * ELEVATIONS]);
            for (texel, mean) in means.iter().enumerate() {
                for (k, mean) in mean.iter().enumerate() {
                    let slice = (2 * direction as usize + k / 4) * means.len();
                    let value = f64::from(planes[k % 4][slice + texel]);
                    wrong += usize::from((value - mean).abs() > 1e-4);
                    all += 1;
                }
            }
            (means, size) = halved(&means, size);
        }
        (wrong, all)
    };
    let directions = (0..AZIMUTHS * ELEVATIONS).into_par_iter().map(of_direction);
    let (wrong, all) = directions.reduce(|| (0, 0), |(a, b), (c, d)| (a + c, b + d));
    wrong as f64 / all as f64
}

#[test]
fn means_are_those_of_exact_rays() {
    for named in maps::ALL {
        for wrap in Wrap::ALL {
            let off = off(&named.build(wrap), 0.0);
            println!("{} {wrap}: {off:.5} off", named.name);
            // A ray that grazes an edge may pass it by a rounding, and then sees another normal.
            assert!(off < 0.01, "{} {wrap}: {off} of the values are off", named.name);
        }
    }
}

#[test]
fn another_direction_is_noticed() {
    for wrap in Wrap::ALL {
        for aside in [0.01, 0.5] {
            let off = off(&maps::ALL[3].build(wrap), aside);
            assert!(off > 0.3, "{wrap}, {aside} turns aside: {off} of the values are off");
        }
    }
}

#[test]
fn straight_down_all_azimuths_see_the_same() {
    let map = maps::ALL[2].build(Wrap::Mirror);
    let texture = stored::textures(&KIND, &map, Metric::UNIT, &[]).expect("a bake").remove(0);
    let [width, height, slices] = texture.texture.size;
    let [azimuths, elevations] = [8, 4];
    assert_eq!(slices, 2 * azimuths * elevations);
    let area = (width * height) as usize;
    for plane in &texture.levels[0] {
        let slice = |azimuth: u32| {
            let start = 2 * (azimuth * elevations + elevations - 1) as usize * area;
            &plane[start..start + 2 * area]
        };
        assert!((1..azimuths).all(|azimuth| slice(azimuth) == slice(0)));
    }
}
