//! The kind `cone`: equal to brute force, safe under attack, tight, and its cost in a search.

use std::sync::atomic::AtomicBool;

use rayon::prelude::*;
use relief_bake::kind::cone::{ConeApex, KIND, cone_ratios};
use relief_core::exact::least_gap;
use relief_core::rng::Rng;
use relief_core::{HeightMap, Metric, Path, Watch, Wrap};
use relief_testing::brute;
use relief_testing::maps::{self, fractal};
use relief_testing::probes::cone::{Contact, Probes, attack};
use relief_tests::accuracy;
use relief_tests::probes::stored::at;
use relief_tests::probes::{run, stored};

/// Probes of each map in each form.
const PROBES: usize = 100_000;

/// Texels of each map tested by brute force, in each wrap and for each type of apex.
const TEXELS: usize = 12;

/// Excess of a cone's slope over the steepest, in heights a texel, by the rounding of equally steep
/// ground.
const STEP: f64 = 1.0 / (1u64 << 23) as f64;

fn metric(k: usize) -> Metric {
    Metric::new([[1.0, 1.0], [3.0, 0.7]][k % 2], 0.1).expect("positive lengths")
}

fn ratios(map: &HeightMap, metric: &Metric, apex: ConeApex) -> Vec<f32> {
    cone_ratios(map, metric, apex, &Watch::none()).expect("nobody cancels")
}

#[test]
fn equals_brute_force() {
    let cases: Vec<(usize, usize)> =
        (0..maps::ALL.len()).flat_map(|k| (0..Wrap::ALL.len()).map(move |wrap| (k, wrap))).collect();
    cases.into_par_iter().for_each(|(k, wrap)| {
        let map = maps::ALL[k].build(Wrap::ALL[wrap]);
        let metric = metric(k + wrap);
        let texel_m = metric.texel_m(&map);
        let (width, texels) = (i64::from(map.width()), map.texels().len());
        let highest = f64::from(map.texels().iter().copied().fold(0.0, f32::max));
        let mut rng = Rng::new(k as u64);
        for apex in [ConeApex::Centre, ConeApex::Footprint] {
            let ratios = ratios(&map, &metric, apex);
            for place in 0..TEXELS.min(texels) {
                // The corners of the map, and texels anywhere.
                let corners = [0, width as usize - 1, texels - width as usize, texels - 1];
                let place = corners.get(place).copied().unwrap_or_else(|| rng.below(texels as u32) as usize);
                let texel = [place as i64 % width, place as i64 / width];
                let slow = brute::cone::slope(&map, texel_m, apex == ConeApex::Footprint, texel, highest);
                let fast = 1.0 / f64::from(ratios[place]);
                // A slope of 2⁻¹⁶ and a millionth more, and a step, is the stated slack.
                assert!(
                    fast >= slow && fast <= slow * (1.0 + 2e-5) + STEP / texel_m[0].min(texel_m[1]),
                    "{} {} {apex:?} texel {texel:?}: {fast} and {slow} by brute force",
                    maps::ALL[k].name,
                    Wrap::ALL[wrap]
                );
            }
        }
    });
}

#[test]
fn no_probe_finds_surface_in_a_cone() {
    for case in [0, 8, 16].into_iter().flat_map(|bits| run::cases(KIND.name, bits)) {
        let outcome = run::run(&case, PROBES, &|_| {}).expect("a bake");
        assert_eq!(outcome.violations, 0, "{case:?}: {outcome:?}");
    }
}

#[test]
fn a_map_loosened_by_one_step_is_caught() {
    (0..run::MAPS.len()).into_par_iter().for_each(|k| {
        let (map, metric) = (run::map(k), metric(k));
        for (bits, apex) in [(8, 1), (16, 1), (16, 0)] {
            let set = [("bits", f64::from(bits)), ("apex", f64::from(apex))];
            let values = stored::ratios(&stored::textures(&KIND, &map, metric, &set).expect("a bake")[0]);
            let heights = stored::heights(&map, bits).expect("a valid map");
            let probes = || Probes::new(&heights, metric.texel_m(&heights), apex == 1, 3);
            let ratio = |contact: &Contact| at(&heights, &values, contact.texel);
            let (_, tightest) = attack(probes(), PROBES, ratio);
            let tightest = tightest.expect("there are probes");
            if tightest.limit.is_infinite() {
                continue;
            }
            let loosened = stored::ratio_above(tightest.limit, &metric, bits);
            let caught = attack(probes(), PROBES, |contact| {
                if contact.texel == tightest.texel { loosened } else { ratio(contact) }
            });
            assert!(caught.0 > 0, "{:?} with {bits} bits: {tightest:?}", run::MAPS[k]);
        }
    });
}

/// Bilinear filter of four stored values.
fn filtered(
    map: &HeightMap,
    values: &[f64],
    [x, y]: [f64; 2],
    f: fn(f64) -> f64,
    back: fn(f64) -> f64,
) -> f64 {
    let (i, j) = (x.floor(), y.floor());
    let (u, v) = (x - i, y - j);
    let value = |by: [i64; 2]| f(at(map, values, [i as i64 + by[0], j as i64 + by[1]]));
    back(
        value([0, 0]) * (1.0 - u) * (1.0 - v)
            + value([1, 0]) * u * (1.0 - v)
            + value([0, 1]) * (1.0 - u) * v
            + value([1, 1]) * u * v,
    )
}

#[test]
fn the_filtered_variant_may_be_filtered_and_the_centres_may_not() {
    let map = &run::map(1);
    let metric = metric(0);
    let find = |apex: ConeApex, f: fn(f64) -> f64, back: fn(f64) -> f64| {
        let values: Vec<f64> = ratios(map, &metric, apex).into_iter().map(f64::from).collect();
        let probes = Probes::new(map, metric.texel_m(map), true, 5);
        attack(probes, PROBES, |contact| filtered(map, &values, contact.apex, f, back)).0
    };
    assert_eq!(find(ConeApex::Filtered, |m| m, |m| m), 0);
    assert_eq!(find(ConeApex::Filtered, f64::sqrt, |m| m * m), 0);
    for apex in [ConeApex::Centre, ConeApex::Footprint] {
        for (name, violations) in [
            ("ratios", find(apex, |m| m, |m| m)),
            ("their roots", find(apex, f64::sqrt, |m| m * m)),
            ("slopes", find(apex, |m| 1.0 / m, |m| 1.0 / m)),
        ] {
            println!("{apex:?}, {name} filtered: {violations} of {PROBES} probes find surface");
            assert!(violations > 0 || apex == ConeApex::Footprint, "{name} of centres filtered");
        }
    }
}

/// Use of the cones by a search.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Fetch {
    /// The apex moves to the ray.
    Moved,
    /// The apex stays at the nearest texel's centre; a ray outside of the cone proceeds to the next
    /// texel.
    Fixed,
}

/// Returns the steps of a cone-stepping search, and whether it has stepped past a hit. The search
/// ends within a thousandth of a texel of the surface, or where it leaves the relief.
fn search(
    map: &HeightMap,
    ratios: &[f32],
    fetch: Fetch,
    from: [f64; 2],
    step: [f64; 2],
    fall: f64,
) -> (usize, bool) {
    let sizes = [f64::from(map.width()), f64::from(map.height())];
    let finest = sizes[0].max(sizes[1]);
    let speed = step[0].hypot(step[1]);
    let (mut t, mut steps) = (0.0f64, 0);
    loop {
        let place = [from[0] + step[0] * t, from[1] + step[1] * t];
        let z = 1.0 - fall * t;
        let gap = z - map.height_at(place[0], place[1]);
        if gap < -1e-9 {
            return (steps, true);
        }
        if z <= 0.0 || gap < 1e-6 || steps >= 2000 {
            return (steps, false);
        }
        let texel = [0, 1].map(|axis: usize| (place[axis] * sizes[axis]).floor());
        let centre = [0, 1].map(|axis: usize| (texel[axis] + 0.5) / sizes[axis]);
        let ratio = f64::from(at(map, ratios, texel.map(|k| k as i64)));
        // Steps below a thousandth of a texel end the search.
        let least = 1e-3 / finest / speed;
        let advance = match fetch {
            Fetch::Moved => gap * ratio / (speed + fall * ratio),
            Fetch::Fixed => {
                let apex = map.height_at(centre[0], centre[1]);
                let aside = [place[0] - centre[0], place[1] - centre[1]];
                // |aside + step t| = ratio (z - fall t - apex)
                let room = ratio * (z - apex);
                let c = aside[0] * aside[0] + aside[1] * aside[1] - room * room;
                let b = aside[0] * step[0] + aside[1] * step[1] + room * ratio * fall;
                let a = speed * speed - ratio * ratio * fall * fall;
                let leave = if room > 0.0 && c < 0.0 {
                    let root = (b * b - a * c).max(0.0).sqrt();
                    if b > 0.0 { -c / (b + root) } else { (root - b) / a }
                } else {
                    0.0
                };
                // To the border of the texel, whose four patches a search solves exactly.
                let border = (0..2).fold(f64::INFINITY, |t, axis| {
                    let side = if step[axis] > 0.0 { texel[axis] + 1.0 } else { texel[axis] };
                    if step[axis] == 0.0 { t } else { t.min((side / sizes[axis] - place[axis]) / step[axis]) }
                });
                if leave < border {
                    // The patches of the texel are solved: the first hit in it ends the search.
                    let path = Path::between(
                        [from[0], from[1], 1.0],
                        [from[0] + step[0], from[1] + step[1], 1.0 - fall],
                    );
                    let path = Path { exit: f64::INFINITY, ..path };
                    let hit = least_gap(map, &path, t, t + border + least) <= 1e-9;
                    if hit {
                        return (steps + 1, false);
                    }
                }
                leave.max(border + least)
            }
        };
        if advance < least {
            return (steps, false);
        }
        t += advance;
        steps += 1;
    }
}

#[test]
fn any_start_in_the_texel_is_safe_and_costs_no_step() {
    let ground = |roughness| {
        HeightMap::new(128, 128, fractal(7, 128, 128, roughness), Wrap::Repeat).expect("a valid map")
    };
    // Cost of cones that may be moved to the ray: little where maps are smooth from texel to texel,
    // more at walls of a texel's width.
    let mut cases =
        vec![("smooth ground", ground(0.4), 1.10, 1.15), ("rough ground", ground(0.5), 1.15, 1.15)];
    for (name, most_slope, most_steps) in [("jacksboro", 1.3, 1.3), ("cobbles", 1.5, 1.5)] {
        let named = accuracy::maps().into_iter().find(|named| named.name == name);
        cases.push((name, named.expect("a map of the accuracy tables").map, most_slope, most_steps));
    }
    for (name, map, most_slope, most_steps) in cases {
        let metric = metric(0);
        let mut rng = Rng::new(1);
        let rays: Vec<([f64; 2], [f64; 2], f64)> = (0..1000)
            .map(|_| {
                let (angle, run) = (rng.between(0.0, std::f64::consts::TAU), rng.between(-5.0, 0.0).exp2());
                ([rng.unit(), rng.unit()], [angle.cos() * run, angle.sin() * run], 1.0)
            })
            .collect();
        let measure = |what: &str, ratios: &[f32], fetch: Fetch| {
            let slope = ratios.iter().map(|&m| 1.0 / f64::from(m)).sum::<f64>() / ratios.len() as f64;
            let runs: Vec<(usize, bool)> = rays
                .par_iter()
                .map(|&(from, step, fall)| search(&map, ratios, fetch, from, step, fall))
                .collect();
            let steps = runs.iter().map(|run| run.0).sum::<usize>() as f64 / runs.len() as f64;
            let late = runs.iter().filter(|run| run.1).count();
            println!("{name}, {what} {fetch:?}: mean slope {slope:.4}, {steps:.2} steps a ray, {late} late");
            (slope, steps, late)
        };
        let of = |apex: ConeApex| ratios(&map, &metric, apex);
        let stored = stored::ratios(&stored::textures(&KIND, &map, metric, &[]).expect("a bake")[0]);
        let stored: Vec<f32> = stored.into_iter().map(|ratio| ratio as f32).collect();
        let default = measure("the default", &stored, Fetch::Fixed);
        let classic = measure("of centres", &of(ConeApex::Centre), Fetch::Moved);
        let footprint = measure("of squares", &of(ConeApex::Footprint), Fetch::Moved);
        let filtered = measure("filtered", &of(ConeApex::Filtered), Fetch::Moved);
        assert_eq!((default.2, footprint.2, filtered.2), (0, 0, 0), "{name}: surface in a safe cone");
        let compare = |of: (f64, f64, usize)| (of.0 / classic.0, of.1 / classic.1);
        let (slope, steps) = compare(default);
        println!("{name}, the default: {slope:.3} of the slope, {steps:.3} of the steps");
        assert!(slope < 1.001 && steps < 0.8, "{name}: {slope} of the slope, {steps} of the steps");
        let (slope, steps) = compare(footprint);
        println!("{name}, of squares: {slope:.3} of the slope, {steps:.3} of the steps");
        assert!(
            slope < most_slope && steps < most_steps,
            "{name}: {slope} of the slope, {steps} of the steps"
        );
    }
}

#[test]
fn bakes_the_same_on_any_number_of_threads_and_ends_when_cancelled() {
    let map = &run::map(2);
    let metric = metric(1);
    let bake_on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        pool.install(|| ratios(map, &metric, ConeApex::Footprint))
    };
    assert_eq!(bake_on(1), bake_on(3));
    let cancel = AtomicBool::new(true);
    assert!(cone_ratios(map, &metric, ConeApex::Centre, &Watch::cancelled_by(&cancel)).is_err());
}
