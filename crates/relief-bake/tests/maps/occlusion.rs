//! Ambient occlusion and bent normals against exact rays.

use std::f64::consts::TAU;

use rayon::prelude::*;
use relief_bake::kind::{bent_normal, occlusion};
use relief_bake::{Collected, bake};
use relief_core::exact::cell_walk;
use relief_core::{HeightMap, Metric, Path, Watch, Wrap};
use relief_testing::brute::sky::Sky;
use relief_testing::maps;

/// Rays a texel: the azimuths, and the elevations in each.
const RAYS: [u32; 2] = [64, 16];

fn metric() -> Metric {
    Metric::new([1.0, 1.3], 0.15).expect("a valid metric")
}

/// Returns the visibility about the base normal and the mean open direction of a texel, by exact
/// rays.
fn exact(map: &HeightMap, texel: usize) -> (f64, [f64; 3]) {
    let Metric { tile_m, scale_m } = metric();
    let (width, height) = (f64::from(map.width()), f64::from(map.height()));
    let place = [texel % map.width() as usize, texel / map.width() as usize].map(|x| x as f64 + 0.5);
    let own = f64::from(map.texels()[texel]);
    let (mut open, mut sum) = (0.0, [0.0; 3]);
    for a in 0..RAYS[0] {
        let (sin, cos) = (TAU * (f64::from(a) + 0.5) / f64::from(RAYS[0])).sin_cos();
        for e in 0..RAYS[1] {
            // Equally spaced in the sine: the same solid angle each.
            let up = (f64::from(e) + 0.5) / f64::from(RAYS[1]);
            let flat = (1.0 - up * up).sqrt();
            let start = [place[0] / width, place[1] / height, own + 1e-7];
            let mut path = Path::between(start, start);
            path.duv = [cos * flat / tile_m[0], sin * flat / tile_m[1]];
            path.h[1] = up / scale_m;
            path.exit = 1.0 / path.h[1];
            if !cell_walk(map, &path).hit.found {
                open += up;
                sum = [sum[0] + cos * flat, sum[1] - sin * flat, sum[2] + up];
            }
        }
    }
    let length = sum.iter().map(|x| x * x).sum::<f64>().sqrt();
    (open * 2.0 / f64::from(RAYS[0] * RAYS[1]), sum.map(|x| x / length))
}

/// Returns maps small enough for a thousand rays a texel.
fn small_maps() -> Vec<HeightMap> {
    let ground = |wrap| HeightMap::new(24, 20, maps::fractal(9, 24, 20, 0.5), wrap).expect("a valid map");
    let mut all: Vec<HeightMap> = Wrap::ALL.into_iter().map(ground).collect();
    all.push(maps::ALL[4].build(Wrap::Repeat));
    all.push(maps::ALL[6].build(Wrap::Clamp));
    all.push(maps::ALL[13].build(Wrap::Mirror));
    all
}

/// Returns the root mean square errors of the visibility and of the bent normal's angle in degrees.
fn errors(map: &HeightMap, open: &[f32], normals: &[Vec<f32>; 3]) -> [f64; 2] {
    let squares: Vec<[f64; 2]> = (0..map.texels().len())
        .into_par_iter()
        .map(|texel| {
            let (visible, normal) = exact(map, texel);
            let cosine: f64 = normal.iter().zip(normals).map(|(a, plane)| a * f64::from(plane[texel])).sum();
            [(visible - f64::from(open[texel])).powi(2), cosine.min(1.0).acos().to_degrees().powi(2)]
        })
        .collect();
    [0, 1].map(|k| (squares.iter().map(|square| square[k]).sum::<f64>() / squares.len() as f64).sqrt())
}

#[test]
fn closed_forms_agree_with_a_thousand_rays() {
    for map in small_maps() {
        let watch = Watch::none();
        let open = occlusion::visibility(&map, metric(), 32, 4, &watch).expect("not cancelled");
        let normals = bent_normal::bent_normals(&map, metric(), 32, 4, &watch).expect("not cancelled");
        let [visibility, degrees] = errors(&map, &open, &normals);
        println!("{}x{} {}: {visibility}, {degrees} degrees", map.width(), map.height(), map.wrap());
        assert!(visibility < 0.02 && degrees < 1.5, "{visibility}, {degrees} degrees");
        // The wrong green, or a visibility without the cosine, would not pass.
        if map.height() == 20 {
            let [x, y, z] = &normals;
            let flipped = [x.clone(), y.iter().map(|y| -y).collect(), z.clone()];
            let uniform: Vec<f32> = open.iter().map(|open| 1.0 - (1.0 - open).max(0.0).sqrt()).collect();
            let [visibility, degrees] = errors(&map, &uniform, &flipped);
            assert!(visibility > 0.02 && degrees > 1.5, "{visibility}, {degrees} degrees");
        }
    }
}

#[test]
fn a_sum_over_the_same_horizons_is_the_same() {
    let metric = metric();
    for map in [maps::ALL[3].build(Wrap::Repeat), maps::ALL[13].build(Wrap::Mirror)] {
        let highest = f64::from(map.texels().iter().copied().fold(0.0, f32::max));
        let (texel_m, reach) = (metric.texel_m(&map), f64::from(map.width().max(map.height()).max(64)));
        let sky = Sky { texel_m, scale_m: metric.scale_m, azimuths: 16, reach, highest };
        let watch = Watch::none();
        let open = occlusion::visibility(&map, metric, 16, 1, &watch).expect("not cancelled");
        let normals = bent_normal::bent_normals(&map, metric, 16, 1, &watch).expect("not cancelled");
        let (mut off, mut turned) = (0.0f64, 0.0f64);
        for texel in (0..map.texels().len()).step_by(7) {
            let place = [texel as u32 % map.width(), texel as u32 / map.width()];
            off = off.max((sky.visibility(&map, place) - f64::from(open[texel])).abs());
            let bent = sky.bent_normal(&map, place);
            let apart = (0..3).map(|k| (bent[k] - f64::from(normals[k][texel])).powi(2)).sum::<f64>();
            turned = turned.max(apart.sqrt());
        }
        // Error of the horizons themselves.
        assert!(off < 0.01 && turned < 0.02, "{off} and {turned}");
    }
}

#[test]
fn an_open_plain_is_open() {
    let map = maps::ALL[7].build(Wrap::Repeat);
    for kind in [&occlusion::KIND, &bent_normal::KIND] {
        for bits in [0.0, 8.0, 16.0] {
            let mut settings = kind.defaults();
            settings.set("bits", bits).expect("in range");
            let mut sink = Collected::default();
            bake(kind, &map, metric(), &settings, &Watch::none(), &mut sink).expect("not cancelled");
            let planes = &sink.textures[0].levels[0];
            let last = planes.last().expect("a channel");
            assert!(last.iter().all(|x| *x == 1.0), "{}", kind.name);
            for plane in &planes[..planes.len() - 1] {
                assert!(plane.iter().all(|x| x.abs() < 0.005), "{}", kind.name);
            }
        }
    }
}

#[test]
fn a_pit_is_dark_and_its_walls_turn_light_inward() {
    let pit = |i: u32, j: u32| if (5..11).contains(&i) && (5..11).contains(&j) { 0.0 } else { 1.0 };
    let map = HeightMap::from_fn(16, 16, Wrap::Clamp, pit).expect("a valid map");
    let metric = Metric::unit_tile(0.5).expect("a valid metric");
    let open = occlusion::visibility(&map, metric, 16, 1, &Watch::none()).expect("not cancelled");
    let normals = bent_normal::bent_normals(&map, metric, 16, 1, &Watch::none()).expect("not cancelled");
    assert_eq!(open[0], 1.0);
    assert!(open[8 * 16 + 8] < 0.3 && open[5 * 16 + 5] < open[8 * 16 + 8]);
    let normal = |texel: usize| normals.each_ref().map(|plane| plane[texel]);
    let west = normal(8 * 16 + 5);
    assert!(west[0] > 0.1, "the sky is in the east: {west:?}");
    let north = normal(5 * 16 + 8);
    assert!(north[1] < -0.1, "the sky is in the south, which is down in the picture: {north:?}");
    let length = |n: [f32; 3]| n.iter().map(|x| x * x).sum::<f32>();
    assert!((0..map.texels().len()).all(|texel| (length(normal(texel)) - 1.0).abs() < 1e-5));
}
