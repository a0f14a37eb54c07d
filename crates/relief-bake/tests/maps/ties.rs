//! Cones and frusta of ground where much is equally steep, against brute force: searches skip most
//! of it.

use rayon::prelude::*;
use relief_bake::kind::cone::{ConeApex, cone_ratios};
use relief_bake::kind::frustum::frustum_map;
use relief_core::rng::Rng;
use relief_core::{HeightMap, Metric, Watch, Wrap};
use relief_testing::brute;

/// Texels of each map tested by brute force.
const TEXELS: usize = 8;

/// Columns and rows: no whole number of any node but the smallest.
const SIZE: [u32; 2] = [83, 70];

/// Excess of a cone's slope over the steepest, in heights a texel, by the rounding of equally steep
/// ground.
const STEP: f64 = 1.0 / (1u64 << 23) as f64;

/// Factor by which the slope of a frustum may exceed the least.
const TIE: f32 = 1.0 + 1.0 / 65536.0;

/// Height over a column and a row, from 0 to 1.
type Ground = fn(f64, f64) -> f64;

/// Ground where many slopes tie, exactly or up to the last bits of its heights.
const GROUND: [(&str, Ground); 10] = [
    ("a ramp of exact heights", |x, _| x / 128.0),
    ("a ramp", |x, _| x / 82.0),
    ("a plane of exact heights", |x, y| (3.0 * x - 2.0 * y + 160.0) / 512.0),
    ("a plane", |x, y| (2.0 * x + y) / 233.0),
    ("few levels", |x, _| (20.0 * x / 82.0).round() / 20.0),
    ("terraces", |_, y| (y / 5.0).floor() / 16.0),
    ("terraces askew", |x, y| ((2.0 * x + 3.0 * y) / 16.0).floor() / 32.0),
    ("a pyramid", |x, y| 1.0 - (x - 41.0).abs().max((y - 35.0).abs()) / 64.0),
    (
        "a roof with a chimney",
        |x, y| if [x, y] == [20.0, 30.0] { 1.0 } else { 0.5 - (x - 40.0).abs() / 128.0 },
    ),
    ("a bowl", |x, y| ((x - 40.0).powi(2) + (y - 30.0).powi(2)) / 4096.0),
];

fn maps() -> impl ParallelIterator<Item = (&'static str, HeightMap)> {
    let cases: Vec<_> = GROUND.into_iter().flat_map(|ground| Wrap::ALL.map(|wrap| (ground, wrap))).collect();
    cases.into_par_iter().map(|((name, height), wrap)| {
        let height = |i: u32, j: u32| height(f64::from(i), f64::from(j)) as f32;
        (name, HeightMap::from_fn(SIZE[0], SIZE[1], wrap, height).expect("heights between 0 and 1"))
    })
}

fn texels() -> impl Iterator<Item = [u32; 2]> {
    let mut rng = Rng::new(5);
    (0..TEXELS).map(move |_| SIZE.map(|side| rng.below(side)))
}

#[test]
fn cones_are_those_of_brute_force() {
    maps().for_each(|(name, map)| {
        for tile_m in [[1.0, 1.0], [3.0, 0.7]] {
            let metric = Metric::new(tile_m, 0.1).expect("lengths");
            let texel_m = metric.texel_m(&map);
            let highest = brute::frustum::highest(&map);
            for apex in [ConeApex::Centre, ConeApex::Footprint] {
                let ratios = cone_ratios(&map, &metric, apex, &Watch::none()).expect("nobody cancels");
                for [i, j] in texels() {
                    let (texel, footprint) = ([i, j].map(i64::from), apex == ConeApex::Footprint);
                    let slow = brute::cone::slope(&map, texel_m, footprint, texel, highest);
                    let fast = 1.0 / f64::from(ratios[(j * SIZE[0] + i) as usize]);
                    assert!(
                        fast >= slow && fast <= slow * (1.0 + 2e-5) + STEP / texel_m[0].min(texel_m[1]),
                        "{name} {} {apex:?} {texel:?}: {fast} and {slow} by brute force",
                        map.wrap()
                    );
                }
            }
        }
    });
}

#[test]
fn frusta_are_those_of_brute_force() {
    maps().for_each(|(name, map)| {
        let frusta = frustum_map(&map, &Watch::none()).expect("nobody cancels");
        let (highest, most) = (brute::frustum::highest(&map), 2 * i64::from(SIZE[0]) + 4);
        for [i, j] in texels() {
            for forward in [[true, true], [false, true], [true, false], [false, false]] {
                let cell = [i, j].map(i64::from);
                let slow = brute::frustum::least_slope(&map, highest, cell, forward, most).slope;
                let fast = f64::from(frusta.slopes(forward)[(j * SIZE[0] + i) as usize]);
                let above = f64::from((slow as f32 * TIE).next_up().next_up()) + 4e-15;
                let within = fast >= slow && fast <= above;
                assert!(within, "{name} {} {cell:?} {forward:?}: {fast:e} and {slow:e}", map.wrap());
            }
        }
    });
}
