//! The kind `relaxed-cone`: no falling ray comes out inside a cone, and its cones are wider than
//! `cone`'s.

use rayon::prelude::*;
use relief_bake::kind::cone::{ConeApex, cone_ratios};
use relief_bake::kind::relaxed_cone::{KIND, RelaxedApex, relaxed_cone_ratios};
use relief_core::rng::Rng;
use relief_core::{HeightMap, Metric, Watch, Wrap};
use relief_testing::brute::relaxed_cone as brute;
use relief_testing::maps;
use relief_testing::probes::relaxed_cone::{Exit, Probes, attack};
use relief_tests::probes::stored::at;
use relief_tests::probes::{run, stored};

/// Probes of each map in each form.
const PROBES: usize = 100_000;

/// Texels of each map tested by brute force, in each wrap.
const TEXELS: usize = 12;

/// Samples along the side of a patch, and the factor by which they are finer on its edges.
const SAMPLES: [usize; 2] = [16, 1];

/// Samples beside level ground, where the supremum is mostly at a place between the others, often
/// on an edge.
const FINE_SAMPLES: [usize; 2] = [32, 5];

fn metric(k: usize) -> Metric {
    Metric::new([[1.0, 1.0], [3.0, 0.7]][k % 2], 0.1).expect("positive lengths")
}

fn relaxed(map: &HeightMap, metric: &Metric, apex: RelaxedApex) -> Vec<f32> {
    relaxed_cone_ratios(map, metric, apex, &Watch::none()).expect("nobody cancels")
}

fn slope(ratios: &[f32], place: usize) -> f64 {
    1.0 / f64::from(ratios[place])
}

/// Compares the slopes required by brute force, from apexes of texels of a map, with relaxed cones
/// and cones. Sampling patches misses some of a supremum, and never exceeds it.
fn compare(name: &str, map: &HeightMap, metric: &Metric, seed: u64, samples: [usize; 2]) {
    let name = &format!("{name} {}", map.wrap());
    let texel_m = metric.texel_m(map);
    let highest = f64::from(map.texels().iter().copied().fold(0.0, f32::max));
    let most = 2 * i64::from(map.width().max(map.height())) + 2;
    let find = |texel: [i64; 2], apex: [f64; 2], samples: [usize; 2]| {
        brute::slope(map, texel_m, texel, apex, samples, highest, most)
    };
    // Effect of an error of a few 1e-15 heights on slopes that are 0.
    let least = 1e-11 / texel_m[0].min(texel_m[1]);
    let from_centre = relaxed(map, metric, RelaxedApex::Centre);
    let from_square = relaxed(map, metric, RelaxedApex::Footprint);
    let mut rng = Rng::new(seed);
    let (mut sum, mut slow_sum) = (0.0, 0.0);
    for _ in 0..TEXELS {
        let texel = [rng.below(map.width()), rng.below(map.height())].map(i64::from);
        let place = texel[1] as usize * map.width() as usize + texel[0] as usize;
        let (fast, slow) = (slope(&from_centre, place), find(texel, [0.0; 2], samples));
        assert!(fast >= slow, "{name} {texel:?}: {fast} and {slow} found");
        assert!(fast <= 1.2 * slow + least, "{name} {texel:?}: {fast} and {slow}");
        (sum, slow_sum) = (sum + fast, slow_sum + slow);
        let bound = slope(&from_square, place);
        for _ in 0..3 {
            let apex = [0; 2].map(|_| match rng.below(3) {
                0 => rng.pick(&[-0.5, 0.0, 0.5]),
                _ => rng.between(-0.5, 0.5),
            });
            let slow = find(texel, apex, SAMPLES);
            assert!(bound >= slow * (1.0 - 1e-9), "{name} {texel:?} {apex:?}: {bound} and {slow} found");
        }
    }
    let lost = sum / slow_sum.max(1e-9);
    assert!(sum <= TEXELS as f64 * least || lost < 1.02, "{name}: {lost} of what brute force finds");
    for (ratios, apex) in [(from_centre, ConeApex::Centre), (from_square, ConeApex::Footprint)] {
        let cones = cone_ratios(map, metric, apex, &Watch::none()).expect("nobody cancels");
        for place in 0..cones.len() {
            let (relaxed, cone) = (slope(&ratios, place), slope(&cones, place));
            assert!(
                relaxed <= cone * (1.0 + 2e-5) + least,
                "{name} {apex:?} texel {place}: {relaxed} and {cone} of a cone"
            );
        }
    }
}

#[test]
fn is_between_brute_force_and_the_cone_and_from_centres_equal_to_brute_force() {
    let cases: Vec<(usize, usize)> =
        (0..maps::ALL.len()).flat_map(|k| (0..Wrap::ALL.len()).map(move |wrap| (k, wrap))).collect();
    cases.into_par_iter().for_each(|(k, wrap)| {
        let map = maps::ALL[k].build(Wrap::ALL[wrap]);
        compare(maps::ALL[k].name, &map, &metric(k + wrap), k as u64, SAMPLES);
    });
}

/// Returns the number of a level at a column and a row.
type Level = fn(u32, u32) -> u32;

/// Maps with level ground, with their sizes and heights: terraces along an axis and askew, with
/// steps of any width, plateaus, and natural ground of few heights.
const LEVEL: [(&str, [u32; 2], Level); 9] = [
    ("row with a plateau", [8, 1], |i, _| u32::from((2..6).contains(&i))),
    ("column of terraces", [1, 31], |_, j| j / 4),
    ("terraces", [40, 19], |i, _| i / 5),
    ("terraces to and fro", [37, 24], |i, _| (i / 6).min((36 - i) / 6)),
    ("terraces askew", [33, 29], |i, j| (i + j) / 4),
    ("terraces of an odd tilt", [31, 34], |i, j| (2 * i + 3 * j) / 9),
    ("plateaus", [32, 27], |i, j| u32::from(i / 5 % 2 == 0) + 2 * u32::from(j / 7 % 2 == 0)),
    ("a stepped pyramid", [35, 33], |i, j| i.abs_diff(17).max(j.abs_diff(16)) / 3),
    ("hollows", [30, 30], |i, j| 5 - (i * i / 7 + j * j / 5 + 3 * i) % 6),
];

fn level(k: usize, wrap: Wrap) -> HeightMap {
    let (_, [width, height], heights) = LEVEL[k];
    HeightMap::from_fn(width, height, wrap, |i, j| heights(i, j) as f32 / 12.0).expect("a valid map")
}

#[test]
fn level_ground_limits_no_cone_but_where_it_falls_off() {
    let cases: Vec<(usize, usize)> =
        (0..LEVEL.len()).flat_map(|k| (0..Wrap::ALL.len()).map(move |wrap| (k, wrap))).collect();
    cases.into_par_iter().for_each(|(k, wrap)| {
        compare(LEVEL[k].0, &level(k, Wrap::ALL[wrap]), &metric(k + wrap), k as u64, FINE_SAMPLES);
    });
    let row = HeightMap::from_fn(8, 1, Wrap::Clamp, |i, _| f32::from(u8::from((2..6).contains(&i))));
    let (row, metric) = (row.expect("a valid map"), Metric::new([8.0, 1.0], 0.1).expect("lengths"));
    let ratios = relaxed(&row, &metric, RelaxedApex::Centre);
    // From the foot to the far edge of the level ground.
    assert!((ratios[1] - 4.0).abs() < 1e-4 && (ratios[0] - 5.0).abs() < 1e-4, "{ratios:?}");
    assert!(ratios[2..6].iter().all(|ratio| *ratio > 1e9), "{ratios:?}");
    // From the square of the texel at the foot, the way to that edge is half a texel shorter, and
    // the rise is half.
    let ratios = relaxed(&row, &metric, RelaxedApex::Footprint);
    assert!(ratios[1] > 3.4 && ratios[2] > 4.9, "{ratios:?}");
}

#[test]
fn no_falling_ray_comes_out_in_a_cone_beside_level_ground() {
    (0..LEVEL.len()).into_par_iter().for_each(|k| {
        for wrap in Wrap::ALL {
            let (map, metric) = (level(k, wrap), metric(k));
            for (apex, footprint) in [(RelaxedApex::Centre, false), (RelaxedApex::Footprint, true)] {
                let ratios = relaxed(&map, &metric, apex);
                let probes = Probes::new(&map, metric.texel_m(&map), footprint, 7);
                let (found, _) = attack(probes, PROBES / 4, |exit| f64::from(at(&map, &ratios, exit.texel)));
                assert_eq!(found, 0, "{} {wrap} {apex:?}", LEVEL[k].0);
            }
        }
    });
}

#[test]
fn what_rounding_makes_of_a_rise_is_no_fall() {
    let height = 27_585.0 / 65_535.0;
    let map = HeightMap::from_fn(3, 3, Wrap::Clamp, |i, j| if (i, j) == (0, 0) { height } else { 0.0 });
    let (map, metric) = (map.expect("a valid map"), Metric::new([4.23, 1.0], 0.1).expect("lengths"));
    let ratios = relaxed(&map, &metric, RelaxedApex::Centre);
    let cones = cone_ratios(&map, &metric, ConeApex::Centre, &Watch::none()).expect("nobody cancels");
    // Seen from the middle the patch beside the peak only rises.
    assert!(cones[4] > 3.44 && ratios[4] >= cones[4], "{} and {} of a cone", ratios[4], cones[4]);
}

#[test]
fn no_falling_ray_comes_out_in_a_cone() {
    for case in [0, 8, 16].into_iter().flat_map(|bits| run::cases(KIND.name, bits)) {
        let outcome = run::run(&case, PROBES, &|_| {}).expect("a bake");
        assert_eq!(outcome.violations, 0, "{case:?}: {outcome:?}");
    }
}

#[test]
fn a_map_loosened_past_its_tightest_ray_is_caught() {
    (0..run::MAPS.len()).into_par_iter().for_each(|k| {
        let (map, metric) = (run::map(k), metric(k));
        for bits in [8, 16] {
            let set = [("bits", f64::from(bits)), ("apex", 0.0)];
            let values = stored::ratios(&stored::textures(&KIND, &map, metric, &set).expect("a bake")[0]);
            let heights = stored::heights(&map, bits).expect("a valid map");
            let probes = || Probes::new(&heights, metric.texel_m(&heights), false, 3);
            let ratio = |exit: &Exit| at(&heights, &values, exit.texel);
            let (_, tightest) = attack(probes(), PROBES, ratio);
            let tightest = tightest.expect("there are probes");
            if tightest.limit.is_infinite() {
                continue;
            }
            let loosened = stored::ratio_above(tightest.limit, &metric, bits);
            let caught =
                attack(
                    probes(),
                    PROBES,
                    |exit| {
                        if exit.texel == tightest.texel { loosened } else { ratio(exit) }
                    },
                );
            assert!(caught.0 > 0, "{:?} with {bits} bits: {tightest:?}", run::MAPS[k]);
        }
    });
}

#[test]
fn relaxed_cones_are_wider() {
    for k in [0, 1, 2] {
        let (map, metric) = (run::map(k), metric(k));
        for (region, apex, most) in [
            (RelaxedApex::Centre, ConeApex::Centre, 0.9),
            (RelaxedApex::Footprint, ConeApex::Footprint, 0.999),
        ] {
            let wide = relaxed(&map, &metric, region);
            let narrow = cone_ratios(&map, &metric, apex, &Watch::none()).expect("nobody cancels");
            let mean = |ratios: &[f32]| {
                ratios.iter().map(|&m| 1.0 / f64::from(m)).sum::<f64>() / ratios.len() as f64
            };
            let part = mean(&wide) / mean(&narrow);
            println!("{:?} {region:?}: {part:.3} of the mean slope of `cone`", run::MAPS[k]);
            assert!(part < most, "{:?} {region:?}: {part}", run::MAPS[k]);
        }
    }
}

#[test]
fn tiles_very_much_longer_than_wide_get_plain_cones() {
    // Found by fuzzing: the images near enough to matter were millions.
    let metric = Metric::new([0.00390625, 128.0], 128.0).expect("lengths");
    let rough = |i: u32, j: u32| ((i * 7 + j * 13) % 11) as f32 / 10.0;
    let nearly_level = |i: u32, j: u32| if (i, j) == (1, 0) { 0.1 } else { 0.0 };
    for wrap in [Wrap::Repeat, Wrap::Mirror] {
        for map in [HeightMap::from_fn(16, 16, wrap, rough), HeightMap::from_fn(13, 16, wrap, nearly_level)] {
            let map = map.expect("a valid map");
            let relaxed = relaxed_cone_ratios(&map, &metric, RelaxedApex::Footprint, &Watch::none());
            let plain = cone_ratios(&map, &metric, ConeApex::Footprint, &Watch::none());
            assert_eq!(relaxed.expect("a bake"), plain.expect("a bake"));
        }
    }
}
