//! The kind `relaxed-cone`: no falling ray comes out inside a cone, and cones are wider than those of `cone`.

use rayon::prelude::*;
use relief_bake::Progress;
use relief_bake::kind::cone::{ConeApex, cone_ratios};
use relief_bake::kind::relaxed_cone::{KIND, RelaxedApex, relaxed_cone_ratios};
use relief_core::{HeightMap, Metric, Wrap};
use relief_tests::brute::relaxed_cone as brute;
use relief_tests::maps;
use relief_tests::probes::relaxed_cone::{Exit, Probes, attack};
use relief_tests::probes::stored::at;
use relief_tests::probes::{run, stored};
use relief_tests::rng::Rng;

/// Probes of each map in each form.
const PROBES: usize = 100_000;

/// Texels of each map, in each wrap, that brute force is run on, and its samples along the side of a patch.
const TEXELS: usize = 12;
const SAMPLES: i32 = 16;

fn metric(k: usize) -> Metric {
    Metric::new([[1.0, 1.0], [3.0, 0.7]][k % 2], 0.1).expect("positive lengths")
}

fn relaxed(map: &HeightMap, metric: &Metric, apex: RelaxedApex) -> Vec<f32> {
    relaxed_cone_ratios(map, metric, apex, &Progress::none()).expect("nobody cancels")
}

fn slope(ratios: &[f32], place: usize) -> f64 {
    1.0 / f64::from(ratios[place])
}

/// The slopes that brute force asks for, from apexes of texels of every map in every wrap, beside those of
/// relaxed cones and of cones. Sampling patches misses some of a supremum, never finds more.
#[test]
fn is_between_brute_force_and_the_cone_and_from_centres_equal_to_brute_force() {
    let cases: Vec<(usize, usize)> =
        (0..maps::ALL.len()).flat_map(|k| (0..Wrap::ALL.len()).map(move |wrap| (k, wrap))).collect();
    cases.into_par_iter().for_each(|(k, wrap)| {
        let map = maps::ALL[k].build(Wrap::ALL[wrap]);
        let (name, metric) = (maps::ALL[k].name, metric(k + wrap));
        let texel_m = metric.texel_m(&map);
        let highest = f64::from(map.texels().iter().copied().fold(0.0, f32::max));
        let most = 2 * i64::from(map.width().max(map.height())) + 2;
        let find = |texel: [i64; 2], apex: [f64; 2]| {
            brute::slope(&map, texel_m, texel, apex, SAMPLES, highest, most)
        };
        // What an error of a few 1e-15 heights makes of slopes that are 0.
        let least = 1e-11 / texel_m[0].min(texel_m[1]);
        let from_centre = relaxed(&map, &metric, RelaxedApex::Centre);
        let from_square = relaxed(&map, &metric, RelaxedApex::Footprint);
        let cones = cone_ratios(&map, &metric, ConeApex::Footprint, &Progress::none());
        let cones = cones.expect("nobody cancels");
        let mut rng = Rng::new(k as u64);
        let (mut sum, mut slow_sum) = (0.0, 0.0);
        for _ in 0..TEXELS {
            let texel = [rng.below(map.width()), rng.below(map.height())].map(i64::from);
            let place = texel[1] as usize * map.width() as usize + texel[0] as usize;
            let (fast, slow) = (slope(&from_centre, place), find(texel, [0.0; 2]));
            assert!(fast >= slow, "{name} {} {texel:?}: {fast} and {slow} found", Wrap::ALL[wrap]);
            assert!(fast <= 1.2 * slow + least, "{name} {} {texel:?}: {fast} and {slow}", Wrap::ALL[wrap]);
            (sum, slow_sum) = (sum + fast, slow_sum + slow);
            let (bound, cone) = (slope(&from_square, place), slope(&cones, place));
            assert!(bound <= cone * (1.0 + 1e-6) + least, "{name} {texel:?}: {bound} and {cone} of a cone");
            for _ in 0..3 {
                let apex = [0; 2].map(|_| match rng.below(3) {
                    0 => rng.pick(&[-0.5, 0.0, 0.5]),
                    _ => rng.between(-0.5, 0.5),
                });
                let slow = find(texel, apex);
                assert!(bound >= slow * (1.0 - 1e-9), "{name} {texel:?} {apex:?}: {bound} and {slow} found");
            }
        }
        let lost = sum / slow_sum.max(1e-9);
        assert!(sum <= TEXELS as f64 * least || lost < 1.02, "{name}: {lost} of what brute force finds");
    });
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
            let narrow = cone_ratios(&map, &metric, apex, &Progress::none()).expect("nobody cancels");
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
            let relaxed = relaxed_cone_ratios(&map, &metric, RelaxedApex::Footprint, &Progress::none());
            let plain = cone_ratios(&map, &metric, ConeApex::Footprint, &Progress::none());
            assert_eq!(relaxed.expect("a bake"), plain.expect("a bake"));
        }
    }
}
