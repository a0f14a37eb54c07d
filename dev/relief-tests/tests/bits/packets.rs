//! Packets of rays have the answers of the exact tracer one by one, to the last bit.

use rayon::prelude::*;
use relief_core::exact::{ExactHit, FastTracer};
use relief_core::{Cost, HeightMap, Lanes, Path, Wrap};
use relief_testing::maps;
use relief_testing::rays::Rays;

/// Paths of a map, width and wrap.
const PATHS: usize = 6_000;

/// All numbers of an answer, as bits.
fn bits(answer: &ExactHit) -> [u64; 12] {
    let ExactHit { hit, cell, slope, clearance } = answer;
    let cost = hit.cost;
    [
        u64::from(hit.found) + 2 * u64::from(hit.exhausted),
        hit.uv[0].to_bits(),
        hit.uv[1].to_bits(),
        hit.height.to_bits(),
        hit.t.to_bits(),
        u64::from(cost.reads),
        u64::from(cost.steps),
        u64::from(cost.bytes),
        cell[0] as u64,
        cell[1] as u64,
        slope.to_bits(),
        clearance.to_bits(),
    ]
}

/// Views, falling and rising, of 4 x 4 pixels side by side, as far apart as texels or farther.
fn pictures(map: &HeightMap, count: usize) -> Vec<Path> {
    let pixel = |number: usize| {
        let (block, place) = (number / 16, number % 16);
        let [x, y] = [place % 4 + 4 * (block % 11), place / 4 + 4 * (block / 11)].map(|at| at as f64);
        let apart = [0.3, 1.0, 4.0][block % 3];
        let [u, v] = [0.1 + apart * x / f64::from(map.width()), 0.2 + apart * y / f64::from(map.height())];
        let steep = 1.0 / [0.6, 2.0, 9.0][block % 3];
        let way = [[0.1, 0.07], [-0.12, 0.02], [0.0, 0.2]][block / 3 % 3];
        let [from, to] = if block % 5 == 4 { [0.3, 1.0] } else { [1.0, 0.0] };
        let steep = steep * (1.0 + 0.001 * x);
        Path::between([u, v, from], [u + way[0] / steep, v + way[1] / steep, to])
    };
    (0..count).map(pixel).collect()
}

/// Adversarial paths, and some values that are no paths at all.
fn adversarial(map: &HeightMap, count: usize) -> Vec<Path> {
    let broken = |(number, mut path): (usize, Path)| {
        match number % 101 {
            7 => path.uv[0] = f64::NAN,
            19 => path.h[1] = f64::INFINITY,
            31 => path.duv[1] = f64::NEG_INFINITY,
            43 => path.exit = f64::NAN,
            57 => path.exit = -1.0,
            _ => {}
        }
        path
    };
    Rays::new(map, 5).map(|(_, path)| path).take(count).enumerate().map(broken).collect()
}

/// First answer in packets that differs from another tracer's single one.
fn first_different(tracer: &FastTracer, oracle: &FastTracer, paths: &[Path], lanes: Lanes) -> Option<usize> {
    let mut answers = vec![ExactHit::miss(Cost::default(), 0.0); paths.len()];
    tracer.trace_all(paths, lanes, &mut answers);
    let mut blocked = vec![false; paths.len()];
    tracer.is_blocked_all(paths, lanes, &mut blocked);
    (0..paths.len()).find(|&at| {
        let expected = oracle.trace(&paths[at]);
        bits(&answers[at]) != bits(&expected) || blocked[at] != oracle.is_blocked(&paths[at])
    })
}

#[test]
fn every_answer_has_the_bits_of_one_by_one() {
    let cases: Vec<_> = maps::ALL.iter().flat_map(|named| Wrap::ALL.map(|wrap| (named, wrap))).collect();
    let hits: usize = cases
        .par_iter()
        .map(|(named, wrap)| {
            let map = named.build(*wrap);
            let tracer = FastTracer::new(&map);
            let all = [pictures(&map, PATHS), adversarial(&map, PATHS)];
            for paths in &all {
                for lanes in Lanes::available() {
                    // Packets that are not full, too.
                    for paths in [&paths[..], &paths[..PATHS - 5]] {
                        let different = first_different(&tracer, &tracer, paths, lanes);
                        let path = different.map(|at| (at, paths[at]));
                        assert!(different.is_none(), "{} {wrap} {lanes} lanes: {path:?}", named.name);
                    }
                }
            }
            all.iter().flatten().filter(|path| tracer.trace(path).hit.found).count()
        })
        .sum();
    let all = cases.len() * 2 * PATHS;
    println!("{hits} hits of {all} paths");
    assert!(hits > all / 4 && hits < all * 9 / 10, "{hits} of {all}");
}

#[test]
fn a_texel_that_is_another_one_is_noticed() {
    let map = HeightMap::from_fn(40, 30, Wrap::Repeat, |i, j| ((i * 7 + j * 5) % 11) as f32 / 10.0);
    let other = HeightMap::from_fn(40, 30, Wrap::Repeat, |i, j| {
        let texel = ((i * 7 + j * 5) % 11) as f32 / 10.0;
        if (i, j) == (9, 12) { (texel + 1e-6).min(1.0) } else { texel }
    });
    let [map, other] = [map, other].map(|map| map.expect("a map"));
    let [own, wrong] = [&map, &other].map(FastTracer::new);
    let paths = pictures(&map, PATHS);
    for lanes in Lanes::available() {
        assert!(first_different(&own, &own, &paths, lanes).is_none());
        assert!(first_different(&wrong, &own, &paths, lanes).is_some(), "{lanes}");
    }
}
